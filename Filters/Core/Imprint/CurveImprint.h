// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Imprint/ImprintedSurface.h"

namespace flattening
{
/// Turns polylines into chains of mesh edges.
///
/// Between two points a curve runs in the section of the surface with the plane through both and
/// the surface's normal, within one triangle straight. Where that is no edge, triangles are split:
/// new vertices lie on old edges and triangles, so that the shape of the surface stays, the edges
/// of the old mesh stay (in parts), and inside each old triangle the parts are constrained
/// Delaunay. Curves that cross share a vertex. A mesh whose edges all curves follow is returned as
/// it is.
///
/// A point near two sheets of the surface goes to the nearer one; where they touch, as at the two
/// sides of a slit, to that on which the curve goes on.
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
