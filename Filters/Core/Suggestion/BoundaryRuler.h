// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/SurfacePoint.h"

namespace flattening
{
/// A place on the boundary: a loop, and an arc length along it from its first vertex.
struct BoundaryPlace
{
  Index loop = none;
  double arc = 0.0;
};

/// The boundary loops of a surface with arc lengths.
class BoundaryRuler
{
public:
  explicit BoundaryRuler(const TriangleMesh& mesh);

  Index loopCount() const { return static_cast<Index>(this->Loops.size()); }
  double length(Index loop) const { return this->Loops[loop].arcs.back(); }
  BoundaryPlace placeOf(Index vertex) const { return this->Places[vertex]; }
  /// The place so far along, around the loop.
  BoundaryPlace moved(const BoundaryPlace& place, double by) const;
  Point3 point(const BoundaryPlace& place) const;
  /// The vertex nearest along the loop.
  Index vertex(const BoundaryPlace& place) const;
  SurfacePoint surfacePoint(const BoundaryPlace& place) const;
  /// A point inside the surface close to the place.
  Point3 inside(const BoundaryPlace& place) const;
  /// The place nearest to a point in space; of the two sides of a cut that next to `inside`.
  BoundaryPlace nearest(const Point3& point, const Point3& inside) const;
  /// Distance along the boundary; infinite between loops.
  double distance(const BoundaryPlace& a, const BoundaryPlace& b) const;
  /// Boundary vertices at steps of about the spacing, all loops, none nearer to a corner (a turn by
  /// more than 30 degrees, where the surface is narrower than a half plane) than `clear`.
  Indices spread(double spacing, double clear) const;

private:
  struct Loop
  {
    Indices halfedges;
    std::vector<double> arcs; ///< one more: the length
    std::vector<double> corners;
  };

  std::size_t edgeAt(const BoundaryPlace& place) const;

  const TriangleMesh& Mesh;
  std::vector<Loop> Loops;
  std::vector<BoundaryPlace> Places; ///< by vertex
};
}
