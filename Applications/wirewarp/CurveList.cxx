// SPDX-License-Identifier: BSD-3-Clause
#include "CurveList.h"

#include "TextFile.h"

#include <vtkCellData.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace wirewarp
{
//------------------------------------------------------------------------------
int curveTypeOf(std::string_view word)
{
  static constexpr std::array<std::string_view, 4> types{ "accessory", "key", "dart", "seam" };
  const auto same = [](char a, char b) {
    return a == static_cast<char>(std::tolower(static_cast<unsigned char>(b)));
  };
  const auto* const found = std::find_if(types.begin(), types.end(), [&](std::string_view type) {
    return std::equal(type.begin(), type.end(), word.begin(), word.end(), same);
  });
  return found == types.end() ? -1 : static_cast<int>(found - types.begin());
}

//------------------------------------------------------------------------------
CurveTitle curveTitle(std::string_view text)
{
  constexpr std::string_view blanks = " \t";
  constexpr std::string_view dividers = " \t-_:";
  const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
  text = text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
  const int type = curveTypeOf(text.substr(0, text.find_first_of(dividers)));
  if (type < 0)
  {
    return { 0, std::string(text) };
  }
  const std::size_t divider = text.find_first_of(dividers);
  const std::size_t name =
    divider == std::string_view::npos ? divider : text.find_first_not_of(dividers, divider);
  return { type, std::string(name == std::string_view::npos ? text : text.substr(name)) };
}

//------------------------------------------------------------------------------
CurveList::CurveList()
{
  this->Types->SetName("CurveType");
  this->Names->SetName("CurveName");
}

//------------------------------------------------------------------------------
void CurveList::add(const std::vector<vtkIdType>& ids, const CurveTitle& title)
{
  std::string name = title.name;
  std::replace(name.begin(), name.end(), '\0', ' '); // VTK ends a text there when it writes it
  this->Lines->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  this->Types->InsertNextValue(title.type);
  this->Names->InsertNextValue(name);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> CurveList::polyData(vtkPoints* points) const
{
  auto curves = vtkSmartPointer<vtkPolyData>::New();
  curves->SetPoints(points);
  curves->SetLines(this->Lines);
  curves->GetCellData()->AddArray(this->Types);
  curves->GetCellData()->AddArray(this->Names);
  return curves;
}
}
