// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Paths/OffsetWindow.h"
#include "Paths/PointDirections.h"
#include "Surface/SurfaceTrace.h"

#include <functional>
#include <queue>
#include <unordered_map>
#include <vector>

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

/// How far straight lines from a path go over a surface within a distance, triangle by triangle (J.
/// Chen and Y. Han, "Shortest paths on a polyhedron", 1990, without windows that S.-Q. Xin and
/// G.-J. Wang, "Improving Chen and Han's algorithm on the discrete geodesic problem", 2009, find
/// idle): behind vertices with more than 2 pi around them, and corners of the boundary, it goes on
/// from there.
class OffsetFront
{
public:
  /// Mesh and path must outlive it.
  OffsetFront(const TriangleMesh& mesh, double distance);

  /// \param own where they end is the offset; else they are only nearer to the path
  void start(const SurfacePath& path, const std::vector<OffsetFamily>& families, bool own);
  /// False where there are too many windows, as of a distance that goes round the surface many
  /// times.
  bool run();

  const std::vector<OffsetWindow>& windows() const { return this->Windows; }

private:
  struct Arrival
  {
    Index vertex = none;
    double distance = 0.0;
    bool own = false;
    double angle = 0.0; ///< towards the foot
  };
  struct Event
  {
    double distance = 0.0;
    std::size_t id = 0;
    bool window = false;
    bool operator>(const Event& other) const
    {
      return this->distance != other.distance ? this->distance > other.distance
                                              : this->id > other.id;
    }
  };

  void startStrip(const SurfacePath& path, std::size_t leg, bool own);
  /// From the greater angle at a point to the smaller one.
  void startSectors(const SurfacePoint& point, double last, double first, double before, bool own);
  void push(OffsetWindow window, double distance);
  void spread(const OffsetWindow& window);
  void arrive(const OffsetWindow& window, const FlatTriangle& flat, Index corner);
  void goOn(const Arrival& arrival);
  bool isIdle(const OffsetWindow& window, const FlatTriangle& flat, Index side, const Point2& right,
    const Point2& left) const;
  double reached(Index vertex) const;

  const TriangleMesh& Mesh;
  double Distance;
  std::vector<OffsetWindow> Windows;
  std::vector<Arrival> Arrivals;
  std::unordered_map<Index, double> Reached; ///< lengths of ways to vertices
  std::priority_queue<Event, std::vector<Event>, std::greater<>> Queue;
};
}
