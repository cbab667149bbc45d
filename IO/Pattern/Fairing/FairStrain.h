// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Outlines/DrawingSource.h"

namespace flattening
{
namespace pattern
{
/// What 95 % of the area of a piece is strained by at most: the largest |ln s| of the singular
/// values s of the maps from the surface's triangles to the plane. 0 where the points in space are
/// not known.
/// \param positions in the plane, millimetres
double strainQuantile(const DrawingSource& all, std::size_t piece, const Points2& positions);

/// Where the points of a piece lie if those of its borders and curves are moved and the others
/// follow: their way is the mean of their neighbours' ways.
/// \param moved all points, of which those of borders and curves are where they are to be
Points2 followBorders(const DrawingSource& all, std::size_t piece, const Points2& moved);
}
}
