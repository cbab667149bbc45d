// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Flattening/FlatteningResult.h"

namespace flattening
{
/// How cloth that is sewn together again is drawn back to the design.
struct ReshapingForces
{
  double anchor = 0.0;      ///< see DesignAnchor
  double outsideBias = 0.0; ///< the same; at 1 no vertex ends inwards of its place
  double thickness = 0.0;   ///< of a plate that bends like it, over the root of the area
  int maximumIterations = 60;
  const TriangleMesh* body = nullptr; ///< that it does not enter; null: none
  double gap = 0.0;                   ///< from the body, over the root of the area
};

/// A surface while it is changed, over the triangles of its design.
class ReshapedSurface
{
public:
  /// \param design it must outlive the surface. \param held per vertex: it stays where it is.
  ReshapedSurface(const TriangleMesh& design, std::vector<char> held);

  const Points3& points() const { return this->Points; }
  TriangleMesh mesh() const;
  bool canMove() const;
  /// Sews flat pieces of the surface together again and lets them come to rest between themselves
  /// and the design; the surface then lies where the cloth does. Shapes that found no rest end
  /// where they are. \return false where the run is cancelled; the surface is as before then.
  bool sew(const FlatteningResult& flat, const ReshapingForces& forces, const Execution& execution);
  /// The surface by so much of the way from the design, 0 to 1.
  ReshapedSurface partOfTheWay(double share) const;

private:
  /// Where a vertex ends that cloth takes there.
  Point3 settled(Index vertex, const Point3& place, const ReshapingForces& forces) const;

  const TriangleMesh* Design; // of which surfaces are copied
  std::vector<char> Held;
  Points3 Outwards; // of the design
  Points3 Points;
};

/// How far a surface lies from its design, vertex from vertex, by area.
struct SurfaceShift
{
  double size = 0.0; ///< root of the area of the design
  double mean = 0.0;
  double p95 = 0.0; ///< not exceeded on 95 % of the area
  double max = 0.0;
  std::vector<double> ofVertex;
  /// Of that, along the normals of the design; below 0 inwards. Mean, most, and of each vertex.
  double outwardsMean = 0.0;
  double inwardsMax = 0.0; ///< not below 0
  std::vector<double> outwardsOfVertex;
};

SurfaceShift measureShift(const TriangleMesh& design, const Points3& points);
}
