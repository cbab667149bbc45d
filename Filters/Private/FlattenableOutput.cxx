// SPDX-License-Identifier: BSD-3-Clause
#include "FlattenableOutput.h"

#include "CurveTolerances.h"
#include "FieldArrays.h"
#include "ImprintOutput.h"

#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

namespace flattening
{
namespace bridge
{
namespace
{
void writeShift(const TriangleMesh& design, const FlattenableSurface& result, vtkPolyData* surface)
{
  vtkPointData* const points = surface->GetPointData();
  vtkNew<vtkDoubleArray> shift;
  shift->SetName("Shift");
  shift->SetNumberOfComponents(3);
  shift->SetNumberOfTuples(design.vertexCount());
  for (Index v = 0; v < design.vertexCount(); ++v)
  {
    const Point3 moved = result.mesh.point(v) - design.point(v);
    shift->SetTypedTuple(v, moved.data());
  }
  points->AddArray(shift);
  addRows<vtkDoubleArray>(points, "ShiftDistance", result.shift.ofVertex.size(),
    [&](std::size_t v) { return result.shift.ofVertex[v]; });
  addRows<vtkDoubleArray>(points, "ShiftOutwards", result.shift.outwardsOfVertex.size(),
    [&](std::size_t v) { return result.shift.outwardsOfVertex[v]; });
  addRows<vtkUnsignedCharArray>(points, "Kept", result.kept.size(),
    [&](std::size_t v) { return static_cast<unsigned char>(result.kept[v]); });
  points->SetActiveScalars("ShiftDistance");

  vtkFieldData* const field = surface->GetFieldData();
  const auto add = [field](const char* name, const std::vector<double>& values) {
    addRows<vtkDoubleArray>(
      field, name, values.size(), [&values](std::size_t row) { return values[row]; });
  };
  addRows<vtkIntArray>(
    field, "BoundMet", 1, [&result](std::size_t) { return result.boundMet ? 1 : 0; });
  add("Strain", { result.strainBefore, result.strainAfter });
  const SurfaceShift& s = result.shift;
  add("Size", { s.size });
  add("ShiftMean", { s.mean });
  add("ShiftP95", { s.p95 });
  add("ShiftMax", { s.max });
  add("ShiftOutwardsMean", { s.outwardsMean });
  add("ShiftInwardsMax", { s.inwardsMax });
  add("RelativeShiftMean", { s.mean / s.size });
  add("RelativeShiftP95", { s.p95 / s.size });
  add("RelativeShiftMax", { s.max / s.size });
  const auto addTrials = [&](const char* name, double FlattenableTrial::*member) {
    addRows<vtkDoubleArray>(field, name, result.trials.size(),
      [&](std::size_t row) { return result.trials[row].*member; });
  };
  addTrials("TrialAnchor", &FlattenableTrial::anchor);
  addTrials("TrialShare", &FlattenableTrial::share);
  addTrials("TrialStrain", &FlattenableTrial::strain);
  addTrials("TrialShift", &FlattenableTrial::shift);
}
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

void writeFlattenable(const CurvedSurface& source, const FlattenableSurface& result,
  const std::array<vtkPolyData*, 6>& outputs, std::vector<std::string>& warnings)
{
  CurvedSurface moved = source;
  moved.imprinted.mesh = result.mesh;
  writeFlattening(moved, result.after, outputs[0], outputs[1], outputs[2]);
  writeImprint(moved, outputs[3], outputs[4], warnings);
  // Normals are those of the design.
  for (int port = 2; port < 5; ++port)
  {
    outputs[port]->GetPointData()->SetNormals(nullptr);
  }
  writeShift(source.imprinted.mesh, result, outputs[3]);
  const vtkNew<vtkPolyData> wires;
  const vtkNew<vtkPolyData> cut;
  writeFlattening(source, result.before, outputs[5], wires, cut);
}

std::string describeShortfall(const FlattenableSurface& result, const FlattenableOptions& options)
{
  const bool freed = !options.keepBoundary && options.kept.empty();
  const std::string bias = options.outsideBias > 0.0 ? "lower the outside bias, " : "";
  return "the strain on 95 % of a piece is " + shortNumber(result.strainAfter) +
    ", above the bound of " + shortNumber(options.bound) + ", after moving the surface by " +
    shortNumber(result.shift.size > 0.0 ? 100.0 * result.shift.mean / result.shift.size : 0.0) +
    " % of its size in the mean; " + bias +
    (freed ? "add darts" : "add darts, or keep fewer curves and not the boundary");
}
}
}
