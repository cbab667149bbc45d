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

/// Puts the stretches of a polyline together and gives each vertex its planar point. The mesh is
/// the one that the route's vertices are of. No vertices where the route has no start.
FeatureCurve assembleCurve(const TriangleMesh& mesh, const Polyline& polyline, const Route& route);
/// One curve a polyline. Errors: CurveTooShort.
Status assembleCurves(const TriangleMesh& mesh, const std::vector<Polyline>& polylines,
  const std::vector<Route>& routes, std::vector<FeatureCurve>& curves);

/// Finite points, and a planar point for each where the key shape wants them. The first defect.
Status checkPolylines(const std::vector<Polyline>& polylines);
/// How messages call a polyline: by its name, or by its number.
std::string curveName(const Polyline& polyline, std::size_t id);
/// Id of a point in the caller's data.
Index pointId(const Polyline& polyline, std::size_t point);
}
