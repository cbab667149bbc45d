// SPDX-License-Identifier: BSD-3-Clause
#include "PanelArrays.h"

#include "FieldArrays.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace bridge
{
namespace
{
using pattern::PatternSource;
using pattern::SourcePanels;

template <typename Array, typename Fill>
void addTable(vtkFieldData* field, const char* name, int columns, std::size_t rows, Fill&& fill)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(columns);
  array->SetNumberOfTuples(static_cast<vtkIdType>(rows));
  for (std::size_t row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      array->SetComponent(
        static_cast<vtkIdType>(row), column, static_cast<double>(fill(row, column)));
    }
  }
  addUnlessEmpty(field, array);
}

Status misfit(const std::string& what)
{
  return { StatusCode::InvalidPattern, "the panels of the wires do not fit the pieces: " + what, {},
    { Remedy::GiveFlatPieces } };
}

/// Whether a value is a whole number below a limit.
bool isIndex(double value, std::size_t limit)
{
  return value >= 0.0 && value < static_cast<double>(limit) && std::floor(value) == value;
}

std::string textAt(vtkStringArray* array, std::size_t row)
{
  return std::string(array->GetValue(static_cast<vtkIdType>(row)));
}
}

void writePanels(const SourcePanels& panels, vtkFieldData* field)
{
  if (panels.edges.empty())
  {
    return;
  }
  std::vector<std::string> labels;
  for (const SourcePanels::Edge& edge : panels.edges)
  {
    labels.push_back(edge.label);
  }
  addStrings(field, "PanelNames", panels.names);
  addStrings(field, "PanelLabels", panels.labels);
  addStrings(field, "PanelEdgeLabels", labels);
  addTable<vtkDoubleArray>(
    field, "PanelPlacements", 6, panels.placements.size(), [&](std::size_t row, int column) {
      const SourcePanels::Placement& placement = panels.placements[row];
      return column < 3 ? placement.translation[column] : placement.rotation[column - 3];
    });
  addTable<vtkIdTypeArray>(
    field, "PanelEdges", 4, panels.edges.size(), [&](std::size_t row, int column) {
      const SourcePanels::Edge& edge = panels.edges[row];
      const std::array<Index, 4> values{ edge.piece, edge.ends[0], edge.ends[1], edge.shape };
      return values[static_cast<std::size_t>(column)];
    });
  addTable<vtkDoubleArray>(
    field, "PanelEdgeParameters", 4, panels.edges.size(), [&](std::size_t row, int column) {
      return panels.edges[row].parameters[static_cast<std::size_t>(column)];
    });
  addTable<vtkIdTypeArray>(
    field, "PanelStitches", 3, panels.stitches.size(), [&](std::size_t row, int column) {
      const SourcePanels::Stitch& stitch = panels.stitches[row];
      return column < 2 ? stitch.edges[static_cast<std::size_t>(column)]
                        : Index{ stitch.rightToWrong ? 1 : 0 };
    });
}

Status readPanels(vtkFieldData* field, PatternSource& source)
{
  vtkDataArray* const edges = field->GetArray("PanelEdges");
  if (!edges)
  {
    return {};
  }
  vtkDataArray* const parameters = field->GetArray("PanelEdgeParameters");
  vtkDataArray* const placements = field->GetArray("PanelPlacements");
  vtkDataArray* const stitches = field->GetArray("PanelStitches");
  auto* const names = vtkStringArray::SafeDownCast(field->GetAbstractArray("PanelNames"));
  auto* const labels = vtkStringArray::SafeDownCast(field->GetAbstractArray("PanelLabels"));
  auto* const edgeLabels = vtkStringArray::SafeDownCast(field->GetAbstractArray("PanelEdgeLabels"));
  const std::size_t pieces = source.pieceOfTriangle.empty()
    ? 0
    : static_cast<std::size_t>(
        *std::max_element(source.pieceOfTriangle.begin(), source.pieceOfTriangle.end()) + 1);
  const auto rows = static_cast<std::size_t>(edges->GetNumberOfTuples());
  const auto has = [](vtkAbstractArray* array, int columns, std::size_t count) {
    return array && array->GetNumberOfComponents() == columns &&
      array->GetNumberOfTuples() == static_cast<vtkIdType>(count);
  };
  if (!has(edges, 4, rows) || !has(parameters, 4, rows) || !has(edgeLabels, 1, rows) ||
    !has(placements, 6, pieces) || !has(names, 1, pieces) || !has(labels, 1, pieces) ||
    (stitches && stitches->GetNumberOfComponents() != 3))
  {
    return misfit("their arrays have other rows");
  }
  SourcePanels panels;
  for (std::size_t p = 0; p < pieces; ++p)
  {
    panels.names.push_back(textAt(names, p));
    panels.labels.push_back(textAt(labels, p));
    SourcePanels::Placement& placement = panels.placements.emplace_back();
    for (int k = 0; k < 3; ++k)
    {
      placement.translation[k] = placements->GetComponent(static_cast<vtkIdType>(p), k);
      placement.rotation[k] = placements->GetComponent(static_cast<vtkIdType>(p), k + 3);
    }
  }
  for (std::size_t row = 0; row < rows; ++row)
  {
    const auto at = [&](int column) {
      return edges->GetComponent(static_cast<vtkIdType>(row), column);
    };
    if (!isIndex(at(0), pieces) || !isIndex(at(1), source.positions.size()) ||
      !isIndex(at(2), source.positions.size()) || !isIndex(at(3), 4))
    {
      return misfit("row " + std::to_string(row) + " of PanelEdges");
    }
    SourcePanels::Edge& edge = panels.edges.emplace_back();
    edge.piece = static_cast<Index>(at(0));
    edge.ends = { static_cast<Index>(at(1)), static_cast<Index>(at(2)) };
    edge.shape = static_cast<int>(at(3));
    edge.label = textAt(edgeLabels, row);
    for (int k = 0; k < 4; ++k)
    {
      edge.parameters[static_cast<std::size_t>(k)] =
        parameters->GetComponent(static_cast<vtkIdType>(row), k);
    }
  }
  for (vtkIdType row = 0; stitches && row < stitches->GetNumberOfTuples(); ++row)
  {
    if (!isIndex(stitches->GetComponent(row, 0), rows) ||
      !isIndex(stitches->GetComponent(row, 1), rows))
    {
      return misfit("row " + std::to_string(row) + " of PanelStitches");
    }
    panels.stitches.push_back({ { static_cast<Index>(stitches->GetComponent(row, 0)),
                                  static_cast<Index>(stitches->GetComponent(row, 1)) },
      stitches->GetComponent(row, 2) != 0.0 });
  }
  source.panels = std::move(panels);
  return {};
}
}
}
