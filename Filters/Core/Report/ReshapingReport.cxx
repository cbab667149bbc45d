// SPDX-License-Identifier: BSD-3-Clause
#include "Report/ReshapingReport.h"

#include "Base/Types.h"

#include <cstddef>
#include <utility>

namespace flattening
{
Columns shiftArrays(const TriangleMesh& design, const FlattenableSurface& result)
{
  std::vector<double> shift;
  for (Index v = 0; v < design.vertexCount(); ++v)
  {
    const Point3 moved = result.mesh.point(v) - design.point(v);
    shift.insert(shift.end(), moved.data(), moved.data() + 3);
  }
  Columns points{ { "Shift", std::move(shift), 3 } };
  addRows<double>(points, "ShiftDistance", result.shift.ofVertex.size(),
    [&](std::size_t v) { return result.shift.ofVertex[v]; });
  addRows<double>(points, "ShiftOutwards", result.shift.outwardsOfVertex.size(),
    [&](std::size_t v) { return result.shift.outwardsOfVertex[v]; });
  addRows<unsigned char>(
    points, "Kept", result.kept.size(), [&](std::size_t v) { return result.kept[v]; });
  return points;
}

Columns shiftTable(const FlattenableSurface& result)
{
  Columns table;
  const std::vector<SurfaceShift> rows{ result.shift };
  const TableColumns<SurfaceShift> columns(table, rows);
  using Shift = const SurfaceShift&;
  columns.add("BoundMet", [&result](Shift) { return result.boundMet; });
  columns.add("StrainBefore", [&result](Shift) { return result.strainBefore; });
  columns.add("StrainAfter", [&result](Shift) { return result.strainAfter; });
  columns.add("Size", &SurfaceShift::size);
  columns.add("ShiftMean", &SurfaceShift::mean);
  columns.add("ShiftP95", &SurfaceShift::p95);
  columns.add("ShiftMax", &SurfaceShift::max);
  columns.add("ShiftOutwardsMean", &SurfaceShift::outwardsMean);
  columns.add("ShiftInwardsMax", &SurfaceShift::inwardsMax);
  columns.add("RelativeShiftMean", [](Shift shift) { return shift.mean / shift.size; });
  columns.add("RelativeShiftP95", [](Shift shift) { return shift.p95 / shift.size; });
  columns.add("RelativeShiftMax", [](Shift shift) { return shift.max / shift.size; });
  return table;
}

Columns shiftTrialTable(const std::vector<FlattenableTrial>& trials)
{
  Columns table;
  const TableColumns<FlattenableTrial> columns(table, trials);
  columns.add("Anchor", &FlattenableTrial::anchor);
  columns.add("Share", &FlattenableTrial::share);
  columns.add("Strain", &FlattenableTrial::strain);
  columns.add("Shift", &FlattenableTrial::shift);
  return table;
}

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
