// SPDX-License-Identifier: BSD-3-Clause
#include "Sizes.h"

#include "Base/LengthUnit.h"
#include "FlagWords.h"
#include "Flattening.h"
#include "Formats/PatternData.h"
#include "Grading/SizeGrading.h"
#include "Input/StatusWords.h"
#include "InputError.h"
#include "Options.h"
#include "Progress.h"
#include "Surface/SurfaceLocator.h"
#include "Surface/SurfacePreparation.h"
#include "TextFile.h"
#include "TriangleList.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace wirewarp
{
namespace
{
/// The options for another surface, of which flat pieces and wires are asked for alone.
Options optionsOf(const Options& options, const std::string& surface, const Flattening& base)
{
  Options one = options;
  one.unitOtherwise = base.unit;
  one.surface = surface;
  one.picture = {};
  one.pattern = {};
  one.quiet = true;
  return one;
}

void refuse(Flattening& result, const std::string& status, const std::string& message)
{
  const double seconds = result.secondsTotal;
  result = Flattening();
  result.exitCode = InputRefused;
  result.status = status;
  result.message = message;
  result.secondsTotal = seconds;
}
}

void gradeSizes(const Options& options, Flattening& result)
{
  const auto start = std::chrono::steady_clock::now();
  flattening::pattern::GradingOptions grading;
  grading.base = options.pattern.size;
  grading.alignment = options.sizes.alignment;
  grading.unit = flattening::unitNamed(result.unit);
  std::vector<flattening::pattern::PatternSize> sizes;
  flattening::Status status;
  const auto add = [&](const std::string& name, const Flattening& one) {
    sizes.push_back({ name, {} });
    status = status.ok()
      ? flattening::pattern::readPattern(*one.flat, one.wires.get(), nullptr, sizes.back().source)
      : status;
  };
  for (const SizeSurface& size : options.sizes.all(options.pattern.size))
  {
    if (size.surface.empty())
    {
      add(size.name, result);
      continue;
    }
    const Flattening other = flattenOne(optionsOf(options, size.surface, result), options.surface);
    if (other.refused())
    {
      refuse(result, other.status, "size " + inQuotes(size.name) + ": " + other.message);
      return;
    }
    if (other.exitCode != Done)
    {
      result.warnings.push_back("size " + inQuotes(size.name) + ": " + other.message);
      result.exitCode = std::max(result.exitCode, other.exitCode);
    }
    if (other.unit != result.unit)
    {
      refuse(result, "UnreadableInput",
        "size " + inQuotes(size.name) + ": " + size.surface + " is in " + other.unit + " and " +
          options.surface + " in " + result.unit + "; state one unit with --unit");
      return;
    }
    add(size.name, other);
  }
  auto graded = std::make_shared<flattening::pattern::Grading>();
  status = status.ok() ? flattening::pattern::gradeSizes(sizes, grading, *graded) : status;
  if (!status.ok())
  {
    refuse(
      result, flattening::statusName(status.code), messageOf(status.message, remediesOf(status)));
    return;
  }
  result.grading = graded;
  result.secondsTotal += secondsSince(start);
}

std::vector<SizeSurface> SizeRequest::all(const std::string& base) const
{
  std::vector<SizeSurface> sizes;
  for (const std::string& text : this->texts)
  {
    const std::size_t sign = std::min(text.find('='), text.size());
    sizes.push_back(
      { text.substr(0, sign), sign < text.size() ? text.substr(sign + 1) : std::string() });
  }
  const bool placed = std::any_of(
    sizes.begin(), sizes.end(), [](const SizeSurface& size) { return size.surface.empty(); });
  if (!placed)
  {
    sizes.insert(sizes.begin(), { base, "" });
  }
  return sizes;
}

std::string SizeRequest::fault(const std::string& base) const
{
  if (base.empty())
  {
    return "a size has no name; write SIZE=SURFACE";
  }
  std::set<std::string> names;
  const std::vector<SizeSurface> sizes = this->all(base);
  for (const SizeSurface& size : sizes)
  {
    if (size.name.empty() || (size.surface.empty() && size.name != base))
    {
      return inQuotes(size.name) + " is not a size; write SIZE=SURFACE";
    }
    if (!names.insert(size.name).second)
    {
      return "the size " + inQuotes(size.name) + " is named twice; leave one of them out";
    }
  }
  return "";
}

void addSizes(
  CLI::App& app, std::vector<std::string>& words, SizeRequest& request, std::string& base)
{
  app
    .add_option("SIZE=SURFACE", words,
      "Surfaces of one connectivity by the names of their sizes, in order, and files of curves, "
      "which are of the base")
    ->type_name("");
  app.add_option("--base", base, "The size whose curves are given (default: the first)")
    ->type_name("SIZE");
  app
    .add_option("--at", request.alignment,
      "Lay sizes on each other at the first point of this curve and along it (default: the first "
      "key curve within each piece; where there is none, as they fit the base best)")
    ->type_name("NAME");
}

namespace
{
/// The triangles of a surface with what finds the closest of them; without triangles where there
/// are none, or a polygon has an id or a point that is refused.
class LocatedTriangles
{
public:
  explicit LocatedTriangles(const DataSet& surface)
  {
    flattening::Triangles triangles;
    for (const ListedTriangle& triangle : listTriangles(surface).triangles)
    {
      const auto& [a, b, c] = triangle.corners;
      triangles.push_back({ static_cast<flattening::Index>(a), static_cast<flattening::Index>(b),
        static_cast<flattening::Index>(c) });
    }
    if (!triangles.empty())
    {
      this->Mesh = flattening::TriangleMesh(*surface.points, std::move(triangles));
      this->Locator.emplace(this->Mesh);
    }
  }
  bool any() const { return this->Locator.has_value(); }
  const flattening::TriangleMesh& mesh() const { return this->Mesh; }
  flattening::ClosestPoint closest(const flattening::Point3& x) const
  {
    return flattening::isUsable(x) ? this->Locator->closest(x) : flattening::ClosestPoint();
  }

private:
  flattening::TriangleMesh Mesh;
  std::optional<flattening::SurfaceLocator> Locator;
};
}

double largestDistance(const DataSet& surface, const std::vector<DataSet>& curves)
{
  double largest = 0.0;
  std::optional<LocatedTriangles> triangles;
  for (const DataSet& data : curves)
  {
    if (data.points == surface.points)
    {
      continue;
    }
    if (!triangles)
    {
      triangles.emplace(surface);
    }
    for (const std::int64_t id : triangles->any() ? data.lines.ids : std::vector<std::int64_t>())
    {
      if (id >= 0 && id < static_cast<std::int64_t>(data.points->size()))
      {
        largest = std::max(
          largest, triangles->closest((*data.points)[static_cast<std::size_t>(id)]).distance);
      }
    }
  }
  return largest;
}

void checkConnectivity(
  const DataSet& base, const std::string& basePath, const DataSet& surface, const std::string& path)
{
  if (base.points->size() == surface.points->size() && base.faces == surface.faces)
  {
    return;
  }
  const auto counts = [](const DataSet& data) {
    return std::to_string(data.points->size()) + " vertices and " +
      std::to_string(data.faces.size()) + " faces";
  };
  const std::string here = counts(surface);
  const std::string there = counts(base);
  throw InputError(path,
    "has another connectivity than " + inQuotes(basePath) +
      (here == there ? ": the corners of its faces differ" : " (" + here + ", not " + there + ")") +
      "; sizes are one mesh with its vertices in other places");
}

DataSet movedCurves(const DataSet& curves, const DataSet& from, const DataSet& to)
{
  DataSet moved = curves;
  if (curves.points == from.points)
  {
    moved.points = to.points;
    return moved;
  }
  const LocatedTriangles faces(from);
  if (!faces.any())
  {
    return moved; // the base's own flattening says what is wrong with it
  }
  flattening::Points3 points = *curves.points;
  for (flattening::Point3& point : points)
  {
    const flattening::ClosestPoint closest = faces.closest(point);
    if (closest.triangle == flattening::none)
    {
      continue; // the flattening says what is wrong with it
    }
    const flattening::Triangle& corners = faces.mesh().triangle(closest.triangle);
    point.setZero();
    for (std::size_t k = 0; k < 3; ++k)
    {
      point += closest.weights[k] * (*to.points)[static_cast<std::size_t>(corners[k])];
    }
  }
  moved.points = std::make_shared<const flattening::Points3>(std::move(points));
  return moved;
}

std::string notesOfNumberNames(const DataSet& surface, const DataSet& curves)
{
  const flattening::Column* const names = findColumn(curves.cellArrays, "CurveName");
  if (!names || !names->isText() || curves.points != surface.points)
  {
    return "";
  }
  for (std::size_t k = 0; k < names->rows(); ++k)
  {
    const std::string name = names->text(k);
    if (!name.empty() && name.find_first_not_of("0123456789") == std::string::npos)
    {
      return "the name of a curve is " + inQuotes(name) +
        ", which is not one of its vertices; if it should be, put a name before it";
    }
  }
  return "";
}
}
