// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/SurfacePoint.h"

namespace flattening
{
/// One straight stretch of a path: over a strip of triangles that are unfolded into a plane, within
/// one triangle, or along an edge.
struct GeodesicSegment
{
  /// The half-edges that it leaves triangles by, in order, none of which holds an end of the
  /// segment; empty within one triangle and along an edge.
  Indices crossed;
  double length = 0.0;
  /// At an end in a vertex, where half-edges are crossed: the angle from the half-edge on the right
  /// of who looks along the segment from there.
  double startAngle = 0.0;
  double endAngle = 0.0;
};

/// A path as an elastic string lies: segments between vertices. Those between the two ends are
/// vertices.
struct GeodesicPath
{
  std::vector<SurfacePoint> vertices;
  std::vector<GeodesicSegment> segments; ///< segments[i] joins vertices[i] and vertices[i + 1]

  /// Adds a path that starts where this one ends.
  void append(const GeodesicPath& more)
  {
    this->segments.insert(this->segments.end(), more.segments.begin(), more.segments.end());
    this->vertices.insert(this->vertices.end(), more.vertices.begin() + 1, more.vertices.end());
  }
};

/// The shortest path between two points inside of the strip of triangles that a list of half-edges
/// crosses: the strip is unfolded into a plane and a string drawn tight in it (the funnel of D. T.
/// Lee and F. P. Preparata, 1984), in time linear in the number of half-edges.
///
/// Vertices that a segment passes closer than an angle of 1e-11 become vertices as well.
/// \pre No half-edge holds an end at its end of the strip; the first is in a triangle of the start.
GeodesicPath shortestInStrip(const TriangleMesh& mesh, const SurfacePoint& start,
  const Indices& crossed, const SurfacePoint& end);

/// The list with steps back taken out, without the half-edges at its ends that hold the ends: the
/// strip that crosses the rest joins them in the same way.
Indices reducedStrip(const TriangleMesh& mesh, const SurfacePoint& start, const Indices& crossed,
  const SurfacePoint& end);

/// Where a segment leaves triangles: as fractions of its half-edges, the last vertex 1.
std::vector<double> crossingFractions(const TriangleMesh& mesh, const SurfacePoint& start,
  const Indices& crossed, const SurfacePoint& end);
}
