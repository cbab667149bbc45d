// SPDX-License-Identifier: BSD-3-Clause
#include "CurveTolerances.h"

#include <cmath>
#include <set>

namespace flattening
{
namespace bridge
{
namespace
{
std::string listed(const std::vector<Polyline>& curves)
{
  constexpr std::size_t most = 20;
  std::set<std::string> names;
  for (const Polyline& curve : curves)
  {
    names.insert(curve.name);
  }
  std::string text;
  std::size_t told = 0;
  for (const std::string& name : names)
  {
    if (told == most)
    {
      return text + " and " + std::to_string(names.size() - most) + " more";
    }
    text += (told++ ? ", " : "") + name;
  }
  return text;
}
}

Status noCurveNamed(const std::string& name, const CurvedSurface& source)
{
  const std::vector<Polyline>& polylines = source.curves.polylines;
  return { StatusCode::InvalidOption,
    "no curve is named \"" + name + "\"; " +
      (polylines.empty() ? "there is no feature curve" : "the curves are " + listed(polylines)),
    {}, { Remedy::NameCurve } };
}

Status applyTolerances(const std::map<std::string, double>& tolerances, CurvedSurface& source)
{
  std::vector<Polyline>& polylines = source.curves.polylines;
  for (const auto& entry : tolerances)
  {
    if (!std::isfinite(entry.second) || entry.second < 0.0 || entry.second >= 1.0)
    {
      return { StatusCode::InvalidOption,
        "the length tolerance of \"" + entry.first + "\" lies outside [0, 1)", {},
        { { Remedy::Give, "a fraction of the length" } } };
    }
    bool known = false;
    for (std::size_t c = 0; c < polylines.size(); ++c)
    {
      if (polylines[c].name == entry.first)
      {
        known = true;
        polylines[c].tolerance = entry.second;
        source.imprinted.curves[c].tolerance = entry.second;
      }
    }
    if (!known)
    {
      return noCurveNamed(entry.first, source);
    }
  }
  return {};
}
}
}
