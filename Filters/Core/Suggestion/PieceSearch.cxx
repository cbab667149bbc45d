// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/PieceSearch.h"

#include "Cut/PieceTopology.h"
#include "Suggestion/CutCandidates.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace flattening
{
namespace
{
/// Of the version on which cuts are tried: a flattening takes some milliseconds.
constexpr Index coarseTriangles = 500;
/// A trial on it is given up after these steps, several times what sound ones take.
constexpr double roughSteps = 75.0;
/// What the price of a cut is divided by that begins or ends on the leg of a dart: seams over a
/// sewn dart are thick.
constexpr double preferenceForLegs = 0.5;
/// In sqrt(area / pi): plans that differ by less are tried once.
constexpr double plansApart = 0.15;
/// In the same unit, the step by which a cut's ends move in the end; the first one is the distance
/// of bases.
constexpr double lastStep = 0.025;
/// A seam that cuts off less than this share of the area only trims the piece.
constexpr double minPiece = 0.03;
/// Moves are taken that raise the score by more than this share.
constexpr double minRise = 0.005;
/// The best by score need not be the best once its ends are moved.
constexpr std::size_t polishedCuts = 2;

/// Null where it is not one piece that can be laid flat once its darts are opened.
std::unique_ptr<SearchedPiece> searchedPiece(
  const PieceSurface& piece, const VertexMarks& marks, const std::optional<SurfaceMirror>& mirror)
{
  const CutSurface cut = cutSurface(piece.mesh, piece.curves);
  if (!cut.status.ok() || cut.pieceCount != 1)
  {
    return nullptr;
  }
  Piece opened = std::move(extractPieces(cut).front());
  if (findDefect(opened))
  {
    return nullptr;
  }
  std::vector<char> barred;
  std::vector<double> preference;
  for (Index v : opened.vertices)
  {
    const Index marked = piece.vertices[cut.originalVertex[v]];
    barred.push_back(marks.barred[marked]);
    preference.push_back(marks.preference[marked]);
  }
  RegionWeights weights;
  for (std::size_t t = 0; t < opened.triangles.size() && !piece.weights.empty(); ++t)
  {
    weights.push_back(piece.weights[opened.triangles[t]]);
  }
  std::vector<double> weight = vertexWeights(opened.mesh, weights);
  return std::make_unique<SearchedPiece>(
    std::move(opened.mesh), std::move(barred), std::move(preference), std::move(weight), mirror);
}

/// The plans of types that none of some others is of.
std::vector<CutPlan> ofOtherTypes(
  const std::vector<CutPlan>& plans, const std::vector<CutPlan>& others)
{
  std::vector<CutPlan> left;
  std::copy_if(plans.begin(), plans.end(), std::back_inserter(left), [&](const CutPlan& plan) {
    return std::none_of(
      others.begin(), others.end(), [&](const CutPlan& other) { return other.type == plan.type; });
  });
  return left;
}

/// Whether the ends of plans, and what seams run over, are nearer to each other than a distance;
/// of seams and darts inside also the other way round.
bool alike(const SearchedPiece& piece, const CutPlan& a, const CutPlan& b, double apart)
{
  const auto near = [&](const Point3& p, const Point3& q) { return (p - q).norm() < apart; };
  const Point3 a1 = piece.baseOf(a);
  const Point3 a2 = piece.endOf(a);
  const Point3 b1 = piece.baseOf(b);
  const Point3 b2 = piece.endOf(b);
  const bool turned = (a.type == CurveType::Seam || a.start) && near(a1, b2) && near(a2, b1);
  const bool sameWay = a.via.has_value() == b.via.has_value() && (!a.via || near(*a.via, *b.via));
  return a.type == b.type && a.start.has_value() == b.start.has_value() && sameWay &&
    ((near(a1, b1) && near(a2, b2)) || turned);
}

/// The first of the plans that differ: of those that lie close to each other the first.
std::vector<CutPlan> distinctPlans(
  const SearchedPiece& piece, const std::vector<CutPlan>& plans, Index most)
{
  std::vector<CutPlan> chosen;
  for (const CutPlan& plan : plans)
  {
    if (static_cast<Index>(chosen.size()) >= most)
    {
      break;
    }
    if (std::none_of(chosen.begin(), chosen.end(), [&](const CutPlan& other) {
          return alike(piece, plan, other, plansApart * piece.size());
        }))
    {
      chosen.push_back(plan);
    }
  }
  return chosen;
}

/// Plans that differ from one by an end, or the place that a seam runs over, moved by a step either
/// way, in the surface's unit: ends on the boundary along it, tips along the cut and across. They
/// keep the plan's role.
std::vector<CutPlan> movedPlans(const SearchedPiece& piece, const CutPlan& plan, double step)
{
  std::vector<CutPlan> plans;
  const BoundaryRuler& ruler = piece.ruler();
  const auto addMoved = [&](double base, double end) {
    CutPlan moved = plan;
    moved.base = ruler.moved(plan.base, base);
    moved.end = plan.type == CurveType::Seam ? ruler.moved(plan.end, end) : plan.end;
    if (piece.endpointPreference(moved.base) > 0.0)
    {
      plans.push_back(moved);
    }
  };
  const bool along = plan.role == MirrorRole::Along;
  for (double by : { step, -step })
  {
    if (!along && !plan.start)
    {
      addMoved(by, 0.0);
    }
    if (plan.type == CurveType::Seam && plan.role != MirrorRole::Across && !along)
    {
      addMoved(0.0, by);
      addMoved(by, by);
      addMoved(by, -by);
    }
  }
  const Point3 base = piece.baseOf(plan);
  const Point3 ahead = (piece.endOf(plan) - base).normalized();
  const auto aside = [&](const Point3& place) { return piece.normalNear(place).cross(ahead); };
  for (double by : { step, -step })
  {
    if (plan.via)
    {
      CutPlan moved = plan;
      moved.via =
        piece.onto(*plan.via + by * aside(*plan.via), along || plan.role == MirrorRole::Across);
      plans.push_back(moved);
    }
    if (plan.type != CurveType::Dart)
    {
      continue;
    }
    for (const Point3& direction : { ahead, aside(plan.tip) })
    {
      CutPlan moved = plan;
      moved.tip = piece.onto(plan.tip + by * direction, along);
      if (!plan.start || piece.takesInnerTip(moved.tip))
      {
        plans.push_back(moved);
      }
      if (plan.start)
      {
        moved = plan;
        moved.start = piece.onto(*plan.start + by * direction, along);
        if (piece.takesInnerTip(*moved.start))
        {
          plans.push_back(moved);
        }
      }
    }
  }
  return plans;
}

void sortByScore(std::vector<TriedCut>& cuts)
{
  std::stable_sort(cuts.begin(), cuts.end(),
    [](const TriedCut& a, const TriedCut& b) { return a.score > b.score; });
}
}

VertexMarks markVertices(const ImprintedSurface& surface, const SearchOptions& options)
{
  VertexMarks marks;
  marks.barred.assign(surface.mesh.vertexCount(), 0);
  marks.preference.assign(surface.mesh.vertexCount(), 1.0);
  for (const FeatureCurve& curve : surface.curves)
  {
    for (std::size_t k = 1; k < curve.vertices.size() && curve.type == CurveType::Dart; ++k)
    {
      marks.preference[curve.vertices[k]] = preferenceForLegs;
    }
    for (const SearchOptions::Preference& preference : options.preferences)
    {
      for (Index v : curve.name == preference.curve ? curve.vertices : Indices{})
      {
        marks.preference[v] = preference.weight;
      }
    }
    for (Index v : curve.type == CurveType::Key ? curve.vertices : Indices{})
    {
      marks.barred[v] = 1;
    }
  }
  return marks;
}

PieceSearch::PieceSearch(const PieceSurface& piece, const VertexMarks& marks,
  const SearchSubject& subject, const SearchOptions& options)
  : Subject(piece)
  , Marks(marks)
  , Mirror(subject.mirror)
  , Options(options)
  , Coarse(coarsened(piece, coarseTriangles))
  , Trials(this->Coarse.mesh, this->Coarse.polylines(), subject.imprint,
      roughly(subject.flattening), subject.goal, this->Coarse.weights, roughSteps)
{
}

bool PieceSearch::ok(const Execution& execution)
{
  this->Searched = searchedPiece(this->Coarse, this->Marks, this->Mirror);
  if (!this->Searched)
  {
    return false;
  }
  ScaleFactorOptions options;
  options.weight = this->Searched->weight();
  this->Factor = std::make_unique<ScaleFactor>(this->Searched->mesh(), options, execution);
  return this->Factor->ok();
}

std::vector<TriedCut> PieceSearch::run(
  double longest, TrialBudget& budget, const Execution& execution)
{
  this->Before = this->Trials.startUncut(budget, execution);
  if (!this->Before.valid)
  {
    // Nothing could be flattened: whatever can is better.
    this->Before.goal = 1e3 * this->Searched->area();
    this->Before.severity = std::numeric_limits<int>::max();
    this->Before.flipped = this->Searched->mesh().triangleCount();
    this->Before.overlaps = this->Searched->mesh().halfedgeCount();
  }
  const std::vector<CutPlan> plans =
    planCuts(*this->Searched, *this->Factor, this->Options, longest, execution);
  const std::vector<CutPlan> first = distinctPlans(*this->Searched, plans, this->Options.trials);
  std::vector<TriedCut> tried = this->tryAll(first, longest, budget, execution);
  if (tried.empty())
  {
    // On a ring that ripples all seams may overlap, and fill the trials.
    tried =
      this->tryAll(distinctPlans(*this->Searched, ofOtherTypes(plans, first), this->Options.trials),
        longest, budget, execution);
  }
  for (std::size_t k = 0; k < std::min(tried.size(), polishedCuts); ++k)
  {
    tried[k] = this->polished(std::move(tried[k]), longest, budget, execution);
  }
  sortByScore(tried);
  return tried;
}

std::vector<TriedCut> PieceSearch::tryAll(const std::vector<CutPlan>& plans, double longest,
  TrialBudget& budget, const Execution& execution) const
{
  std::vector<std::vector<Polyline>> cuts(plans.size());
  execution.forEachTask(static_cast<Index>(plans.size()),
    [&](Index k) { cuts[k] = this->Searched->polylines(plans[k]); });
  std::vector<TrialOutcome> outcomes = this->Trials.runAll(cuts, budget, execution);
  const double least = minCutLength * this->Searched->size();
  std::vector<TriedCut> tried;
  for (std::size_t k = 0; k < plans.size(); ++k)
  {
    TriedCut cut{ plans[k], std::move(outcomes[k]), 0.0 };
    const double length = cut.outcome.cutLength();
    const bool seam = cut.plan.type == CurveType::Seam;
    if (!cut.outcome.soundAfter(this->Before) || length > longest ||
      length < least * static_cast<double>(cut.outcome.lengths.size()) ||
      (seam && cut.outcome.minPiece < minPiece))
    {
      continue;
    }
    const double gain = this->Before.goal - cut.outcome.goal;
    cut.plan.length = length;
    cut.plan.price = this->Searched->price(cut.plan, length, this->Options);
    cut.score = gain / cut.plan.price;
    if (gain > 0.0)
    {
      tried.push_back(std::move(cut));
    }
  }
  sortByScore(tried);
  return tried;
}

TriedCut PieceSearch::polished(
  TriedCut cut, double longest, TrialBudget& budget, const Execution& execution) const
{
  const SearchedPiece& piece = *this->Searched;
  double step = baseSpacing * piece.size();
  std::vector<CutPlan> before{ cut.plan };
  while (step >= lastStep * piece.size() && !budget.spent() && !execution.cancelled())
  {
    std::vector<CutPlan> plans = movedPlans(piece, cut.plan, step);
    const auto tried = [&](const CutPlan& plan) {
      return std::any_of(before.begin(), before.end(), [&](const CutPlan& other) {
        return alike(piece, plan, other, 0.2 * lastStep * piece.size());
      });
    };
    eraseIf(plans, tried);
    before.insert(before.end(), plans.begin(), plans.end());
    std::vector<TriedCut> found = this->tryAll(plans, longest, budget, execution);
    if (!found.empty() && found.front().score > (1.0 + minRise) * cut.score)
    {
      cut = std::move(found.front());
    }
    else
    {
      step *= 0.5;
    }
  }
  return cut;
}

const SearchedPiece& PieceSearch::fine()
{
  if (this->Coarse.mesh.vertexCount() == this->Subject.mesh.vertexCount())
  {
    return *this->Searched;
  }
  if (!this->Fine)
  {
    this->Fine = searchedPiece(this->Subject, this->Marks, this->Mirror);
  }
  return *this->Fine;
}

std::vector<Polyline> PieceSearch::lines(const CutPlan& plan)
{
  const SearchedPiece& piece = this->fine();
  if (&piece == this->Searched.get())
  {
    return piece.polylines(plan);
  }
  if (plan.role != MirrorRole::Alone && !piece.mirror())
  {
    return {};
  }
  const BoundaryRuler& ruler = this->Searched->ruler();
  const auto place = [&](const BoundaryPlace& there) {
    return piece.ruler().nearest(ruler.point(there), ruler.inside(there));
  };
  const bool along = plan.role == MirrorRole::Along;
  CutPlan here = plan;
  here.base = plan.start ? plan.base : place(plan.base);
  if (plan.type == CurveType::Seam)
  {
    here.end = place(plan.end);
  }
  else
  {
    here.tip = piece.onto(plan.tip, along);
  }
  if (plan.start)
  {
    here.start = piece.onto(*plan.start, along);
  }
  if (plan.via)
  {
    here.via = piece.onto(*plan.via, along || plan.role == MirrorRole::Across);
  }
  return piece.polylines(here);
}
}
