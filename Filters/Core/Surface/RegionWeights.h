// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"
#include "Surface/TriangleMesh.h"

#include <vector>

namespace flattening
{
/// How much distortion matters, by triangle of a surface: each counts as if its area were
/// multiplied by it. Empty: everywhere alike. Only their ratios matter.
using RegionWeights = std::vector<double>;

/// Errors: InvalidOption (not one for each triangle, one that is negative or no number, or none
/// above 0; ids: triangles).
Status checkWeights(const RegionWeights& weights, Index triangles);

/// Weights whose mean over the area is 1; empty where all are the same.
RegionWeights relativeWeights(const TriangleMesh& mesh, const RegionWeights& weights);

/// By vertex, the mean over the triangles around it by area; empty where the weights are.
std::vector<double> vertexWeights(const TriangleMesh& mesh, const RegionWeights& weights);

/// The weights for another triangulation of the same surface: each triangle's is the mean over
/// those whose middle is nearest to it; empty where the weights are.
RegionWeights resampledWeights(
  const TriangleMesh& mesh, const RegionWeights& weights, const TriangleMesh& other);
}
