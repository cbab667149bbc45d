// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Outlines/PatternSource.h"

#include <string>

namespace flattening::pattern
{
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
