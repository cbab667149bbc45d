// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkCellArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>

#include <string>
#include <string_view>
#include <vector>

namespace wirewarp
{
/// The value of the cell array CurveType for accessory, key, dart or seam, in letters of any case;
/// -1 for another word.
int curveTypeOf(std::string_view word);

/// What the name of a group or layer says of a curve.
struct CurveTitle
{
  int type = 0; ///< accessory, where the first word is no type
  std::string name;
};

/// "dart left" is a dart called left, "Key" a key called Key, "hem line" an accessory curve of that
/// name. Words are divided by blanks, and before the name also by -, _ or :.
CurveTitle curveTitle(std::string_view text);

/// Curves as a reader finds them, one after the other.
class CurveList
{
public:
  CurveList();
  void add(const std::vector<vtkIdType>& ids, const CurveTitle& title);
  bool empty() const { return this->Lines->GetNumberOfCells() == 0; }
  /// The curves over points, with the cell arrays CurveType and CurveName.
  vtkSmartPointer<vtkPolyData> polyData(vtkPoints* points) const;

private:
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkIntArray> Types;
  vtkNew<vtkStringArray> Names;
};
}
