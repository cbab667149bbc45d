// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/CutCandidates.h"

#include "Quality/ScaleFactor.h"
#include "Surface/EdgePaths.h"
#include "Surface/VertexFan.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flattening
{
namespace
{
// Lengths are in sqrt(area / pi).

/// Bases stay this far from corners, where a dart would cut off a sliver.
constexpr double clearOfCorner = 0.05;
/// Sides may overlap this much by the forecast, which is linear.
constexpr double maxOverlap = 4e-3;
/// Longer darts cut a piece through: this is the diameter of a disk.
constexpr double longestDart = 2.0;
/// Ends of a seam nearer to each other along the boundary cut off a corner alone.
constexpr double minSeamArc = 0.35;
/// With the tips below some thousand plans, ranked within hundredths of a second.
constexpr Index maxBases = 80;
constexpr Index maxTips = 140;
/// Where fewer stay clear of corners these are bases as well.
constexpr std::size_t minBases = 8;
/// Seams run over this many of the places that are farthest from flat, this far apart.
constexpr std::size_t maxPeaks = 6;
constexpr double peaksApart = 0.3;
/// They turn there by less than the angle whose cosine this is, 37 degrees, as seen from this far:
/// nearly straight, though edges zigzag.
constexpr double minTurn = 0.8;
constexpr double seenFrom = 0.25;
/// Of more bases every other is the end of such a seam, since their pairs are many.
constexpr std::size_t fewBases = 40;
/// Darts inside join two of the places with most curvature: some hundred pairs.
constexpr std::size_t maxSites = 24;
/// Tips are also the vertices with most curvature, where a dart has to end exactly.
constexpr std::size_t maxApexes = 16;
/// Of these none where less than this angle is missing, in radians: it is spread, not an apex.
constexpr double apexDefect = 0.3;

/// Vertices inside a surface where darts may end.
struct CutPlaces
{
  Indices tips;  ///< spread over all of the inside
  Indices sites; ///< those of the tips around which most curvature lies, where it is positive
};

/// \param barred per vertex, whether it lies on a key curve, which no cut may cross
CutPlaces cutPlaces(const TriangleMesh& mesh, const std::vector<char>& barred)
{
  Indices inside;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    if (mesh.outgoing(v) != none && !mesh.onBoundary(v) && !barred[v])
    {
      inside.push_back(v);
    }
  }
  const Indices cluster = clusterVertices(mesh, inside, maxTips);
  const Index count = std::min<Index>(maxTips, static_cast<Index>(inside.size()));
  std::vector<Point3> center(count, Point3::Zero());
  std::vector<double> members(count, 0.0);
  for (Index v : inside)
  {
    center[cluster[v]] += mesh.point(v);
    members[cluster[v]] += 1.0;
  }
  Indices tips(count, none);
  const auto miss = [&](Index v) {
    return (mesh.point(v) - center[cluster[v]] / members[cluster[v]]).squaredNorm();
  };
  for (Index v : inside)
  {
    Index& tip = tips[cluster[v]];
    tip = tip == none || miss(v) < miss(tip) ? v : tip;
  }
  std::vector<double> defects(mesh.vertexCount(), 0.0);
  for (Index v : inside)
  {
    defects[v] = 2.0 * pi - angleSum(mesh, v);
  }
  std::vector<std::pair<double, Index>> curved(count, { 0.0, none });
  for (Index v : inside)
  {
    curved[cluster[v]].first -= defects[v];
    curved[cluster[v]].second = tips[cluster[v]];
  }
  std::sort(curved.begin(), curved.end());
  Indices apexes = inside;
  const auto sharper = [&](
                         Index a, Index b) { return std::abs(defects[a]) > std::abs(defects[b]); };
  std::stable_sort(apexes.begin(), apexes.end(), sharper);
  apexes.resize(std::min(apexes.size(), maxApexes));
  for (Index v : apexes)
  {
    if (std::abs(defects[v]) > apexDefect && std::find(tips.begin(), tips.end(), v) == tips.end())
    {
      tips.push_back(v);
    }
  }
  CutPlaces places;
  for (const auto& [defect, tip] : curved)
  {
    if (defect < 0.0 && places.sites.size() < maxSites)
    {
      places.sites.push_back(tip);
    }
  }
  tips.erase(std::remove(tips.begin(), tips.end(), none), tips.end());
  places.tips = std::move(tips);
  return places;
}

/// How far cuts stay from the mirror plane or lie in it, in sqrt(area / pi).
constexpr double clearOfPlane = 0.04;

/// Which part plans take with regard to the mirror plane of a piece, if it has one.
class MirrorRoles
{
public:
  /// The piece must outlive it. \param pairs whether cuts may come in pairs
  MirrorRoles(const SearchedPiece& piece, bool pairs)
    : Piece(piece)
    , Pairs(pairs)
    , Margin(clearOfPlane * piece.size())
  {
  }

  /// On which side of the plane; 0 in it. \pre there is one
  int side(const Point3& point) const
  {
    const double distance = this->Piece.mirror()->side(point);
    return distance > this->Margin ? 1 : distance < -this->Margin ? -1 : 0;
  }

  /// The boundary vertex nearest to a boundary vertex' image. \pre there is a plane
  Index mirroredBase(Index base) const
  {
    return this->Piece.ruler().vertex(this->Piece.mirrored(this->Piece.ruler().placeOf(base)));
  }

  /// The role of a cut from one point to another; false where it can have none. Moves the ends of
  /// one that lies along the plane into it.
  bool take(const Point3& from, const Point3& to, CutPlan& plan) const
  {
    if (!this->Piece.mirror())
    {
      return true;
    }
    const int a = this->side(from);
    const int b = this->side(to);
    if (a == 0 && b == 0)
    {
      plan.role = MirrorRole::Along;
      this->bringIntoPlane(plan);
      return true;
    }
    plan.role = MirrorRole::Pair;
    return a * b > 0 && this->Pairs;
  }

  /// The same of a seam by its `via`, which it moves into the plane where that is near. \pre there
  /// is one
  bool takeOver(Index base, Index end, CutPlan& plan) const
  {
    const int top = this->side(*plan.via);
    if (top == 0)
    {
      plan.via = this->Piece.onto(*plan.via, true);
      if (end == this->mirroredBase(base))
      {
        plan.role = MirrorRole::Across;
        return true;
      }
    }
    const Point3& from = this->Piece.mesh().point(base);
    return this->take(from, this->Piece.mesh().point(end), plan) && this->side(from) == top;
  }

private:
  void bringIntoPlane(CutPlan& plan) const
  {
    if (plan.start)
    {
      plan.start = this->Piece.onto(*plan.start, true);
    }
    else
    {
      plan.base = this->inPlane(plan.base);
    }
    if (plan.type == CurveType::Seam)
    {
      plan.end = this->inPlane(plan.end);
    }
    else
    {
      plan.tip = this->Piece.onto(plan.tip, true);
    }
  }

  /// Where the boundary crosses the plane near a place.
  BoundaryPlace inPlane(BoundaryPlace place) const
  {
    const BoundaryRuler& ruler = this->Piece.ruler();
    const SurfaceMirror& plane = *this->Piece.mirror();
    double low = -2.0 * this->Margin;
    double high = 2.0 * this->Margin;
    const auto at = [&](double by) { return plane.side(ruler.point(ruler.moved(place, by))); };
    if (at(low) * at(high) > 0.0)
    {
      return place;
    }
    const bool rising = at(high) > 0.0;
    for (int halving = 0; halving < 60; ++halving)
    {
      const double middle = 0.5 * (low + high);
      ((at(middle) > 0.0) == rising ? high : low) = middle;
    }
    return ruler.moved(place, 0.5 * (low + high));
  }

  const SearchedPiece& Piece;
  bool Pairs;
  double Margin;
};

class Planning
{
public:
  Planning(const SearchedPiece& piece, const ScaleFactor& factor, const SearchOptions& options,
    double longest)
    : Piece(piece)
    , Mesh(piece.mesh())
    , Factor(factor)
    , Options(options)
    , Longest(longest)
    , Roles(piece, options.maximumCuts > 1)
  {
    double around = 0.0;
    for (Index l = 0; l < piece.ruler().loopCount(); ++l)
    {
      around += piece.ruler().length(l);
    }
    const double spacing = std::max(baseSpacing * piece.size(), around / maxBases);
    Indices bases = piece.ruler().spread(spacing, clearOfCorner * piece.size());
    if (bases.size() < minBases) // all may be corners
    {
      bases = piece.ruler().spread(spacing, 0.0);
    }
    for (Index v : bases)
    {
      if (piece.endpointPreference(piece.ruler().placeOf(v)) > 0.0 && !piece.barred()[v])
      {
        this->Bases.push_back(v);
      }
    }
    this->Places = cutPlaces(this->Mesh, piece.barred());
    if (options.cuts != SuggestedCuts::Darts)
    {
      this->Peaks =
        this->Factor.peaks(this->Places.tips, peaksApart * this->Piece.size(), maxPeaks);
    }
    if (options.cuts == SuggestedCuts::Seams)
    {
      this->Places = {};
    }
  }

  std::vector<CutPlan> run(const Execution& execution) const
  {
    const auto bases = static_cast<Index>(this->Bases.size());
    const auto sites = static_cast<Index>(this->Places.sites.size());
    const auto peaks = static_cast<Index>(this->Peaks.size());
    std::vector<std::vector<CutPlan>> parts(bases + sites + peaks);
    execution.forEachTask(static_cast<Index>(parts.size()), [&](Index k) {
      parts[k] = k < bases  ? this->plansFrom(k)
        : k < bases + sites ? this->plansInside(k - bases)
                            : this->plansOver(this->Peaks[k - bases - sites]);
    });
    std::vector<CutPlan> plans;
    for (const std::vector<CutPlan>& part : parts)
    {
      plans.insert(plans.end(), part.begin(), part.end());
    }
    std::stable_sort(plans.begin(), plans.end(),
      [](const CutPlan& a, const CutPlan& b) { return a.score() > b.score(); });
    return plans;
  }

private:
  std::vector<CutPlan> plansFrom(Index b) const
  {
    std::vector<CutPlan> plans;
    const Index base = this->Bases[b];
    if (this->Piece.mirror() && this->Roles.side(this->Mesh.point(base)) < 0)
    {
      return plans; // the mirror image of another
    }
    const EdgePaths paths(this->Mesh, { base }, this->Piece.barred());
    for (Index tip : this->Places.tips)
    {
      this->addDart(paths, base, tip, plans);
    }
    if (this->Options.cuts == SuggestedCuts::Darts)
    {
      return plans;
    }
    for (std::size_t e = 0; e < this->Bases.size(); ++e)
    {
      const bool twice = static_cast<Index>(e) <= b && !this->Piece.mirror();
      if (!twice && this->Bases[e] != base)
      {
        this->addSeam(paths, base, this->Bases[e], plans);
      }
    }
    if (this->Piece.mirror())
    {
      this->addSeam(paths, base, this->Roles.mirroredBase(base), plans);
    }
    return plans;
  }

  /// Darts from one place of much curvature to those after it.
  std::vector<CutPlan> plansInside(Index s) const
  {
    std::vector<CutPlan> plans;
    const Index start = this->Places.sites[s];
    const bool image = this->Piece.mirror() && this->Roles.side(this->Mesh.point(start)) < 0;
    if (image || !this->Piece.takesInnerTip(this->Mesh.point(start)))
    {
      return plans;
    }
    const EdgePaths paths(this->Mesh, { start }, this->Piece.barred());
    for (std::size_t e = s + 1; e < this->Places.sites.size(); ++e)
    {
      const Index tip = this->Places.sites[e];
      CutPlan plan;
      plan.start = this->Mesh.point(start);
      plan.tip = this->Mesh.point(tip);
      if (!this->Piece.takesInnerTip(plan.tip) || !paths.reaches(tip) ||
        paths.distance(tip) > longestDart * this->Piece.size() ||
        !this->Roles.take(*plan.start, plan.tip, plan))
      {
        continue;
      }
      this->add(paths.path(tip), plan, plans);
    }
    return plans;
  }

  /// Seams that run over a place nearly straight, which need not be the shortest way: that between
  /// opposite places of a hemisphere's boundary runs along it.
  std::vector<CutPlan> plansOver(Index peak) const
  {
    std::vector<CutPlan> plans;
    const Point3& top = this->Mesh.point(peak);
    if (this->Piece.mirror() && this->Roles.side(top) < 0)
    {
      return plans;
    }
    const EdgePaths paths(this->Mesh, { peak }, this->Piece.barred());
    const Point3 up = this->Piece.normalNear(top);
    std::vector<std::pair<Index, Point3>> ends;
    const std::size_t step = this->Bases.size() > fewBases ? 2 : 1;
    for (std::size_t b = 0; b < this->Bases.size(); b += step)
    {
      if (paths.reaches(this->Bases[b]))
      {
        ends.emplace_back(this->Bases[b], this->directionTo(paths, this->Bases[b], top, up));
      }
    }
    for (std::size_t e = 0; e < ends.size(); ++e)
    {
      for (std::size_t b = 0; b < e; ++b)
      {
        if (ends[b].second.dot(ends[e].second) < -minTurn)
        {
          this->addSeamOver(paths, ends[b].first, peak, ends[e].first, plans);
        }
      }
    }
    return plans;
  }

  /// In which direction a way sets out, seen from some way along it.
  Point3 directionTo(const EdgePaths& paths, Index end, const Point3& top, const Point3& up) const
  {
    Point3 ahead = this->Mesh.point(end) - top;
    for (Index v : paths.path(end))
    {
      if (paths.distance(v) >= seenFrom * this->Piece.size())
      {
        ahead = this->Mesh.point(v) - top;
        break;
      }
    }
    ahead -= ahead.dot(up) * up;
    return ahead.normalized();
  }

  void addSeamOver(
    const EdgePaths& paths, Index base, Index peak, Index end, std::vector<CutPlan>& plans) const
  {
    CutPlan plan;
    plan.type = CurveType::Seam;
    plan.base = this->Piece.ruler().placeOf(base);
    plan.end = this->Piece.ruler().placeOf(end);
    plan.via = this->Mesh.point(peak);
    if (this->Piece.mirror() && !this->Roles.takeOver(base, end, plan))
    {
      return;
    }
    Indices path = paths.path(base);
    std::reverse(path.begin(), path.end());
    const Indices rest = paths.path(end);
    path.insert(path.end(), rest.begin() + 1, rest.end());
    this->add(path, plan, plans);
  }

  void addDart(const EdgePaths& paths, Index base, Index tip, std::vector<CutPlan>& plans) const
  {
    CutPlan plan;
    plan.base = this->Piece.ruler().placeOf(base);
    plan.tip = this->Mesh.point(tip);
    if (!paths.reaches(tip) || paths.distance(tip) > longestDart * this->Piece.size() ||
      !this->Roles.take(this->Mesh.point(base), plan.tip, plan))
    {
      return;
    }
    this->add(paths.path(tip), plan, plans);
  }

  void addSeam(const EdgePaths& paths, Index base, Index end, std::vector<CutPlan>& plans) const
  {
    const BoundaryRuler& ruler = this->Piece.ruler();
    CutPlan plan;
    plan.type = CurveType::Seam;
    plan.base = ruler.placeOf(base);
    plan.end = ruler.placeOf(end);
    if (base == end || !paths.reaches(end) ||
      ruler.distance(plan.base, plan.end) < minSeamArc * this->Piece.size() ||
      !(this->Piece.endpointPreference(plan.end) > 0.0))
    {
      return;
    }
    if (this->Piece.mirror() && end == this->Roles.mirroredBase(base))
    {
      plan.role = MirrorRole::Across;
    }
    else if (!this->Roles.take(this->Mesh.point(base), this->Mesh.point(end), plan))
    {
      return;
    }
    this->add(paths.path(end), plan, plans);
  }

  void add(const Indices& path, CutPlan& plan, std::vector<CutPlan>& plans) const
  {
    for (std::size_t k = 1; k < path.size(); ++k)
    {
      plan.length += (this->Mesh.point(path[k]) - this->Mesh.point(path[k - 1])).norm();
    }
    const double one = plan.length;
    plan.length *= plan.role == MirrorRole::Pair ? 2.0 : 1.0;
    if (one < minCutLength * this->Piece.size() || plan.length > this->Longest)
    {
      return;
    }
    CutForecast forecast =
      plan.start ? this->Factor.forecastInside(path) : this->Factor.forecast(path);
    plan.opening = forecast.leastOpening();
    if (plan.type == CurveType::Dart && plan.opening < -maxOverlap * this->Piece.size())
    {
      return;
    }
    if (plan.role == MirrorRole::Pair && plan.start)
    {
      forecast.gain *= 2.0; // as if its image were far away
    }
    else if (plan.role == MirrorRole::Pair)
    {
      Indices both = path;
      for (Index v : path)
      {
        both.push_back(this->Piece.mirrored(v));
      }
      forecast = this->Factor.forecast(both);
    }
    plan.opening = plan.start        ? forecast.greatestOpening()
      : plan.type == CurveType::Dart ? forecast.opening(0.0)
                                     : 0.0;
    plan.predictedGain = forecast.gain;
    plan.price = this->Piece.price(plan, plan.length, this->Options);
    if (plan.predictedGain > 0.0)
    {
      plans.push_back(plan);
    }
  }

  const SearchedPiece& Piece;
  const TriangleMesh& Mesh;
  const ScaleFactor& Factor;
  const SearchOptions& Options;
  double Longest;
  MirrorRoles Roles;
  Indices Bases;
  CutPlaces Places; ///< none where seams alone are wanted
  Indices Peaks;    ///< that seams may run over
};
}

std::vector<CutPlan> planCuts(const SearchedPiece& piece, const ScaleFactor& factor,
  const SearchOptions& options, double longest, const Execution& execution)
{
  return Planning(piece, factor, options, longest).run(execution);
}
}
