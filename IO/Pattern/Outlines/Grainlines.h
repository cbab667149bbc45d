// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/Pattern.h"
#include "Outlines/PatternSource.h"
#include "Outlines/PlaneGeometry.h"

#include <array>
#include <optional>
#include <vector>

namespace flattening::pattern
{
/// How far a line may leave its chord, as a fraction of the chord, and still be straight to whoever
/// lays cloth: 1.5 mm on 30 cm.
inline constexpr double straightness = 0.005;

/// Where the up of the surface points in a flat piece, of length 1: the mean slope of the height
/// there. None where the surface is not known, or lies rather level in the piece.
std::optional<Point2> upOf(const PatternSource& source, std::size_t piece, UpAxis axis);

/// The direction of a flat piece's grain, of length 1: upright on its cloth, else along its first
/// straight key curve, else the up of the surface, or upright.
Point2 grainOf(const PatternSource& source, std::size_t piece, UpAxis axis);

/// Whether a piece has a key curve that is straight in the plane, along which its grain runs.
bool hasStraightKey(const PatternPiece& piece);

/// Draws the grain of a piece: of one that lies on its cloth upright, else along the first of its
/// key curves that is straight in the plane, and upright where none is. A piece whose key curves
/// all bend gets a warning that names the one that bends least and by how much.
/// \param boundary of the cloth, in which the arrow stays
/// \param stands the piece is turned so that the up of its surface is upright
void drawGrainline(const Segments& boundary, bool onCloth, bool stands, PatternPiece& piece);

/// The heads of its arrow, as triangles: one where the grain is known, else one at either end; none
/// where it has no length.
std::vector<std::array<Point2, 3>> arrowHeads(const Grainline& grain);
}
