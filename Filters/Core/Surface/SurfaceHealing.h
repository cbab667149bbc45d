// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Base/Types.h"
#include "Surface/SurfacePreparation.h"

#include <vector>

namespace flattening
{
/// The defects that are healed, in the order in which they are reported.
enum class SurfaceDefect
{
  CollapsedPoints,   ///< joined to a neighbour by an edge of a millionth of the mean edge there
  FlatTriangles,     ///< without area: taken out, what lies behind them is divided
  DoubledTriangles,  ///< with the same corners as another, in either orientation
  Fins,              ///< small parts that stand on an edge of two others
  CrowdedEdges,      ///< of more than two triangles, between large parts: separated there, and
                     ///< at an edge beside it where the triangles have both ends in common
  OneSidedEdges,     ///< at which a surface that cannot be oriented was opened
  PinchedPoints,     ///< in which parts of the surface touch: doubled
  ReversedTriangles, ///< oriented against the majority of their part
  Specks,            ///< parts below a thousandth of the area of the largest: left out
};

/// What is done about defects of a surface.
enum class Defects
{
  Heal,      ///< where it is clear how, see healSurface()
  HealParts, ///< the same, but for specks: of a surface that has been cut, they may be pieces
  Separate,  ///< as Heal; an edge of more than two triangles comes apart where no rule decides, and
             ///< a one-sided surface where triangles are turned over
  Refuse,    ///< but for triangles that are turned over
};

/// What was done about one kind of defect.
struct Mending
{
  SurfaceDefect defect = SurfaceDefect::CollapsedPoints;
  /// Of the input, ascending: points (collapsed, pinched), pairs of points (edges) or
  /// triangles.
  ElementIds ids;
  Index parts = 0; ///< specks: how many parts the triangles form
};

/// A surface as prepareSurface() gives it, of what is left of the input's triangles. A point in
/// which parts touched has several vertices; vertexOfPoint is that of the largest fan.
struct HealedSurface : PreparedSurface
{
  /// Per triangle that of the input; empty where each is its own.
  Indices originalTriangle;
  /// Points that were joined to a neighbour, whose vertex they share; ascending.
  Indices joinedPoints;
  std::vector<Mending> mendings; ///< one for each kind of defect that was found
};

/// prepareSurface() of a surface whose defects are healed where there is one clear way to; holes
/// stay. What that cannot heal is refused as there, in the ids of the input.
///
/// - Ends of an edge of at most a millionth of the mean edge at one of them become one point, that
///   of the lower id.
/// - A triangle with its corners in a line is divided among those behind its longest edge. Where
///   half of the triangles or more are without area, the surface is refused.
/// - At an edge of more than two triangles those two go on with each other that are of large parts,
///   or of one part, or in one plane by at least 30 degrees clearer than any other two that are
///   oriented alike, else than any other two. The others come off, and are fins below a hundredth
///   of the area of the largest part, or as single triangles below a tenth. Where none of it
///   decides between large parts, the surface is refused, or all come off.
///
/// It takes linear time, and where the surface has no defect returns prepareSurface()'s to the last
/// bit. Which triangle of doubled ones stays is all that depends on their order.
HealedSurface healSurface(const Points3& points, const Triangles& triangles,
  CoincidentPoints coincident = CoincidentPoints::Automatic, Defects defects = Defects::Heal);
}
