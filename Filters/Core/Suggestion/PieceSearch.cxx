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
/// Of a trial on it.
constexpr double mostSteps = 75.0;

/// What a cut is worth that begins or ends on the leg of a dart: nobody likes to sew over one.
constexpr double worthOfLegs = 0.5;
}

VertexMarks markVertices(const ImprintedSurface& surface, const SearchOptions& options)
{
  VertexMarks marks;
  marks.barred.assign(surface.mesh.vertexCount(), 0);
  marks.worth.assign(surface.mesh.vertexCount(), 1.0);
  for (const FeatureCurve& curve : surface.curves)
  {
    for (std::size_t k = 1; k < curve.vertices.size() && curve.type == CurveType::Dart; ++k)
    {
      marks.worth[curve.vertices[k]] = worthOfLegs;
    }
    for (const SearchOptions::Preference& preference : options.preferences)
    {
      for (Index v : curve.name == preference.curve ? curve.vertices : Indices{})
      {
        marks.worth[v] = preference.weight;
      }
    }
    for (Index v : curve.type == CurveType::Key ? curve.vertices : Indices{})
    {
      marks.barred[v] = 1;
    }
  }
  return marks;
}

std::unique_ptr<SearchedPiece> searchedPiece(
  const PieceSurface& piece, const VertexMarks& marks, const std::optional<SurfaceMirror>& mirror)
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
    barred.push_back(marks.barred[marked]);
    worth.push_back(marks.worth[marked]);
  }
  RegionWeights weights;
  for (std::size_t t = 0; t < opened.triangles.size() && !piece.weights.empty(); ++t)
  {
    weights.push_back(piece.weights[opened.triangles[t]]);
  }
  std::vector<double> weight = vertexWeights(opened.mesh, weights);
  return std::make_unique<SearchedPiece>(
    std::move(opened.mesh), std::move(barred), std::move(worth), std::move(weight), mirror);
}

PieceSearch::PieceSearch(const PieceSurface& piece, const VertexMarks& marks,
  const std::optional<SurfaceMirror>& mirror, const ImprintOptions& imprint,
  const FlatteningOptions& flattening, const SearchOptions& options)
  : Subject(piece)
  , Marks(marks)
  , Mirror(mirror)
  , Options(options)
  , Coarse(coarsened(piece, coarseTriangles))
  , Trials(this->Coarse.mesh, this->Coarse.polylines(), imprint, roughly(flattening), options.goal,
      this->Coarse.weights, mostSteps)
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
  TrialOutcome before = this->Trials.startUncut(budget, execution);
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
    this->Fine = searchedPiece(this->Subject, this->Marks, this->Mirror);
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
