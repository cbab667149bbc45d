// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Suggestion/ChartMerging.h"
#include "Suggestion/CurveSuggestions.h"
#include "Suggestion/SurfaceMirror.h"
#include "Suggestion/SymmetryPlane.h"

namespace flattening
{
/// Seams, and darts that begin on them or on the boundary, which part a connected surface into
/// disks that flatten within a bound.
///
/// A version with few triangles is parted into many small charts (clusterTriangles()), whose seams
/// are drawn straight, and which are then merged, over the seam first that saves most for what it
/// is forecast to cost, as long as a flattening of the whole chart keeps the bound; last, seams are
/// sewn from an end on and become darts (elimination of seams as in N. Pietroni et al.,
/// "Computational pattern making from 3D garment models", ACM Transactions on Graphics 41(4),
/// 2022). On the surface itself seams are drawn as straight as the bound allows, and charts that do
/// not keep it there are parted again. With a mirror plane the cuts are those of one side and their
/// images, and what of the plane's section is needed.
///
/// One piece that need not keep the length of its boundary is opened along a SeamTree; also where
/// there is a mirror plane that need not be kept, and what is alike on both sides misses the bound.
///
/// \return empty where none are needed, or where the surface cannot be parted
std::vector<SuggestedCurve> chartCuts(const TriangleMesh& mesh,
  const std::optional<SymmetryPlane>& plane, const ChartOptions& options, TrialBudget& budget,
  const Execution& execution);

/// Adds the images of the cuts from the first on, which are in a piece, to the piece that is its
/// image. False where they miss the bound there, and are not added.
bool addImages(std::vector<SuggestedCurve>& cuts, Index first, const SurfaceMirror& mirror,
  const TriangleMesh& piece, const TriangleMesh& image, const ChartOptions& options,
  TrialBudget& budget, const Execution& execution);

/// Cuts with more of such in the pieces that do not keep a bound, which may be another than that of
/// the options.
std::vector<SuggestedCurve> partedCharts(const TriangleMesh& mesh,
  const std::optional<SurfaceMirror>& mirror, const ChartOptions& options, double bound,
  std::vector<SuggestedCurve> cuts, TrialBudget& budget, const Execution& execution);
}
