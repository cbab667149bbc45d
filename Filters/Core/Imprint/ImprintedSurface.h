// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Imprint/CurveRoute.h"
#include "Surface/FeatureCurve.h"
#include "Surface/TriangleMesh.h"

namespace flattening
{
struct ImprintOptions
{
  /// Split triangles where a curve does not follow mesh edges; otherwise such a curve is refused.
  bool split = true;
  /// Greatest distance of a curve point from the surface, as a fraction of the diagonal of the
  /// surface's bounding box; 0 to 1. A point within this and within 1 % of the mean edge length of
  /// a vertex is that vertex (without splitting: the
  /// nearest one within this). The default takes points as pickers and splines give them.
  double tolerance = 2e-3;
  /// Curve points and crossings nearer to a vertex or edge than this fraction of the mean edge
  /// length move onto it, so that no slivers arise; 0 to 0.5. Where the longest edge of the
  /// triangles there is shorter than the mean it is a fraction of that.
  double snap = 1e-3;
};

/// One vertex of the imprinted mesh as a mean of vertices of the mesh before (weights sum to 1).
struct VertexSource
{
  Triangle vertices{ none, none, none };
  std::array<double, 3> weights{ 1.0, 0.0, 0.0 };
};

struct ImprintedSurface
{
  TriangleMesh mesh;
  std::vector<FeatureCurve> curves;
  std::vector<Route> routes; ///< by curve
  /// Per vertex; the first ones are the vertices of the mesh before, unchanged.
  std::vector<VertexSource> vertexSource;
  /// Per triangle the triangle before that it is a part of.
  Indices originalTriangle;
  Status status;
};
}
