// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/StraightLoop.h"

#include "Base/Memory.h"
#include "Paths/CourseStraightening.h"
#include "Paths/PathPoints.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
constexpr int mostMovesOfBase = 1000;
constexpr int baseHalvings = 100;
/// A base so near to an end of its edge, as a fraction, is there.
constexpr double atEnd = 1e-9;
/// A band that is so much shorter than it was is drawn together to a point.
constexpr double vanishing = 1e-9;

class RubberBand
{
public:
  RubberBand(const TriangleMesh& mesh, SurfacePath loop)
    : Mesh(mesh)
    , Loop(std::move(loop))
    , First(lengthOf(this->Loop))
  {
  }

  StraightPath run()
  {
    StraightPath result;
    int rounds = 0;
    do
    {
      this->tighten();
    } while (!this->vanished() && this->moveBase() && ++rounds < mostMovesOfBase);
    result.path = this->Loop;
    result.length = lengthOf(result.path);
    if (this->vanished())
    {
      result.status = { StatusCode::CurveTooShort,
        "a loop can be drawn together to a point of the surface", {}, { Remedy::RedrawCurve } };
    }
    else if (rounds == mostMovesOfBase || !this->Bent.empty())
    {
      result.status = { StatusCode::NotConverged,
        "a loop is not straight at points " + listIds(this->Bent),
        { ElementKind::Points, this->Bent }, { Remedy::MendSlivers } };
    }
    return result;
  }

private:
  bool vanished() const
  {
    return this->Loop.points.size() < 3 || lengthOf(this->Loop) < vanishing * this->First;
  }

  /// Draws the band tight, held at its base.
  void tighten()
  {
    this->Course = courseAlong(this->Mesh, this->Loop);
    this->Bent = straighten(this->Mesh, this->Course);
    this->Loop = pathAlong(this->Mesh, this->Course);
  }

  /// Makes another point the base where the band is not straight at this one; false where it is at
  /// rest.
  bool moveBase()
  {
    const std::size_t knots = this->Course.knots.size();
    if (this->Loop.points.front().type == SurfacePointType::Vertex)
    {
      const GeodesicPath& c = this->Course;
      const KnotSide side = sharperSide(
        this->Mesh, c.knots[knots - 2], c.legs.back(), c.knots[0], c.legs.front(), c.knots[1]);
      if (!(side.angle < pi - straightAngle))
      {
        return false;
      }
    }
    // A knot far from the base, or else an edge to slide along.
    const std::size_t half = this->Loop.points.size() / 2;
    std::size_t base = 0;
    for (std::size_t i = 1; i + 1 < this->Loop.points.size(); ++i)
    {
      if (this->Loop.points[i].type == SurfacePointType::Vertex &&
        (base == 0 || apart(i, half) < apart(base, half)))
      {
        base = i;
      }
    }
    if (base > 0)
    {
      this->rotate(base);
      return true;
    }
    this->rotate(half);
    return this->Loop.points.front().type == SurfacePointType::Edge && this->slide();
  }

  static std::size_t apart(std::size_t a, std::size_t b) { return a < b ? b - a : a - b; }

  void rotate(std::size_t base)
  {
    SurfacePath turned = partOf(this->Loop, base, this->Loop.points.size() - 1);
    append(turned, partOf(this->Loop, 0, base));
    this->Loop = std::move(turned);
  }

  /// How fast the band gets longer as its base moves along the edge.
  double growth(const SurfacePath& loop, const Point3& along) const
  {
    const Point3& base = loop.points.front().position;
    const Point3 out = (loop.points[1].position - base).normalized();
    const Point3 in = (loop.points[loop.points.size() - 2].position - base).normalized();
    return -(out + in).dot(along);
  }

  SurfacePath heldAt(double fraction) const
  {
    SurfacePath loop = this->Loop;
    const Index edge = loop.points.front().id;
    loop.points.front() = edgePoint(this->Mesh, edge, fraction);
    loop.points.back() = loop.points.front();
    GeodesicPath course = courseAlong(this->Mesh, loop);
    straighten(this->Mesh, course);
    return pathAlong(this->Mesh, course);
  }

  /// The length is a convex function of where the base is on its edge. Moves the base to its
  /// minimum; to an end of the edge where that is none inside. True where the band is to be
  /// tightened again.
  bool slide()
  {
    const Index edge = this->Loop.points.front().id;
    const Point3 along =
      (this->Mesh.point(this->Mesh.to(edge)) - this->Mesh.point(this->Mesh.from(edge)))
        .normalized();
    double low = 0.0;
    double high = 1.0;
    for (int k = 0; k < baseHalvings && high - low > 1e-16 && low < 1.0 - atEnd && high > atEnd;
         ++k)
    {
      const double middle = 0.5 * (low + high);
      const SurfacePath loop = this->heldAt(middle);
      if (loop.points.size() < 3)
      {
        this->Loop = loop;
        return false;
      }
      (this->growth(loop, along) > 0.0 ? high : low) = middle;
    }
    const double best = 0.5 * (low + high);
    if (best > atEnd && best < 1.0 - atEnd)
    {
      this->Loop = this->heldAt(best);
      return false;
    }
    const SurfacePoint end =
      vertexPoint(this->Mesh, best < 0.5 ? this->Mesh.from(edge) : this->Mesh.to(edge));
    this->Loop.points.front() = end;
    this->Loop.points.back() = end;
    return true;
  }

  const TriangleMesh& Mesh;
  SurfacePath Loop;
  GeodesicPath Course;
  Indices Bent;
  double First;
};

Status checkLoop(const TriangleMesh& mesh, const SurfacePath& loop)
{
  if (!liesOn(mesh, loop) || loop.points.size() < 3 ||
    !samePlace(loop.points.front(), loop.points.back()))
  {
    return { StatusCode::InvalidCurve, "a loop is no closed path over the surface", {},
      { Remedy::RedrawCurve } };
  }
  return {};
}
}

StraightPath straightLoop(const PathGraph& graph, const SurfacePath& loop)
{
  return withinMemory([&] {
    StraightPath result;
    result.status = checkLoop(graph.mesh(), loop);
    return result.status.ok() ? RubberBand(graph.mesh(), loop).run() : result;
  });
}
}
