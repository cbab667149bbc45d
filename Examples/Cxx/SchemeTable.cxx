// SPDX-License-Identifier: BSD-3-Clause
// How much each scheme distorts the pieces of Data/, as the table of Documentation/schemes.md. With
// --check FILE the program fails unless that page has the numbers, to one unit of the last digit.
#include "Pieces.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

using namespace figures;

namespace
{
struct Run
{
  const char* title;
  Method method;
  Interior interior;
};

const std::vector<Run> runs{
  { "progressive", Method::Progressive, Interior::Paper },
  { "global", Method::Global, Interior::Paper },
  { "pinned", Method::Global, Interior::Rigid },
  { "isometric", Method::Isometric, Interior::Rigid },
  { "LSCM", Method::Conformal, Interior::Rigid },
};

struct Measure
{
  const char* title;
  const char* array; ///< of the field data
  bool greatest;     ///< of the pieces is the worst, otherwise the least
};

const std::vector<Measure> measures{
  { "E_len", "EdgeLengthError", true },
  { "E_ang", "AngleErrorMean", true },
  { "E_h", "GlobalHomogeneity", false },
  { "E_r", "GlobalAspectRatio", false },
  { "E_area", "AreaError", true },
  { "flips", "FlippedTriangles", true },
};

/// The worst of the surface's pieces.
double worst(const FlatPiece& result, const Measure& measure)
{
  double value = result.number(measure.array);
  for (vtkIdType row = 1; std::isfinite(result.number(measure.array, row)); ++row)
  {
    const double next = result.number(measure.array, row);
    value = measure.greatest ? std::max(value, next) : std::min(value, next);
  }
  return value;
}

std::string row(const std::string& name, const Run& run, const FlatPiece& result)
{
  std::string text = "| " + name + " | " + run.title + " |";
  for (const Measure& measure : measures)
  {
    char cell[32];
    const bool count = measure.array == std::string("FlippedTriangles");
    const double value = worst(result, measure);
    // No sign on a zero that rounding made.
    std::snprintf(
      cell, sizeof(cell), count ? " %.0f |" : " %.4f |", std::abs(value) < 5e-5 ? 0.0 : value);
    text += cell;
  }
  return text;
}

std::vector<std::string> makeTable(const std::string& folder)
{
  std::vector<std::string> lines{ "| piece | scheme |", "|---|---|" };
  for (const Measure& measure : measures)
  {
    lines[0] += std::string(" ") + measure.title + " |";
    lines[1] += "---|";
  }
  for (const std::string& name : listPieces(folder))
  {
    const Piece piece = readPiece(folder, name);
    for (const Run& run : runs)
    {
      lines.push_back(row(name, run, flatten(piece, run.method, run.interior)));
    }
  }
  return lines;
}

std::vector<std::string> cellsOf(const std::string& line)
{
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, '|');)
  {
    cells.push_back(cell);
  }
  return cells;
}

bool sameRow(const std::string& a, const std::string& b)
{
  const std::vector<std::string> ours = cellsOf(a);
  const std::vector<std::string> theirs = cellsOf(b);
  if (ours.size() != theirs.size())
  {
    return false;
  }
  for (std::size_t k = 0; k < ours.size(); ++k)
  {
    const bool number = k > 2 && ours[k].find_first_of("0123456789") != std::string::npos;
    if (number ? std::abs(std::atof(ours[k].c_str()) - std::atof(theirs[k].c_str())) > 1.01e-4
               : ours[k] != theirs[k])
    {
      return false;
    }
  }
  return true;
}

/// The page's table, line by line; says which rows differ.
bool check(const std::vector<std::string>& table, const std::string& path)
{
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);)
  {
    if (line.rfind("| ", 0) == 0 || line.rfind("|-", 0) == 0)
    {
      lines.push_back(line);
    }
  }
  bool good = lines.size() == table.size();
  if (!good)
  {
    std::cerr << path << " has " << lines.size() << " rows, the table " << table.size() << '\n';
  }
  for (std::size_t k = 0; k < table.size() && k < lines.size(); ++k)
  {
    if (!sameRow(table[k], lines[k]))
    {
      std::cerr << path << " has\n" << lines[k] << "\nwhere it is now\n" << table[k] << '\n';
      good = false;
    }
  }
  return good;
}
}

int main(int argc, char* argv[])
{
  const bool checks = argc == 4 && std::string(argv[2]) == "--check";
  if (argc != 2 && !checks)
  {
    std::cerr << "usage: SchemeTable DATA_FOLDER [--check FILE]\n";
    return EXIT_FAILURE;
  }
  try
  {
    const std::vector<std::string> table = makeTable(argv[1]);
    for (const std::string& line : table)
    {
      std::cout << line << '\n';
    }
    return !checks || check(table, argv[3]) ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch (const std::exception& error)
  {
    std::cerr << "SchemeTable: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
