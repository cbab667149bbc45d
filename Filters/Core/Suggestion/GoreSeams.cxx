// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/GoreSeams.h"

#include "Paths/PlaneSection.h"
#include "Sparse/LinearSolver.h"
#include "Suggestion/CutThinning.h"
#include "Suggestion/SurfaceMirror.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace flattening
{
namespace
{
/// Planes at multiples of this angle mirror no prism or pyramid, in units of pi: the golden
/// section.
constexpr double irregular = 0.6180339887498949;
constexpr int planesTried = 5;
/// An axis lies in a plane if the sine of the angle between them is below this.
constexpr double inPlane = 1e-3;
/// No more gores are tried of a surface of revolution: 46 hold a ball to 0.3 %. Where they are
/// unequal, other seams do better by then.
constexpr double maxEqualGores = 48.0;
constexpr double maxGores = 12.0;
/// A trial is given up after these steps where more gores may follow: of shapes by formula sets
/// within twice the bound took 5 to 40, and those far from it up to 1,200.
constexpr double maxGoreSteps = 75.0;
/// No more are tried where the forecast is this many times the most.
constexpr double hopelessGores = 1.5;
/// Where as many gores as were to be enough would have to be this many times as many, the surface
/// is not round.
constexpr double offLaw = 1.5;
/// Half planes at this many angles tell whether there are gores.
constexpr int halvesTried = 12;
/// Ends of sections this near to each other, in sqrt(area / pi), are one point on the axis.
constexpr double samePole = 1e-9;
/// A point is on a line from which it is no farther, in sqrt(area / pi).
constexpr double samePlace = 1e-4;

Point3 onAxis(const Point3& a, double sideOfA, const Point3& b, double sideOfB)
{
  return a + sideOfA / (sideOfA - sideOfB) * (b - a);
}

bool isLoop(const Points3& line)
{
  return line.front() == line.back();
}

/// A loop from where it is nearest to an axis in the plane through the center across it.
/// Empty where it is not cut there.
Points3 fromInside(Points3 loop, const Point3& center, const Point3& axis)
{
  loop.pop_back();
  std::size_t first = loop.size();
  Point3 start;
  double least = 0.0;
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    const Point3& next = loop[(k + 1) % loop.size()];
    const double here = axis.dot(loop[k] - center);
    const double there = axis.dot(next - center);
    if ((here > 0.0) == (there > 0.0))
    {
      continue;
    }
    const Point3 crossing = onAxis(loop[k], here, next, there);
    const double arm = axis.cross(crossing - center).norm();
    if (first == loop.size() || arm < least)
    {
      first = k;
      start = crossing;
      least = arm;
    }
  }
  if (first == loop.size())
  {
    return {};
  }
  std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(first) + 1, loop.end());
  Points3 line{ start };
  std::copy_if(loop.begin(), loop.end(), std::back_inserter(line),
    [&](const Point3& point) { return (point - start).norm() > 0.0; });
  line.push_back(start);
  return line;
}

/// The stretches of a section on the positive side of a plane, which begin and end in it, and loops
/// there.
void addHalves(
  const PlaneSection& section, const SymmetryPlane& across, std::vector<Points3>& halves)
{
  Points3 points = positionsOf(section.path.points);
  if (section.closed)
  {
    points.pop_back();
    const auto outside = std::find_if(
      points.begin(), points.end(), [&](const Point3& p) { return across.side(p) <= 0.0; });
    if (outside == points.end())
    {
      points.push_back(points.front());
      halves.push_back(std::move(points));
      return;
    }
    std::rotate(points.begin(), outside, points.end());
    points.push_back(points.front());
  }
  Points3 half;
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    const double side = across.side(points[k]);
    const double before = k > 0 ? across.side(points[k - 1]) : side;
    if ((side > 0.0) != (before > 0.0))
    {
      half.push_back(onAxis(points[k - 1], before, points[k], side));
    }
    if (side > 0.0)
    {
      half.push_back(points[k]);
    }
    if ((side <= 0.0 || k + 1 == points.size()) && half.size() > 1)
    {
      halves.push_back(std::move(half));
      half.clear();
    }
  }
}

class GoreSeams
{
public:
  GoreSeams(
    const TriangleMesh& mesh, SymmetryPlane plane, const Point3& axis, const Point3& center);

  /// The axes about which there are gores: that of a surface of revolution alone.
  static std::vector<GoreSeams> find(const TriangleMesh& mesh, const SymmetryPlane& plane);
  /// The seams between this number of gores. Empty where one of them does not go from end to end.
  std::vector<SuggestedCurve> seams(Index gores) const;
  /// Gores that are disks: two of a closed surface that is no ring.
  Index fewest() const { return this->Fewest; }
  /// Whether it is a surface of revolution.
  bool equal() const { return this->Angles.empty(); }
  const SymmetryPlane& plane() const { return this->Plane; }

private:
  double turnOf(const Point3& point) const;
  void measureGirth();
  double angleOf(double share) const;
  std::vector<Points3> halfSections(double angle) const;
  Points3 innerArc(const Point3& from, const Point3& to) const;

  const TriangleMesh* Mesh;
  SymmetryPlane Plane;
  Point3 Axis;
  Point3 Center;
  Point3 Ahead; ///< in the plane, across the axis
  Index Fewest;
  bool Ring = false;
  /// Round the middle from Ahead on, and the shares of its length there.
  std::vector<double> Angles;
  std::vector<double> Shares;
};

GoreSeams::GoreSeams(
  const TriangleMesh& mesh, SymmetryPlane plane, const Point3& axis, const Point3& center)
  : Mesh(&mesh)
  , Plane(std::move(plane))
  , Axis(axis)
  , Center(center)
  , Ahead(this->Plane.normal.cross(axis))
  , Fewest(mesh.boundaryLoops().empty() ? 2 : 1)
{
}

std::vector<GoreSeams> GoreSeams::find(const TriangleMesh& mesh, const SymmetryPlane& plane)
{
  const SurfaceMoments moments = momentsOf(mesh);
  const auto through = [&](const Point3& normal) {
    SymmetryPlane tried;
    tried.normal = normal;
    tried.offset = normal.dot(moments.center);
    return measuredPlane(mesh, tried);
  };
  std::vector<Point3> axes{ Point3::UnitZ(), Point3::UnitY(), Point3::UnitX() };
  for (Eigen::Index k = 0; k < 3; ++k)
  {
    axes.emplace_back(moments.axes.col(k));
  }
  std::vector<GoreSeams> all;
  for (const Point3& axis : axes)
  {
    const bool within = std::abs(axis.dot(plane.normal)) < inPlane;
    const bool known = std::any_of(all.begin(), all.end(),
      [&](const GoreSeams& other) { return axis.cross(other.Axis).norm() < inPlane; });
    const Point3 first = within ? plane.normal : axis.unitOrthogonal();
    bool equal = true;
    for (int k = within ? 1 : 0; k < planesTried && equal && !known; ++k)
    {
      const double angle = k * irregular * pi;
      equal = through(std::cos(angle) * first + std::sin(angle) * axis.cross(first)).spread <
        mirrorTolerance;
    }
    if (known || !(equal || within))
    {
      continue;
    }
    GoreSeams gores(mesh, within ? plane : through(first), axis, moments.center);
    bool whole = true;
    for (int k = 0; k < halvesTried && whole; ++k)
    {
      const std::vector<Points3> halves = gores.halfSections(2.0 * pi * k / halvesTried);
      whole = halves.size() == 1 && (k == 0 || isLoop(halves.front()) == gores.Ring);
      gores.Ring = whole && isLoop(halves.front());
    }
    gores.Fewest = gores.Ring ? 1 : gores.Fewest;
    if (whole && equal)
    {
      return { gores };
    }
    if (whole)
    {
      gores.measureGirth();
      all.push_back(std::move(gores));
    }
  }
  return all;
}

/// Round the axis, from Ahead on.
double GoreSeams::turnOf(const Point3& point) const
{
  const Point3 arm = point - this->Center;
  return std::atan2(this->Plane.normal.dot(arm), this->Ahead.dot(arm));
}

/// The line in which the plane across the axis cuts the surface, once round it from Ahead on.
/// Nothing where there is none; gores have equal angles then.
void GoreSeams::measureGirth()
{
  for (const PlaneSection& section : planeSections(*this->Mesh, this->Center, this->Axis))
  {
    std::vector<double> turns;
    std::vector<double> lengths;
    const std::vector<SurfacePoint>& points = section.path.points;
    for (std::size_t k = 0; k < points.size(); ++k)
    {
      turns.push_back(this->turnOf(points[k].position));
      lengths.push_back(
        k == 0 ? 0.0 : lengths.back() + (points[k].position - points[k - 1].position).norm());
      turns[k] += k == 0 ? 0.0 : 2.0 * pi * std::round((turns[k - 1] - turns[k]) / (2.0 * pi));
    }
    const double round = turns.back() - turns.front();
    if (!section.closed || std::abs(std::abs(round) - 2.0 * pi) > inPlane)
    {
      continue;
    }
    if (round < 0.0)
    {
      std::reverse(turns.begin(), turns.end());
      std::reverse(lengths.begin(), lengths.end());
    }
    // Twice round, so that all angles from 0 on are there.
    const double whole = lengths.back() - lengths.front();
    for (int times : { 0, 1 })
    {
      for (std::size_t k = times; k < turns.size(); ++k)
      {
        this->Angles.push_back(turns[k] + 2.0 * pi * times);
        this->Shares.push_back((lengths[k] - lengths.front()) / whole + times);
      }
    }
    return;
  }
}

/// The angle up to which the girth has a share of its length.
double GoreSeams::angleOf(double share) const
{
  const auto between = [](
                         const std::vector<double>& from, const std::vector<double>& to, double x) {
    const auto next = std::upper_bound(from.begin() + 1, from.end() - 1, x) - from.begin();
    const double part = (x - from[next - 1]) / (from[next] - from[next - 1]);
    return to[next - 1] + part * (to[next] - to[next - 1]);
  };
  if (this->Angles.empty())
  {
    return 2.0 * pi * share;
  }
  const double begin = this->Angles.front() > 0.0 ? 2.0 * pi : 0.0;
  return between(this->Shares, this->Angles, between(this->Angles, this->Shares, begin) + share);
}

/// Where the half plane at an angle from the mirror plane cuts the surface: of a ring a loop, from
/// its inside on.
std::vector<Points3> GoreSeams::halfSections(double angle) const
{
  const Point3 normal = std::cos(angle) * this->Plane.normal - std::sin(angle) * this->Ahead;
  SymmetryPlane across;
  across.normal = normal.cross(this->Axis);
  across.offset = across.normal.dot(this->Center);
  std::vector<Points3> halves;
  for (const PlaneSection& section : planeSections(*this->Mesh, this->Center, normal))
  {
    if (section.path.points.size() > 1)
    {
      addHalves(section, across, halves);
    }
  }
  for (Points3& half : halves)
  {
    half = isLoop(half) ? fromInside(std::move(half), this->Center, this->Axis) : half;
  }
  halves.erase(std::remove(halves.begin(), halves.end(), Points3()), halves.end());
  return halves;
}

/// Along the inside of a ring, between starts of its half sections. Empty where there is no such
/// line.
Points3 GoreSeams::innerArc(const Point3& from, const Point3& to) const
{
  const auto onwards = [&](const Point3& point) {
    const double turn = this->turnOf(point) - this->turnOf(from);
    return turn > 0.0 ? turn : turn + 2.0 * pi;
  };
  const double whole = onwards(to);
  // Sections go through vertices that are near their plane, so the start lies only nearly on one.
  double nearest = samePlace * std::sqrt(this->Mesh->area() / pi);
  Points3 arc;
  for (const PlaneSection& section : planeSections(*this->Mesh, this->Center, this->Axis))
  {
    std::vector<std::pair<double, Point3>> between;
    double off = nearest;
    const std::vector<SurfacePoint>& points = section.path.points;
    for (std::size_t k = 1; k < points.size(); ++k)
    {
      const Point3& a = points[k - 1].position;
      const Point3& b = points[k].position;
      off = std::min(off, (from - a).norm() + (from - b).norm() - (b - a).norm());
      if (onwards(b) > inPlane * whole && onwards(b) < (1.0 - inPlane) * whole)
      {
        between.emplace_back(onwards(b), b);
      }
    }
    if (off < nearest)
    {
      nearest = off;
      std::sort(between.begin(), between.end(),
        [](const auto& one, const auto& other) { return one.first < other.first; });
      arc = { from };
      for (const auto& [turn, point] : between)
      {
        arc.push_back(point);
      }
      arc.push_back(to);
    }
  }
  return arc;
}

std::vector<SuggestedCurve> GoreSeams::seams(Index gores) const
{
  std::vector<SuggestedCurve> cuts;
  Points3 poles;
  Points3 starts(gores);
  const double near = samePole * std::sqrt(this->Mesh->area() / pi);
  const auto add = [&](Points3 points, Index mirrorOf) {
    for (Point3* end : { &points.front(), &points.back() })
    {
      const auto pole = std::find_if(
        poles.begin(), poles.end(), [&](const Point3& p) { return (p - *end).norm() < near; });
      if (pole == poles.end())
      {
        poles.push_back(*end);
      }
      else
      {
        *end = *pole;
      }
    }
    cuts.push_back(proposedCut(std::move(points), CurveType::Seam, mirrorOf));
  };
  for (Index k = 0; 2 * k <= gores; ++k)
  {
    const double angle = this->angleOf(static_cast<double>(k) / static_cast<double>(gores));
    const std::vector<Points3> halves = this->halfSections(angle);
    if (halves.size() != 1)
    {
      return {};
    }
    starts[k] = halves.front().front();
    add(halves.front(), none);
    if (k == 0 || 2 * k == gores)
    {
      continue;
    }
    Points3 image;
    if (this->Plane.error <= SurfaceMirror::exact)
    {
      image = this->Plane.mirrored(halves.front());
    }
    else
    {
      const std::vector<Points3> others = this->halfSections(-angle);
      if (others.size() != 1)
      {
        return {};
      }
      image = others.front();
    }
    starts[gores - k] = image.front();
    add(std::move(image), static_cast<Index>(cuts.size()) - 1);
  }
  for (Index k = 0; this->Ring && 2 * k < gores; ++k)
  {
    const Index last = gores - 1 - k;
    Points3 arc = this->innerArc(starts[k], starts[(k + 1) % gores]);
    Points3 image = this->innerArc(starts[last], starts[(last + 1) % gores]);
    if (arc.empty() || image.empty())
    {
      return {};
    }
    add(std::move(arc), none);
    if (k != last)
    {
      std::reverse(image.begin(), image.end());
      add(std::move(image), static_cast<Index>(cuts.size()) - 1);
    }
  }
  return cuts;
}

CutSet fewestGores(const GoreSeams& gores, double triangles, const CutTrials& trials,
  const SearchOptions& wanted, TrialBudget& budget, const Execution& execution)
{
  double most = gores.equal() ? maxEqualGores : maxGores;
  most = wanted.maximumCuts > 0 ? std::min<double>(most, wanted.maximumCuts) : most;
  const auto tried = [&](Index count) {
    CutSet set;
    set.cuts = gores.seams(count);
    set.end = SearchEnd::BoundMet;
    if (!set.cuts.empty())
    {
      const bool last = wanted.pieces > 0 || (wanted.maximumCuts > 0 && count + 1 > most);
      TrialBudget some(
        last ? budget.left() : std::min(budget.left(), maxGoreSteps * factorizationWork(triangles)),
        budget);
      set.outcome = trials.run(linesOf(set.cuts), some, execution);
    }
    return set;
  };
  const auto misses = [&](const CutSet& set) {
    return !set.cuts.empty() && !set.outcome.keeps(wanted.bound);
  };
  Index count = std::max(gores.fewest(), wanted.pieces);
  Index missed = count - 1;                                  // this number misses the bound
  double forecast = std::numeric_limits<double>::infinity(); // number that keeps it
  CutSet set = tried(count);
  while (misses(set) && wanted.pieces == 0 && !budget.spent() && !execution.cancelled())
  {
    // The strain of a narrow gore goes with the square of its width, where the surface is round.
    const double needed =
      set.outcome.valid ? count * std::sqrt(set.outcome.strainP95 / wanted.bound) : 2.0 * count;
    if (needed > offLaw * count && count >= forecast)
    {
      return wanted.maximumCuts > 0 ? set : CutSet();
    }
    forecast = needed;
    missed = count;
    count = std::max(count + 1, static_cast<Index>(std::min(needed, most)));
    if (count > most || (wanted.maximumCuts == 0 && needed > hopelessGores * most))
    {
      return wanted.maximumCuts > 0 ? set : CutSet();
    }
    set = tried(count);
  }
  while (set.outcome.valid && !misses(set) && count - 1 > missed)
  {
    CutSet fewer = tried(--count);
    if (!fewer.outcome.valid || misses(fewer))
    {
      break;
    }
    set = std::move(fewer);
  }
  return set;
}
}

Gores findGores(const TriangleMesh& mesh, const SymmetryPlane& plane, const CutTrials& trials,
  const SearchOptions& wanted, TrialBudget& budget, const Execution& execution)
{
  Gores best;
  // Of the bound by length; of a number by strain.
  const auto merit = [&wanted](const CutSet& set) {
    const double strain = set.outcome.strainP95;
    return wanted.pieces > 0 || strain > wanted.bound ? std::pair(1, strain)
                                                      : std::pair(0, set.outcome.cutLength());
  };
  for (const GoreSeams& gores : GoreSeams::find(mesh, plane))
  {
    if (wanted.symmetric != "on" && gores.plane().normal != plane.normal)
    {
      continue; // another plane than the one that was stated
    }
    CutSet set = fewestGores(
      gores, static_cast<double>(mesh.triangleCount()), trials, wanted, budget, execution);
    if (set.outcome.valid && (best.set.cuts.empty() || merit(set) < merit(best.set)))
    {
      best = { std::move(set), gores.plane(), gores.equal() };
    }
  }
  return best;
}
}
