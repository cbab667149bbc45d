// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Figure.h"

namespace figures
{
/// The range of both indices of quality in a map: 1 - index on 0 to 0.5, blue to red.
constexpr ColorRange indexRange{ 1.0, 0.5 };

/// Radians; smaller angle defects are none.
constexpr double developable = 1e-3;

/// Each piece flattened on its own, beside each other.
std::vector<FlatPiece> flattenAll(
  const std::vector<Piece>& pieces, Method method, Interior interior = Interior::Rigid);

/// Surfaces with their boundaries and curves in space.
void drawSpace(Drawing& drawing, const std::vector<Piece>& pieces, const Vector& direction);

/// Surfaces and boundaries in the colors of E_dev, Eq. 25. Returns the largest value, which is
/// red.
double drawDevelopability(
  Drawing& drawing, const std::vector<Piece>& pieces, const Vector& direction);

/// Flat pieces with their wires.
void drawFlat(Drawing& drawing, const std::vector<FlatPiece>& pieces);

/// Flat pieces in the colors of a cell array of quality, with their wires.
void drawIndex(Drawing& drawing, const std::vector<FlatPiece>& pieces, const char* array);
}
