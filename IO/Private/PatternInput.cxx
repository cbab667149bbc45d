// SPDX-License-Identifier: BSD-3-Clause
#include "PatternInput.h"

#include "Formats/PatternData.h"
#include "Outlines/Outline.h"
#include "PolyDataSets.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"

#include <string>

namespace flattening
{
namespace bridge
{
Status readPieces(
  vtkPolyData* flat, vtkPolyData* wires, vtkPolyData* cut, pattern::PatternSource& source)
{
  for (vtkPolyData* const data : { flat, wires, cut })
  {
    if (data && (!data->GetPolys()->IsValid() || !data->GetLines()->IsValid()))
    {
      return pattern::invalidPieces(std::string("the cells of the ") +
        (data == wires ? "wires" : "flat surface") + " do not fit the list of their " +
        (data == wires ? "points" : "corners"));
    }
  }
  const DataSet wireData = wires ? dataSetOf(wires) : DataSet();
  const DataSet cutData = cut ? geometryOf(cut) : DataSet();
  return pattern::readPattern(
    dataSetOf(flat), wires ? &wireData : nullptr, cut ? &cutData : nullptr, source);
}
}
}
