// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/CutTrials.h"
#include "Surface/TriangleMesh.h"

namespace flattening
{
/// A tree of edges along which a sphere, or a disk from its boundary on, opens into one disk. It
/// grows to where most strain is forecast (X. Gu, S. Gortler, H. Hoppe, "Geometry images", ACM
/// Transactions on Graphics 21(3), 2002, who take the strain of a flattening instead): of the tips
/// where ScaleFactor is extreme, by the shortest path to the one that lowers its energy most for
/// the length.
class SeamTree
{
public:
  /// Whether a mesh, which is connected, is a sphere or a disk.
  static bool opens(const TriangleMesh& mesh)
  {
    const auto loops = static_cast<Index>(mesh.boundaryLoops().size());
    return loops < 2 && eulerCharacteristic(mesh) + loops == 2;
  }

  /// The mesh must outlive it. \pre opens(mesh)
  explicit SeamTree(const TriangleMesh& mesh);

  /// Until forecastStrain() of the disk is within a bound. False where it can grow no more, or the
  /// budget is spent.
  bool grow(double bound, TrialBudget& budget, const Execution& execution);
  /// By half-edge.
  const std::vector<char>& cut() const { return this->Cut; }

private:
  void add(const Indices& path);

  const TriangleMesh& Mesh;
  double Size; ///< sqrt(area / pi)
  std::vector<char> Cut;
  Indices Vertices; ///< of the tree and the boundary
};
}
