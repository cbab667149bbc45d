// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/PieceSearch.h"

#include "Suggestion/CutCandidates.h"

#include <algorithm>
#include <limits>

namespace flattening
{
namespace
{
/// Of the version on which cuts are tried.
constexpr Index coarseTriangles = 500;

/// Energies to compare trials by are known to five digits long before the last iterations.
constexpr double enoughToCompare = 1e-3;
constexpr double lengthTolerance = 1e-4;

FlatteningOptions roughly(FlatteningOptions options, bool unsettled)
{
  options.isometric.rough = unsettled;
  options.isometric.tolerance = std::max(options.isometric.tolerance, enoughToCompare);
  options.isometric.lengthTolerance = lengthTolerance;
  return options;
}
}

PieceSearch::PieceSearch(const PieceSurface& piece, const VertexMarks& marks,
  const std::optional<SurfaceMirror>& mirror, const ImprintOptions& imprint,
  const FlatteningOptions& flattening, const SearchOptions& options)
  : Subject(piece)
  , Marks(marks)
  , Mirror(mirror)
  , Options(options)
  , Coarse(coarsened(piece, coarseTriangles))
  , Trials(this->Coarse.mesh, this->Coarse.polylines(), imprint,
      roughly(flattening, options.unsettled), options.goal, this->Coarse.weights)
{
}

std::unique_ptr<SearchedPiece> PieceSearch::searched(const PieceSurface& piece) const
{
  const CutSurface cut = cutSurface(piece.mesh, piece.curves);
  if (!cut.status.ok() || cut.pieceCount != 1)
  {
    return nullptr;
  }
  Piece opened = std::move(extractPieces(cut).front());
  std::vector<char> barred;
  std::vector<double> worth;
  for (Index v : opened.vertices)
  {
    const Index marked = piece.vertices[cut.originalVertex[v]];
    barred.push_back(this->Marks.barred[marked]);
    worth.push_back(this->Marks.worth[marked]);
  }
  RegionWeights weights;
  for (std::size_t t = 0; t < opened.triangles.size() && !piece.weights.empty(); ++t)
  {
    weights.push_back(piece.weights[opened.triangles[t]]);
  }
  std::vector<double> weight = vertexWeights(opened.mesh, weights);
  return std::make_unique<SearchedPiece>(
    std::move(opened.mesh), std::move(barred), std::move(worth), std::move(weight), this->Mirror);
}

bool PieceSearch::ok(const Execution& execution)
{
  this->Searched = this->searched(this->Coarse);
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
  TrialOutcome before = this->Trials.startUncut(execution);
  budget.pay(before);
  if (!before.valid)
  {
    // Nothing could be flattened: whatever can is better.
    before.goal = 1e3 * this->Searched->area();
    before.severity = std::numeric_limits<int>::max();
    before.flipped = this->Searched->mesh().triangleCount();
    before.overlaps = this->Searched->mesh().halfedgeCount();
  }
  const std::vector<CutPlan> plans =
    planCuts(*this->Searched, *this->Factor, this->Options, longest, execution);
  return CutSearch(*this->Searched, this->Trials, this->Options, before)
    .run(plans, longest, budget, execution);
}

const SearchedPiece& PieceSearch::fine()
{
  if (this->Coarse.mesh.vertexCount() == this->Subject.mesh.vertexCount())
  {
    return *this->Searched;
  }
  if (!this->Fine)
  {
    this->Fine = this->searched(this->Subject);
  }
  return *this->Fine;
}

std::vector<Polyline> PieceSearch::lines(const CutPlan& plan)
{
  const SearchedPiece& piece = this->fine();
  CutPlan here = plan;
  if (&piece != this->Searched.get())
  {
    const BoundaryRuler& ruler = this->Searched->ruler();
    const auto place = [&](const BoundaryPlace& there) {
      return piece.ruler().nearest(ruler.point(there), ruler.inside(there));
    };
    here.base = plan.start ? plan.base : place(plan.base);
    here.end = plan.type == CurveType::Seam ? place(plan.end) : plan.end;
    here.tip = plan.type == CurveType::Dart ? piece.onto(plan.tip) : plan.tip;
    if (plan.role == MirrorRole::Along && plan.type == CurveType::Dart && piece.mirror())
    {
      here.tip = piece.onto(piece.mirror()->projected(here.tip));
    }
    if (plan.start)
    {
      const bool along = plan.role == MirrorRole::Along && piece.mirror();
      here.start = piece.onto(along ? piece.mirror()->projected(*plan.start) : *plan.start);
    }
    if (plan.via)
    {
      const bool inPlane =
        (plan.role == MirrorRole::Along || plan.role == MirrorRole::Across) && piece.mirror();
      here.via = piece.onto(inPlane ? piece.mirror()->projected(*plan.via) : *plan.via);
    }
    if (plan.role != MirrorRole::Alone && !piece.mirror())
    {
      return {};
    }
  }
  return piece.polylines(here);
}
}
