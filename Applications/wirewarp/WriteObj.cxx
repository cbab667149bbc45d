// SPDX-License-Identifier: BSD-3-Clause
#include "Units.h"
#include "WriteData.h"

#include <iomanip>
#include <sstream>

namespace wirewarp
{
namespace
{
void writeCell(const flattening::CellList& cells, std::size_t cell, char keyword, std::ostream& out)
{
  out << keyword;
  for (const std::int64_t* id = cells.begin(cell); id != cells.end(cell); ++id)
  {
    out << ' ' << *id + 1;
  }
  out << '\n';
}

/// As CurveList.h reads it: "dart left".
std::string titleOf(const flattening::DataSet& data, std::size_t line)
{
  const flattening::Column* const types = findColumn(data.cellArrays, "CurveType");
  const flattening::Column* const shapes = findColumn(data.cellArrays, "KeyShape");
  const flattening::Column* const names = findColumn(data.cellArrays, "CurveName");
  const std::size_t cell = data.vertexCells + line;
  const int type = types ? static_cast<int>(types->number(cell)) : 0;
  const bool straight = type == 1 && shapes && shapes->number(cell) == 1.0;
  const std::string word = straight ? "straight"
    : type < 0                      ? ""
                                    : curveTypeName(static_cast<flattening::CurveType>(type));
  return word + (word.empty() ? "" : " ") + (names ? names->text(cell) : "curve");
}
}

std::string objOf(const flattening::DataSet& data)
{
  std::ostringstream out;
  out << std::setprecision(17);
  const std::string unit = unitOf(data);
  if (!unit.empty())
  {
    out << "# units: " << unit << '\n';
  }
  for (const flattening::Point3& p : *data.points)
  {
    out << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  }
  for (std::size_t k = 0; k < data.faces.size(); ++k)
  {
    writeCell(data.faces, k, 'f', out);
  }
  for (std::size_t k = 0; k < data.lines.size(); ++k)
  {
    out << "g " << titleOf(data, k) << '\n';
    writeCell(data.lines, k, 'l', out);
  }
  return out.str();
}
}
