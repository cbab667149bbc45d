// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Imprint/SurfaceTrace.h"
#include "Paths/PointDirections.h"

namespace flattening
{
/// Straight lines that leave one leg of a path at right angles, or a corner in all directions
/// between two.
struct OffsetFamily
{
  std::size_t point = 0; ///< of the corner, or where the leg starts
  bool leg = false;
  double first = 0.0; ///< angles at the corner, from the greater one on
  double last = 0.0;
};

/// The straight lines that leave a path on its left, from end to end of it.
class OffsetFamilies
{
public:
  /// \pre No leg of the path is without length. Mesh and path must outlive this.
  OffsetFamilies(const TriangleMesh& mesh, const SurfacePath& path);

  /// In the order of the path; from the boundary on, and to it, where the path's ends lie there.
  std::vector<OffsetFamily> along() const;
  /// Round the ends that do not lie on the boundary, from the right of the path to its left and
  /// back.
  std::vector<OffsetFamily> caps() const;

private:
  double outAngle(const PointDirections& around, std::size_t i) const;
  double inAngle(const PointDirections& around, std::size_t i) const;
  void addFromBoundary(std::size_t i, std::vector<OffsetFamily>& all) const;
  void addToBoundary(std::size_t i, std::vector<OffsetFamily>& all) const;
  void addCorner(std::size_t i, std::vector<OffsetFamily>& all) const;

  const TriangleMesh& Mesh;
  const SurfacePath& Path;
  bool Closed;
};
}
