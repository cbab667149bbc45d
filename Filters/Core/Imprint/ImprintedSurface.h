// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/FeatureCurve.h"
#include "Surface/TriangleMesh.h"

namespace flattening
{
/// The way of a polyline over the surface, one stretch per segment: the vertices from the point
/// before to the point.
struct Route
{
  Index start = none;
  std::size_t firstPoint = 0;
  std::vector<Indices> stretches;
  std::vector<std::size_t> points; ///< the point at the end of each stretch
};

/// One curve a polyline: its stretches together, with a planar point for each vertex where it has
/// them. The mesh is the one that the routes' vertices are of. Errors: CurveTooShort.
Status assembleCurves(const TriangleMesh& mesh, const std::vector<Polyline>& polylines,
  const std::vector<Route>& routes, std::vector<FeatureCurve>& curves);

/// Finite points, and a planar point for each where the key shape wants them. The first defect.
Status checkPolylines(const std::vector<Polyline>& polylines);
/// How messages call a polyline: by its name, or by its number.
std::string curveName(const Polyline& polyline, std::size_t id);
/// Id of a point in the caller's data.
Index pointId(const Polyline& polyline, std::size_t point);

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
