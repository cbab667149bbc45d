// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Paths/PathGraph.h"

namespace flattening
{
/// Lengths of the shortest ways from sixteen nodes, far from each other, of the graph's largest
/// part to every node; 0 to nodes of other parts. By the triangle inequality they bound the length
/// of every way from below (A. V. Goldberg and C. Harrelson, 2005), and spare searches over bumps
/// and coils most of their time. They take as much as so many searches over the whole surface.
std::vector<LandmarkDistances> landmarkDistances(const PathGraph& graph);
}
