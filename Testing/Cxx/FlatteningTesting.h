// SPDX-License-Identifier: BSD-3-Clause
// What several tests of the filters need: checks, small surfaces, and an ear for messages.
#ifndef FlatteningTesting_h
#define FlatteningTesting_h

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkFlatPieceAlgorithm.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkVariant.h"
#include "vtkXMLPolyDataReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <iostream>
#include <string>
#include <vector>

namespace flatteningTesting
{
/// Counts what fails; a test returns result().
class Checks
{
public:
  void that(bool fact, const std::string& what)
  {
    if (!fact)
    {
      std::cerr << "FAILED: " << what << "\n";
      ++this->Failures;
    }
  }
  void near(double value, double expected, double tolerance, const std::string& what)
  {
    if (!(std::abs(value - expected) <= tolerance))
    {
      std::cerr.precision(17);
      std::cerr << "FAILED: " << what << " is " << value << ", not " << expected << " within "
                << tolerance << "\n";
      ++this->Failures;
    }
  }
  template <class A, class B>
  void equal(const A& value, const B& expected, const std::string& what)
  {
    if (!(value == expected))
    {
      std::cerr << "FAILED: " << what << " is " << value << ", not " << expected << "\n";
      ++this->Failures;
    }
  }
  void contains(const std::string& text, const std::string& part, const std::string& what)
  {
    if (text.find(part) == std::string::npos)
    {
      std::cerr << "FAILED: " << what << " should contain \"" << part << "\": " << text << "\n";
      ++this->Failures;
    }
  }
  int result() const { return this->Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE; }

private:
  int Failures = 0;
};

/// Keeps the errors and warnings of an object from the output and remembers them.
class Messages
{
public:
  explicit Messages(vtkObject* object)
  {
    object->AddObserver(vtkCommand::ErrorEvent, this, &Messages::onError);
    object->AddObserver(vtkCommand::WarningEvent, this, &Messages::onWarning);
    if (auto* const algorithm = vtkAlgorithm::SafeDownCast(object))
    {
      // It repeats that the request failed.
      vtkNew<vtkCallbackCommand> nothing;
      nothing->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
      algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, nothing);
    }
  }
  std::vector<std::string> errors;
  std::vector<std::string> warnings;

private:
  void onError(vtkObject*, unsigned long, void* text)
  {
    this->errors.emplace_back(static_cast<char*>(text));
  }
  void onWarning(vtkObject*, unsigned long, void* text)
  {
    this->warnings.emplace_back(static_cast<char*>(text));
  }
};

using Cell = std::vector<vtkIdType>;

/// An array of what a function gives for 0, 1, ...
template <class Array, class Value>
vtkSmartPointer<Array> arrayOf(const char* name, vtkIdType count, const Value& value)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  for (vtkIdType k = 0; k < count; ++k)
  {
    array->InsertNextValue(value(k));
  }
  return array;
}

template <class Array, class Value>
vtkSmartPointer<Array> arrayOf(const char* name, const std::vector<Value>& values)
{
  return arrayOf<Array>(name, static_cast<vtkIdType>(values.size()),
    [&values](vtkIdType k) { return values[static_cast<std::size_t>(k)]; });
}

/// A value of an array of cells.
inline double cellValue(vtkPolyData* data, const char* array, vtkIdType cell)
{
  return data->GetCellData()->GetArray(array)->GetComponent(cell, 0);
}

inline vtkSmartPointer<vtkPolyData> makePolyData(
  const std::vector<std::array<double, 3>>& coordinates, const std::vector<Cell>& polygons)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const std::array<double, 3>& p : coordinates)
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> cells;
  for (const Cell& polygon : polygons)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(cells);
  return surface;
}

/// (columns + 1) x (rows + 1) points over the unit square, i + j (columns + 1), lifted by `height`.
inline vtkSmartPointer<vtkPolyData> makeGrid(
  int columns, int rows,
  const std::function<double(double, double)>& height = [](double, double) { return 0.0; })
{
  std::vector<std::array<double, 3>> points;
  std::vector<Cell> triangles;
  for (int j = 0; j <= rows; ++j)
  {
    for (int i = 0; i <= columns; ++i)
    {
      const double x = static_cast<double>(i) / columns;
      const double y = static_cast<double>(j) / rows;
      points.push_back({ x, y, height(x, y) });
      if (i < columns && j < rows)
      {
        const vtkIdType a = i + static_cast<vtkIdType>(j) * (columns + 1);
        const vtkIdType c = a + columns + 1;
        triangles.push_back({ a, a + 1, c + 1 });
        triangles.push_back({ a, c + 1, c });
      }
    }
  }
  return makePolyData(points, triangles);
}

/// The paper's quarter-sphere (Fig. 11): a lune of 90 degrees of the unit sphere in 4 x 8 steps, 37
/// points, 56 triangles. Point 0 is the north pole, 36 the south pole, 1 + i + 5 (j - 1) between
/// them.
inline vtkIdType lunePoint(int i, int j)
{
  return j == 0 ? 0 : j == 8 ? 36 : 1 + i + 5 * static_cast<vtkIdType>(j - 1);
}

inline vtkSmartPointer<vtkPolyData> makeQuarterSphere()
{
  std::vector<std::array<double, 3>> points(37);
  const double step = vtkMath::Pi() / 8.0;
  for (int j = 0; j <= 8; ++j)
  {
    for (int i = 0; i <= 4; ++i)
    {
      points[lunePoint(i, j)] = { std::sin(j * step) * std::cos(i * step),
        std::sin(j * step) * std::sin(i * step), std::cos(j * step) };
    }
  }
  std::vector<Cell> triangles;
  for (int j = 0; j < 8; ++j)
  {
    for (int i = 0; i < 4; ++i)
    {
      if (j < 7)
      {
        triangles.push_back({ lunePoint(i, j), lunePoint(i, j + 1), lunePoint(i + 1, j + 1) });
      }
      if (j > 0)
      {
        triangles.push_back({ lunePoint(i, j), lunePoint(i + 1, j + 1), lunePoint(i + 1, j) });
      }
    }
  }
  return makePolyData(points, triangles);
}

/// Closed, of six quads; `x` moves it along the first axis.
inline vtkSmartPointer<vtkPolyData> makeCube(double x = 0.0)
{
  return makePolyData({ { x, 0, 0 }, { x + 1, 0, 0 }, { x + 1, 1, 0 }, { x, 1, 0 }, { x, 0, 1 },
                        { x + 1, 0, 1 }, { x + 1, 1, 1 }, { x, 1, 1 } },
    { { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 },
      { 3, 0, 4, 7 } });
}

/// Adds a polyline over points of a data set as one of its line cells.
inline void addLine(vtkPolyData* data, const Cell& line)
{
  vtkNew<vtkCellArray> lines;
  if (data->GetNumberOfLines() > 0)
  {
    lines->DeepCopy(data->GetLines());
  }
  lines->InsertNextCell(static_cast<vtkIdType>(line.size()), line.data());
  data->SetLines(lines);
}

/// Lines over the points of a surface, as a data set of their own.
inline vtkSmartPointer<vtkPolyData> makeCurves(
  vtkPolyData* surface, const std::vector<Cell>& lines, const std::vector<int>& types = {})
{
  auto curves = vtkSmartPointer<vtkPolyData>::New();
  curves->SetPoints(surface->GetPoints());
  for (const Cell& line : lines)
  {
    addLine(curves, line);
  }
  if (!types.empty())
  {
    curves->GetCellData()->AddArray(arrayOf<vtkIntArray>("CurveType", types));
  }
  return curves;
}

/// An array of one value throughout.
template <class Array>
vtkSmartPointer<Array> filled(
  const char* name, int components, vtkIdType tuples, const vtkVariant& value)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  for (vtkIdType k = 0; k < components * tuples; ++k)
  {
    array->SetVariantValue(k, value);
  }
  return array;
}

/// The arc half-way between the poles of the quarter-sphere.
inline vtkSmartPointer<vtkPolyData> makeQuarterSphereArc(vtkPolyData* surface)
{
  return makeCurves(surface,
    { { lunePoint(0, 4), lunePoint(1, 4), lunePoint(2, 4), lunePoint(3, 4), lunePoint(4, 4) } });
}

/// A value of a table; infinite where there is none.
inline double number(vtkTable* table, const char* column, vtkIdType row = 0)
{
  const bool known = table->GetColumnByName(column) && row < table->GetNumberOfRows();
  return known ? table->GetValueByName(row, column).ToDouble() : vtkMath::Inf();
}

inline std::string text(vtkTable* table, const char* column, vtkIdType row = 0)
{
  const bool known = table->GetColumnByName(column) && row < table->GetNumberOfRows();
  return known ? std::string(table->GetValueByName(row, column).ToString()) : "(none)";
}

/// A value of the table of pieces.
inline double number(vtkFlatPieceAlgorithm* filter, const char* column, vtkIdType row = 0)
{
  return number(filter->GetPieces(), column, row);
}

/// A value of the field data.
inline double number(vtkPolyData* data, const char* array, vtkIdType row = 0)
{
  vtkDataArray* values = data->GetFieldData()->GetArray(array);
  return values && row < values->GetNumberOfTuples() ? values->GetComponent(row, 0)
                                                     : vtkMath::Inf();
}

inline std::string text(vtkPolyData* data, const char* array, vtkIdType row = 0)
{
  auto* values = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(array));
  return values && row < values->GetNumberOfValues() ? values->GetValue(row) : "(none)";
}

/// Largest relative difference of the lengths of all segments of `lines` over two sets of points.
inline double largestLengthError(vtkPolyData* lines, vtkPoints* flat, vtkPoints* inSpace)
{
  double largest = 0.0;
  for (vtkIdType k = 0; k < lines->GetNumberOfLines(); ++k)
  {
    vtkNew<vtkIdList> ids;
    lines->GetLines()->GetCellAtId(k, ids);
    for (vtkIdType i = 1; i < ids->GetNumberOfIds(); ++i)
    {
      double a[3];
      double b[3];
      flat->GetPoint(ids->GetId(i - 1), a);
      flat->GetPoint(ids->GetId(i), b);
      const double length = std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
      inSpace->GetPoint(ids->GetId(i - 1), a);
      inSpace->GetPoint(ids->GetId(i), b);
      const double rest = std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
      largest = std::max(largest, std::abs(length - rest) / rest);
    }
  }
  return largest;
}

/// What stands behind an option on the command line.
inline std::string argumentOf(
  const std::string& option, int argc, char* argv[], const char* otherwise)
{
  for (int i = 1; i + 1 < argc; ++i)
  {
    if (argv[i] == option)
    {
      return argv[i + 1];
    }
  }
  return otherwise;
}
inline std::string dataDirectory(int argc, char* argv[])
{
  return argumentOf("-D", argc, argv, ".");
}
inline std::string temporaryDirectory(int argc, char* argv[])
{
  return argumentOf("-T", argc, argv, "Testing/Temporary");
}

inline vtkSmartPointer<vtkPolyData> read(const std::string& path)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

inline bool isEmpty(vtkPolyData* data)
{
  return data->GetNumberOfPoints() == 0 && data->GetNumberOfCells() == 0;
}

/// Equal to the last bit.
inline void samePoints(Checks& check, vtkPolyData* a, vtkPolyData* b, const std::string& what)
{
  check.equal(a->GetNumberOfPoints(), b->GetNumberOfPoints(), what + ": points");
  for (vtkIdType p = 0; p < std::min(a->GetNumberOfPoints(), b->GetNumberOfPoints()); ++p)
  {
    for (int k = 0; k < 3; ++k)
    {
      check.equal(a->GetPoints()->GetData()->GetComponent(p, k),
        b->GetPoints()->GetData()->GetComponent(p, k), what + ": coordinate");
    }
  }
}

/// Every array of `expected` but those of time has the same values in `data`.
inline void sameArrays(
  Checks& check, vtkFieldData* data, vtkFieldData* expected, const std::string& what)
{
  check.equal(data->GetNumberOfArrays(), expected->GetNumberOfArrays(), what + ": arrays");
  for (int k = 0; k < expected->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* const before = expected->GetAbstractArray(k);
    vtkAbstractArray* const after = data->GetAbstractArray(before->GetName());
    check.that(after != nullptr, what + " has " + before->GetName());
    if (!after || std::string(before->GetName()).rfind("Seconds", 0) == 0)
    {
      continue;
    }
    check.equal(after->GetNumberOfValues(), before->GetNumberOfValues(), before->GetName());
    for (vtkIdType i = 0; i < before->GetNumberOfValues(); ++i)
    {
      check.that(
        after->GetVariantValue(i) == before->GetVariantValue(i), what + ": " + before->GetName());
    }
  }
}

/// A filter that has run.
template <class Filter>
vtkSmartPointer<Filter> updated(vtkPolyData* surface)
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputData(surface);
  filter->Update();
  return filter;
}

template <class Filter>
vtkSmartPointer<Filter> updated(vtkPolyData* surface, vtkPolyData* curves)
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputData(surface);
  filter->SetCurvesData(curves);
  filter->Update();
  return filter;
}
}

#endif
