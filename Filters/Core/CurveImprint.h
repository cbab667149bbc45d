// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurveRoute.h"
#include "Execution.h"
#include "FeatureCurve.h"
#include "TriangleMesh.h"

namespace flattening
{
struct ImprintOptions
{
  /// Split triangles where a curve does not follow mesh edges; otherwise such a curve is refused.
  bool split = true;
  /// Greatest distance of a curve point from the surface, as a fraction of the diagonal of the
  /// surface's bounding box; 0 to 1. A point within this and within 1 % of the mean edge length of
  /// a vertex is that vertex (without splitting: within this alone).
  double tolerance = 1e-5;
  /// Curve points and crossings nearer to a vertex or edge than this fraction of the mean edge
  /// length move onto it, so that no slivers arise; 0 to 0.5. Where edges are shorter than the
  /// mean it is a fraction of the local edge length.
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

/// Turns polylines into chains of mesh edges.
///
/// Between two points a curve runs in the section of the surface with the plane through both and
/// the surface's normal, within one triangle straight. Where that is no edge, triangles are split:
/// new vertices lie on old edges and triangles, so that the shape of the surface stays, the edges
/// of the old mesh stay (in parts), and inside each old triangle the parts are constrained
/// Delaunay. Curves that cross share a vertex. A mesh whose edges all curves follow is returned as
/// it is.
///
/// A point near two sheets of the surface goes to the nearer one.
///
/// Errors: NonFinitePoint (ids: points of the polyline); CurveTooShort (a curve with fewer than two
/// different points; ids: curves); CurvePointOffSurface (ids: points of the polyline);
/// CurveLeavesSurface (a segment that meets the boundary before its end, or whose ends no plane
/// section joins; ids: its two points);
/// CurveNotOnEdges (ids: points of the polyline, only where splitting is off); InvalidCurve (a
/// planar shape of another number of points; ids: curves); InvalidOption; NumericalFailure (ids:
/// triangles too thin to split); Cancelled.
ImprintedSurface imprintCurves(const TriangleMesh& mesh, const std::vector<Polyline>& polylines,
  const ImprintOptions& options, const Execution& execution = {});

/// The curves anew where at most names, types, shapes and tolerances of the polylines are others
/// than those that were imprinted. The result is the same as that of imprintCurves().
void describeCurves(ImprintedSurface& imprinted, const std::vector<Polyline>& polylines);
}
