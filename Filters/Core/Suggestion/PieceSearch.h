// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Quality/ScaleFactor.h"
#include "Suggestion/CutTrials.h"
#include "Suggestion/PieceSurface.h"
#include "Suggestion/SearchedPiece.h"

#include <memory>

namespace flattening
{
/// What a search is about; it only refers to what it names.
struct SearchSubject
{
  const TriangleMesh& mesh;
  const std::vector<Polyline>& curves;
  const ImprintOptions& imprint;
  const FlatteningOptions& flattening;
  const SearchOptions& search;
  std::optional<SurfaceMirror> mirror; ///< to which cuts keep
  const RegionWeights& weights;        ///< relative ones
  SearchGoal goal = SearchGoal::Energy;
};

/// Marks of the vertices of the surface that the pieces are parts of.
struct VertexMarks
{
  std::vector<char> barred; ///< on a key curve, which no cut may cross
  /// What the price of a cut that begins or ends there is divided by.
  std::vector<double> preference;
};

VertexMarks markVertices(const ImprintedSurface& surface, const SearchOptions& options);

/// A cut that has been flattened.
struct TriedCut
{
  CutPlan plan;
  TrialOutcome outcome;
  double score = 0.0; ///< drop of the goal per price
};

/// Searches one piece for its best next cut, on a version with few triangles, of which a flattening
/// takes milliseconds: ranks plans by forecast, flattens the first that differ, and moves the ends
/// of the best while that raises the gain per price (a search by patterns: R. Hooke, T. A. Jeeves,
/// "Direct search solution of numerical and statistical problems", Journal of the ACM 8(2), 1961).
class PieceSearch
{
public:
  /// All must outlive it. \param options those of the subject, but for what this piece may have
  PieceSearch(const PieceSurface& piece, const VertexMarks& marks, const SearchSubject& subject,
    const SearchOptions& options);

  /// False where nothing can be planned on the piece.
  bool ok(const Execution& execution);
  /// The cuts that lower the goal and are no longer than `longest`, the best first. Where none of
  /// the first plans does those of the types that are not among them are tried. \pre ok()
  std::vector<TriedCut> run(double longest, TrialBudget& budget, const Execution& execution);
  /// The lines of a plan on the piece itself. Empty where there is no way. \pre ok()
  std::vector<Polyline> lines(const CutPlan& plan);
  /// The piece with all its triangles. \pre ok()
  const SearchedPiece& fine();

private:
  std::vector<TriedCut> tryAll(const std::vector<CutPlan>& plans, double longest,
    TrialBudget& budget, const Execution& execution) const;
  TriedCut polished(
    TriedCut cut, double longest, TrialBudget& budget, const Execution& execution) const;

  const PieceSurface& Subject;
  const VertexMarks& Marks;
  const std::optional<SurfaceMirror>& Mirror;
  const SearchOptions& Options;
  PieceSurface Coarse;
  CutTrials Trials;
  TrialOutcome Before; ///< without another cut
  std::unique_ptr<SearchedPiece> Searched;
  std::unique_ptr<SearchedPiece> Fine;
  std::unique_ptr<ScaleFactor> Factor;
};
}
