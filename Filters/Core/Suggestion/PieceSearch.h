// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/CutSearch.h"
#include "Suggestion/PieceSurface.h"

#include <memory>

namespace flattening
{
/// What the surface that the pieces are of says of its vertices.
struct VertexMarks
{
  std::vector<char> barred;  ///< on a key curve, which no cut may cross
  std::vector<double> worth; ///< what the price of a cut that begins or ends there is divided by
};

VertexMarks markVertices(const ImprintedSurface& surface, const SearchOptions& options);

/// Null where it is not one piece once its darts are opened. \param marks of the surface that the
/// piece is of
std::unique_ptr<SearchedPiece> searchedPiece(
  const PieceSurface& piece, const VertexMarks& marks, const std::optional<SurfaceMirror>& mirror);

/// A cut as lines on the piece as fine as it is, and what it did to a coarse version.
struct FoundCut
{
  TriedCut tried;
  std::vector<Polyline> lines;
};

/// Searches one piece for its best next cut: on a version of so many triangles that a flattening
/// takes milliseconds.
class PieceSearch
{
public:
  /// All must outlive it.
  PieceSearch(const PieceSurface& piece, const VertexMarks& marks,
    const std::optional<SurfaceMirror>& mirror, const ImprintOptions& imprint,
    const FlatteningOptions& flattening, const SearchOptions& options);

  /// False where nothing can be planned on the piece.
  bool ok(const Execution& execution);
  /// The best cuts first, no longer than `longest`.
  std::vector<TriedCut> run(double longest, TrialBudget& budget, const Execution& execution);
  /// The lines of a plan on the piece itself. Empty where there is no way.
  std::vector<Polyline> lines(const CutPlan& plan);
  /// The piece as fine as it is. \pre ok()
  const SearchedPiece& fine();

private:
  const PieceSurface& Subject;
  const VertexMarks& Marks;
  const std::optional<SurfaceMirror>& Mirror;
  const SearchOptions& Options;
  PieceSurface Coarse;
  CutTrials Trials;
  std::unique_ptr<SearchedPiece> Searched;
  std::unique_ptr<SearchedPiece> Fine;
  std::unique_ptr<ScaleFactor> Factor;
};
}
