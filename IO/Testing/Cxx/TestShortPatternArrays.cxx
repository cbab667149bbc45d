// SPDX-License-Identifier: BSD-3-Clause
// Arrays of flat pieces and wires that are shorter than their cells: a pattern needs them, and
// refuses them by name.
#include "FlatteningTesting.h"

#include "vtkIdTypeArray.h"
#include "vtkPatternWriter.h"
#include "vtkWireWarpingFilter.h"

using namespace flatteningTesting;

namespace
{
/// Zeros, or empty texts.
template <class Array>
vtkSmartPointer<vtkAbstractArray> make(vtkIdType tuples)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfTuples(tuples);
  for (vtkIdType k = 0; k < tuples; ++k)
  {
    array->SetVariantValue(k, vtkVariant(0));
  }
  return array;
}

}

int TestShortPatternArrays(int argc, char* argv[])
{
  Checks checks;
  const std::string folder = temporaryDirectory(argc, argv);
  const auto grid = makeGrid(3, 3);
  vtkNew<vtkWireWarpingFilter> filter;
  filter->SetInputData(grid);
  filter->SetCurvesData(makeCurves(grid, { { 1, 5, 9 }, { 4, 5, 6, 7 } }, { 2, 0 }));
  filter->Update();
  struct Position
  {
    int port;
    const char* array;
    bool ofCells;
  };
  for (const Position& position :
    { Position{ 0, "PieceId", true }, Position{ 1, "CurveType", true },
      Position{ 1, "CurveId", true }, Position{ 1, "PieceId", true },
      Position{ 1, "Connector", true }, Position{ 1, "CurveName", true },
      Position{ 0, "SeamClosed", false }, Position{ 0, "SeamPairs", false } })
  {
    for (const vtkIdType tuples : { 0, 1 })
    {
      std::array<vtkSmartPointer<vtkPolyData>, 3> inputs;
      for (int port = 0; port < 3; ++port)
      {
        inputs[port] = vtkSmartPointer<vtkPolyData>::New();
        inputs[port]->DeepCopy(filter->GetOutput(port));
      }
      const auto array = std::string(position.array) == "CurveName" ? make<vtkStringArray>(tuples)
                                                                    : make<vtkIdTypeArray>(tuples);
      array->SetName(position.array);
      vtkFieldData* data = inputs[position.port]->GetFieldData();
      if (position.ofCells)
      {
        data = inputs[position.port]->GetCellData();
      }
      data->AddArray(array);
      vtkNew<vtkPatternWriter> writer;
      const Messages messages(writer);
      for (int port = 0; port < 3; ++port)
      {
        writer->SetInputData(port, inputs[port]);
      }
      writer->SetUnitToCentimetre();
      writer->SetFileName((folder + "/short.svg").c_str());
      writer->Write();
      checks.equal(messages.errors.size(), std::size_t{ 1 }, position.array);
      if (!messages.errors.empty())
      {
        checks.contains(messages.errors.front(), position.array, "the error");
      }
    }
  }
  return checks.result();
}
