// SPDX-License-Identifier: BSD-3-Clause
// Measures of maps whose distortion is known in closed form, and of the filters' own results.
#include "FlatteningTesting.h"

#include "vtkFlatteningQuality.h"
#include "vtkWireWarpingFilter.h"

using namespace flatteningTesting;

namespace
{
vtkSmartPointer<vtkPolyData> mapped(
  vtkPolyData* surface, const std::function<std::array<double, 2>(double, double)>& map)
{
  auto flat = vtkSmartPointer<vtkPolyData>::New();
  flat->DeepCopy(surface);
  for (vtkIdType p = 0; p < flat->GetNumberOfPoints(); ++p)
  {
    const std::array<double, 2> position = map(surface->GetPoint(p)[0], surface->GetPoint(p)[1]);
    flat->GetPoints()->SetPoint(p, position[0], position[1], 0.0);
  }
  return flat;
}

void edgesChooseWhatCounts(Checks& check)
{
  const auto grid = makeGrid(4, 4);
  const auto flat = mapped(grid, [](double x, double y) {
    return std::array<double, 2>{ 2.0 * x, 0.25 * y };
  });
  vtkNew<vtkFlatteningQuality> quality;
  quality->SetInputData(grid);
  quality->SetFlatData(flat);
  quality->SetEdgesData(makeCurves(grid, { { 10, 11, 12 } }));
  quality->Update();
  check.near(number(quality->GetMeasures(), "EdgeLengthError"), 1.0, 1e-14, "E_len along x");
  // The same edges by the coordinates of the flat surface.
  quality->SetEdgesData(makeCurves(flat, { { 2, 7, 12 } }));
  quality->Update();
  check.near(number(quality->GetMeasures(), "EdgeLengthError"), 0.75, 1e-14, "E_len along y");
}

// A strip rolled over itself: its ends cross.
void overlapsAreListed(Checks& check)
{
  vtkNew<vtkFlatteningQuality> quality;
  const auto strip = makeGrid(24, 1);
  quality->SetInputData(strip);
  quality->SetFlatData(mapped(strip, [](double x, double y) {
    const double angle = 2.3 * vtkMath::Pi() * x;
    return std::array<double, 2>{ (2.0 - y) * std::cos(angle), (2.0 - y) * std::sin(angle) };
  }));
  quality->Update();
  const auto rows = [&] {
    auto* edges =
      vtkIdTypeArray::SafeDownCast(quality->GetOutput()->GetFieldData()->GetArray("OverlapEdges"));
    return edges && edges->GetNumberOfComponents() == 4 ? edges->GetNumberOfTuples() : 0;
  };
  const double all = number(quality->GetMeasures(), "Overlaps");
  check.that(all > 1.0, "the roll overlaps itself");
  check.equal(static_cast<double>(rows()), all, "a row of OverlapEdges for each");
  quality->SetMaximumOverlaps(1);
  quality->Update();
  check.equal(
    number(quality->GetMeasures(), "Overlaps"), all, "MaximumOverlaps bounds the list alone");
  check.equal(rows(), vtkIdType{ 1 }, "rows of OverlapEdges");
}

// The filter's own numbers come out again from its outputs: as texture coordinates and as two
// surfaces, with a dart, so that both sides of the cut must stay apart.
void theFiltersNumbersComeOutAgain(Checks& check)
{
  const auto surface = makeQuarterSphere();
  const auto filter = updated<vtkWireWarpingFilter>(surface,
    makeCurves(surface,
      { { lunePoint(0, 4), lunePoint(1, 4), lunePoint(2, 4) },
        { lunePoint(0, 2), lunePoint(1, 2), lunePoint(2, 2), lunePoint(3, 2), lunePoint(4, 2) } },
      { 2, 0 }));
  vtkPolyData* flat = filter->GetOutput(0);
  for (const bool twoSurfaces : { false, true })
  {
    vtkNew<vtkFlatteningQuality> quality;
    quality->SetInputData(filter->GetOutput(2));
    if (twoSurfaces)
    {
      quality->SetFlatData(flat);
    }
    quality->Update();
    vtkPolyData* output = quality->GetOutput();
    check.equal(std::string(quality->GetStatusName()), "Ok", "status");
    check.equal(output->GetNumberOfCells(), flat->GetNumberOfCells(), "cells");
    check.equal(number(quality->GetMeasures(), "Vertices"), number(filter, "Vertices"), "Vertices");
    for (const char* name : { "AngleErrorMean", "GlobalHomogeneity", "GlobalAspectRatio",
           "AreaError", "StrainP95", "RigidEnergy", "CutLength" })
    {
      check.near(number(quality->GetMeasures(), name), number(filter, name), 1e-12, name);
    }
    // The dart of two edges, each a chord of the sphere over an eighth of 180 degrees.
    check.near(number(quality->GetMeasures(), "CutLength"), 4.0 * std::sin(vtkMath::Pi() / 16),
      1e-12, "a dart");
    check.near(number(quality->GetMeasures(), "MaxEdgeLengthError"), 0.0, 1e-10, "E_len_max");
    for (vtkIdType t = 0; t < output->GetNumberOfCells(); ++t)
    {
      check.near(cellValue(output, "AreaRatio", t), cellValue(flat, "AreaRatio", t), 1e-12, "a");
    }
  }
}

void looseTrianglesAreLeftOut(Checks& check)
{
  for (const vtkIdType before : { 0, 3, 8 })
  {
    for (const bool three : { false, true })
    {
      const auto grid = makeGrid(2, 2);
      const auto plain = makeGrid(2, 2);
      vtkNew<vtkCellArray> cells;
      const vtkIdType p = grid->GetPoints()->InsertNextPoint(0.3, 0.4, 0.0);
      const vtkIdType q = three ? grid->GetPoints()->InsertNextPoint(0.3, 0.4, 0.0) : p;
      for (vtkIdType t = 0; t <= plain->GetNumberOfCells(); ++t)
      {
        if (t == before)
        {
          cells->InsertNextCell({ p, q, p });
        }
        if (t < plain->GetNumberOfCells())
        {
          cells->InsertNextCell(plain->GetCell(t));
        }
      }
      grid->SetPolys(cells);
      vtkNew<vtkFlatteningQuality> quality;
      const Messages messages(quality);
      quality->SetInputData(grid);
      quality->SetFlatData(mapped(grid, [](double x, double y) {
        return std::array<double, 2>{ 2.0 * x, y };
      }));
      quality->Update();
      vtkPolyData* const output = quality->GetOutput();
      const std::string what = "a loose triangle as cell " + std::to_string(before);
      check.equal(std::string(quality->GetStatusName()), "Ok", what);
      check.equal(messages.warnings.size(), std::size_t{ 1 }, what + ": warnings");
      check.contains(messages.warnings.empty() ? "" : messages.warnings.front(),
        "taken out (" + std::to_string(before) + ")", what);
      check.equal(output->GetNumberOfCells(), plain->GetNumberOfCells(), what + ": cells");
      check.near(number(quality->GetMeasures(), "AreaError"), 1.0, 1e-14, what + ": E_area");
      for (vtkIdType t = 0; t < output->GetNumberOfCells(); ++t)
      {
        check.equal(cellValue(output, "vtkOriginalCellIds", t),
          static_cast<double>(t < before ? t : t + 1), what + ": vtkOriginalCellIds");
        check.near(cellValue(output, "AreaRatio", t), 2.0, 1e-14, what + ": AreaRatio");
      }
    }
  }
}

void badInputIsRefused(Checks& check)
{
  const auto grid = makeGrid(2, 2);
  struct Case
  {
    const char* what;
    vtkSmartPointer<vtkPolyData> flat;
    vtkSmartPointer<vtkPolyData> edges;
    int status;
    const char* words;
  };
  const auto broken = makeGrid(2, 2);
  broken->GetPoints()->SetPoint(5, std::nan(""), 0.0, 0.0);
  const auto away = makePolyData({ { 0, 0, 0 }, { 7, 7, 7 } }, {});
  addLine(away, { 0, 1 });
  for (const Case& c :
    { Case{ "no flat positions", nullptr, nullptr, vtkFlatteningQuality::INVALID_OPTION, "port 1" },
      Case{ "another surface", makeGrid(3, 2), nullptr, vtkFlatteningQuality::INVALID_OPTION,
        "as many points" },
      Case{ "a NaN", broken, nullptr, vtkFlatteningQuality::NON_FINITE_POINT, "points 5" },
      Case{ "edges elsewhere", makeGrid(2, 2), away, vtkFlatteningQuality::CURVE_POINT_OFF_SURFACE,
        "points 1" },
      Case{ "an edge across", makeGrid(2, 2), makeCurves(grid, { { 2, 4 } }),
        vtkFlatteningQuality::CURVE_NOT_ON_EDGES, "between points 2 and 4" } })
  {
    vtkNew<vtkFlatteningQuality> quality;
    const Messages messages(quality);
    quality->SetInputData(grid);
    if (c.flat)
    {
      quality->SetFlatData(c.flat);
    }
    if (c.edges)
    {
      quality->SetEdgesData(c.edges);
    }
    quality->Update();
    check.equal(quality->GetStatusCode(), c.status, std::string(c.what) + ": status");
    check.equal(messages.errors.size(), std::size_t{ 1 }, std::string(c.what) + ": errors");
    check.contains(quality->GetStatusMessage(), c.words, c.what);
    check.that(isEmpty(quality->GetOutput()), std::string(c.what) + ": output is empty");
  }
}
}

int TestFlatteningQuality(int, char*[])
{
  Checks check;
  edgesChooseWhatCounts(check);
  overlapsAreListed(check);
  theFiltersNumbersComeOutAgain(check);
  looseTrianglesAreLeftOut(check);
  badInputIsRefused(check);
  return check.result();
}
