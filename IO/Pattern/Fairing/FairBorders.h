// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Execution.h"
#include "Fairing/FairFit.h"
#include "Outlines/DrawingSource.h"
#include "Outlines/Pattern.h"

#include <memory>
#include <optional>
#include <utility>

namespace flattening::pattern
{
/// The smooth borders of one flattening, which are found once for all of its files.
class FairCache
{
public:
  /// \param execution hears of the search
  explicit FairCache(Execution execution = {})
    : Run(std::move(execution))
  {
  }
  /// Those of a source, found anew only where it, or what of its options they depend on, is another
  /// one than last time.
  std::shared_ptr<const FairBorders> of(const DrawingSource& all);

private:
  Execution Run;
  std::optional<DrawingSource> Last; ///< that they are of
  std::shared_ptr<const FairBorders> Borders;
};

/// What became of the borders and curves of one piece.
struct FairPieceReport
{
  std::size_t edges = 0;            ///< of the mesh along them
  std::size_t splines = 0;          ///< cubic Bezier curves in their place
  std::size_t segments = 0;         ///< straight lines in their place, and edges that were left
  std::size_t straightened = 0;     ///< stretches that were not straight before
  double deviation = 0.0;           ///< of the mesh's points from what is drawn, millimetres
  double strainBefore = 0.0;        ///< of 95 % of the area, strainQuantile()
  double strain = 0.0;              ///< the same with borders as they are drawn, followBorders()
  double share = 1.0;               ///< of the tolerances that was used, so that it rises little
  bool solved = true;               ///< false: nothing was drawn otherwise
  std::optional<MirrorAxis> mirror; ///< of its outline, which is drawn as its own mirror image
  double mirrorMiss = 0.0;          ///< of the outline that is drawn, millimetres
  double lengthDifference = 0.0; ///< of sides of it that are mirror images, on the surface, at most
  double lengthChange = 0.0;     ///< of a stretch between two corners, from the surface, at most
  std::string whyNotMirrored;    ///< empty: it is, or was not to be
  double worstLeft = 0.0;     ///< what the worst of the stretches that were left would have needed
  double wantedOfWorst = 0.0; ///< its tolerance
  std::vector<std::string> left; ///< names of curves with such stretches
};

/// The borders and feature curves of all pieces as smooth curves: between corners fair splines, or
/// straight lines where they are nearly so, each interval with its exact length, both sides of a
/// seam alike. What cannot be drawn within the tolerance stays as it was, edge by edge. A piece of
/// which 95 % of the area would be strained by over 0.3 % more is drawn nearer to its flat points.
class FairBorders
{
public:
  /// \param all its options say how far points of the flat pieces may be from what is drawn
  explicit FairBorders(const DrawingSource& all, const Execution& execution = {});

  const BorderChains& chains() const { return this->Chains; }
  const std::vector<PlannedChain>& plan() const { return this->Plan; }
  /// Of each chain, along it.
  const std::vector<std::vector<FairSpan>>& spans() const { return this->Spans; }
  const std::vector<FairPieceReport>& reports() const { return this->Reports; }
  /// Where the points are now, millimetres; those within the pieces are where they were.
  const Points2& positions() const { return this->Positions; }
  /// A feature curve or border from its first point to its last.
  std::vector<FairSpan> curveOf(const SourceWire& wire) const;
  /// The part of a curve along one edge, from its first point to its second.
  std::vector<FairSpan> alongEdge(
    Index from, Index to, double fromFraction = 0.0, double toFraction = 1.0) const;

private:
  void place(const DrawingSource& all);
  /// Where along a chain its smooth curve is so long.
  double placeAt(std::size_t chain, double length) const;
  void report(const DrawingSource& all, const FairFit& fit);
  void reportMirror(const FairFit& fit, std::size_t piece);
  /// Draws a piece no longer as its own mirror image, but by all of its tolerances.
  void dropMirror(std::size_t piece, const std::string& why, FairLimits& limits);
  /// Takes from what pieces may do that cannot be drawn so, or are strained by too much. \return
  /// whether there are any
  bool lower(const DrawingSource& all, const FairFit& fit, FairLimits& limits);

  BorderChains Chains;
  std::vector<PlannedChain> Plan;
  std::vector<std::vector<FairSpan>> Spans;
  std::vector<std::vector<double>> Places; ///< of the points of each chain along its spans
  Points2 Positions;
  std::vector<FairPieceReport> Reports;
  std::vector<std::string> WhyNotMirrored; ///< by piece
};

/// Says on a piece what was drawn smoothly, what was made straight or its own mirror image, and
/// what was left as it was and why.
void addFairNotes(const FairPieceReport& report, PatternPiece& piece);

/// Adds the points of an edge of a border as it is drawn, all but its second end.
void addDrawnEdge(const DrawingSource& all, Index from, Index to, Points2& points);

/// A line along edges of borders as it is drawn, with its last point.
Points2 drawnLine(const DrawingSource& all, const Indices& points);

/// A place on an edge of a border as it is drawn.
/// \param outward to the right of the way from the first point to the second, of length 1
Point2 pointOnDrawnEdge(
  const DrawingSource& all, Index from, Index to, double fraction, Point2& outward);
}
