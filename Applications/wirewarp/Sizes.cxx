// SPDX-License-Identifier: BSD-3-Clause
#include "Sizes.h"

#include "FlagWords.h"
#include "Flattening.h"
#include "InputError.h"
#include "Options.h"
#include "Progress.h"
#include "TextFile.h"
#include "VtkMessages.h"

#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkFlatteningAlgorithm.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPatternGrading.h>
#include <vtkPoints.h>
#include <vtkStaticCellLocator.h>
#include <vtkStringArray.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <set>
#include <string>
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

int unitValue(const std::string& unit)
{
  return unit == "mm" ? vtkPatternGrading::MILLIMETRE
    : unit == "m"     ? vtkPatternGrading::METRE
    : unit == "inch"  ? vtkPatternGrading::INCH
                      : vtkPatternGrading::CENTIMETRE;
}
}

void gradeSizes(const Options& options, Flattening& result)
{
  const auto start = std::chrono::steady_clock::now();
  const vtkNew<vtkPatternGrading> grading;
  grading->SetBaseSize(options.pattern.size);
  grading->SetAlignmentCurve(options.sizes.alignment);
  grading->SetUnit(unitValue(result.unit));
  for (const SizeSurface& size : options.sizes.all(options.pattern.size))
  {
    if (size.surface.empty())
    {
      grading->AddSize(size.name, result.flat, result.wires);
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
      result.notes.push_back("size " + inQuotes(size.name) + ": " + other.message);
      result.exitCode = std::max(result.exitCode, other.exitCode);
    }
    if (other.unit != result.unit)
    {
      refuse(result, "UnreadableInput",
        "size " + inQuotes(size.name) + ": " + size.surface + " is in " + other.unit + " and " +
          options.surface + " in " + result.unit + "; state one unit with --unit");
      return;
    }
    grading->AddSize(size.name, other.flat, other.wires);
  }
  const VtkMessages messages;
  grading->Update();
  if (grading->IsRefused())
  {
    refuse(
      result, grading->GetStatusName(), messageOf(grading->GetStatusDefect(), remediesOf(grading)));
    return;
  }
  result.grading = grading->GetOutput();
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
    ->type_name("...");
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
std::array<double, 3> pointOf(vtkPolyData* data, vtkIdType p)
{
  std::array<double, 3> point{};
  data->GetPoint(p, point.data());
  return point;
}

/// Whether VTK's locators can be asked about a point: not where the filters refuse it, since VTK
/// 9.6 ends the program where a coordinate is no number.
bool canBeLocated(const std::array<double, 3>& point)
{
  constexpr double largest = 1e60; // beyond which the filters refuse coordinates
  return std::all_of(point.begin(), point.end(),
    [](double x) { return std::isfinite(x) && std::abs(x) <= largest; });
}

/// The triangles of a surface for VTK's locators, polygons divided as the filters do: a quad that
/// is not flat has its middle elsewhere. Null where there are none, or a polygon has an id or a
/// point that the filters refuse.
vtkSmartPointer<vtkPolyData> locatedTriangles(vtkPolyData* surface)
{
  const VtkMessages messages; // of what the flattening refuses
  auto triangles = vtkSmartPointer<vtkPolyData>::New();
  vtkFlatteningAlgorithm::Triangulate(surface, triangles);
  return triangles->GetNumberOfCells() > 0 ? triangles : nullptr;
}
}

double largestDistance(vtkPolyData* surface, const std::vector<vtkPolyData*>& curves)
{
  double largest = 0.0;
  vtkSmartPointer<vtkPolyData> triangles;
  vtkNew<vtkStaticCellLocator> locator;
  for (vtkPolyData* data : curves)
  {
    if (!data->GetPoints() || data->GetPoints() == surface->GetPoints())
    {
      continue;
    }
    if (!triangles)
    {
      triangles = locatedTriangles(surface);
      if (!triangles)
      {
        return 0.0;
      }
      locator->SetDataSet(triangles);
      locator->BuildLocator();
    }
    const auto lines = vtk::TakeSmartPointer(data->GetLines()->NewIterator());
    for (lines->GoToFirstCell(); !lines->IsDoneWithTraversal(); lines->GoToNextCell())
    {
      const vtkIdType* ids = nullptr;
      vtkIdType count = 0;
      lines->GetCurrentCell(count, ids);
      for (vtkIdType k = 0; k < count; ++k)
      {
        if (ids[k] < 0 || ids[k] >= data->GetNumberOfPoints())
        {
          continue;
        }
        const std::array<double, 3> x = pointOf(data, ids[k]);
        std::array<double, 3> closest{};
        vtkIdType cell = -1;
        int part = 0;
        double square = 0.0;
        if (canBeLocated(x))
        {
          locator->FindClosestPoint(x.data(), closest.data(), cell, part, square);
          largest = cell >= 0 ? std::max(largest, std::sqrt(square)) : largest;
        }
      }
    }
  }
  return largest;
}

namespace
{
bool sameCells(vtkCellArray* one, vtkCellArray* other)
{
  if (one->GetNumberOfCells() != other->GetNumberOfCells())
  {
    return false;
  }
  const auto mine = vtk::TakeSmartPointer(one->NewIterator());
  const auto theirs = vtk::TakeSmartPointer(other->NewIterator());
  theirs->GoToFirstCell();
  for (mine->GoToFirstCell(); !mine->IsDoneWithTraversal(); mine->GoToNextCell())
  {
    vtkIdType count = 0;
    vtkIdType otherCount = 0;
    const vtkIdType* ids = nullptr;
    const vtkIdType* otherIds = nullptr;
    mine->GetCurrentCell(count, ids);
    theirs->GetCurrentCell(otherCount, otherIds);
    if (!std::equal(ids, ids + count, otherIds, otherIds + otherCount))
    {
      return false;
    }
    theirs->GoToNextCell();
  }
  return true;
}
}

void checkConnectivity(
  vtkPolyData* base, const std::string& basePath, vtkPolyData* surface, const std::string& path)
{
  if (base->GetNumberOfPoints() == surface->GetNumberOfPoints() &&
    sameCells(base->GetPolys(), surface->GetPolys()))
  {
    return;
  }
  const auto counts = [](vtkPolyData* data) {
    return std::to_string(data->GetNumberOfPoints()) + " vertices and " +
      std::to_string(data->GetNumberOfPolys()) + " faces";
  };
  const std::string here = counts(surface);
  const std::string there = counts(base);
  throw InputError(path,
    "has another connectivity than " + inQuotes(basePath) +
      (here == there ? ": the corners of its faces differ" : " (" + here + ", not " + there + ")") +
      "; sizes are one mesh with its vertices in other places");
}

vtkSmartPointer<vtkPolyData> movedCurves(vtkPolyData* curves, vtkPolyData* from, vtkPolyData* to)
{
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->ShallowCopy(curves);
  if (!curves->GetPoints() || curves->GetPoints() == from->GetPoints())
  {
    moved->SetPoints(to->GetPoints());
    return moved;
  }
  const vtkSmartPointer<vtkPolyData> faces = locatedTriangles(from);
  if (!faces)
  {
    return moved; // the base's own flattening says what is wrong with it
  }
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(faces);
  locator->BuildLocator();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType p = 0; p < curves->GetNumberOfPoints(); ++p)
  {
    std::array<double, 3> x = pointOf(curves, p);
    std::array<double, 3> closest{};
    vtkIdType id = -1;
    int part = 0;
    double square = 0.0;
    if (canBeLocated(x))
    {
      locator->FindClosestPoint(x.data(), closest.data(), cell, id, part, square);
    }
    std::array<double, 3> parameters{};
    std::vector<double> weights(static_cast<std::size_t>(cell->GetNumberOfPoints()));
    if (id < 0 ||
      cell->EvaluatePosition(
        closest.data(), x.data(), part, parameters.data(), square, weights.data()) < 0)
    {
      points->InsertNextPoint(x.data()); // the flattening says what is wrong with the face
      continue;
    }
    std::array<double, 3> place{};
    for (vtkIdType k = 0; k < cell->GetNumberOfPoints(); ++k)
    {
      std::array<double, 3> corner{};
      to->GetPoint(cell->GetPointId(k), corner.data());
      for (std::size_t c = 0; c < 3; ++c)
      {
        place[c] += weights[static_cast<std::size_t>(k)] * corner[c];
      }
    }
    points->InsertNextPoint(place.data());
  }
  moved->SetPoints(points);
  return moved;
}

std::string notesOfNumberNames(vtkPolyData* surface, vtkPolyData* curves)
{
  auto* names = vtkStringArray::SafeDownCast(curves->GetCellData()->GetAbstractArray("CurveName"));
  if (!names || curves->GetPoints() != surface->GetPoints())
  {
    return "";
  }
  for (vtkIdType k = 0; k < names->GetNumberOfValues(); ++k)
  {
    const std::string name = names->GetValue(k);
    if (!name.empty() && name.find_first_not_of("0123456789") == std::string::npos)
    {
      return "the name of a curve is " + inQuotes(name) +
        ", which is not one of its vertices; if it should be, put a name before it";
    }
  }
  return "";
}
}
