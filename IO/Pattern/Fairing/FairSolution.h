// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fairing/FairTrial.h"
#include "Fairing/PieceNetwork.h"
#include "Outlines/FairSpan.h"

#include <optional>

namespace flattening
{
namespace pattern
{
/// A plan of all stretches, and the curves that were found for it, piece by piece.
class FairSolution
{
public:
  using Place = StretchPlace;

  /// Source and chains stay the caller's.
  FairSolution(const DrawingSource& all, const BorderChains& chains, const FairLimits& limits);

  std::vector<PlannedChain>& plan() { return this->Plan; }
  const std::vector<PlannedChain>& plan() const { return this->Plan; }
  PlannedStretch& at(const Place& place)
  {
    return this->Plan[place.chain].stretches[place.stretch];
  }
  /// Of each chain, along it.
  const std::vector<std::vector<FairSpan>>& spans() const { return this->Spans; }
  /// Of each point of each chain, millimetres.
  double deviationAt(const Place& place, std::size_t point) const
  {
    return this->Deviation[place.chain][point];
  }
  /// The longest wave that is smoothed away in a piece, millimetres.
  double wave(std::size_t piece) const { return this->Wave[piece]; }

  /// How the outline of a piece is drawn as its own mirror image.
  const OutlineMirror& mirror(std::size_t piece) const { return this->Mirrors[piece]; }
  /// Of a stretch of such a piece the one that is its mirror image, maybe itself.
  std::optional<Place> imageOf(const Place& place) const;
  /// Draws a stretch within such a piece, and its image, each by itself.
  void dropImage(const Place& place);
  /// Gives stretches that are mirror images of each other the same form and breaks.
  void mirrorPlan(std::size_t piece);
  /// Puts the ends of intervals of such stretches where the lengths of the curves say.
  void placeIntervals(std::size_t piece);

  bool isOf(std::size_t chain, std::size_t piece) const;
  /// All stretches of a piece that are of a form.
  std::vector<Place> placesOf(std::size_t piece, StretchForm form) const;
  double toleranceAt(const Place& place, std::size_t point) const;
  /// The largest deviation of a stretch over its tolerance.
  double excess(const Place& place) const;
  bool keepsTolerances(std::size_t piece) const;
  /// Of the points of a piece, millimetres.
  double largestDeviation(std::size_t piece) const;

  PieceNetwork networkOf(std::size_t piece) const;
  /// Finds the curves of a piece. \return false: there are none, and those before stay
  bool solve(std::size_t piece);
  /// The same with more weight on what is too far from its curve.
  /// \param times how often that may be given
  bool solveEvenly(std::size_t piece, int times);
  /// Draws a stretch as it was tried by itself, between nodes as they are.
  /// \param part of the trial that it is
  void take(const Place& place, const FairTrial& trial, std::size_t part);
  /// Draws all of the piece as it was.
  void drawEdges(std::size_t piece);

private:
  void placeIntervals(const Place& place);
  bool emphasizeStretch(const Place& place);

  const DrawingSource& All;
  const BorderChains& Chains;
  std::vector<PlannedChain> Plan;
  std::vector<OutlineMirror> Mirrors; ///< of the pieces
  std::vector<std::vector<FairSpan>> Spans;
  std::vector<std::vector<double>> Deviation;
  std::vector<double> Wave;
  std::vector<double>& Work;
};
}
}
