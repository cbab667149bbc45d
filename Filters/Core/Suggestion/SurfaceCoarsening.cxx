// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/SurfaceCoarsening.h"

#include "Suggestion/SeamDrawing.h"
#include "Suggestion/SeamSettling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

namespace flattening
{
namespace
{
/// Cosine of the most that a triangle may turn in one step, and the least shape (1: equilateral) of
/// one that changes, unless it becomes no worse.
constexpr double minCosine = 0.7;
constexpr double minShape = 0.15;
/// Cuts of larger surfaces are found on a version with two thirds as many triangles.
constexpr Index largeSurface = 15000;
/// A version with more than this share of the triangles saves no work.
constexpr double mostLeft = 0.8;
/// What an edge of mean length weighs against curvature that moves, in radians.
constexpr double lengthShare = 0.03;

class Coarsening
{
public:
  Coarsening(const TriangleMesh& mesh, std::vector<char> kept)
    : Mesh(mesh)
    , Kept(std::move(kept))
    , Cells(mesh.triangles())
    , Around(mesh.vertexCount())
    , Gone(mesh.vertexCount(), 0)
    , Stamp(mesh.vertexCount(), 0)
    , Left(mesh.triangleCount())
  {
    for (Index t = 0; t < mesh.triangleCount(); ++t)
    {
      for (Index v : mesh.triangle(t))
      {
        this->Around[v].push_back(t);
        this->Kept[v] = this->Kept[v] || mesh.onBoundary(v) ? 1 : 0;
      }
    }
  }

  CoarseSurface run(Index most)
  {
    double sum = 0.0;
    for (Index h = 0; h < this->Mesh.halfedgeCount(); ++h)
    {
      sum += this->Mesh.length(h) * this->Mesh.length(h);
    }
    this->MeanSquare = sum / std::max<Index>(1, this->Mesh.halfedgeCount());
    for (Index v = 0; v < this->Mesh.vertexCount() && this->Left > most; ++v)
    {
      this->push(v);
    }
    while (!this->Queue.empty() && this->Left > most)
    {
      const Step step = this->Queue.top();
      this->Queue.pop();
      if (step.stamp == this->Stamp[step.vertex] && !this->Gone[step.vertex])
      {
        this->move(step.vertex, step.onto);
        this->push(step.onto);
        for (Index x : this->neighbours(step.onto))
        {
          this->push(x);
        }
      }
    }
    return this->collect();
  }

private:
  struct Step
  {
    double cost;
    Index vertex;
    Index onto;
    Index stamp; ///< of the vertex when this was the best for it

    bool operator<(const Step& other) const
    {
      return std::tie(this->cost, this->vertex) > std::tie(other.cost, other.vertex);
    }
  };

  /// Finds the best step for a vertex anew.
  void push(Index v)
  {
    ++this->Stamp[v];
    Step best{ std::numeric_limits<double>::infinity(), v, none, this->Stamp[v] };
    if (this->Kept[v] || this->Gone[v])
    {
      return;
    }
    const Indices around = this->neighbours(v);
    for (Index w : around)
    {
      if (this->allowed(v, w, around))
      {
        const double cost = this->cost(v, w, around);
        if (cost < best.cost)
        {
          best.cost = cost;
          best.onto = w;
        }
      }
    }
    if (best.onto != none)
    {
      this->Queue.push(best);
    }
  }

  /// How much curvature moves: the change of the angle sums around the neighbours.
  double cost(Index v, Index w, const Indices& around) const
  {
    std::vector<double> change(around.size(), 0.0);
    const auto at = [&](Index x) -> double& {
      return change[std::lower_bound(around.begin(), around.end(), x) - around.begin()];
    };
    for (Index t : this->Around[v])
    {
      const Triangle& cell = this->Cells[t];
      const bool lost = holds(cell, w);
      for (int k = 0; k < 3; ++k)
      {
        if (cell[k] != v)
        {
          at(cell[k]) -= this->angle(cell, k, v, v);
        }
        if (!lost)
        {
          at(cell[k] == v ? w : cell[k]) += this->angle(cell, k, v, w);
        }
      }
    }
    double sum =
      lengthShare * (this->Mesh.point(v) - this->Mesh.point(w)).squaredNorm() / this->MeanSquare;
    for (double c : change)
    {
      sum += std::abs(c);
    }
    return sum;
  }

  /// Of the triangle with one vertex taken for another.
  double angle(const Triangle& cell, int k, Index v, Index w) const
  {
    const auto point = [&](int j) -> const Point3& {
      const Index x = cell[(k + j) % 3];
      return this->Mesh.point(x == v ? w : x);
    };
    return angleBetween(point(1) - point(0), point(2) - point(0));
  }

  Indices neighbours(Index v) const
  {
    Indices all;
    for (Index t : this->Around[v])
    {
      for (Index x : this->Cells[t])
      {
        if (x != v)
        {
          all.push_back(x);
        }
      }
    }
    sortUnique(all);
    return all;
  }

  static bool holds(const Triangle& t, Index v) { return t[0] == v || t[1] == v || t[2] == v; }

  static double shape(const Point3& a, const Point3& b, const Point3& c)
  {
    const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
    return squares > 0.0 ? 2.0 * std::sqrt(3.0) * areaVector(a, b, c).norm() / squares : 0.0;
  }

  bool allowed(Index v, Index w, const Indices& a) const
  {
    // Exactly the two triangles between them are lost, or the surface would meet itself.
    const Indices b = this->neighbours(w);
    Indices common;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
    if (common.size() != 2)
    {
      return false;
    }
    for (Index t : this->Around[v])
    {
      if (holds(this->Cells[t], w))
      {
        continue;
      }
      std::array<Point3, 3> before;
      std::array<Point3, 3> after;
      for (int k = 0; k < 3; ++k)
      {
        const Index x = this->Cells[t][k];
        before[k] = this->Mesh.point(x);
        after[k] = this->Mesh.point(x == v ? w : x);
      }
      const Point3 was = areaVector(before[0], before[1], before[2]);
      const Point3 is = areaVector(after[0], after[1], after[2]);
      const double form = shape(after[0], after[1], after[2]);
      if (was.dot(is) < minCosine * was.norm() * is.norm() ||
        (form < minShape && form < shape(before[0], before[1], before[2])))
      {
        return false;
      }
    }
    return true;
  }

  void move(Index v, Index w)
  {
    this->Gone[v] = 1;
    for (Index t : this->Around[v])
    {
      Triangle& cell = this->Cells[t];
      if (holds(cell, w))
      {
        for (Index x : cell)
        {
          Indices& around = this->Around[x];
          if (x != v)
          {
            around.erase(std::remove(around.begin(), around.end(), t), around.end());
          }
        }
        cell = { none, none, none };
        --this->Left;
        continue;
      }
      std::replace(cell.begin(), cell.end(), v, w);
      this->Around[w].push_back(t);
    }
    this->Around[v].clear();
  }

  CoarseSurface collect() const
  {
    CoarseSurface result;
    Indices number(this->Mesh.vertexCount(), none);
    Points3 points;
    for (Index v = 0; v < this->Mesh.vertexCount(); ++v)
    {
      if (!this->Around[v].empty())
      {
        number[v] = static_cast<Index>(points.size());
        points.push_back(this->Mesh.point(v));
        result.vertices.push_back(v);
      }
    }
    Triangles cells;
    for (const Triangle& cell : this->Cells)
    {
      if (cell[0] != none)
      {
        cells.push_back({ number[cell[0]], number[cell[1]], number[cell[2]] });
      }
    }
    result.mesh = TriangleMesh(std::move(points), std::move(cells));
    return result;
  }

  const TriangleMesh& Mesh;
  std::vector<char> Kept;
  Triangles Cells;
  std::vector<Indices> Around; ///< triangles, by vertex
  std::vector<char> Gone;
  Indices Stamp; ///< by vertex, how often its best step was found
  std::priority_queue<Step> Queue;
  double MeanSquare = 1.0;
  Index Left;
};
}

CoarseSurface coarsened(const TriangleMesh& mesh, std::vector<char> kept, Index most)
{
  return Coarsening(mesh, std::move(kept)).run(most);
}

TriangleMesh fewTriangles(const TriangleMesh& mesh, Index most)
{
  std::vector<char> kept(mesh.vertexCount(), 0);
  const std::vector<char> creases = creasesOf(mesh, creaseCosine);
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    kept[mesh.from(h)] = kept[mesh.from(h)] || creases[h] ? 1 : 0;
  }
  return coarsened(mesh, std::move(kept), most).mesh;
}

std::optional<TriangleMesh> coarseVersion(const TriangleMesh& mesh)
{
  if (mesh.triangleCount() <= largeSurface)
  {
    return {};
  }
  TriangleMesh few = fewTriangles(mesh, 2 * largeSurface / 3);
  return few.triangleCount() < mostLeft * mesh.triangleCount() ? std::optional(std::move(few))
                                                               : std::nullopt;
}

std::vector<SuggestedCurve> movedCuts(
  const TriangleMesh& mesh, std::optional<SurfaceMirror>& mirror, std::vector<SuggestedCurve> cuts)
{
  if (mirror && mirror->plane())
  {
    mirror = SurfaceMirror(measuredPlane(mesh, *mirror->plane()));
  }
  const SeamDrawing drawing(mesh);
  const bool exact = mirror && mirror->plane() && mirror->error <= SurfaceMirror::exact;
  std::vector<SuggestedCurve> moved = cuts;
  for (std::size_t k = 0; k < cuts.size(); ++k)
  {
    const Points3& given = cuts[k].curve.points;
    Points3& points = moved[k].curve.points;
    if (exact && cuts[k].mirrorOf != none)
    {
      // Where a pair meets, in the plane, it still has to.
      const Points3& other = cuts[cuts[k].mirrorOf].curve.points;
      const Points3& first = moved[cuts[k].mirrorOf].curve.points;
      points = mirror->mirrored(first);
      points.front() = given.front() == other.front() ? first.front() : points.front();
      points.back() = given.back() == other.back() ? first.back() : points.back();
      continue;
    }
    points = drawing.moved(given);
    moved[k].length = polylineLength(points);
  }
  return laidTogether(mesh, std::move(moved));
}
}
