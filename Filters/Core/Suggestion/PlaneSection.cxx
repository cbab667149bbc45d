// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/PlaneSection.h"

#include <cmath>

namespace flattening
{
namespace
{
/// Crossings this near to a vertex, in edge lengths, are the vertex.
constexpr double snapFraction = 1e-3;

/// Follows the section from triangle to triangle, above on its left.
class Section
{
public:
  Section(const TriangleMesh& mesh, const MirrorPlane& plane)
    : Mesh(mesh)
    , Visited(mesh.triangleCount(), 0)
  {
    for (const Point3& p : mesh.points())
    {
      this->Side.push_back(plane.side(p));
    }
  }

  std::vector<Polyline> run()
  {
    std::vector<Polyline> loops;
    for (Index t = 0; t < this->Mesh.triangleCount(); ++t)
    {
      if (this->Visited[t] || this->leaving(t) == none)
      {
        continue;
      }
      Polyline loop;
      loop.type = CurveType::Seam;
      if (this->follow(t, loop.points) && loop.points.size() > 3)
      {
        loops.push_back(std::move(loop));
      }
    }
    return loops;
  }

private:
  bool above(Index vertex) const { return this->Side[vertex] >= 0.0; }

  /// The half-edge over which the section leaves a triangle; none where it does not cross it.
  Index leaving(Index t) const
  {
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
    {
      if (!this->above(this->Mesh.from(h)) && this->above(this->Mesh.to(h)))
      {
        return h;
      }
    }
    return none;
  }

  /// True where it comes back to its first triangle.
  bool follow(Index first, Points3& points)
  {
    Index t = first;
    do
    {
      this->Visited[t] = 1;
      const Index h = this->leaving(t);
      const Point3 crossing = this->crossing(h);
      if (points.empty() || crossing != points.back())
      {
        points.push_back(crossing);
      }
      if (this->Mesh.twin(h) == none)
      {
        return false;
      }
      t = this->Mesh.twin(h) / 3;
    } while (t != first);
    if (points.front() != points.back())
    {
      points.push_back(points.front());
    }
    return true;
  }

  Point3 crossing(Index h) const
  {
    const Index a = this->Mesh.from(h);
    const Index b = this->Mesh.to(h);
    const double fraction = this->Side[a] / (this->Side[a] - this->Side[b]);
    if (fraction < snapFraction || fraction > 1.0 - snapFraction)
    {
      return this->Mesh.point(fraction < 0.5 ? a : b);
    }
    return this->Mesh.point(a) + fraction * (this->Mesh.point(b) - this->Mesh.point(a));
  }

  const TriangleMesh& Mesh;
  std::vector<double> Side;
  std::vector<char> Visited;
};
}

std::vector<Polyline> sectionLoops(const TriangleMesh& mesh, const MirrorPlane& plane)
{
  return Section(mesh, plane).run();
}
}
