// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/SurfaceFlattening.h"
#include "Imprint/CurveImprint.h"
#include "Surface/SurfacePreparation.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>
#include <vector>

/// Inputs that no well-meaning user would make, decoded from bytes, and what must hold of the
/// answer.
namespace hostile
{
using namespace flattening;

/// A surface as triangles over points, with the curves that belong to it.
struct Specimen
{
  std::string name;
  Points3 points;
  Triangles triangles;
  std::vector<Polyline> curves;
};

/// Of a case that is made from its seed.
inline std::vector<std::uint8_t> randomBytes(std::mt19937& random, std::size_t count = 768)
{
  std::vector<std::uint8_t> bytes(count);
  std::generate(bytes.begin(), bytes.end(), [&] { return static_cast<std::uint8_t>(random()); });
  return bytes;
}

/// A number that is named by hand.
inline unsigned fromEnvironment(const char* name, unsigned otherwise)
{
  const char* value = std::getenv(name);
  return value ? static_cast<unsigned>(std::atoi(value)) : otherwise;
}

/// Names a seed before it is tried, where HOSTILE_TRACE=1 asks for it.
inline void traceSeed(unsigned seed)
{
  if (std::getenv("HOSTILE_TRACE"))
  {
    std::cerr << "seed " << seed << std::endl;
  }
}

/// Reads numbers off a byte string; past its end all are zero.
class Bytes
{
public:
  explicit Bytes(const std::vector<std::uint8_t>& bytes)
    : Bytes(bytes.data(), bytes.size())
  {
  }
  Bytes(const std::uint8_t* data, std::size_t size)
    : Data(data)
    , Size(size)
  {
  }
  unsigned next() { return this->At < this->Size ? this->Data[this->At++] : 0U; }
  /// In [0, count).
  Index below(Index count);
  /// In [0, 1].
  double unit() { return static_cast<double>(this->below(65536)) / 65535.0; }
  bool oneIn(unsigned count) { return this->next() % count == 1 % count; }
  /// A generator for what would need too many bytes.
  std::mt19937 generator() { return std::mt19937(static_cast<unsigned>(this->below(65536))); }

private:
  const std::uint8_t* Data;
  std::size_t Size;
  std::size_t At = 0;
};

inline double between(std::mt19937& random, double least, double most)
{
  return std::uniform_real_distribution<double>(least, most)(random);
}

inline Index anyOf(std::mt19937& random, Index least, Index most)
{
  return std::uniform_int_distribution<Index>(least, std::max(least, most))(random);
}

/// Sizes of a surface before its mutations, about.
struct SizeRange
{
  double least = 1.0;
  double most = 120.0;
};

struct HostileCase
{
  std::string origin; ///< of the surface, for messages
  Points3 points;
  Triangles triangles;
  CoincidentPoints coincident = CoincidentPoints::Automatic;
  std::vector<Polyline> polylines;
  ImprintOptions imprint;
  /// Chains of vertex ids that go past the imprint, as a caller of flattenSurface() may give them.
  std::vector<FeatureCurve> chains;
  FlatteningOptions options;
  /// Cancel at this question; none: never.
  Index cancelAt = none;
};

/// What the fuzz target tries: an input of its corpus is another surface with other sizes.
constexpr SizeRange fuzzedSizes{ 1.0, 40.0 };

HostileCase decodeCase(
  Bytes& bytes, const std::vector<Specimen>& specimens, const SizeRange& triangles);

/// What a well-meaning user would make: an ordinary surface, options as they are, each scheme as
/// often, curves on half of them.
HostileCase decodeOrdinaryCase(Bytes& bytes, const SizeRange& triangles);

struct Verdict
{
  std::string fault; ///< empty where all is as it must be
  StatusCode code = StatusCode::Ok;
  Index triangles = 0;
  double seconds = 0.0; ///< of the processor
};

/// The whole way as vtkWireWarpingFilter goes it: preparation, imprint, flattening; then checks of
/// the answer that share no code with it.
Verdict tryCase(const HostileCase& hostileCase);
}
