// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/DataSet.h"

#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace wirewarp
{
using flattening::DataSet;

struct Flattening;
struct Options;

/// A size of the pattern; that of SURFACE itself names no surface.
struct SizeSurface
{
  std::string name;
  std::string surface;
};

/// The sizes to grade a pattern by, beside SURFACE, whose size the pattern's options name.
struct SizeRequest
{
  std::vector<std::string> texts; ///< NAME=SURFACE, or NAME
  std::string alignment;          ///< a curve; empty: the first key curve of each piece

  bool any() const { return !this->texts.empty(); }
  /// All sizes in their order, that of SURFACE among them.
  /// \param base its name
  std::vector<SizeSurface> all(const std::string& base) const;
  /// What is wrong with the sizes; empty where nothing is.
  std::string fault(const std::string& base) const;
};

/// \param words SIZE=SURFACE and files of curves
void addSizes(
  CLI::App& app, std::vector<std::string>& words, SizeRequest& request, std::string& base);

/// Flattens the other sizes and lays them on the base, whose flattening this is. Where one is
/// refused, so is the result, with the size in its message.
void gradeSizes(const Options& options, Flattening& result);

/// How far the points of the curves lie off the surface at most, in its unit: by so much they are
/// moved to be laid on it. Curves over the surface's own points lie on it.
double largestDistance(const DataSet& surface, const std::vector<DataSet>& curves);

/// Throws InputError where the cells of a surface have other corners than those of the base.
void checkConnectivity(const DataSet& base, const std::string& basePath, const DataSet& surface,
  const std::string& path);

/// Curves of one surface on another of the same connectivity: each point at the same place of the
/// same cell, those over the surface's own points at the same points.
DataSet movedCurves(const DataSet& curves, const DataSet& from, const DataSet& to);

/// A note where curves over the surface's own vertices have numbers as their names, which may be
/// vertices of lines without a name; empty where none has.
std::string notesOfNumberNames(const DataSet& surface, const DataSet& curves);
}
