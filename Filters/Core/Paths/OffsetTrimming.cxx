// SPDX-License-Identifier: BSD-3-Clause
#include "Paths/OffsetTrimming.h"

#include "Paths/NearbyLegs.h"
#include "Paths/PathCrossings.h"
#include "Paths/PathPoints.h"
#include "Paths/StraightPath.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace flattening
{
namespace
{
/// What is nearer than the distance by this fraction is, beyond rounding; and so many times the
/// fraction that vertices of the mesh make.
constexpr double rounding = 1e-10;
constexpr double beyondShortcut = 4.0;
/// A loop shorter than this fraction of the distance is no part of the offset, whatever its points.
constexpr double knot = 0.1;
/// Ends of arcs nearer to each other, as a fraction of the distance, are one.
constexpr double sameEnd = 1e-9;
constexpr int trimHalvings = 50;

/// Where an offset is cut, and on which sides of that it is nearer to the source.
struct Cut
{
  PathPlace place;
  SurfacePoint point;
  bool nearBefore = false;
  bool nearAfter = false;
};

class OffsetTrimming
{
public:
  OffsetTrimming(
    const PathGraph& graph, const SurfacePath& source, double distance, double shortcut)
    : Graph(graph)
    , Source(source)
    , SourceLegs(source, distance)
    , Distance(distance)
    , Nearer(rounding + beyondShortcut * shortcut)
  {
  }

  std::vector<SurfacePath> run(
    const std::vector<SurfacePath>& offset, const std::vector<SurfacePath>& others) const
  {
    const std::vector<std::vector<Cut>> cuts = this->cuts(offset, others);
    std::vector<SurfacePath> arcs;
    for (std::size_t p = 0; p < offset.size(); ++p)
    {
      for (const SurfacePath& arc : this->arcs(offset[p], cuts[p]))
      {
        for (SurfacePath& part : this->withoutStretches(arc))
        {
          arcs.push_back(std::move(part));
        }
      }
    }
    return this->joined(arcs);
  }

private:
  /// Of each part of the offset, in its order.
  std::vector<std::vector<Cut>> cuts(
    const std::vector<SurfacePath>& offset, const std::vector<SurfacePath>& others) const
  {
    std::vector<SurfacePath> paths = offset;
    paths.insert(paths.end(), others.begin(), others.end());
    std::vector<std::vector<double>> lengths;
    for (const SurfacePath& path : offset)
    {
      lengths.push_back(lengthsTo(path));
    }
    std::vector<std::vector<Cut>> cuts(offset.size());
    for (const PathCrossing& crossing : pathCrossings(this->Graph.mesh(), paths, offset.size()))
    {
      // What lies on the right of either path is nearer to the source.
      bool firstEnds = crossing.turn > 0.0;
      const PathPlace& first = crossing.first;
      const PathPlace& second = crossing.second;
      if (first.path == second.path)
      {
        const std::vector<double>& to = lengths[first.path];
        firstEnds = firstEnds || to[second.leg] - to[first.leg + 1] <= knot * this->Distance;
      }
      cuts[first.path].push_back({ first, crossing.point, !firstEnds, firstEnds });
      if (second.path < offset.size())
      {
        cuts[second.path].push_back({ second, crossing.point, firstEnds, !firstEnds });
      }
    }
    for (std::vector<Cut>& some : cuts)
    {
      std::stable_sort(some.begin(), some.end(), [](const Cut& a, const Cut& b) {
        return std::tie(a.place.leg, a.place.along) < std::tie(b.place.leg, b.place.along);
      });
    }
    return cuts;
  }

  /// Between cuts; without those that are nearer at an end.
  std::vector<SurfacePath> arcs(const SurfacePath& path, const std::vector<Cut>& cuts) const
  {
    if (cuts.empty())
    {
      return { path };
    }
    const std::size_t legs = path.triangles.size();
    std::vector<SurfacePath> arcs;
    for (std::size_t k = 0; k <= cuts.size(); ++k)
    {
      if ((k > 0 && cuts[k - 1].nearAfter) || (k < cuts.size() && cuts[k].nearBefore))
      {
        continue;
      }
      const Cut begin = k > 0 ? cuts[k - 1] : Cut{ { 0, 0, 0.0 }, path.points.front() };
      const Cut end = k < cuts.size() ? cuts[k] : Cut{ { 0, legs - 1, 1.0 }, path.points.back() };
      SurfacePath arc;
      arc.points = { begin.point };
      for (std::size_t i = begin.place.leg; i <= end.place.leg; ++i)
      {
        const SurfacePoint& next = i < end.place.leg ? path.points[i + 1] : end.point;
        if (next.position != arc.points.back().position)
        {
          arc.points.push_back(next);
          arc.triangles.push_back(path.triangles[i]);
        }
      }
      if (lengthOf(arc) > sameEnd * this->Distance)
      {
        this->dropSplinters(arc);
        arc.arrived = true;
        arcs.push_back(std::move(arc));
      }
    }
    return arcs;
  }

  /// A cut that is all but at an edge of the mesh is at the edge.
  void dropSplinters(SurfacePath& arc) const
  {
    const auto isSplinter = [&](std::size_t leg) {
      return arc.triangles.size() > 1 &&
        (arc.points[leg + 1].position - arc.points[leg].position).norm() <=
        rounding * this->Distance;
    };
    while (isSplinter(0))
    {
      arc.points.erase(arc.points.begin());
      arc.triangles.erase(arc.triangles.begin());
    }
    while (isSplinter(arc.triangles.size() - 1))
    {
      arc.points.pop_back();
      arc.triangles.pop_back();
    }
  }

  /// An arc without what is nearer for another reason than a crossing: behind corners of the
  /// boundary, and where paths meet at a vertex.
  std::vector<SurfacePath> withoutStretches(const SurfacePath& arc) const
  {
    const SurfacePath path = this->withMiddle(arc);
    std::vector<char> near;
    for (const SurfacePoint& point : path.points)
    {
      near.push_back(this->isNearer(point, this->Nearer) ? 1 : 0);
    }
    if (std::find(near.begin(), near.end(), 1) == near.end())
    {
      return { arc };
    }
    const std::size_t count = near.size();
    for (const bool backwards : { false, true })
    {
      for (std::size_t k = 1; k < count; ++k)
      {
        const std::size_t i = backwards ? count - 1 - k : k;
        const std::size_t before = backwards ? i + 1 : i - 1;
        near[i] = near[i] || (near[before] && this->isNearer(path.points[i], rounding)) ? 1 : 0;
      }
    }
    std::vector<SurfacePath> parts;
    for (std::size_t i = 0; i < count; ++i)
    {
      if (near[i])
      {
        continue;
      }
      std::size_t last = i;
      while (last + 1 < count && !near[last + 1])
      {
        ++last;
      }
      SurfacePath part = partOf(path, i, last);
      if (i > 0)
      {
        part.points.insert(part.points.begin(), this->border(path, i - 1, false));
        part.triangles.insert(part.triangles.begin(), path.triangles[i - 1]);
      }
      if (last + 1 < count)
      {
        part.points.push_back(this->border(path, last, true));
        part.triangles.push_back(path.triangles[last]);
      }
      if (lengthOf(part) > sameEnd * this->Distance)
      {
        parts.push_back(std::move(part));
      }
      i = last;
    }
    return parts;
  }

  /// Arcs of one leg have no point between their ends that could be asked.
  SurfacePath withMiddle(SurfacePath path) const
  {
    if (path.triangles.size() == 1)
    {
      path.points.insert(path.points.begin() + 1,
        pointBetween(
          this->Graph.mesh(), path.triangles[0], path.points.front(), path.points.back(), 0.5));
      path.triangles.push_back(path.triangles[0]);
    }
    return path;
  }

  /// Where on a leg a stretch that is nearer ends, or begins.
  SurfacePoint border(const SurfacePath& path, std::size_t leg, bool begins) const
  {
    double far = begins ? 0.0 : 1.0;
    double near = 1.0 - far;
    const auto at = [&](double s) {
      return pointBetween(
        this->Graph.mesh(), path.triangles[leg], path.points[leg], path.points[leg + 1], s);
    };
    for (int k = 0; k < trimHalvings; ++k)
    {
      const double s = 0.5 * (far + near);
      (this->isNearer(at(s), rounding) ? near : far) = s;
    }
    return at(far);
  }

  /// Arcs of which one starts where another ends are one.
  std::vector<SurfacePath> joined(const std::vector<SurfacePath>& arcs) const
  {
    const std::size_t none = arcs.size();
    std::vector<std::size_t> next(arcs.size(), none);
    std::vector<char> follows(arcs.size(), 0);
    for (std::size_t a = 0; a < arcs.size(); ++a)
    {
      double least = sameEnd * this->Distance;
      for (std::size_t b = 0; b < arcs.size(); ++b)
      {
        const double gap =
          (arcs[a].points.back().position - arcs[b].points.front().position).norm();
        if (!follows[b] && gap <= least)
        {
          next[a] = b;
          least = gap;
        }
      }
      if (next[a] != none)
      {
        follows[next[a]] = 1;
      }
    }
    std::vector<SurfacePath> parts;
    std::vector<char> taken(arcs.size(), 0);
    for (const bool closed : { false, true })
    {
      for (std::size_t a = 0; a < arcs.size(); ++a)
      {
        if (taken[a] || (!closed && follows[a]))
        {
          continue;
        }
        SurfacePath part = arcs[a];
        taken[a] = 1;
        for (std::size_t b = next[a]; b != none && !taken[b]; b = next[b])
        {
          taken[b] = 1;
          this->join(part, arcs[b]);
        }
        if (closed)
        {
          this->close(part);
        }
        parts.push_back(std::move(part));
      }
    }
    return parts;
  }

  /// Adds an arc that starts where a path ends: both may be one crossing, found from either side of
  /// an edge.
  void join(SurfacePath& path, const SurfacePath& arc) const
  {
    SurfacePath next = arc;
    if (contains(this->Graph.mesh(), next.triangles.front(), path.points.back()))
    {
      next.points.front() = path.points.back();
    }
    else
    {
      this->endAt(path, next.points.front());
    }
    append(path, next);
  }
  void close(SurfacePath& path) const
  {
    const SurfacePoint start = path.points.front();
    this->endAt(path, start);
  }
  void endAt(SurfacePath& path, const SurfacePoint& end) const
  {
    if (contains(this->Graph.mesh(), path.triangles.back(), end))
    {
      path.points.back() = end;
      return;
    }
    const StraightPath step = localStraightPath(this->Graph, path.points.back(), end);
    if (!step.status.refused())
    {
      append(path, step.path);
    }
  }

  static std::vector<double> lengthsTo(const SurfacePath& path)
  {
    std::vector<double> lengths{ 0.0 };
    for (std::size_t i = 0; i < path.triangles.size(); ++i)
    {
      lengths.push_back(
        lengths.back() + (path.points[i + 1].position - path.points[i].position).norm());
    }
    return lengths;
  }

  /// Whether a point is nearer to the source than the distance, by a fraction of it.
  bool isNearer(const SurfacePoint& point, double fraction) const
  {
    const TriangleMesh& mesh = this->Graph.mesh();
    const double bound = (1.0 - fraction) * this->Distance;
    for (const PathFoot& foot : this->SourceLegs.feet(point.position, bound))
    {
      const SurfacePoint place = pointBetween(mesh, this->Source.triangles[foot.leg],
        this->Source.points[foot.leg], this->Source.points[foot.leg + 1], foot.along);
      const StraightPath way = straightPath(this->Graph, point, place);
      if (!way.status.refused() && way.length < bound)
      {
        return true;
      }
    }
    return false;
  }

  const PathGraph& Graph;
  const SurfacePath& Source;
  NearbyLegs SourceLegs;
  double Distance;
  double Nearer;
};
}

std::vector<SurfacePath> trimmedOffset(const PathGraph& graph, const SurfacePath& source,
  double distance, double shortcut, const std::vector<SurfacePath>& offset,
  const std::vector<SurfacePath>& others)
{
  return OffsetTrimming(graph, source, distance, shortcut).run(offset, others);
}
}
