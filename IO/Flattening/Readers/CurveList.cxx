// SPDX-License-Identifier: BSD-3-Clause
#include "CurveList.h"

#include "TextFile.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

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

bool isEdgeWord(std::string_view word)
{
  return isWord("edge", word);
}

CurveTitle curveTitle(std::string_view text)
{
  constexpr std::string_view dividers = " \t-_:";
  text = trimmed(text);
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

void CurveList::add(const std::vector<std::int64_t>& ids, const CurveTitle& title)
{
  std::string name = title.name;
  std::replace(name.begin(), name.end(), '\0', ' '); // VTK ends a text there when it writes it
  this->Lines.add(ids);
  this->Types.push_back(title.kind.type);
  this->Shapes.push_back(title.kind.keyShape);
  this->Names.push_back(name);
}

void CurveList::add(const Points3& line, Points3& places, const CurveTitle& title)
{
  std::vector<std::int64_t> ids;
  for (const Point3& point : line)
  {
    const bool closes = ids.size() > 1 && ids.size() + 1 == line.size() && point == line.front();
    ids.push_back(closes ? ids.front() : static_cast<std::int64_t>(places.size()));
    places.insert(places.end(), closes ? 0 : 1, point);
  }
  this->add(ids, title);
}

DataSet CurveList::over(std::shared_ptr<const Points3> points) const
{
  DataSet curves;
  curves.points = std::move(points);
  curves.lines = this->Lines;
  curves.cellArrays = { { "CurveType", this->Types }, { "CurveName", this->Names } };
  if (std::any_of(this->Shapes.begin(), this->Shapes.end(), [](int shape) { return shape > 0; }))
  {
    curves.cellArrays.push_back({ "KeyShape", this->Shapes });
  }
  return curves;
}
}
