// SPDX-License-Identifier: BSD-3-Clause
#include "GradingData.h"

#include "FieldArrays.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace bridge
{
namespace
{
using pattern::GradeRule;
using pattern::Grading;
using pattern::SourceWire;

Status invalidSizes(const std::string& what)
{
  return { StatusCode::InvalidPattern, "the sizes: " + what, {},
    { { Remedy::Give, "the output of vtkPatternGrading" } } };
}

/// Points as rows of a field array.
void addPoints(vtkFieldData* field, const char* name, const std::vector<Points2>& rows)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  const std::size_t width = rows.empty() ? 0 : rows.front().size();
  array->SetNumberOfComponents(static_cast<int>(2 * width));
  array->SetNumberOfTuples(static_cast<vtkIdType>(rows.size()));
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    for (std::size_t k = 0; k < width; ++k)
    {
      const int column = static_cast<int>(2 * k);
      array->SetComponent(static_cast<vtkIdType>(row), column, rows[row][k].x());
      array->SetComponent(static_cast<vtkIdType>(row), column + 1, rows[row][k].y());
    }
  }
  addUnlessEmpty(field, array);
}

/// An array of the field data; null where it has other rows or components.
vtkDataArray* numbers(vtkPolyData* data, const char* name, vtkIdType rows, int components)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() == rows && array->GetNumberOfComponents() == components
    ? array
    : nullptr;
}

Point2 pointOf(vtkDataArray* array, vtkIdType row, std::size_t point)
{
  const int column = static_cast<int>(2 * point);
  return { array->GetComponent(row, column), array->GetComponent(row, column + 1) };
}

/// A whole number within bounds; none where it is none.
Index indexBelow(double value, vtkIdType count)
{
  const bool within = value >= 0.0 && value < static_cast<double>(count);
  return within ? static_cast<Index>(value) : none;
}

/// The wires of the first size; those of the others are the same.
Status readWires(vtkPolyData* data, vtkIdType points, vtkIdType pieces, Grading& grading)
{
  auto* const names =
    vtkStringArray::SafeDownCast(data->GetCellData()->GetAbstractArray("CurveName"));
  vtkDataArray* const sizes = data->GetCellData()->GetArray("SizeId");
  vtkDataArray* const ofPiece = data->GetCellData()->GetArray("PieceId");
  const vtkIdType cells = data->GetNumberOfCells();
  if (!names || !sizes || !ofPiece || names->GetNumberOfTuples() != cells ||
    sizes->GetNumberOfTuples() != cells || ofPiece->GetNumberOfTuples() != cells ||
    data->GetNumberOfLines() != cells || !data->GetLines()->IsValid())
  {
    return invalidSizes("there are no lines with SizeId, PieceId and CurveName");
  }
  const auto lines = vtk::TakeSmartPointer(data->GetLines()->NewIterator());
  for (lines->GoToFirstCell(); !lines->IsDoneWithTraversal(); lines->GoToNextCell())
  {
    const vtkIdType row = lines->GetCurrentCellId();
    if (sizes->GetComponent(row, 0) != 0.0)
    {
      continue;
    }
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    lines->GetCurrentCell(count, ids);
    SourceWire wire;
    wire.name = names->GetValue(row);
    wire.piece = indexBelow(ofPiece->GetComponent(row, 0), pieces);
    for (vtkIdType k = 0; k < count; ++k)
    {
      wire.points.push_back(indexBelow(static_cast<double>(ids[k]), points));
    }
    if (wire.piece == none || count < 2 ||
      std::find(wire.points.begin(), wire.points.end(), none) != wire.points.end())
    {
      return invalidSizes("the line " + std::to_string(row) + " is of no piece or of no points");
    }
    grading.wires.push_back(std::move(wire));
  }
  return {};
}

Status readRules(vtkPolyData* data, vtkIdType points, vtkIdType pieces, Grading& grading)
{
  auto* const names =
    vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("RuleName"));
  const vtkIdType rows = names ? names->GetNumberOfTuples() : 0;
  const std::size_t sizes = grading.sizes.size();
  vtkDataArray* const ofPiece = numbers(data, "RulePiece", rows, 1);
  vtkDataArray* const ofPoint = numbers(data, "RulePoint", rows, 1);
  vtkDataArray* const deltas = numbers(data, "RuleDelta", rows, static_cast<int>(2 * sizes));
  if (rows > 0 && (!ofPiece || !ofPoint || !deltas))
  {
    return invalidSizes("RulePiece, RulePoint or RuleDelta is missing or has other rows");
  }
  for (vtkIdType row = 0; row < rows; ++row)
  {
    GradeRule rule;
    rule.name = names->GetValue(row);
    rule.piece = indexBelow(ofPiece->GetComponent(row, 0), pieces);
    rule.point = indexBelow(ofPoint->GetComponent(row, 0), points);
    if (rule.piece == none || rule.point == none)
    {
      return invalidSizes("the rule " + std::to_string(row) + " is of no piece or of no point");
    }
    for (std::size_t s = 0; s < sizes; ++s)
    {
      rule.deltas.push_back(pointOf(deltas, row, s));
    }
    grading.rules.push_back(std::move(rule));
  }
  return {};
}
}

//------------------------------------------------------------------------------
void writeGrading(const Grading& grading, vtkPolyData* output)
{
  const std::size_t points = grading.positions.front().size();
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIntArray> sizeIds;
  vtkNew<vtkIdTypeArray> pieceIds;
  vtkNew<vtkStringArray> names;
  sizeIds->SetName("SizeId");
  pieceIds->SetName("PieceId");
  names->SetName("CurveName");
  for (std::size_t s = 0; s < grading.sizes.size(); ++s)
  {
    for (const Point2& p : grading.positions[s])
    {
      places->InsertNextPoint(p.x(), p.y(), 0.0);
    }
    for (const SourceWire& wire : grading.wires)
    {
      lines->InsertNextCell(static_cast<int>(wire.points.size()));
      for (const Index point : wire.points)
      {
        lines->InsertCellPoint(static_cast<vtkIdType>(s * points) + point);
      }
      sizeIds->InsertNextValue(static_cast<int>(s));
      pieceIds->InsertNextValue(wire.piece);
      names->InsertNextValue(wire.name);
    }
  }
  output->SetPoints(places);
  output->SetLines(lines);
  output->GetCellData()->AddArray(sizeIds);
  output->GetCellData()->AddArray(pieceIds);
  output->GetCellData()->AddArray(names);
  vtkFieldData* const field = output->GetFieldData();
  addStrings(field, "SizeName", grading.sizes);
  addRows<vtkIntArray>(
    field, "BaseSize", 1, [&](std::size_t) { return static_cast<int>(grading.base); });
  addPoints(field, "GrainDirection", std::vector<Points2>(1, grading.grains));
  const auto& rules = grading.rules;
  addRows<vtkIdTypeArray>(
    field, "RulePiece", rules.size(), [&](std::size_t k) { return vtkIdType{ rules[k].piece }; });
  addRows<vtkIdTypeArray>(
    field, "RulePoint", rules.size(), [&](std::size_t k) { return vtkIdType{ rules[k].point }; });
  addRows<vtkStringArray>(
    field, "RuleName", rules.size(), [&](std::size_t k) { return rules[k].name; });
  std::vector<Points2> deltas;
  for (const GradeRule& rule : rules)
  {
    deltas.push_back(rule.deltas);
  }
  addPoints(field, "RuleDelta", deltas);
}

//------------------------------------------------------------------------------
Status readGrading(vtkPolyData* data, Grading& grading)
{
  grading = Grading();
  auto* const names =
    vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("SizeName"));
  const vtkIdType sizes = names ? names->GetNumberOfTuples() : 0;
  vtkDataArray* const base = numbers(data, "BaseSize", 1, 1);
  vtkDataArray* const grains = data->GetFieldData()->GetArray("GrainDirection");
  if (sizes < 1 || !base || !grains || grains->GetNumberOfTuples() != 1 ||
    data->GetNumberOfPoints() % sizes != 0 || data->GetNumberOfPoints() == 0)
  {
    return invalidSizes("SizeName, BaseSize or GrainDirection is missing or has other rows");
  }
  const vtkIdType points = data->GetNumberOfPoints() / sizes;
  const vtkIdType pieces = grains->GetNumberOfComponents() / 2;
  const Index chosen = indexBelow(base->GetComponent(0, 0), sizes);
  if (chosen == none)
  {
    return invalidSizes("BaseSize is no size");
  }
  grading.base = static_cast<std::size_t>(chosen);
  for (vtkIdType s = 0; s < sizes; ++s)
  {
    grading.sizes.push_back(names->GetValue(s));
    Points2& laid = grading.positions.emplace_back();
    for (vtkIdType v = 0; v < points; ++v)
    {
      const double* p = data->GetPoint(s * points + v);
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]))
      {
        return invalidSizes("a point is not finite");
      }
      laid.emplace_back(p[0], p[1]);
    }
  }
  for (vtkIdType piece = 0; piece < pieces; ++piece)
  {
    grading.grains.push_back(pointOf(grains, 0, static_cast<std::size_t>(piece)));
  }
  Status status = readWires(data, points, pieces, grading);
  return status.ok() ? readRules(data, points, pieces, grading) : status;
}
}
}
