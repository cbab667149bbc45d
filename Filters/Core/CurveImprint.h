// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FeatureCurve.h"
#include "TriangleMesh.h"

namespace flattening
{
struct ImprintOptions
{
  /// Split triangles where a curve does not follow mesh edges; otherwise such a curve is refused.
  bool split = true;
  /// Greatest distance of a curve point from the surface, as a fraction of the diagonal of the
  /// surface's bounding box.
  double tolerance = 1e-5;
  /// A curve point or crossing nearer to a vertex than this fraction of the mean edge length moves
  /// onto the vertex.
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
  /// Per vertex; the first ones are the vertices of the mesh before, unchanged.
  std::vector<VertexSource> vertexSource;
  /// Per triangle the triangle before that it is a part of.
  Indices originalTriangle;
  Status status;
};

/// Turns polylines into chains of mesh edges.
///
/// Errors: CurveTooShort (a curve with fewer than two different points; ids: curves),
/// CurvePointOffSurface (ids: points of the polyline), CurveNotOnEdges (ids: points of the polyline,
/// only where splitting is off).
ImprintedSurface imprintCurves(
  const TriangleMesh& mesh, const std::vector<Polyline>& polylines, const ImprintOptions& options);
}
