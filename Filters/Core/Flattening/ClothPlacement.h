// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/PieceSolution.h"

namespace flattening
{
/// Lays a placed piece on the cloth of the options, warp along y; nothing where there is none. In
/// the isometric scheme the piece takes the shape in which the cloth has its least energy, and a
/// free grain the angle at which that is least. Other schemes, and a sheet without threads, only
/// turn the piece; a free grain is then the angle with the least strain of the threads.
void layOnCloth(const PieceContext& context, PieceSolution& piece);
}
