// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cut/SurfaceCut.h"
#include "Suggestion/ChartTrials.h"
#include "Suggestion/CurveSuggestions.h"
#include "Suggestion/SymmetryPlane.h"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace flattening
{
/// The flattening of a chart on the surface itself is given up after these steps; those of charts
/// that keep the bound take 126 at most, beside the narrow triangles of seams that are drawn.
inline constexpr double maxDrawnSteps = 130.0;

/// Of the bound, up to where pieces are relaxed or joined: the flattening to come may have a few
/// triangles otherwise.
inline constexpr double relaxedShare = 0.95;

/// A mirror plane along whose section the surface has edges.
struct MirrorSection
{
  SymmetryPlane plane;
  double distance = 0.0; ///< within which points are on the section

  bool has(const Point3& point) const { return std::abs(this->plane.side(point)) < this->distance; }
};

/// A seam or dart to be drawn, the first of each pair of images.
struct ChartSeam
{
  Points3 chain;
  Points3 imageChain; ///< on the other side of the plane
  bool dart = false;
  bool crosses = false; ///< the mirror plane, in which the chain ends
  bool paired = false;
  int least = 0;  ///< level, that of a straight line where there is one
  int level = 0;  ///< of SeamDrawing
  Points3 points; ///< none: to be drawn
  Points3 image;
};

/// The pieces of a cut surface, and what they are like flat.
struct DrawnPieces
{
  CutSurface cut;
  std::vector<Piece> pieces;
  std::vector<ChartTrials::Result> results;

  DrawnPieces(
    CutSurface surface, ChartTrials& trials, TrialBudget& budget, const Execution& execution)
    : cut(std::move(surface))
    , pieces(extractPieces(this->cut))
  {
    std::vector<std::vector<TriangleMesh>> meshes;
    for (const Piece& piece : this->pieces)
    {
      meshes.push_back({ piece.mesh });
    }
    this->results = trials.run(meshes, std::numeric_limits<double>::infinity(), budget, execution);
  }

  /// How much is wrong with one: its strain, and one more where it is folded, lies over itself, or
  /// has no flattening.
  double fault(std::size_t piece) const
  {
    const ChartTrials::Result& result = this->results[piece];
    return (result.sound ? 0.0 : 1.0) + (std::isinf(result.strain) ? 0.0 : result.strain);
  }

  /// How many are wrong, and the largest strain.
  double worst() const
  {
    double count = 0.0;
    double strain = 0.0;
    for (const ChartTrials::Result& result : this->results)
    {
      count += result.sound ? 0.0 : 1.0;
      strain = std::max(strain, std::isinf(result.strain) ? 0.0 : result.strain);
    }
    return count + strain;
  }
};

struct SettledSeams
{
  std::vector<SuggestedCurve> cuts; ///< the seams and their images
  Index pieces = 0;
  double worst = std::numeric_limits<double>::infinity(); ///< DrawnPieces::worst()
};

/// Darts with different pieces at their sides, as where seams were added, become seams.
void openDividingDarts(const TriangleMesh& mesh, const std::vector<Polyline>& curves,
  const ImprintOptions& imprint, std::vector<SuggestedCurve>& cuts);

/// The cuts as they can be laid into the surface together, beside curves that it has: without what
/// cannot be followed, and each stretch that two share once; cuts in parts have no images. None
/// where that does not end.
std::vector<SuggestedCurve> laidTogether(const TriangleMesh& mesh, std::vector<SuggestedCurve> cuts,
  const std::vector<Polyline>& curves = {}, const ImprintOptions& imprint = {});

/// Draws seams on a surface as straight as charts that keep the bound and cuts that do not meet
/// allow: straight at first, nearer to their chains where something is wrong, and straight again
/// one by one where they may. Those that cannot be drawn apart are laid together.
/// \param drawn the surface with the section of the mirror plane, if there is one
/// \param most steps after which a flattening is given up
SettledSeams settleSeams(const TriangleMesh& surface, const TriangleMesh& drawn,
  const std::optional<MirrorSection>& mirror, std::vector<ChartSeam> seams, double bound,
  double most, const FlatteningOptions& flattening, TrialBudget& budget,
  const Execution& execution);
}
