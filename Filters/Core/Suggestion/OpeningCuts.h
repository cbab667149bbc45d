// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/SymmetryPlane.h"
#include "Surface/FeatureCurve.h"
#include "Surface/TriangleMesh.h"

namespace flattening
{
/// A boundary loop that is shorter than this share of the longest is short.
inline constexpr double shortLoop = 0.2;
/// Of a full turn, what the edge of a hole in a flat piece turns by at least, the other way than an
/// outer one; the ends of tubes do not.
inline constexpr double minHoleTurn = 0.95;

/// Cuts without which a connected surface cannot be laid flat: along loops around its handles, two
/// each; of a closed surface without handles, along its section with the mirror plane, or with the
/// plane through its centre across the axis along which it extends least; between the boundary
/// loops of tubes. Loops that are short beside the longest, or turn as the edge of a hole in a flat
/// piece does, are holes and stay.
///
/// The loops are the edges that neither a tree of shortest ways from one vertex nor a tree of
/// triangles across the other edges needs, closed along the first tree (D. Eppstein, "Dynamic
/// generators of topologically embedded graphs", SODA 2003; J. Erickson, K. Whittlesey, "Greedy
/// optimal homotopy and homology generators", SODA 2005).
///
/// \param barred per vertex, whether it lies on a key curve, which no cut between boundary loops may
/// meet; loops are left where there is no other way. Empty: none does
std::vector<Polyline> openingCuts(const TriangleMesh& mesh,
  const std::optional<SymmetryPlane>& mirror = {}, const std::vector<char>& barred = {});

/// Whether curves part a surface into pieces with a boundary and without handles.
bool laysOpen(const TriangleMesh& mesh, const std::vector<Polyline>& curves);

/// By boundary loop, whether it is a hole, which a piece may surround: it is short beside the
/// longest, the first, or turns as the edge of a hole in a flat piece does.
std::vector<char> findHoles(const TriangleMesh& mesh, const std::vector<Indices>& loops);
}
