// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FairPlan.h"
#include "FairSpan.h"

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

/// Splines of exact lengths for all planned stretches, few of them: more where the tolerance is not
/// kept, then fewer wherever it is kept without them. A stretch that cannot keep it stays edge by
/// edge.
class FairFit
{
public:
  /// Source and chains stay the caller's.
  /// \param shares which part of its tolerances each piece may use
  FairFit(const DrawingSource& all, const BorderChains& chains, const std::vector<double>& shares);

  const std::vector<PlannedChain>& plan() const { return this->Plan; }
  /// Of each chain, along it.
  const std::vector<std::vector<FairSpan>>& spans() const { return this->Spans; }
  const std::vector<LeftStretch>& left() const { return this->Left; }
  /// False where nothing of a piece could be drawn otherwise.
  bool solved(std::size_t piece) const { return this->Solved[piece]; }
  /// Of the points of a piece, millimetres.
  double largestDeviation(std::size_t piece) const;

private:
  struct Place
  {
    std::size_t chain = 0;
    std::size_t interval = 0;
  };

  PlannedInterval& at(const Place& place)
  {
    return this->Plan[place.chain].intervals[place.interval];
  }
  bool isOf(std::size_t chain, std::size_t piece) const;
  bool solvePiece(std::size_t piece);
  /// More spans where the tolerance is not kept, and the stretch as it was where they do not help.
  /// \param last nothing is tried any more
  bool refine(std::size_t piece, bool last);
  bool refineStretch(std::size_t c, PlannedStretch& stretch, bool last);
  /// Takes away what spans the tolerances do not need.
  void coarsen();
  std::vector<Place> reducible() const;
  bool tryFewer(const std::vector<Place>& places);
  bool keepsTolerances(std::size_t piece) const;
  void smooth(std::size_t piece);
  /// Lets what was made straight bend again, if there is any.
  bool loosen(std::size_t piece);
  /// Lets all of the piece be as it was.
  void leave(std::size_t piece);
  /// Draws all of the piece as it was.
  void drawEdges(std::size_t piece);
  /// Largest deviation over its tolerance; infinite where nothing is to be smooth.
  double largestShare(std::size_t piece) const;

  const DrawingSource& All;
  const BorderChains& Chains;
  std::vector<PlannedChain> Plan;
  std::vector<double> Wave; ///< smoothed away in each piece
  std::vector<std::vector<FairSpan>> Spans;
  std::vector<std::vector<double>> Deviation; ///< of each interval of each chain
  std::vector<LeftStretch> Left;
  std::vector<bool> Solved;
};
}
}
