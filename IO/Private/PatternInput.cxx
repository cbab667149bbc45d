// SPDX-License-Identifier: BSD-3-Clause
#include "PatternInput.h"

#include "Formats/PatternData.h"
#include "Outlines/Outline.h"
#include "PolyDataSets.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

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

/// Points as rows of an array.
Column pointColumn(const char* name, const std::vector<Points2>& rows)
{
  std::vector<double> values;
  for (const Points2& row : rows)
  {
    for (const Point2& point : row)
    {
      values.insert(values.end(), { point.x(), point.y() });
    }
  }
  const int width = rows.empty() ? 1 : static_cast<int>(2 * rows.front().size());
  return { name, std::move(values), std::max(width, 1) };
}

Point2 pointOf(const Column& column, std::size_t row, std::size_t point)
{
  const int k = static_cast<int>(2 * point);
  return { column.number(row, k), column.number(row, k + 1) };
}

/// An array of numbers; null where it has other rows or components.
const Column* numbers(
  const Columns& columns, const char* name, std::size_t rows, std::size_t components = 1)
{
  const Column* const found = findColumn(columns, name);
  return found && !found->isText() && found->rows() == rows &&
      static_cast<std::size_t>(found->components) == components
    ? found
    : nullptr;
}

/// An array of texts; null where there is none.
const Column* texts(const Columns& columns, const char* name)
{
  const Column* const found = findColumn(columns, name);
  return found && found->isText() && found->components == 1 ? found : nullptr;
}

/// A whole number within bounds; none where it is none.
Index indexBelow(double value, std::size_t count)
{
  return value >= 0.0 && value < static_cast<double>(count) ? static_cast<Index>(value) : none;
}

/// The wires of the first size; those of the others are the same.
Status readWires(const DataSet& data, std::size_t points, Grading& grading)
{
  const std::size_t cells = data.cells();
  const Column* const names = texts(data.cellArrays, "CurveName");
  const Column* const sizes = numbers(data.cellArrays, "SizeId", cells);
  const Column* const ofPiece = numbers(data.cellArrays, "PieceId", cells);
  if (!names || !sizes || !ofPiece || names->rows() != cells || data.lines.size() != cells)
  {
    return invalidSizes("there are no lines with SizeId, PieceId and CurveName");
  }
  for (std::size_t row = 0; row < cells; ++row)
  {
    if (sizes->number(row) != 0.0)
    {
      continue;
    }
    SourceWire wire;
    wire.name = names->text(row);
    wire.piece = indexBelow(ofPiece->number(row), grading.grains.size());
    std::transform(data.lines.begin(row), data.lines.end(row), std::back_inserter(wire.points),
      [points](std::int64_t id) { return indexBelow(static_cast<double>(id), points); });
    if (wire.piece == none || wire.points.size() < 2 ||
      std::find(wire.points.begin(), wire.points.end(), none) != wire.points.end())
    {
      return invalidSizes("the line " + std::to_string(row) + " is of no piece or of no points");
    }
    grading.wires.push_back(std::move(wire));
  }
  return {};
}

Status readRules(const Columns& field, std::size_t points, Grading& grading)
{
  const Column* const names = texts(field, "RuleName");
  const std::size_t rows = names ? names->rows() : 0;
  const std::size_t sizes = grading.sizes.size();
  const Column* const ofPiece = numbers(field, "RulePiece", rows);
  const Column* const ofPoint = numbers(field, "RulePoint", rows);
  const Column* const deltas = numbers(field, "RuleDelta", rows, 2 * sizes);
  if (rows > 0 && (!ofPiece || !ofPoint || !deltas))
  {
    return invalidSizes("RulePiece, RulePoint or RuleDelta is missing or has other rows");
  }
  for (std::size_t row = 0; row < rows; ++row)
  {
    GradeRule rule;
    rule.name = names->text(row);
    rule.piece = indexBelow(ofPiece->number(row), grading.grains.size());
    rule.point = indexBelow(ofPoint->number(row), points);
    if (rule.piece == none || rule.point == none)
    {
      return invalidSizes("the rule " + std::to_string(row) + " is of no piece or of no point");
    }
    for (std::size_t s = 0; s < sizes; ++s)
    {
      rule.deltas.push_back(pointOf(*deltas, row, s));
    }
    grading.rules.push_back(std::move(rule));
  }
  return {};
}
}

Status readPieces(
  vtkPolyData* flat, vtkPolyData* wires, vtkPolyData* cut, pattern::PatternSource& source)
{
  for (vtkPolyData* const data : { flat, wires, cut })
  {
    if (data && (!data->GetPolys()->IsValid() || !data->GetLines()->IsValid()))
    {
      return pattern::invalidPieces(std::string("the cells of the ") +
        (data == wires ? "wires" : "flat surface") + " do not fit the list of their " +
        (data == wires ? "points" : "corners"));
    }
  }
  const DataSet wireData = wires ? dataSetOf(wires) : DataSet();
  const DataSet cutData = cut ? geometryOf(cut) : DataSet();
  return pattern::readPattern(
    dataSetOf(flat), wires ? &wireData : nullptr, cut ? &cutData : nullptr, source);
}

void writeGrading(const Grading& grading, vtkPolyData* output)
{
  const std::size_t count = grading.positions.front().size();
  DataSet data;
  Points3 places;
  std::vector<int> sizeIds;
  std::vector<std::int64_t> pieceIds;
  std::vector<std::string> names;
  for (std::size_t s = 0; s < grading.sizes.size(); ++s)
  {
    for (const Point2& p : grading.positions[s])
    {
      places.emplace_back(p.x(), p.y(), 0.0);
    }
    for (const SourceWire& wire : grading.wires)
    {
      std::vector<std::int64_t> ids(wire.points.begin(), wire.points.end());
      std::for_each(ids.begin(), ids.end(), [&](std::int64_t& id) { id += s * count; });
      data.lines.add(ids);
      sizeIds.push_back(static_cast<int>(s));
      pieceIds.push_back(wire.piece);
      names.push_back(wire.name);
    }
  }
  data.points = std::make_shared<const Points3>(std::move(places));
  data.cellArrays = { { "SizeId", std::move(sizeIds) }, { "PieceId", std::move(pieceIds) },
    { "CurveName", std::move(names) } };
  data.fieldArrays = { { "SizeName", grading.sizes },
    { "BaseSize", std::vector<int>{ static_cast<int>(grading.base) } },
    pointColumn("GrainDirection", { grading.grains }) };
  const TableColumns<GradeRule> rules(data.fieldArrays, grading.rules);
  rules.add("RulePiece", &GradeRule::piece);
  rules.add("RulePoint", &GradeRule::point);
  rules.add("RuleName", &GradeRule::name);
  std::vector<Points2> deltas;
  std::transform(grading.rules.begin(), grading.rules.end(), std::back_inserter(deltas),
    [](const GradeRule& rule) { return rule.deltas; });
  data.fieldArrays.push_back(pointColumn("RuleDelta", deltas));
  fill(output, data);
}

Status readGrading(vtkPolyData* input, Grading& grading)
{
  grading = Grading();
  if (!input->GetLines()->IsValid() || !input->GetPolys()->IsValid())
  {
    return invalidSizes("the cells do not fit the list of their points");
  }
  const DataSet data = dataSetOf(input);
  const Column* const names = texts(data.fieldArrays, "SizeName");
  const std::size_t sizes = names ? names->rows() : 0;
  const Column* const base = numbers(data.fieldArrays, "BaseSize", 1);
  const Column* const grains = findColumn(data.fieldArrays, "GrainDirection");
  if (sizes < 1 || !base || !grains || grains->isText() || grains->rows() != 1 ||
    data.points->size() % sizes != 0 || data.points->empty())
  {
    return invalidSizes("SizeName, BaseSize or GrainDirection is missing or has other rows");
  }
  const std::size_t points = data.points->size() / sizes;
  const Index chosen = indexBelow(base->number(0), sizes);
  if (chosen == none)
  {
    return invalidSizes("BaseSize is not one of the sizes");
  }
  grading.base = static_cast<std::size_t>(chosen);
  for (std::size_t s = 0; s < sizes; ++s)
  {
    grading.sizes.push_back(names->text(s));
    Points2& laid = grading.positions.emplace_back();
    for (std::size_t v = 0; v < points; ++v)
    {
      laid.emplace_back((*data.points)[s * points + v].head<2>());
      if (!laid.back().allFinite())
      {
        return invalidSizes("a point is not finite");
      }
    }
  }
  for (int piece = 0; piece < grains->components / 2; ++piece)
  {
    grading.grains.push_back(pointOf(*grains, 0, static_cast<std::size_t>(piece)));
  }
  Status status = readWires(data, points, grading);
  return status.ok() ? readRules(data.fieldArrays, points, grading) : status;
}
}
}
