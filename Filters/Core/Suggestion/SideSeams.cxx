// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/SideSeams.h"

#include "Suggestion/CutTrials.h"
#include "Suggestion/OpeningCuts.h"
#include "Suggestion/SeamDrawing.h"
#include "Surface/EdgePaths.h"
#include "Surface/VertexFan.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// An edge that faces front or back counts for this many times more than one on the outline: of a
/// tube of equal width, a way along its side is then shorter than one across its front.
constexpr double facingPrice = 2.0;
/// Of a full turn, the other way than an outer edge: a short loop that turns by as much is no
/// opening, as cuffs of tight sleeves are, which turn less.
constexpr double shortTurn = 0.5;
/// In sqrt(area / pi): an opening whose center is this near to the mirror plane is its own image.
constexpr double nearPlane = 0.1;

/// An opening and where it lies.
struct Opening
{
  Indices loop; ///< half-edges
  Point3 center = Point3::Zero();
  double angle = 0.0; ///< around the axis that points to the front
};

class SideSeams
{
public:
  SideSeams(const TriangleMesh& mesh, const std::optional<SurfaceMirror>& mirror)
    : Mesh(mesh)
    , Mirror(mirror && mirror->plane() ? mirror : std::nullopt)
    , Moments(momentsOf(mesh))
    , Barred(mesh.vertexCount(), 0)
    , Drawing(mesh)
  {
    this->findFrame();
    this->findOpenings();
    for (Index h = 0; h < mesh.halfedgeCount(); ++h)
    {
      const Index twin = mesh.twin(h);
      Point3 normal = this->areaNormal(h / 3);
      normal += twin == none ? Point3::Zero() : this->areaNormal(twin / 3);
      const double facing = std::abs(this->Front.dot(normal.normalized()));
      this->Costs.push_back((1.0 + facingPrice * facing) * mesh.length(h));
    }
  }

  std::vector<SuggestedCurve> run()
  {
    const auto count = static_cast<Index>(this->Openings.size());
    const auto loops = static_cast<Index>(this->Mesh.boundaryLoops().size());
    if (count < 2 || eulerCharacteristic(this->Mesh) != 2 - loops)
    {
      return {};
    }
    const bool found = count == 2 ? this->joinTwo()
      : this->Mirror              ? this->joinMirrored()
                                  : this->joinAround();
    return found ? std::move(this->Seams) : std::vector<SuggestedCurve>();
  }

private:
  Point3 areaNormal(Index triangle) const
  {
    const auto& [a, b, c] = this->Mesh.triangle(triangle);
    return areaVector(this->Mesh.point(a), this->Mesh.point(b), this->Mesh.point(c));
  }

  void findFrame()
  {
    this->Front = this->Moments.axes.col(0);
    this->Side = this->Moments.axes.col(1);
    if (this->Mirror)
    {
      this->Side = this->Mirror->plane()->normal;
      const bool across = std::abs(this->Front.dot(this->Side)) > std::sqrt(0.5);
      const Point3 axis = this->Moments.axes.col(across ? 1 : 0);
      this->Front = (axis - axis.dot(this->Side) * this->Side).normalized();
    }
    this->Up = this->Front.cross(this->Side);
  }

  void findOpenings()
  {
    Index tubeEnds = 0;
    double longest = 0.0;
    for (const Indices& loop : this->Mesh.boundaryLoops())
    {
      Opening opening;
      opening.loop = loop;
      double length = 0.0;
      for (Index h : loop)
      {
        const Point3 middle =
          0.5 * (this->Mesh.point(this->Mesh.from(h)) + this->Mesh.point(this->Mesh.to(h)));
        opening.center += this->Mesh.length(h) * middle;
        length += this->Mesh.length(h);
      }
      opening.center /= length;
      longest = std::max(longest, length); // the first
      const double turn = turnOf(this->Mesh, loop) / (2.0 * pi);
      if (turn <= -shortTurn && length < shortLoop * longest)
      {
        continue;
      }
      tubeEnds += turn > -minHoleTurn ? 1 : 0;
      // From below upwards on the one side, and down on the other.
      const Point3 out = opening.center - this->Moments.center;
      opening.angle = std::atan2(this->Side.dot(out), -this->Up.dot(out));
      this->Openings.push_back(std::move(opening));
    }
    if (tubeEnds < 2)
    {
      this->Openings.clear(); // no tube
    }
    std::stable_sort(this->Openings.begin(), this->Openings.end(),
      [](const Opening& a, const Opening& b) { return a.angle < b.angle; });
  }

  double sideOf(const Point3& point) const
  {
    return this->Mirror ? this->Mirror->side(point) : this->Side.dot(point - this->Moments.center);
  }

  /// Along one side and along the other.
  bool joinTwo()
  {
    const Opening& a = this->Openings[0];
    const Opening& b = this->Openings[1];
    return this->Mirror
      ? this->joinTwice(a, b)
      : this->join(a, b, this->barredBut(1.0)) && this->join(a, b, this->barredBut(-1.0));
  }

  /// All but the vertices on one side, and what seams bar.
  std::vector<char> barredBut(double side) const
  {
    std::vector<char> barred = this->Barred;
    for (Index v = 0; v < this->Mesh.vertexCount(); ++v)
    {
      barred[v] = barred[v] || side * this->sideOf(this->Mesh.point(v)) <= 0.0 ? 1 : 0;
    }
    return barred;
  }

  /// On one side of the plane, and the image, which is drawn on the surface where the mirror is not
  /// exact.
  bool joinTwice(const Opening& from, const Opening& to)
  {
    if (!this->join(from, to, this->barredBut(1.0)))
    {
      return false;
    }
    addImages(this->Seams, static_cast<Index>(this->Seams.size()) - 1, *this->Mirror);
    if (this->Mirror->error > SurfaceMirror::exact)
    {
      SuggestedCurve& image = this->Seams.back();
      std::vector<SurfacePoint> chain = this->Drawing.place(image.curve.points);
      chain.front() = this->boundaryPoint(image.curve.points.front());
      chain.back() = this->boundaryPoint(image.curve.points.back());
      image.curve.points = this->Drawing.draw(chain, 0);
      image.length = polylineLength(image.curve.points);
    }
    return true;
  }

  SurfacePoint boundaryPoint(const Point3& near) const
  {
    Index nearest = none;
    for (const Opening& opening : this->Openings)
    {
      for (Index h : opening.loop)
      {
        const Index v = this->Mesh.from(h);
        if (nearest == none ||
          (this->Mesh.point(v) - near).norm() < (this->Mesh.point(nearest) - near).norm())
        {
          nearest = v;
        }
      }
    }
    return vertexPoint(this->Mesh, nearest);
  }

  bool joinAround()
  {
    for (std::size_t k = 0; k < this->Openings.size(); ++k)
    {
      const Opening& next = this->Openings[(k + 1) % this->Openings.size()];
      if (!this->join(this->Openings[k], next, this->Barred))
      {
        return false;
      }
    }
    return true;
  }

  /// The openings of one side from below upwards, between those in the plane or across it.
  bool joinMirrored()
  {
    const double near = nearPlane * std::sqrt(this->Moments.area / pi);
    std::vector<const Opening*> side;
    const Opening* lowest = nullptr;
    const Opening* highest = nullptr;
    for (const Opening& opening : this->Openings)
    {
      const double distance = this->sideOf(opening.center);
      if (distance > near)
      {
        side.push_back(&opening); // in the order of angles
      }
      else if (distance >= -near)
      {
        const Opening*& place = std::abs(opening.angle) < 0.5 * pi ? lowest : highest;
        if (place)
        {
          return false; // two in the plane above each other
        }
        place = &opening;
      }
    }
    const std::size_t central = (lowest ? 1 : 0) + (highest ? 1 : 0);
    if (side.empty() || 2 * side.size() + central != this->Openings.size())
    {
      return false;
    }
    if (lowest)
    {
      side.insert(side.begin(), lowest);
    }
    if (highest)
    {
      side.push_back(highest);
    }
    for (std::size_t k = 0; k + 1 < side.size(); ++k)
    {
      if (!this->joinTwice(*side[k], *side[k + 1]))
      {
        return false;
      }
    }
    return (lowest || this->joinImage(*side.front())) && (highest || this->joinImage(*side.back()));
  }

  /// An opening and its image, across the plane.
  bool joinImage(const Opening& opening)
  {
    const auto image = std::min_element(this->Openings.begin(), this->Openings.end(),
      [place = this->Mirror->mirrored(opening.center)](const Opening& a, const Opening& b) {
        return (a.center - place).norm() < (b.center - place).norm();
      });
    return &*image != &opening && this->join(opening, *image, this->Barred);
  }

  /// The shortest way from one opening to another, which no later one may meet.
  bool join(const Opening& from, const Opening& to, const std::vector<char>& barred)
  {
    Indices starts;
    for (Index h : from.loop)
    {
      if (!barred[this->Mesh.from(h)])
      {
        starts.push_back(this->Mesh.from(h));
      }
    }
    const EdgePaths paths(this->Mesh, starts, barred, EdgePaths::Through::Inside, this->Costs);
    Index end = none;
    for (Index h : to.loop)
    {
      const Index v = this->Mesh.from(h);
      if (!barred[v] && paths.reaches(v) &&
        (end == none || paths.distance(v) < paths.distance(end)))
      {
        end = v;
      }
    }
    if (end == none)
    {
      return false;
    }
    std::vector<SurfacePoint> chain;
    for (Index v : paths.path(end))
    {
      this->Barred[v] = 1;
      chain.push_back(vertexPoint(this->Mesh, v));
    }
    this->Seams.push_back(proposedCut(this->Drawing.draw(chain, 0)));
    return true;
  }

  const TriangleMesh& Mesh;
  std::optional<SurfaceMirror> Mirror; ///< where it is a plane
  SurfaceMoments Moments;
  Point3 Front;
  Point3 Side;
  Point3 Up;
  std::vector<Opening> Openings; ///< around the axis to the front
  std::vector<double> Costs;     ///< by half-edge
  std::vector<char> Barred;      ///< by vertex: on a seam
  SeamDrawing Drawing;
  std::vector<SuggestedCurve> Seams;
};
}

std::vector<SuggestedCurve> sideSeams(
  const TriangleMesh& mesh, const std::optional<SurfaceMirror>& mirror)
{
  return SideSeams(mesh, mirror).run();
}
}
