// SPDX-License-Identifier: BSD-3-Clause
#include "HostileSurface.h"

#include "../Benchmark/RefinedPiece.h"

#include <algorithm>
#include <filesystem>

namespace hostile
{
namespace
{
std::vector<Specimen> readAll()
{
  const std::string mark = "_curves";
  std::vector<Specimen> specimens;
  std::error_code failure;
  for (const auto& entry : std::filesystem::directory_iterator(FLATTENING_DATA_DIR, failure))
  {
    const std::filesystem::path& file = entry.path();
    const std::string name = file.stem().string();
    const std::size_t end = name.find(mark);
    if (file.extension() == ".vtp" && end != std::string::npos)
    {
      const auto surface = file.parent_path() / (name.substr(0, end) + ".vtp");
      benchmarks::DataPiece piece = benchmarks::readPiece(surface.string(), file.string());
      specimens.push_back(
        { name, std::move(piece.points), std::move(piece.triangles), std::move(piece.curves) });
    }
  }
  std::sort(specimens.begin(), specimens.end(),
    [](const Specimen& a, const Specimen& b) { return a.name < b.name; });
  return specimens;
}
}

const std::vector<Specimen>& dataSpecimens()
{
  static const std::vector<Specimen> specimens = readAll();
  return specimens;
}
}
