// SPDX-License-Identifier: BSD-3-Clause
// Arrays that are shorter than their points or cells, wherever a filter copies or reads them: they
// are left out and named, or refused, and nothing is read beyond an array's end.
#include "FlatteningTesting.h"

#include "vtkBitArray.h"
#include "vtkFeatureCurveCutter.h"
#include "vtkFeatureCurveImprinter.h"
#include "vtkFlatteningQuality.h"
#include "vtkFloatArray.h"
#include "vtkLeastSquaresConformalFilter.h"
#include "vtkSurfaceDevelopability.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariantArray.h"
#include "vtkWireWarpingFilter.h"
#include "vtkXMLPolyDataWriter.h"

using namespace flatteningTesting;

namespace
{
/// An array of a kind of values, by name.
using Maker = std::function<vtkSmartPointer<vtkAbstractArray>(vtkIdType tuples)>;

template <class Array>
vtkSmartPointer<vtkAbstractArray> make(vtkIdType tuples, int components)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  for (vtkIdType k = 0; k < tuples * components; ++k)
  {
    array->SetVariantValue(k, vtkVariant(static_cast<int>(k % 2)));
  }
  return array;
}

const std::vector<std::pair<std::string, Maker>> kinds{
  { "doubles", [](vtkIdType n) { return make<vtkDoubleArray>(n, 1); } },
  { "vectors", [](vtkIdType n) { return make<vtkFloatArray>(n, 3); } },
  { "pairs", [](vtkIdType n) { return make<vtkDoubleArray>(n, 2); } },
  { "integers", [](vtkIdType n) { return make<vtkIntArray>(n, 1); } },
  { "ids", [](vtkIdType n) { return make<vtkIdTypeArray>(n, 1); } },
  { "bits", [](vtkIdType n) { return make<vtkBitArray>(n, 1); } },
  { "texts", [](vtkIdType n) { return make<vtkStringArray>(n, 1); } },
  { "variants", [](vtkIdType n) { return make<vtkVariantArray>(n, 1); } },
};

/// Ways in which an array can be among the attributes.
const std::vector<std::string> roles{ "plain", "scalars", "vectors", "normals", "tcoords", "ids" };

void add(vtkDataSetAttributes* attributes, vtkAbstractArray* array, const std::string& role)
{
  const int index = attributes->AddArray(array);
  const std::vector<std::pair<std::string, int>> types{ { "scalars",
                                                          vtkDataSetAttributes::SCALARS },
    { "vectors", vtkDataSetAttributes::VECTORS }, { "normals", vtkDataSetAttributes::NORMALS },
    { "tcoords", vtkDataSetAttributes::TCOORDS }, { "ids", vtkDataSetAttributes::PEDIGREEIDS } };
  for (const auto& [name, type] : types)
  {
    const bool isVector = array->GetNumberOfComponents() == 3;
    const bool fits =
      vtkDataArray::SafeDownCast(array) && (isVector || (role != "vectors" && role != "normals"));
    if (role == name && (fits || role == "ids"))
    {
      attributes->SetActiveAttribute(index, type);
    }
  }
}

vtkSmartPointer<vtkPolyData> surface()
{
  auto grid =
    makeGrid(3, 3, [](double x, double y) { return 0.2 * std::sin(2.0 * x) * std::cos(y); });
  // A curve that has to be imprinted, so that points are interpolated.
  double p[3];
  double q[3];
  grid->GetPoint(0, p);
  const vtkIdType a = grid->GetPoints()->InsertNextPoint(p);
  grid->GetPoint(1, p);
  grid->GetPoint(5, q);
  const vtkIdType b = grid->GetPoints()->InsertNextPoint(
    0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2]));
  addLine(grid, { a, b });
  grid->GetPointData()->AddArray(
    filled<vtkDoubleArray>("whole", 1, grid->GetNumberOfPoints(), 3.0));
  grid->GetCellData()->AddArray(filled<vtkDoubleArray>("whole", 1, grid->GetNumberOfCells(), 4.0));
  return grid;
}

/// A filter of the family on a surface, with its field data of warnings where it has some.
struct Run
{
  std::string name;
  std::function<vtkSmartPointer<vtkFlatteningAlgorithm>(vtkPolyData*)> filter;
  bool flattens = false; ///< its output lies in the plane
};

template <class Filter>
Run runOf(const std::string& name, bool flattens = false)
{
  return { name,
    [](vtkPolyData* input) {
      auto filter = vtkSmartPointer<Filter>::New();
      filter->SetInputData(input);
      return vtkSmartPointer<vtkFlatteningAlgorithm>(filter);
    },
    flattens };
}

std::vector<Run> runs()
{
  Run quality{ "vtkFlatteningQuality", [](vtkPolyData* input) {
                auto filter = vtkSmartPointer<vtkFlatteningQuality>::New();
                filter->SetInputData(input);
                filter->SetFlatData(input);
                return vtkSmartPointer<vtkFlatteningAlgorithm>(filter);
              } };
  return { runOf<vtkWireWarpingFilter>("vtkWireWarpingFilter", true),
    runOf<vtkLeastSquaresConformalFilter>("vtkLeastSquaresConformalFilter", true),
    runOf<vtkFeatureCurveCutter>("vtkFeatureCurveCutter"),
    runOf<vtkFeatureCurveImprinter>("vtkFeatureCurveImprinter"), quality,
    runOf<vtkSurfaceDevelopability>("vtkSurfaceDevelopability") };
}

/// \param copied whether the filter copies the array if it is whole
void check(Checks& checks, const Run& run, vtkPolyData* input, bool ofPoints, bool isShort,
  bool copied, const std::string& what)
{
  const auto filter = run.filter(input);
  const Messages messages(filter);
  filter->Update();
  checks.that(!filter->IsRefused(), what + ": no refusal");
  checks.equal(messages.errors.size(), std::size_t{ 0 }, what + ": errors");
  std::size_t told = 0;
  for (const std::string& warning : messages.warnings)
  {
    told += warning.find("\"suspect\"") != std::string::npos ? 1 : 0;
  }
  checks.equal(told, std::size_t{ isShort ? 1U : 0U }, what + ": warnings that name it");
  vtkPolyData* output = filter->GetOutput();
  checks.that(output->GetNumberOfCells() > 0, what + ": output");
  vtkDataSetAttributes* data =
    ofPoints ? static_cast<vtkDataSetAttributes*>(output->GetPointData()) : output->GetCellData();
  if (isShort || copied)
  {
    checks.equal(data->GetAbstractArray("suspect") != nullptr, !isShort, what + ": copied");
  }
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    checks.that(data->GetAbstractArray(k)->GetNumberOfTuples() >=
        (ofPoints ? output->GetNumberOfPoints() : output->GetNumberOfCells()),
      what + ": every array of the output is whole");
  }
  checks.that(output->GetPointData()->GetArray("whole") && output->GetCellData()->GetArray("whole"),
    what + ": the other arrays are there");
  checks.equal(
    output->GetPointData()->GetArray("whole")->GetComponent(2, 0), 3.0, what + ": whole");
  checks.equal(output->GetCellData()->GetArray("whole")->GetComponent(2, 0), 4.0, what + ": whole");
}

void anArrayOfAnyKindAndLengthIsSafe(Checks& checks)
{
  for (const Run& run : runs())
  {
    for (const auto& [kind, maker] : kinds)
    {
      for (const bool ofPoints : { true, false })
      {
        for (const std::string& role : roles)
        {
          for (const int missing : { 1, 7, 1000, 0, -3 })
          {
            const auto input = surface();
            const vtkIdType count =
              ofPoints ? input->GetNumberOfPoints() : input->GetNumberOfCells();
            const auto array = maker(std::max<vtkIdType>(0, count - missing));
            array->SetName("suspect");
            vtkDataSetAttributes* data = ofPoints
              ? static_cast<vtkDataSetAttributes*>(input->GetPointData())
              : input->GetCellData();
            add(data, array, role);
            // Between points VTK interpolates no ids; normals do not follow into the plane.
            const bool copied = (!ofPoints || (kind != "ids" && role != "ids")) &&
              (role != "normals" || !run.flattens);
            check(checks, run, input, ofPoints, missing > 0, copied,
              run.name + ", " + kind + " as " + role + (ofPoints ? " of points, " : " of cells, ") +
                std::to_string(missing) + " missing");
          }
        }
      }
    }
  }
}

void arraysOfTheCurvesThatAreTooShortAreLeftOut(Checks& checks)
{
  for (const auto& [kind, maker] : kinds)
  {
    for (const vtkIdType tuples : { 0, 1, 2 })
    {
      const auto grid = makeGrid(3, 3);
      const auto curves = makeCurves(grid, { { 0, 1, 2 }, { 4, 5, 6, 7 } });
      const auto array = maker(tuples);
      array->SetName("suspect");
      curves->GetCellData()->AddArray(array);
      vtkNew<vtkFeatureCurveImprinter> filter;
      const Messages messages(filter);
      filter->SetInputData(grid);
      filter->SetCurvesData(curves);
      filter->Update();
      const bool kept = filter->GetOutput(1)->GetCellData()->GetAbstractArray("suspect") != nullptr;
      checks.equal(kept, tuples == 2, kind + " of curves are copied");
      checks.equal(messages.warnings.size(), std::size_t{ tuples == 2 ? 0U : 1U },
        kind + " of curves: warnings");
      vtkStringArray* const told = filter->GetStatusWarnings();
      const bool named =
        told->GetNumberOfValues() > 0 && told->GetValue(0).find("\"suspect\"") != std::string::npos;
      checks.equal(named, tuples != 2, kind + " of curves: a warning names it");
    }
  }
}

/// Where the result would be another curve than was meant, it is refused.
void arraysThatSayWhatACurveIsAreRefused(Checks& checks)
{
  for (const char* name :
    { "CurveType", "CurveName", "KeyShape", "LengthTolerance", "PlanarShape" })
  {
    for (const vtkIdType tuples : { 0, 1 })
    {
      const auto grid = makeGrid(3, 3);
      const auto curves = makeCurves(grid, { { 0, 1, 2 }, { 4, 5, 6, 7 } });
      curves->GetCellData()->RemoveArray(name);
      const bool planar = std::string(name) == "PlanarShape";
      const auto array = planar            ? make<vtkDoubleArray>(tuples, 2)
        : std::string(name) == "CurveName" ? make<vtkStringArray>(tuples, 1)
                                           : make<vtkIntArray>(tuples, 1);
      array->SetName(name);
      vtkDataSetAttributes* data =
        planar ? static_cast<vtkDataSetAttributes*>(curves->GetPointData()) : curves->GetCellData();
      data->AddArray(array);
      vtkNew<vtkWireWarpingFilter> filter;
      const Messages messages(filter);
      filter->SetInputData(grid);
      filter->SetCurvesData(curves);
      filter->Update();
      checks.equal(
        std::string(filter->GetStatusName()), std::string("InvalidCurve"), std::string(name));
      checks.contains(filter->GetStatusMessage(), name, "the message");
    }
  }
}

/// Cells whose offsets point behind their corners.
void cellsThatDoNotFitTheirCornersAreRefused(Checks& checks)
{
  for (const bool lines : { false, true })
  {
    const auto grid = makeGrid(3, 3);
    const auto curves = makeCurves(grid, { { 0, 1, 2 }, { 4, 5, 6, 7 } });
    const auto offsets = arrayOf<vtkIdTypeArray>("", std::vector<vtkIdType>{ 0, 3, 600000 });
    const auto corners = arrayOf<vtkIdTypeArray>("", std::vector<vtkIdType>{ 0, 1, 5, 0, 5, 4 });
    vtkNew<vtkCellArray> cells;
    cells->SetData(offsets, corners);
    if (lines)
    {
      curves->SetLines(cells);
    }
    else
    {
      grid->SetPolys(cells);
    }
    vtkNew<vtkWireWarpingFilter> filter;
    const Messages messages(filter);
    filter->SetInputData(grid);
    filter->SetCurvesData(curves);
    filter->Update();
    checks.that(filter->IsRefused(), "cells that do not fit are refused");
    checks.contains(filter->GetStatusMessage(), "do not fit", "the message");
  }
}

/// What VTK's writer makes of the data, read again.
vtkSmartPointer<vtkPolyData> writtenAndRead(vtkPolyData* data)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->WriteToOutputStringOn();
  writer->Write();
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(writer->GetOutputString());
  reader->Update();
  return reader->GetOutput();
}

/// The character NUL ends a text in a file; what follows it crashes the reader.
void textsWithNulCanBeWrittenAndRead(Checks& checks)
{
  const std::string nul("a\0b", 3);
  const auto grid = makeGrid(3, 3);
  addLine(grid, { 0, 1, 2 });
  vtkNew<vtkStringArray> names;
  names->SetName("CurveName");
  names->SetNumberOfValues(grid->GetNumberOfCells());
  names->SetValue(0, nul);
  grid->GetCellData()->AddArray(names);
  for (vtkFieldData* data :
    { static_cast<vtkFieldData*>(grid->GetPointData()), grid->GetFieldData() })
  {
    data->AddArray(
      filled<vtkStringArray>("texts", 1, grid->GetNumberOfPoints(), vtkVariant(vtkStdString(nul))));
  }
  for (const Run& run : runs())
  {
    const auto filter = run.filter(grid);
    const Messages messages(filter);
    filter->Update();
    checks.that(!messages.warnings.empty(), run.name + ": NUL is warned of");
    for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
    {
      vtkPolyData* output = filter->GetOutput(port);
      if (!output)
      {
        continue; // a table
      }
      const auto again = writtenAndRead(output);
      checks.equal(again->GetNumberOfCells(), output->GetNumberOfCells(), run.name + ": cells");
      auto* texts = vtkStringArray::SafeDownCast(again->GetPointData()->GetAbstractArray("texts"));
      checks.that(texts != nullptr, run.name + ": the texts");
      checks.equal(
        texts ? std::string(texts->GetValue(3)) : "", std::string("a\\0b"), run.name + ": a text");
    }
  }
  vtkNew<vtkWireWarpingFilter> filter;
  const Messages messages(filter);
  filter->SetInputData(grid);
  filter->Update();
  checks.equal(text(filter->GetCurves(), "Name"), std::string("a\\0b"), "the curve's name");
}
}

int TestShortArrays(int, char*[])
{
  Checks checks;
  anArrayOfAnyKindAndLengthIsSafe(checks);
  arraysOfTheCurvesThatAreTooShortAreLeftOut(checks);
  arraysThatSayWhatACurveIsAreRefused(checks);
  cellsThatDoNotFitTheirCornersAreRefused(checks);
  textsWithNulCanBeWrittenAndRead(checks);
  return checks.result();
}
