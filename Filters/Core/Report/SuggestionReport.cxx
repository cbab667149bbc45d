// SPDX-License-Identifier: BSD-3-Clause
#include "Report/SuggestionReport.h"

#include "Base/Types.h"
#include "Suggestion/CutTrials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace flattening
{
std::vector<SuggestedCurve> suggestionRows(
  const std::vector<Polyline>& curves, const CurveSuggestions& suggestions)
{
  std::vector<SuggestedCurve> rows;
  for (const Polyline& curve : curves)
  {
    rows.emplace_back().curve = curve;
    rows.back().length = polylineLength(curve.points);
  }
  rows.insert(rows.end(), suggestions.curves.begin(), suggestions.curves.end());
  return rows;
}

Columns suggestionArrays(const std::vector<SuggestedCurve>& rows, std::size_t first)
{
  Columns cells;
  const TableColumns<SuggestedCurve> columns(cells, rows);
  using Curve = const SuggestedCurve&;
  columns.addAs<int>("CurveType", [](Curve row) { return row.curve.type; });
  columns.add("CurveName", [](Curve row) { return row.curve.name; });
  columns.addAs<int>(
    "KeyShape", [](Curve row) { return row.curve.keyShape == KeyShape::Straight ? 1 : 0; });
  columns.add("LengthTolerance", [](Curve row) { return row.curve.tolerance; });
  addEases(cells, rows.size(), [&](std::size_t c) { return rows[c].curve.ease; });
  addRows<int>(cells, "Rank", rows.size(),
    [&](std::size_t c) { return c < first ? -1 : static_cast<int>(c - first) + 1; });
  columns.add("Length", &SuggestedCurve::length);
  columns.add("PredictedGain", &SuggestedCurve::predictedGain);
  columns.add("Gain", &SuggestedCurve::gain);
  columns.add("Opening", &SuggestedCurve::opening);
  columns.add("AreaErrorBefore", &SuggestedCurve::areaErrorBefore);
  columns.add("AreaErrorAfter", &SuggestedCurve::areaErrorAfter);
  columns.add("StrainBefore", &SuggestedCurve::strainBefore);
  columns.add("StrainAfter", &SuggestedCurve::strainAfter);
  columns.addAs<int>(
    "MirrorOf", [](Curve row) { return row.mirrorOf == none ? -1 : row.mirrorOf + 1; });
  return cells;
}

Columns mirrorArrays(const CurveSuggestions& suggestions)
{
  Columns field;
  if (suggestions.mirror && suggestions.mirror->intrinsic())
  {
    const std::array<Point3, 2>& axis = suggestions.mirror->intrinsic()->axis();
    addRows<double>(field, "MirrorAxis", 6,
      [&](std::size_t k) { return axis[k / 3][static_cast<Eigen::Index>(k % 3)]; });
  }
  if (suggestions.mirror && suggestions.mirror->plane())
  {
    const SymmetryPlane& plane = *suggestions.mirror->plane();
    addRows<double>(field, "MirrorPlane", 4, [&](std::size_t k) {
      return k < 3 ? plane.normal[static_cast<Eigen::Index>(k)] : plane.offset;
    });
  }
  return field;
}

Columns leftOutTable(const CurveSuggestions& suggestions)
{
  Columns table;
  const TableColumns<SuggestedCurve> columns(table, suggestions.leftOut);
  columns.add("Name", [](const SuggestedCurve& line) { return line.curve.name; });
  columns.add("Type", [](const SuggestedCurve& line) { return curveTypeName(line.curve.type); });
  columns.add("Sound", &SuggestedCurve::sound);
  columns.add("Length", &SuggestedCurve::length);
  columns.add("Gain", &SuggestedCurve::gain);
  columns.add("AreaErrorBefore", &SuggestedCurve::areaErrorBefore);
  columns.add("AreaErrorAfter", &SuggestedCurve::areaErrorAfter);
  columns.add("StrainBefore", &SuggestedCurve::strainBefore);
  columns.add("StrainAfter", &SuggestedCurve::strainAfter);
  return table;
}

Columns searchTable(const CurveSuggestions& suggestions)
{
  Columns table;
  const std::vector<const CurveSuggestions*> rows{ &suggestions };
  const TableColumns<const CurveSuggestions*> columns(table, rows);
  columns.add("BoundMet", &CurveSuggestions::boundMet);
  columns.add("StrainBefore", &CurveSuggestions::strainBefore);
  columns.add("StrainAfter", &CurveSuggestions::strainAfter);
  columns.add("Width", &CurveSuggestions::width);
  columns.add("Trials", &CurveSuggestions::trials);
  columns.add("Work", &CurveSuggestions::work);
  return table;
}

std::string describeShortfall(const CurveSuggestions& suggestions, double bound,
  double maximumWidth, const std::vector<Polyline>& curves)
{
  const std::string byWork =
    "the limit of work ended the search after " + std::to_string(suggestions.trials) + " trials";
  const bool worked = suggestions.end == SearchEnd::WorkUsedUp;
  const std::string interrupted =
    "the search was interrupted after " + std::to_string(suggestions.trials) + " trials";
  const std::string needed = std::to_string(std::lround(suggestions.cutsNeeded));
  const bool more = suggestions.end == SearchEnd::CutsUsedUp && suggestions.cutsNeeded > 0.0;
  if (more && suggestions.curves.empty())
  {
    return "nothing was tried: the surface takes " + needed +
      " seams to be opened, more than the cuts allowed; allow more cuts";
  }
  const bool ended = worked || suggestions.end == SearchEnd::Interrupted;
  if (std::isnan(suggestions.strainAfter) && ended && suggestions.curves.empty())
  {
    return worked ? byWork +
        ", before the surface could be flattened with any cuts; allow a longer search, or draw "
        "seams that open the surface"
                  : interrupted + ", before any cut was found";
  }
  if (std::isnan(suggestions.strainAfter) && ended)
  {
    return (worked ? byWork : interrupted) +
      ", before the surface was flattened with the proposed cuts; allow a longer search";
  }
  if (std::isnan(suggestions.strainAfter))
  {
    const bool keys = std::any_of(curves.begin(), curves.end(),
      [](const Polyline& curve) { return curve.type == CurveType::Key; });
    return keys
      ? "nothing could be tried: the seams that open the surface meet a key curve, or cannot be "
        "made; make it an accessory curve, or draw seams that open the surface"
      : "nothing could be tried: seams that open the surface are not found, or it cannot be "
        "flattened with them; draw seams that open the surface";
  }
  if (maximumWidth > 0.0 && suggestions.width > maximumWidth)
  {
    return "a piece is " + shortNumber(suggestions.width) + " wide, more than the " +
      shortNumber(maximumWidth) + " allowed; allow more cuts, or part it by seams";
  }
  if (suggestions.boundMet || bound == 0.0)
  {
    return suggestions.end == SearchEnd::Interrupted ? interrupted
      : worked && bound == 0.0 ? byWork + "; allow a longer search for more cuts"
                               : std::string();
  }
  const Point3& p = suggestions.worstPlace;
  const std::string percent = shortNumber(100.0 * bound) + " %, ";
  const std::string left = "the proposed cuts leave a strain of " +
    shortNumber(100.0 * suggestions.strainAfter) + " %, " +
    (suggestions.strainAfter <= bound
        ? "within the bound of " + percent + "and pieces that fold or overlap; "
        : "above the bound of " + percent + "the largest at (" + shortNumber(p.x()) + ", " +
          shortNumber(p.y()) + ", " + shortNumber(p.z()) + "); ");
  switch (suggestions.end)
  {
    case SearchEnd::WorkUsedUp:
      return left + byWork + "; allow a longer search or a larger strain";
    case SearchEnd::Interrupted:
      return left + interrupted;
    case SearchEnd::GivenUp:
      return left + "the search was given up, since " +
        (suggestions.cutsNeeded > 0.0 && suggestions.cutsNeeded < 1e6
            ? "at this rate about " + needed + " cuts would be needed"
            : std::string("cuts do not help here")) +
        "; smooth the surface, or allow a larger strain, or give 0 to use up the cuts";
    case SearchEnd::CutsUsedUp:
      return left + (more ? "it takes more than " + needed + " cuts; " : std::string()) +
        "allow more or longer cuts, or a larger strain";
    default:
      return left + "no other cut that is allowed helps; search longer, or allow a larger strain";
  }
}
}
