// SPDX-License-Identifier: BSD-3-Clause
#include "Units.h"

#include "Base/LengthUnit.h"
#include "TextFile.h"
#include "TriangleList.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace wirewarp
{
namespace
{
/// The next word of letters; empty at the end.
std::string_view takeLetters(std::string_view& text)
{
  const auto isLetter = [](unsigned char c) { return std::isalpha(c) != 0; };
  const auto* const begin = std::find_if(text.begin(), text.end(), isLetter);
  const auto* const end = std::find_if_not(begin, text.end(), isLetter);
  const auto from = static_cast<std::size_t>(begin - text.begin());
  const auto length = static_cast<std::size_t>(end - begin);
  const std::string_view word = text.substr(from, length);
  text.remove_prefix(from + length);
  return word;
}
}

std::string unitNamed(std::string_view word)
{
  const flattening::Unit unit = flattening::unitNamed(std::string(word));
  return unit == flattening::Unit::Unspecified ? std::string() : flattening::unitName(unit);
}

std::string unitInComment(std::string_view comment)
{
  const std::string lower = lowered(comment);
  std::string_view rest(lower);
  for (std::string_view word = takeLetters(rest); !word.empty(); word = takeLetters(rest))
  {
    if (word == "unit" || word == "units")
    {
      return unitNamed(takeLetters(rest));
    }
  }
  return "";
}

double millimetresOf(const std::string& unit)
{
  return flattening::millimetresPer(flattening::unitNamed(unit));
}

bool parseLength(std::string_view text, Length& length)
{
  const std::size_t end = std::min(text.find_first_not_of("+-.0123456789eE"), text.size());
  length.unit = unitNamed(text.substr(end));
  return parseNumber(text.substr(0, end), length.value) &&
    (end == text.size() || !length.unit.empty());
}

std::string unitOf(const DataSet& data)
{
  const flattening::Column* const stated = flattening::findColumn(data.fieldArrays, "LengthUnit");
  return stated && stated->isText() && stated->rows() > 0 ? unitNamed(stated->text(0))
                                                          : std::string();
}

void setUnit(DataSet& data, const std::string& unit)
{
  flattening::eraseIf(
    data.fieldArrays, [](const flattening::Column& column) { return column.name == "LengthUnit"; });
  const std::string name = unitNamed(unit);
  if (!name.empty())
  {
    data.fieldArrays.push_back({ "LengthUnit", std::vector<std::string>{ name } });
  }
}

LikelyUnit likelyUnit(const DataSet& surface)
{
  constexpr double usual = 800.0; // mm
  const TriangleList list = listTriangles(surface);
  const Eigen::AlignedBox3d box = boxOf(list);
  LikelyUnit likely;
  if (box.isEmpty() || !(box.sizes().maxCoeff() > 0.0))
  {
    return likely;
  }
  likely.size = box.sizes().maxCoeff();
  const auto offBy = [&likely](const char* unit) {
    return std::abs(std::log(likely.size * millimetresOf(unit) / usual));
  };
  for (const char* const unit : { "m", "mm" })
  {
    if (offBy(unit) < offBy(likely.unit.c_str()))
    {
      likely.unit = unit;
    }
  }
  return likely;
}

std::string describe(const LikelyUnit& taken)
{
  std::ostringstream text;
  text << std::setprecision(4) << "states no unit: " << taken.unit << " is taken";
  if (taken.size > 0.0)
  {
    text << ", in which it is " << taken.size << ' ' << taken.unit << " large";
  }
  return text.str();
}
}
