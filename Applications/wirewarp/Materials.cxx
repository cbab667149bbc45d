// SPDX-License-Identifier: BSD-3-Clause
#include "Materials.h"

#include <vtkNew.h>
#include <vtkTable.h>
#include <vtkVariant.h>
#include <vtkWireWarpingFilter.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace wirewarp
{
namespace
{
std::string range(double least, double greatest)
{
  if (!std::isfinite(least) && !std::isfinite(greatest))
  {
    return "-";
  }
  char text[64];
  std::snprintf(text, sizeof text, "%g..%+g", least, greatest);
  return text;
}
}

//------------------------------------------------------------------------------
void printMaterials(std::ostream& out)
{
  const vtkNew<vtkTable> table;
  vtkWireWarpingFilter::ListMaterials(table);
  const auto number = [&](vtkIdType row, const char* column) {
    return table->GetValueByName(row, column).ToDouble();
  };
  const auto text = [&](vtkIdType row, const char* column) {
    return std::string(table->GetValueByName(row, column).ToString());
  };
  char line[256];
  std::snprintf(line, sizeof line, "%-14s %9s %9s %9s %7s %12s %12s %6s  %s\n", "material",
    "warp N/m", "weft N/m", "shear N/m", "compr.", "warp %", "weft %", "shear", "what it is");
  out << line;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const std::string name = text(row, "Name");
    const bool threads = number(row, "Warp") > 0.0;
    if (!threads)
    {
      std::snprintf(line, sizeof line, "%-14s %9s %9s %9s %7s %12s %12s %6s  ", name.c_str(), "-",
        "-", "-", "-", "-", "-", "-");
    }
    else
    {
      std::snprintf(line, sizeof line, "%-14s %9g %9g %9g %7g %12s %12s %5g°  ", name.c_str(),
        number(row, "Warp"), number(row, "Weft"), number(row, "Shear"), number(row, "Compression"),
        range(number(row, "WarpLeast"), number(row, "WarpGreatest")).c_str(),
        range(number(row, "WeftLeast"), number(row, "WeftGreatest")).c_str(),
        number(row, "ShearLimit"));
    }
    out << line << text(row, "Description") << '\n';
  }
  out << "\nStiffness of warp, weft and shear; compr.: in compression over that in tension; then "
         "the limits.\nSources:\n";
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    out << "  " << text(row, "Name") << ": " << text(row, "Source") << '\n';
  }
}
}
