// SPDX-License-Identifier: BSD-3-Clause
// What the patterns use of Clipper 6, by its port to JavaScript (clipper-lib), since Debian has no
// Clipper for WebAssembly. load() of the package takes the library; package/clipper.js calls it.
#pragma once

#include <emscripten/val.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>
#include <vector>

namespace ClipperLib
{
using cInt = std::int64_t;

struct IntPoint
{
  cInt X;
  cInt Y;
  IntPoint(cInt x = 0, cInt y = 0)
    : X(x)
    , Y(y)
  {
  }
};

using Path = std::vector<IntPoint>;
using Paths = std::vector<Path>;

enum ClipType
{
  ctUnion,
  ctDifference
};
enum PolyType
{
  ptSubject,
  ptClip
};
enum PolyFillType
{
  pftNonZero,
  pftPositive
};
enum JoinType
{
  jtMiter
};
enum EndType
{
  etClosedPolygon
};

class clipperException : public std::exception
{
public:
  explicit clipperException(const char* words)
    : Words(words)
  {
  }
  const char* what() const noexcept override { return this->Words.c_str(); }

private:
  std::string Words;
};

inline double Area(const Path& path)
{
  double twice = 0.0;
  for (std::size_t k = 0; k < path.size(); ++k)
  {
    const IntPoint& a = path[k];
    const IntPoint& b = path[(k + 1) % path.size()];
    twice += static_cast<double>(a.X) * static_cast<double>(b.Y) -
      static_cast<double>(b.X) * static_cast<double>(a.Y);
  }
  return twice / 2.0;
}

inline bool Orientation(const Path& path)
{
  return Area(path) >= 0.0;
}

inline void ReversePath(Path& path)
{
  std::reverse(path.begin(), path.end());
}

namespace port
{
using emscripten::val;

inline val library()
{
  const val given = val::module_property("clipper");
  if (given.isUndefined())
  {
    throw clipperException("load() was not given clipper-lib");
  }
  return given;
}

/// x, y of each point.
inline val numbersOf(const Path& path)
{
  std::vector<double> numbers;
  for (const IntPoint& p : path)
  {
    numbers.push_back(static_cast<double>(p.X));
    numbers.push_back(static_cast<double>(p.Y));
  }
  return val(emscripten::typed_memory_view(numbers.size(), numbers.data())).call<val>("slice");
}

inline Paths pathsOf(const val& list)
{
  Paths paths;
  for (const val& numbers : emscripten::vecFromJSArray<val>(list))
  {
    const auto all = emscripten::convertJSArrayToNumberVector<double>(numbers);
    Path& path = paths.emplace_back();
    for (std::size_t k = 1; k < all.size(); k += 2)
    {
      path.emplace_back(std::llround(all[k - 1]), std::llround(all[k]));
    }
  }
  return paths;
}
}

inline void CleanPolygons(Paths& paths)
{
  emscripten::val list = emscripten::val::array();
  for (const Path& path : paths)
  {
    list.call<void>("push", port::numbersOf(path));
  }
  paths = port::pathsOf(port::library().call<emscripten::val>("clean", list));
}

inline void MinkowskiSum(const Path& pattern, const Path& path, Paths& sums, bool closed)
{
  sums = port::pathsOf(port::library().call<emscripten::val>(
    "sum", port::numbersOf(pattern), port::numbersOf(path), closed));
}

class Clipper
{
public:
  void AddPath(const Path& path, PolyType type, bool)
  {
    this->Given[type].call<void>("push", port::numbersOf(path));
  }
  void AddPaths(const Paths& paths, PolyType type, bool closed)
  {
    for (const Path& path : paths)
    {
      this->AddPath(path, type, closed);
    }
  }
  void Execute(ClipType type, Paths& result, PolyFillType fill, PolyFillType)
  {
    result = port::pathsOf(port::library().call<emscripten::val>("combine", this->Given[ptSubject],
      this->Given[ptClip], type == ctUnion, fill == pftPositive));
  }

private:
  emscripten::val Given[2]{ emscripten::val::array(), emscripten::val::array() };
};

/// Of one polygon, with mitred corners.
class ClipperOffset
{
public:
  ClipperOffset(double mitreLimit, double arcTolerance)
    : MitreLimit(mitreLimit)
    , ArcTolerance(arcTolerance)
  {
  }
  void AddPath(const Path& path, JoinType, EndType) { this->Given = path; }
  void Execute(Paths& result, double distance)
  {
    result = port::pathsOf(port::library().call<emscripten::val>(
      "offset", port::numbersOf(this->Given), this->MitreLimit, this->ArcTolerance, distance));
  }

private:
  double MitreLimit;
  double ArcTolerance;
  Path Given;
};
}
