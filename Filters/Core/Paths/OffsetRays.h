// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Imprint/SurfaceTrace.h"
#include "Paths/StraightRay.h"

namespace flattening
{
/// Rays that leave one leg at right angles, or a corner in all directions between two.
struct RayFamily
{
  std::size_t point = 0; ///< of the corner, or where the leg starts
  bool leg = false;
  double first = 0.0; ///< angles at the corner, 0 and 1 of a leg
  double last = 0.0;
  double width = 0.0; ///< length of the leg
  bool apart = false; ///< the boundary lies between this family and the one before
};

/// The straight lines that leave a path on its left, from end to end of it.
class OffsetRays
{
public:
  /// \param widestArc between the tangents that make an arc, in radians
  /// \pre No leg of the path is without length. Mesh and path must outlive this.
  OffsetRays(const TriangleMesh& mesh, const SurfacePath& path, double distance, double widestArc);

  /// In the order of the path; from the boundary on, and to it, where the path's ends lie there.
  std::vector<RayFamily> families() const;
  /// Round the ends that do not lie on the boundary, from the right of the path to its left and
  /// back.
  std::vector<RayFamily> caps() const;
  /// Where rays are drawn at least, behind the first: of an arc where its tangents meet.
  std::vector<double> places(const RayFamily& family) const;
  /// As long as the distance, or up to the tangents of an arc.
  StraightRay ray(const RayFamily& family, double at) const;
  SurfacePoint foot(const RayFamily& family, double at) const;

private:
  double outAngle(const PointDirections& around, std::size_t i) const;
  double inAngle(const PointDirections& around, std::size_t i) const;
  void addFromBoundary(std::size_t i, std::vector<RayFamily>& all) const;
  void addToBoundary(std::size_t i, std::vector<RayFamily>& all) const;
  void addCorner(std::size_t i, std::vector<RayFamily>& all) const;
  double halfArc(const RayFamily& family) const;
  double reachOf(const RayFamily& family, double at) const;

  const TriangleMesh& Mesh;
  const SurfacePath& Path;
  double Distance;
  double WidestArc;
  bool Closed;
};
}
