// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"

#include <array>
#include <string>
#include <vector>

namespace flattening::pattern
{
enum class EdgeShape
{
  Straight,
  Quadratic, ///< parameters: control point, in the frame of the chord
  Cubic,     ///< parameters: two control points, in the frame of the chord
  Circle,    ///< parameters: radius, 1 for the larger arc, 1 for counter-clockwise
};

/// One edge of a panel. The frame of a chord from a to b has its origin at a, b - a as its first
/// axis and that turned to the left as its second, both of the length 1 in it.
struct GarmentEdge
{
  std::array<std::size_t, 2> ends{}; ///< vertices of the panel
  EdgeShape shape = EdgeShape::Straight;
  std::array<double, 4> parameters{};
  std::string label;
};

/// A flat piece of GarmentCode, and how it is placed in space.
struct GarmentPanel
{
  std::string name;
  std::string label;
  Points2 vertices;
  std::vector<GarmentEdge> edges; ///< each begins where the one before ends
  Point3 translation = Point3::Zero();
  Point3 rotation = Point3::Zero(); ///< degrees about x, then y, then z, which stay
};

struct GarmentSide
{
  std::size_t panel = 0;
  std::size_t edge = 0;

  bool operator==(const GarmentSide& other) const
  {
    return this->panel == other.panel && this->edge == other.edge;
  }
};

/// Two edges that are sewn together, the start of one to the end of the other.
struct GarmentStitch
{
  std::array<GarmentSide, 2> sides{};
  bool rightToWrong = false; ///< start to start instead
};

/// Panels and stitches as the JSON of GarmentCode has them; lengths in centimetres.
struct Garment
{
  std::vector<GarmentPanel> panels;
  std::vector<GarmentStitch> stitches;
};

/// Whether all that is named is there, borders are rings of edges that have a length, and no edge
/// is sewn twice.
/// \return InvalidPattern with panel and edge
Status checkGarment(const Garment& garment);

/// Places on an edge whose chords are within a distance of it and of one length along it, both ends
/// among them.
/// \param least fewest chords
Points2 pointsAlong(
  const GarmentPanel& panel, const GarmentEdge& edge, double distance, std::size_t least);

/// A point in the frame of the chord from one point to another: along it, and to its left.
Point2 inFrameOf(const Point2& point, const Point2& from, const Point2& to);

/// The point of space at which a panel has a point of its plane.
Point3 placedPoint(const GarmentPanel& panel, const Point2& point);

/// "edge 3 of the panel sleeve", for messages.
std::string edgeName(const GarmentPanel& panel, std::size_t edge);

/// The file's text. Numbers are written such that reading them gives the same bits.
std::string writeGarment(const Garment& garment);
}
