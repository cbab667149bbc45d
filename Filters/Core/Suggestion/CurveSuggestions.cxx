// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/CurveSuggestions.h"

#include "Suggestion/CutTrials.h"
#include "Surface/SurfaceLocator.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace flattening
{
namespace
{
/// Mean change of relative weights by a mirror up to which they count as mirrored: triangles that
/// are not each other's images differ where regions end.
constexpr double littleChange = 0.1;
/// Mirrors that map surfaces onto themselves worse than this, in sqrt(area / pi), are rejected.
constexpr double forcedError = 0.25;
/// Planes that mirror a surface better than this are taken before mirrors by lengths on it.
constexpr double nearlyExact = 3e-3;

/// Whether the plane mirrors the weights onto themselves as well, but for the triangles along their
/// borders. \param weights relative ones
bool mirrorsWeights(
  const TriangleMesh& mesh, const RegionWeights& weights, const SurfaceMirror& mirror)
{
  if (weights.empty())
  {
    return true;
  }
  const SurfaceLocator locator(mesh);
  double change = 0.0;
  double area = 0.0;
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    const Index image = locator.closest(mirror.mirrored(mesh.centroid(t))).triangle;
    change += mesh.area(t) * std::abs(weights[t] - weights[image]);
    area += mesh.area(t);
  }
  return change <= littleChange * area;
}

/// More in a message are not read.
constexpr std::size_t maxNames = 8;

Status checkGrain(const FlatteningOptions& flattening, const std::vector<Polyline>& curves)
{
  if (!flattening.cloth || flattening.cloth->grain != GrainKind::Curve)
  {
    return {};
  }
  const std::vector<std::string>& wanted = flattening.cloth->grainCurves;
  std::set<std::string> known;
  for (const Polyline& curve : curves)
  {
    known.insert(curve.name);
  }
  if (std::any_of(wanted.begin(), wanted.end(), [&known](const std::string& name) {
        return known.count(name) > 0 || isProposedName(name);
      }))
  {
    return {};
  }
  const auto listed = [](const auto& names) {
    std::string list;
    std::size_t left = maxNames;
    for (const std::string& name : names)
    {
      if (left-- == 0)
      {
        return list + ", ...";
      }
      list += (list.empty() ? "\"" : ", \"") + name + "\"";
    }
    return list;
  };
  Status status{ StatusCode::InvalidOption,
    "no curve is named " + listed(wanted) + ", along which the grain is to lie" };
  if (!known.empty())
  {
    status.remedies.emplace_back(Remedy::NameGrain, listed(known));
  }
  status.remedies.emplace_back(Remedy::GiveGrainAngle);
  return status;
}
}

Status findMirror(const TriangleMesh& mesh, const std::vector<Polyline>& curves,
  const SearchOptions& search, const RegionWeights& weights, const Execution& execution,
  std::optional<SurfaceMirror>& mirror)
{
  SymmetryChoice choice;
  Status status = readSymmetry(search.symmetric, mesh, curves, choice);
  if (!status.ok() || choice.kind == SymmetryChoice::Off)
  {
    return status;
  }
  if (choice.kind != SymmetryChoice::Found)
  {
    const std::optional<SymmetryPlane> plane = choice.kind == SymmetryChoice::Stated
      ? measuredPlane(mesh, choice.plane)
      : findSymmetryPlane(mesh, forcedError);
    if (!plane || plane->spread > forcedError)
    {
      return { StatusCode::InvalidOption,
        "no such plane mirrors 95 % of the surface to within " + shortNumber(100.0 * forcedError) +
          " % of its size",
        {}, { { Remedy::Give, "another plane, or symmetric off" } } };
    }
    mirror = SurfaceMirror(*plane);
    return {};
  }
  const std::optional<SymmetryPlane> plane = findSymmetryPlane(mesh);
  auto intrinsic =
    plane && plane->error < nearlyExact ? nullptr : IntrinsicMirror::find(mesh, execution);
  if (intrinsic)
  {
    mirror = SurfaceMirror(std::move(intrinsic));
  }
  else if (plane)
  {
    mirror = SurfaceMirror(*plane);
  }
  // One that holds only nearly is no reason to keep a single cut to its axis.
  const bool alone = search.maximumCuts == 1 && mirror && mirror->intrinsic() &&
    mirror->error > SurfaceMirror::exact;
  if (mirror && (alone || !mirrorsWeights(mesh, weights, *mirror)))
  {
    mirror.reset();
  }
  return {};
}

void addImages(std::vector<SuggestedCurve>& cuts, Index first, const SurfaceMirror& mirror)
{
  const auto last = static_cast<Index>(cuts.size());
  for (Index k = first; k < last; ++k)
  {
    cuts.push_back(cuts[k]);
    cuts.back().mirrorOf = k;
    cuts.back().curve.points = mirror.mirrored(std::move(cuts.back().curve.points));
  }
}

bool arePaired(const std::vector<SuggestedCurve>& cuts)
{
  return std::any_of(
    cuts.begin(), cuts.end(), [](const SuggestedCurve& cut) { return cut.mirrorOf != none; });
}

void pairTypes(std::vector<SuggestedCurve>& cuts)
{
  for (SuggestedCurve& cut : cuts)
  {
    if (cut.mirrorOf != none && cut.curve.type != cuts[cut.mirrorOf].curve.type)
    {
      cut.curve.type = cuts[cut.mirrorOf].curve.type = CurveType::Seam;
    }
  }
}

SuggestedCurve proposedCut(Points3 points, CurveType type, Index mirrorOf)
{
  SuggestedCurve cut;
  cut.length = polylineLength(points);
  cut.curve.type = type;
  cut.curve.points = std::move(points);
  cut.mirrorOf = mirrorOf;
  return cut;
}

void nameCuts(const std::vector<Polyline>& curves, std::vector<SuggestedCurve>& cuts)
{
  Index number = 0;
  for (SuggestedCurve& cut : cuts)
  {
    const char* kind = cut.curve.type == CurveType::Dart ? "dart " : "seam ";
    do
    {
      cut.curve.name = kind + std::to_string(++number);
    } while (std::any_of(curves.begin(), curves.end(),
      [&](const Polyline& curve) { return curve.name == cut.curve.name; }));
  }
}

bool isProposedName(const std::string& name)
{
  const char* const kinds[] = { "dart ", "seam ", "centre line ", "grain line ", "girth ",
    "style line " };
  const std::size_t number = name.find_last_not_of("0123456789") + 1;
  return number < name.size() &&
    std::any_of(std::begin(kinds), std::end(kinds),
      [&](const char* kind) { return name.compare(0, number, kind) == 0; });
}

Status checkSuggestion(
  const SuggestionOptions& suggestion, Index triangles, const std::vector<Polyline>& curves)
{
  const SearchOptions& options = suggestion.search;
  struct Check
  {
    bool holds;
    std::string defect;
    const char* wanted;
  };
  const Check checks[] = {
    { std::isfinite(options.bound) && options.bound >= 0.0 && options.bound < 1.0,
      "the bound of the strain is " + shortNumber(options.bound), "a number from 0 to below 1" },
    { !std::isnan(options.maximumCutLength) && options.maximumCutLength >= 0.0,
      "the greatest length of cuts is " + shortNumber(options.maximumCutLength),
      "a length from 0, 0 for no limit" },
    { !std::isnan(options.maximumWidth) && options.maximumWidth >= 0.0,
      "the greatest width of pieces is " + shortNumber(options.maximumWidth),
      "a width from 0, 0 for any" },
    { options.maximumCuts >= 0, "the greatest number of cuts is below 0",
      "a number from 0, 0 for no limit" },
    { options.pieces >= 0, "the number of pieces is below 0",
      "a number from 0, 0 for as few as possible" },
    { std::isfinite(options.maximumWork) && options.maximumWork >= 0.0,
      "the limit of work is " + shortNumber(options.maximumWork), "a number from 0, 0 for none" },
  };
  for (const Check& check : checks)
  {
    if (!check.holds)
    {
      return invalidOption(check.defect, check.wanted);
    }
  }
  for (const SearchOptions::Preference& preference : options.preferences)
  {
    const bool known = std::any_of(curves.begin(), curves.end(),
      [&](const Polyline& curve) { return curve.name == preference.curve; });
    if (!known)
    {
      return invalidOption("no curve is named \"" + preference.curve + "\"", "the name of a curve");
    }
    if (!std::isfinite(preference.weight) || preference.weight < 0.0)
    {
      return invalidOption(
        "the weight of \"" + preference.curve + "\" is " + shortNumber(preference.weight),
        "a number from 0");
    }
  }
  const Status weights = checkWeights(suggestion.weights, triangles);
  return weights.ok() ? checkGrain(suggestion.flattening, curves) : weights;
}
}
