// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMakeFlattenable.h"

#include "BodyInput.h"
#include "CurvedPolyData.h"
#include "FieldArrays.h"
#include "FilterExecution.h"
#include "FlatteningOutput.h"
#include "ImprintOutput.h"
#include "ListChanges.h"
#include "OptionVisitor.h"
#include "Options/OptionStructures.h"
#include "Options/OptionTable.h"
#include "Report/FlatteningTables.h"
#include "Report/ReportColumns.h"
#include "Reshaping/FlattenableSurface.h"

#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <set>

vtkStandardNewMacro(vtkMakeFlattenable);

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
}

/// Writes the one row of the measures, and one row per flattening of the search.
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

/// Finds the curves of these names; refuses a name that no curve has.
Status findCurves(const std::set<std::string>& names, const CurvedPolyData& source, Indices& curves)
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

/// Writes the moved surface and its curves as vtkMakeFlattenable documents.
/// \param moved the source with its mesh moved
/// \param warnings get a sentence for each array of the curves that is left out
void writeMovedSurface(const CurvedPolyData& source, const CurvedPolyData& moved,
  const FlattenableSurface& result, vtkPolyData* surface, vtkPolyData* curves,
  std::vector<std::string>& warnings)
{
  writeImprint(moved, surface, curves, warnings);
  // Normals are those of the design.
  surface->GetPointData()->SetNormals(nullptr);
  curves->GetPointData()->SetNormals(nullptr);
  writeShift(source.imprinted.mesh, result, surface);
}

/// A sentence that says how far the bound was missed, and what may help.
std::string describeShortfall(const FlattenableSurface& result, const FlattenableOptions& options)
{
  const bool freed = !options.keepBoundary && options.kept.empty();
  const std::string bias = options.outsideBias > 0.0 ? "lower the outside bias, " : "";
  return "the strain on 95 % of a piece is " + shortNumber(result.strainAfter) +
    ", above the bound of " + shortNumber(options.bound) + ", after moving the surface by " +
    shortNumber(result.shift.size > 0.0 ? 100.0 * result.shift.mean / result.shift.size : 0.0) +
    " % of its size in the mean; " + result.hindrance + "; " + bias +
    (freed ? "add darts" : "add darts, or keep fewer curves and not the boundary");
}
}
}
}

namespace
{
constexpr int surfacePort = 5; // and its curves behind it
constexpr int beforePort = 7;
constexpr int piecesBeforePort = 8;
constexpr int measurePort = 9;
}

//------------------------------------------------------------------------------
vtkMakeFlattenable::vtkMakeFlattenable()
{
  this->SetNumberOfInputPorts(3);
  this->SetTablePort(piecesBeforePort);
  this->SetTablePort(measurePort);
  this->Trials = vtkSmartPointer<vtkTable>::New();
  this->SetDefaultOptions();
}

//------------------------------------------------------------------------------
void vtkMakeFlattenable::VisitOptions(flattening::bridge::OptionVisitor& visit)
{
  this->Superclass::VisitOptions(visit);
  visit("Bound", this->Bound);
  visit("KeepBoundary", this->KeepBoundary);
  visit("OutsideBias", this->OutsideBias);
  visit("Thickness", this->Thickness);
}

//------------------------------------------------------------------------------
void vtkMakeFlattenable::AddKeptCurve(const std::string& curve)
{
  if (this->KeptCurves.insert(curve).second)
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkMakeFlattenable::RemoveAllKeptCurves()
{
  flattening::bridge::changeToNone(this, this->KeptCurves);
}

//------------------------------------------------------------------------------
int vtkMakeFlattenable::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port < 2)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
vtkTable* vtkMakeFlattenable::GetTrials() const
{
  return this->Trials;
}

//------------------------------------------------------------------------------
int vtkMakeFlattenable::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  namespace bridge = flattening::bridge;
  this->Begin(outputVector);
  this->Trials = vtkSmartPointer<vtkTable>::New(); // the caller may have kept that of the last run
  const auto output = [outputVector](int port) { return vtkPolyData::GetData(outputVector, port); };
  flattening::FlattenableOptions options = this->OptionsForCore().reshaping;
  options.flattening = this->Settings();
  const bridge::LoadedBody body = bridge::loadBody(vtkPolyData::GetData(inputVector[2]));
  options.body = body.get();
  const auto source = this->LoadInput(inputVector);
  if (source && this->Conclude(body.outcome) &&
    this->Conclude(bridge::findCurves(this->KeptCurves, *source, options.kept)))
  {
    this->Warn(flattening::describeShortEnds(*source));
    const flattening::FlattenableSurface result = flattening::makeFlattenable(
      source->imprinted.mesh, source->imprinted.curves, options, bridge::executionOf(this));
    if (this->Conclude(source->outcomeOfStage(
          result.status, result.status.refused() ? nullptr : result.after.cut.get())))
    {
      std::vector<std::string> warnings;
      if (!result.after.leftOut.empty())
      {
        warnings.push_back(flattening::describeLeftOut(*source, result.after));
      }
      if (!result.boundMet)
      {
        warnings.push_back(bridge::describeShortfall(result, options));
      }
      const std::string unit = this->LengthUnitOf(inputVector);
      bridge::CurvedPolyData moved = *source;
      moved.imprinted.mesh = result.mesh;
      this->WriteFlattening(moved, result.after, options.flattening, unit, outputVector);
      output(2)->GetPointData()->SetNormals(nullptr); // those of the design
      bridge::writeMovedSurface(
        *source, moved, result, output(surfacePort), output(surfacePort + 1), warnings);
      const vtkNew<vtkPolyData> wires;
      const vtkNew<vtkPolyData> cut;
      bridge::writeFlattening(
        *source, result.before, options.flattening, output(beforePort), wires, cut);
      bridge::writeTable(flattening::pieceTable(*source, result.before, unit,
                           bridge::textsOfCells(output(beforePort), "PieceName")),
        vtkTable::GetData(outputVector, piecesBeforePort));
      bridge::writeTable(bridge::shiftTable(result), vtkTable::GetData(outputVector, measurePort));
      this->Trials = bridge::makeTable(bridge::shiftTrialTable(result.trials));
      this->Warn(warnings);
    }
  }
  this->WriteRunStatus(output(0));
  return 1;
}

//------------------------------------------------------------------------------
void vtkMakeFlattenable::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const std::string& curve : this->KeptCurves)
  {
    os << indent << "KeptCurve: " << curve << "\n";
  }
}
