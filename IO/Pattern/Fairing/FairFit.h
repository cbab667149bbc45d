// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fairing/FairSolution.h"

namespace flattening
{
namespace pattern
{
/// A stretch that stays as it was.
struct LeftStretch
{
  std::size_t chain = 0;
  std::size_t firstPoint = 0;
  double needed = 0.0;    ///< deviation with as many splines as make sense, millimetres
  double tolerance = 0.0; ///< that it had
};

/// Splines of exact lengths for all planned stretches, of few curves: divided where the tolerance
/// is not kept, then joined wherever it is kept without a break. A stretch that cannot keep it
/// stays edge by edge.
class FairFit
{
public:
  /// Source and chains stay the caller's.
  FairFit(const DrawingSource& all, const BorderChains& chains, const FairLimits& limits);

  const std::vector<PlannedChain>& plan() const { return this->Now.plan(); }
  /// Of each chain, along it.
  const std::vector<std::vector<FairSpan>>& spans() const { return this->Now.spans(); }
  const std::vector<LeftStretch>& left() const { return this->Left; }
  /// False where nothing of a piece could be drawn otherwise.
  bool solved(std::size_t piece) const { return this->Solved[piece]; }
  /// How the outline of a piece is drawn as its own mirror image.
  const OutlineMirror& mirror(std::size_t piece) const { return this->Now.mirror(piece); }
  /// What of such a piece cannot be drawn so, which has ended the search for its curves.
  const std::optional<LeftStretch>& unmirrored(std::size_t piece) const
  {
    return this->Unmirrored[piece];
  }
  /// Of the points of a piece, millimetres.
  double largestDeviation(std::size_t piece) const { return this->Now.largestDeviation(piece); }

private:
  using Place = FairSolution::Place;

  /// Breaks where the tolerance is not kept, and the stretch as it was where they do not help.
  /// \param last nothing is tried any more
  bool refine(std::size_t piece, bool last);
  /// Leaves what does not keep its tolerance. \return whether there is a solution
  bool settle(std::size_t piece);
  bool refineStretch(const Place& place, bool last);
  void fitPiece(std::size_t piece);
  /// Lets a stretch be as it was, or all that do not keep their tolerance.
  void leave(const Place& place);
  void leaveBad(std::size_t piece);
  bool addBreaks(const Place& place);
  /// Draws each stretch by fewer curves, where these keep the tolerances.
  void coarsen(std::size_t piece);
  /// Gives all splines of a piece twice as many curves, where they may have them.
  bool halveSpans(std::size_t piece);
  /// Lets what was made straight bend again, if there is any.
  bool loosen(std::size_t piece);
  /// Lets all of the piece be as it was.
  void leave(std::size_t piece);

  const BorderChains& Chains;
  FairSolution Now;
  std::vector<LeftStretch> Left;
  std::vector<bool> Solved;
  std::vector<std::optional<LeftStretch>> Unmirrored;
};
}
}
