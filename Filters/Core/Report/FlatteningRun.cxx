// SPDX-License-Identifier: BSD-3-Clause
#include "Report/FlatteningRun.h"

#include "Design/LineSuggestion.h"
#include "Flattening/SurfaceFlattening.h"
#include "Report/FlatteningArrays.h"
#include "Report/FlatteningTables.h"
#include "Report/SuggestionReport.h"
#include "Suggestion/CurveSuggestion.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace flattening
{
namespace
{
/// The curves of the input with those proposed behind them, of a source of their own.
CurveInput withProposed(CurveInput curves, const std::vector<SuggestedCurve>& proposed)
{
  const int source = curves.sourceOfPolyline.empty()
    ? 1
    : *std::max_element(curves.sourceOfPolyline.begin(), curves.sourceOfPolyline.end()) + 1;
  Index point = 0;
  for (std::size_t k = 0; k < proposed.size(); ++k)
  {
    Polyline curve = proposed[k].curve;
    curve.pointIds.clear();
    while (curve.pointIds.size() < curve.points.size())
    {
      curve.pointIds.push_back(point++);
    }
    curves.polylines.push_back(std::move(curve));
    curves.cellOfPolyline.push_back(static_cast<std::int64_t>(k));
    curves.sourceOfPolyline.push_back(source);
  }
  return curves;
}

/// Reads the numbers of a cell array for the triangles of the surface.
Status readWeights(const Columns& cellArrays, const std::string& name, const CurvedSurface& source,
  RegionWeights& weights)
{
  if (name.empty())
  {
    return {};
  }
  const Column* const values = findColumn(cellArrays, name);
  if (!values || values->isText() || values->components != 1)
  {
    std::string names;
    for (const Column& column : cellArrays)
    {
      names +=
        column.isText() || column.components != 1 ? "" : (names.empty() ? "" : ", ") + column.name;
    }
    return invalidOption(values && !values->isText()
        ? "the cell array \"" + name + "\" has " + std::to_string(values->components) +
          " numbers a cell"
        : "the surface has no cell array of numbers named \"" + name + "\"",
      names.empty() ? "a cell array with a number for each cell" : "one of " + names);
  }
  for (const std::int64_t cell : source.surface.input.cellOfTriangle)
  {
    weights.push_back(values->number(static_cast<std::size_t>(cell)));
  }
  return {};
}

/// Finds the curves of these names; refuses a name that no curve has.
Status findCurves(const std::set<std::string>& names, const CurvedSurface& source, Indices& curves)
{
  const std::vector<FeatureCurve>& all = source.imprinted.curves;
  for (const std::string& name : names)
  {
    const std::size_t before = curves.size();
    for (std::size_t c = 0; c < all.size(); ++c)
    {
      if (all[c].name == name)
      {
        curves.push_back(static_cast<Index>(c));
      }
    }
    if (curves.size() == before)
    {
      Status missing = noCurveNamed(name, source);
      missing.remedies = { { Remedy::Give, "the name of a curve" } };
      return missing;
    }
  }
  return {};
}

/// A sentence that says how far the bound was missed, and what may help.
std::string describeShortfall(const FlattenableSurface& result, const FlattenableOptions& options)
{
  const bool freed = !options.keepBoundary && options.kept.empty();
  const std::string bias = options.outsideBias > 0.0 ? "lower the outside bias, " : "";
  return "the strain is " + shortNumber(100.0 * result.strainAfter) + " %, above the bound of " +
    shortNumber(100.0 * options.bound) + " %, after moving the surface by " +
    shortNumber(result.shift.size > 0.0 ? 100.0 * result.shift.mean / result.shift.size : 0.0) +
    " % of its size in the mean; " + result.hindrance + "; " + bias +
    (freed ? "add darts" : "add darts, or keep fewer curves and not the boundary");
}
}

bool FlatteningRun::conclude(const Status& outcome)
{
  this->status = outcome;
  return !outcome.refused();
}

void FlatteningRun::warn(const std::vector<std::string>& sentences)
{
  for (const std::string& sentence : sentences)
  {
    if (std::find(this->warnings.begin(), this->warnings.end(), sentence) == this->warnings.end())
    {
      this->warnings.push_back(sentence);
    }
  }
}

bool FlatteningRun::load(SurfaceTriangles surface, CurveInput curves,
  const OptionStructures& options, const std::map<std::string, double>& tolerances,
  const Execution& execution)
{
  this->source.surface = surface.outcome.ok()
    ? loadSurface(std::move(surface), options.coincidentPoints, options.defects())
    : LoadedSurface{ {}, {}, surface.outcome, {} };
  const std::vector<std::string>& mendings = this->source.surface.mendings;
  this->source.warnings.insert(this->source.warnings.end(), mendings.begin(), mendings.end());
  this->source.outcome = this->source.surface.outcome;
  if (this->source.outcome.ok())
  {
    imprintInput(std::move(curves), options.imprint, execution, this->source);
  }
  const bool loaded = this->conclude(this->source.outcome) &&
    this->conclude(applyTolerances(tolerances, this->source));
  this->warn(loaded ? this->source.warnings : std::vector<std::string>());
  return loaded;
}

/// Concludes with the status of a flattening, and says what it leaves out.
bool FlatteningRun::concludeFlattening(const Status& outcome, const FlatteningResult& result)
{
  const bool flat = this->conclude(
    this->source.outcomeOfStage(outcome, outcome.refused() ? nullptr : result.cut.get()));
  if (flat && !result.leftOut.empty())
  {
    this->warn({ describeLeftOut(this->source, result) });
  }
  return flat;
}

bool FlatteningRun::weigh(const Columns& cellArrays, const std::string& name)
{
  this->weights.clear();
  return this->conclude(readWeights(cellArrays, name, this->source, this->weights));
}

FlatteningOptions FlatteningRun::weighted(FlatteningOptions options) const
{
  for (const Index t : this->weights.empty() ? Indices() : this->source.imprinted.originalTriangle)
  {
    options.isometric.weights.push_back(this->weights[t]);
  }
  return options;
}

std::optional<FlatteningResult> FlatteningRun::flatten(FlatteningOptions options,
  const std::array<std::int64_t, 2>& pins, const Execution& execution, FlatteningCache* kept)
{
  if (!this->conclude(this->source.pinVertices(pins, options.conformal.pins)))
  {
    return {};
  }
  this->warn(describeShortEnds(this->source));
  return this->flattened(std::move(options), execution, kept);
}

std::optional<FlatteningResult> FlatteningRun::flattened(
  FlatteningOptions options, const Execution& execution, FlatteningCache* kept)
{
  FlatteningResult result = flattenSurface(this->source.imprinted.mesh,
    this->source.imprinted.curves, this->weighted(std::move(options)), execution, kept);
  if (!this->concludeFlattening(result.status, result))
  {
    return {};
  }
  this->warn(describeVerdicts(this->source, result));
  return result;
}

std::optional<KeyPrices> FlatteningRun::price(
  const FlatteningOptions& options, const Execution& execution)
{
  KeyPrices prices = priceKeys(
    this->source.imprinted.mesh, this->source.imprinted.curves, this->weighted(options), execution);
  return this->conclude(this->source.outcomeOfStage(prices.status))
    ? std::make_optional(std::move(prices))
    : std::nullopt;
}

std::optional<FlatteningResult> FlatteningRun::suggest(const OptionStructures& options,
  const Execution& execution, const std::function<void()>& goOn, CurveSuggestions& found,
  FlatteningCache* kept)
{
  const bool lines = options.search.cuts == SuggestedCuts::Lines;
  found = (lines ? suggestLines : suggestCurves)(this->source.surface.prepared.mesh,
    this->source.curves.polylines,
    { options.search, this->weights, options.imprint, options.flattening },
    execution.part(0.0, 0.9));
  if (!this->conclude(this->source.outcomeOfStage(found.status)))
  {
    return {};
  }
  const std::vector<Polyline> given = this->source.curves.polylines;
  this->warn(describeShortEnds(this->source)); // those of proposed cuts are meant
  if (found.end == SearchEnd::Interrupted)
  {
    goOn();
  }
  imprintInput(
    withProposed(this->source.curves, found.curves), options.imprint, execution, this->source);
  std::optional<FlatteningResult> result;
  if (this->conclude(this->source.outcome))
  {
    this->warn(this->source.warnings);
    result = this->flattened(options.flattening, execution.part(0.9, 1.0), kept);
  }
  const std::string shortfall = result && !lines
    ? describeShortfall(found, options.search.bound, options.search.maximumWidth, given)
    : std::string();
  if (!shortfall.empty())
  {
    this->warn({ shortfall });
  }
  return result;
}

std::optional<FlattenableSurface> FlatteningRun::reshape(const std::set<std::string>& keptCurves,
  const LoadedBody& body, const OptionStructures& settings, const Execution& execution)
{
  FlattenableOptions options = settings.reshaping;
  options.body = body.get();
  options.flattening = this->weighted(settings.flattening);
  if (!this->conclude(body.outcome) ||
    !this->conclude(findCurves(keptCurves, this->source, options.kept)))
  {
    return {};
  }
  this->warn(describeShortEnds(this->source));
  FlattenableSurface moved =
    makeFlattenable(this->source.imprinted.mesh, this->source.imprinted.curves, options, execution);
  if (!this->concludeFlattening(moved.status, moved.after))
  {
    return {};
  }
  if (!moved.boundMet)
  {
    this->warn({ describeShortfall(moved, options) });
  }
  return moved;
}
}
