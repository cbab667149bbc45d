// SPDX-License-Identifier: BSD-3-Clause
#include "CurveList.h"

#include "TextFile.h"

#include <vtkCellData.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace wirewarp
{
namespace
{
bool isWord(std::string_view known, std::string_view word)
{
  return std::equal(known.begin(), known.end(), word.begin(), word.end(), [](char a, char b) {
    return a == static_cast<char>(std::tolower(static_cast<unsigned char>(b)));
  });
}
}

//------------------------------------------------------------------------------
std::optional<CurveKind> curveKindOf(std::string_view word)
{
  static constexpr std::array<std::string_view, 5> words{ "accessory", "key", "dart", "seam",
    "straight" };
  static constexpr CurveKind straight{ 1, 1 };
  const auto* const found = std::find_if(
    words.begin(), words.end(), [word](std::string_view known) { return isWord(known, word); });
  if (found == words.end())
  {
    return std::nullopt;
  }
  return *found == "straight" ? straight : CurveKind{ static_cast<int>(found - words.begin()), 0 };
}

//------------------------------------------------------------------------------
bool isEdgeWord(std::string_view word)
{
  return isWord("edge", word);
}

//------------------------------------------------------------------------------
CurveTitle curveTitle(std::string_view text)
{
  constexpr std::string_view blanks = " \t";
  constexpr std::string_view dividers = " \t-_:";
  const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
  text = text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
  const auto kind = curveKindOf(text.substr(0, text.find_first_of(dividers)));
  if (!kind)
  {
    return { {}, std::string(text) };
  }
  const std::size_t divider = text.find_first_of(dividers);
  const std::size_t name =
    divider == std::string_view::npos ? divider : text.find_first_not_of(dividers, divider);
  return { *kind, std::string(name == std::string_view::npos ? text : text.substr(name)) };
}

//------------------------------------------------------------------------------
CurveList::CurveList()
{
  this->Types->SetName("CurveType");
  this->Shapes->SetName("KeyShape");
  this->Names->SetName("CurveName");
}

//------------------------------------------------------------------------------
void CurveList::add(const std::vector<vtkIdType>& ids, const CurveTitle& title)
{
  std::string name = title.name;
  std::replace(name.begin(), name.end(), '\0', ' '); // VTK ends a text there when it writes it
  this->Lines->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  this->Types->InsertNextValue(title.kind.type);
  this->Shapes->InsertNextValue(title.kind.keyShape);
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
  if (this->Shapes->GetNumberOfTuples() > 0 && this->Shapes->GetRange()[1] > 0.0)
  {
    curves->GetCellData()->AddArray(this->Shapes);
  }
  return curves;
}
}
