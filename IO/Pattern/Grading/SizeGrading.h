// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Outlines/PatternSource.h"

#include <string>
#include <vector>

namespace flattening::pattern
{
/// One size of a pattern.
struct PatternSize
{
  std::string name;
  PatternSource source;
};

struct GradingOptions
{
  Unit unit = Unit::Centimetre; ///< of the surfaces of all sizes
  std::string base;             ///< the size that rules count from; empty: the one in the middle
  /// The curve at whose first point and along whose chord sizes are laid on each other; empty: of
  /// each piece the first key curve within it, or, where there is none, the middle of its wires,
  /// turned as they fit those of the base best.
  std::string alignment;
};

/// How one point of a piece goes from the base size to the others.
struct GradeRule
{
  Index piece = none;
  Index point = none; ///< of the flat pieces
  std::string name;   ///< of the curves that meet there, "side, hem"
  Points2 deltas;     ///< by size, from the base; millimetres across the grain and along it
};

/// Sizes of one pattern, laid on each other piece by piece. Lengths are millimetres.
struct Grading
{
  std::vector<std::string> sizes;
  std::size_t base = 0;
  std::vector<Points2> positions; ///< by size: the points of all pieces, y along the grain
  std::vector<SourceWire> wires;  ///< the same of all sizes
  std::vector<GradeRule> rules;   ///< by piece and point
  Points2 grains;                 ///< by piece, the grain of the base as it lies, of length 1
};

/// Lays the pieces of several sizes on each other. Points with rules are the ends of curves on the
/// border, and corners of the boundary.
/// \return InvalidOption where there are fewer than two sizes, two of one name or one without, no
/// base or curve of the name, or where sizes differ in more than where their points are;
/// InvalidPattern where a size is broken
Status gradeSizes(
  const std::vector<PatternSize>& sizes, const GradingOptions& options, Grading& grading);
}
