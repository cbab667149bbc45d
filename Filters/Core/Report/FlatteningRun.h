// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Design/KeyPrices.h"
#include "Flattening/FlatteningCache.h"
#include "Flattening/FlatteningOptions.h"
#include "Flattening/FlatteningResult.h"
#include "Input/CurvedSurface.h"
#include "Input/DataSet.h"
#include "Options/OptionStructures.h"
#include "Suggestion/CurveSuggestions.h"
#include "Surface/RegionWeights.h"

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace flattening
{
/// What is done with a surface and its curves, and what is to be said of it. The last status
/// counts.
struct FlatteningRun
{
  /// \param curved must live as long as this
  explicit FlatteningRun(CurvedSurface& curved)
    : source(curved)
  {
  }

  CurvedSurface& source;
  Status status;
  std::vector<std::string> warnings; ///< each once
  RegionWeights weights;             ///< of the surface's triangles, for all that follows

  /// \return whether there is a result up to here
  bool conclude(const Status& outcome);
  void warn(const std::vector<std::string>& sentences);

  /// Heals the surface and imprints the curves. \param tolerances by names of curves
  /// \return whether that could be done
  bool load(SurfaceTriangles surface, CurveInput curves, const OptionStructures& options,
    const std::map<std::string, double>& tolerances, const Execution& execution);

  /// Reads the weights of triangles from a cell array of the input; none without its name.
  /// InvalidOption where there is no cell array of that name with one number for each cell.
  /// \pre the surface is loaded
  bool weigh(const Columns& cellArrays, const std::string& name);

  /// \param pins points of the input, or -1 \param kept of the run before; may be null
  /// \return none where the surface is refused
  std::optional<FlatteningResult> flatten(FlatteningOptions options,
    const std::array<std::int64_t, 2>& pins, const Execution& execution,
    FlatteningCache* kept = nullptr);

  /// Measures what the planar shape of each key curve costs.
  /// \return none where the surface is refused
  std::optional<KeyPrices> price(const FlatteningOptions& options, const Execution& execution);

  /// Proposes curves, which the source has then behind its own. \param goOn called where the search
  /// was interrupted, before the surface is flattened with what it found
  /// \return none where the surface is refused
  std::optional<FlatteningResult> suggest(const OptionStructures& options,
    const Execution& execution, const std::function<void()>& goOn, CurveSuggestions& found,
    FlatteningCache* kept = nullptr);

  /// Moves the surface.
  /// \return none where the surface is refused
  std::optional<FlattenableSurface> reshape(const std::set<std::string>& keptCurves,
    const LoadedBody& body, const OptionStructures& settings, const Execution& execution);

private:
  std::optional<FlatteningResult> flattened(
    FlatteningOptions options, const Execution& execution, FlatteningCache* kept);
  bool concludeFlattening(const Status& outcome, const FlatteningResult& result);
  FlatteningOptions weighted(FlatteningOptions options) const;
};
}
