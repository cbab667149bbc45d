// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace wirewarp
{
enum class PlyScalar
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Float32,
  Float64,
};

struct PlyProperty
{
  std::string name;
  PlyScalar type = PlyScalar::Float32;
  bool list = false;
  PlyScalar countType = PlyScalar::UInt8;
};

struct PlyElement
{
  std::string name;
  long long count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyEncoding
{
  Ascii,
  LittleEndian,
  BigEndian,
};

struct PlyHeader
{
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::vector<PlyElement> elements;
  std::size_t size = 0; ///< bytes up to the data
};

/// Reads the header of a PLY file. \param bytes of the whole file; \param path for messages.
/// Throws InputError with file and line.
PlyHeader parsePlyHeader(const std::string& path, std::string_view bytes);
}
