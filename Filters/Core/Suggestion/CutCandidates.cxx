// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/CutCandidates.h"

#include "Suggestion/CutPlaces.h"
#include "Surface/EdgePaths.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// In sqrt(area / pi): steps between bases along the boundary, how far they stay from corners, how
/// far cuts stay from the mirror plane or lie in it, how much banks may overlap by the forecast,
/// how long a dart may be, how far along the boundary a seam's ends lie apart, and how far plans
/// that differ.
constexpr double baseSpacing = 0.12;
constexpr double clearOfCorner = 0.05;
constexpr double clearOfPlane = 0.04;
constexpr double mostOverlap = 4e-3;
constexpr double longestDart = 2.0;
constexpr double leastSeamArc = 0.35;
constexpr double plansApart = 0.15;
constexpr Index mostBases = 80;

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
    , Margin(clearOfPlane * piece.size())
  {
    double around = 0.0;
    for (Index l = 0; l < piece.ruler().loopCount(); ++l)
    {
      around += piece.ruler().length(l);
    }
    const double spacing = std::max(baseSpacing * piece.size(), around / mostBases);
    for (Index v : piece.ruler().spread(spacing, clearOfCorner * piece.size()))
    {
      if (piece.worth(piece.ruler().placeOf(v)) > 0.0 && !piece.barred()[v])
      {
        this->Bases.push_back(v);
      }
    }
    if (options.cuts != SuggestedCuts::Seams)
    {
      this->Places = cutPlaces(this->Mesh, piece.barred());
    }
  }

  std::vector<CutPlan> run(const Execution& execution) const
  {
    const auto bases = static_cast<Index>(this->Bases.size());
    std::vector<std::vector<CutPlan>> parts(this->Bases.size() + this->Places.sites.size());
    execution.parallelFor(static_cast<Index>(parts.size()), [&](Index begin, Index end) {
      for (Index k = begin; k < end; ++k)
      {
        parts[k] = k < bases ? this->plansFrom(k) : this->plansInside(k - bases);
      }
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
  /// On which side of the mirror plane; 0 in it.
  int side(const Point3& point) const
  {
    const double distance = this->Piece.mirror()->side(point);
    return distance > this->Margin ? 1 : distance < -this->Margin ? -1 : 0;
  }

  std::vector<CutPlan> plansFrom(Index b) const
  {
    std::vector<CutPlan> plans;
    const Index base = this->Bases[b];
    if (this->Piece.mirror() && this->side(this->Mesh.point(base)) < 0)
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
      this->addSeam(paths, base, this->mirroredBase(base), plans);
    }
    return plans;
  }

  /// Darts from one place of much curvature to those after it.
  std::vector<CutPlan> plansInside(Index s) const
  {
    std::vector<CutPlan> plans;
    const Index start = this->Places.sites[s];
    const bool image = this->Piece.mirror() && this->side(this->Mesh.point(start)) < 0;
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
        !this->takeRole(*plan.start, plan.tip, plan))
      {
        continue;
      }
      if (plan.role == MirrorRole::Along)
      {
        plan.start = this->Piece.onto(this->Piece.mirror()->projected(*plan.start));
        plan.tip = this->Piece.onto(this->Piece.mirror()->projected(plan.tip));
      }
      this->add(paths.path(tip), plan, plans);
    }
    return plans;
  }

  Index mirroredBase(Index base) const
  {
    return this->Piece.ruler().vertex(this->Piece.mirrored(this->Piece.ruler().placeOf(base)));
  }

  /// Its role to the mirror plane; false where it can have none.
  bool takeRole(const Point3& from, const Point3& to, CutPlan& plan) const
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
      return true;
    }
    plan.role = MirrorRole::Pair;
    return a * b > 0 && this->Options.maximumCuts > 1;
  }

  void addDart(const EdgePaths& paths, Index base, Index tip, std::vector<CutPlan>& plans) const
  {
    CutPlan plan;
    plan.base = this->Piece.ruler().placeOf(base);
    plan.tip = this->Mesh.point(tip);
    if (!paths.reaches(tip) || paths.distance(tip) > longestDart * this->Piece.size() ||
      !this->takeRole(this->Mesh.point(base), plan.tip, plan))
    {
      return;
    }
    if (plan.role == MirrorRole::Along)
    {
      this->bringIntoPlane(plan);
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
      ruler.distance(plan.base, plan.end) < leastSeamArc * this->Piece.size() ||
      !(this->Piece.worth(plan.end) > 0.0))
    {
      return;
    }
    if (this->Piece.mirror() && end == this->mirroredBase(base))
    {
      plan.role = MirrorRole::Across;
    }
    else if (!this->takeRole(this->Mesh.point(base), this->Mesh.point(end), plan))
    {
      return;
    }
    if (plan.role == MirrorRole::Along)
    {
      this->bringIntoPlane(plan);
    }
    this->add(paths.path(end), plan, plans);
  }

  void bringIntoPlane(CutPlan& plan) const
  {
    const MirrorPlane& plane = *this->Piece.mirror();
    plan.base = this->inPlane(plan.base);
    if (plan.type == CurveType::Seam)
    {
      plan.end = this->inPlane(plan.end);
    }
    else
    {
      plan.tip = this->Piece.onto(plane.projected(plan.tip));
    }
  }

  /// Where the boundary crosses the plane near a place.
  BoundaryPlace inPlane(BoundaryPlace place) const
  {
    const BoundaryRuler& ruler = this->Piece.ruler();
    const MirrorPlane& plane = *this->Piece.mirror();
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

  void add(const Indices& path, CutPlan& plan, std::vector<CutPlan>& plans) const
  {
    for (std::size_t k = 1; k < path.size(); ++k)
    {
      plan.length += (this->Mesh.point(path[k]) - this->Mesh.point(path[k - 1])).norm();
    }
    const double one = plan.length;
    plan.length *= plan.role == MirrorRole::Pair ? 2.0 : 1.0;
    if (one < this->Options.leastLength * this->Piece.size() || plan.length > this->Longest)
    {
      return;
    }
    CutForecast forecast =
      plan.start ? this->Factor.forecastInside(path) : this->Factor.forecast(path);
    plan.opening = forecast.leastOpening();
    if (plan.type == CurveType::Dart && plan.opening < -mostOverlap * this->Piece.size())
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
  double Margin;
  Indices Bases;
  CutPlaces Places; ///< none where seams alone are wanted
};
}

std::vector<CutPlan> planCuts(const SearchedPiece& piece, const ScaleFactor& factor,
  const SearchOptions& options, double longest, const Execution& execution)
{
  return Planning(piece, factor, options, longest).run(execution);
}

std::vector<CutPlan> distinctPlans(
  const SearchedPiece& piece, const std::vector<CutPlan>& plans, Index most)
{
  std::vector<CutPlan> chosen;
  const double apart = plansApart * piece.size();
  const auto alike = [&](const CutPlan& a, const CutPlan& b) {
    const auto near = [&](const Point3& p, const Point3& q) { return (p - q).norm() < apart; };
    const Point3 a1 = piece.baseOf(a);
    const Point3 a2 = piece.endOf(a);
    const Point3 b1 = piece.baseOf(b);
    const Point3 b2 = piece.endOf(b);
    const bool turned = (a.type == CurveType::Seam || a.start) && near(a1, b2) && near(a2, b1);
    return a.type == b.type && a.start.has_value() == b.start.has_value() &&
      ((near(a1, b1) && near(a2, b2)) || turned);
  };
  for (const CutPlan& plan : plans)
  {
    if (static_cast<Index>(chosen.size()) >= most)
    {
      break;
    }
    if (std::none_of(
          chosen.begin(), chosen.end(), [&](const CutPlan& other) { return alike(plan, other); }))
    {
      chosen.push_back(plan);
    }
  }
  return chosen;
}
}
