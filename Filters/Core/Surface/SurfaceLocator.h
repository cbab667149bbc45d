// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Surface/TriangleMesh.h"

#include <vector>

namespace flattening
{
/// A point of the surface as a mean of a triangle's corners.
struct ClosestPoint
{
  Index triangle = none;
  std::array<double, 3> weights{ 1.0, 0.0, 0.0 };
  Point3 position = Point3::Zero();
  double distance = 0.0;
};

/// Distances that differ by less than this fraction of them are equal: which of two faces is the
/// closer one to a point over the edge between them is not left to rounding.
inline constexpr double equalDistances = 1e-10;

/// Finds the point of a surface that is closest to a point in space, with a tree of bounding boxes:
/// n log n to build, log n a query where the point is near the surface.
class SurfaceLocator
{
public:
  /// The mesh must outlive the locator.
  explicit SurfaceLocator(const TriangleMesh& mesh);

  /// The smallest triangle id among those that are equally close but for rounding.
  ClosestPoint closest(const Point3& point) const;
  /// The closest point of each triangle that is farther than the closest one by at most a distance;
  /// ascending ids.
  std::vector<ClosestPoint> allClosest(const Point3& point, double farther) const;
  /// Of the box around the surface; 0 for an empty one.
  double diagonal() const
  {
    return this->Nodes.empty() ? 0.0 : this->Nodes.front().box.diagonal().norm();
  }

private:
  struct Node
  {
    Eigen::AlignedBox3d box;
    Index begin = 0; ///< range in Order; only leaves use it
    Index end = 0;
    Index right = none; ///< the left child follows its parent; none in leaves
  };

  Index build(Index begin, Index end, const Points3& centers);

  const TriangleMesh& Mesh;
  Indices Order;
  std::vector<Node> Nodes;
};

/// Finds the points of a surface that are closest to those of lines. Where the surface touches
/// itself or another part, as at the two sides of a slit, there are several sheets, and a line
/// stays on the one on which it continues.
class SheetLocator
{
public:
  /// The mesh must outlive the locator.
  explicit SheetLocator(const TriangleMesh& mesh);

  /// Where one point of a line lies.
  struct Place
  {
    ClosestPoint closest;
    Indices sheet; ///< where there are several, the triangles there that lie on its own; ascending
  };
  /// By point. A point without a place has no triangle.
  std::vector<Place> along(const Points3& line) const;
  /// Of single points.
  const SurfaceLocator& points() const { return this->Locator; }

private:
  std::vector<std::vector<ClosestPoint>> sheetsAt(const Point3& point) const;

  const TriangleMesh& Mesh;
  SurfaceLocator Locator;
  double SamePlace;
  mutable Indices Parts; ///< by triangle, of what is joined; found when needed
};
}
