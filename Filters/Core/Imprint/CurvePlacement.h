// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Imprint/ImprintedSurface.h"
#include "Surface/SurfacePoint.h"

#include <optional>

namespace flattening
{
/// Where the points of polylines lie on a surface: at its vertices, or anywhere on it.
class CurvePlacement
{
public:
  /// The mesh, the polylines and the options stay the caller's and must outlive the placement.
  CurvePlacement(const TriangleMesh& mesh, const std::vector<Polyline>& polylines,
    const ImprintOptions& options);

  /// Finds the vertices of all points in one pass over the mesh. \pre The points are finite.
  void findVertices();
  /// The vertex that a point of a polyline is, none where it lies elsewhere.
  Index vertex(std::size_t polyline, std::size_t point) const
  {
    return this->Vertices[this->First[polyline] + point];
  }
  /// The nearest point of the surface per point of polyline c. Errors: CurvePointOffSurface (ids:
  /// points of the polyline).
  Status locate(std::size_t c, std::vector<ClosestPoint>& closest);

private:
  void keepNearVertices(const Points3& queries, std::vector<Indices>& candidates) const;
  SuggestedRemedies waysFrom(double farthest) const;

  const TriangleMesh& Mesh;
  const std::vector<Polyline>& Polylines;
  const ImprintOptions& Options;
  double Diagonal;
  double Reach;          ///< greatest distance of a point from the surface
  SnapDistance AtVertex; ///< greatest distance of a point from the vertex that it is
  std::vector<std::size_t> First;
  Indices Vertices; ///< per point of all polylines
  std::optional<SurfaceLocator> Locator;
};
}
