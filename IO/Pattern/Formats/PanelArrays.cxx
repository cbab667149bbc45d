// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/PanelArrays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace flattening::pattern
{
namespace
{
/// Adds a table of numbers, where it has rows.
template <class Value, class Fill>
void addTable(Columns& fields, const char* name, int columns, std::size_t rows, const Fill& fill)
{
  std::vector<Value> values;
  for (std::size_t row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      values.push_back(static_cast<Value>(fill(row, column)));
    }
  }
  if (rows > 0)
  {
    setColumn(fields, { name, std::move(values), columns });
  }
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
}

void writePanels(const SourcePanels& panels, Columns& fields)
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
  setColumn(fields, { "PanelNames", panels.names });
  setColumn(fields, { "PanelLabels", panels.labels });
  setColumn(fields, { "PanelEdgeLabels", labels });
  addTable<double>(
    fields, "PanelPlacements", 6, panels.placements.size(), [&](std::size_t row, int column) {
      const SourcePanels::Placement& placement = panels.placements[row];
      return column < 3 ? placement.translation[column] : placement.rotation[column - 3];
    });
  addTable<std::int64_t>(
    fields, "PanelEdges", 4, panels.edges.size(), [&](std::size_t row, int column) {
      const SourcePanels::Edge& edge = panels.edges[row];
      const std::array<Index, 4> values{ edge.piece, edge.ends[0], edge.ends[1], edge.shape };
      return values[static_cast<std::size_t>(column)];
    });
  addTable<double>(
    fields, "PanelEdgeParameters", 4, panels.edges.size(), [&](std::size_t row, int column) {
      return panels.edges[row].parameters[static_cast<std::size_t>(column)];
    });
  addTable<std::int64_t>(
    fields, "PanelStitches", 3, panels.stitches.size(), [&](std::size_t row, int column) {
      const SourcePanels::Stitch& stitch = panels.stitches[row];
      return column < 2 ? stitch.edges[static_cast<std::size_t>(column)]
                        : Index{ stitch.rightToWrong ? 1 : 0 };
    });
}

Status readPanels(const Columns& fields, PatternSource& source)
{
  const Column* const edges = findColumn(fields, "PanelEdges");
  if (!edges || edges->isText())
  {
    return {};
  }
  const Column* const parameters = findColumn(fields, "PanelEdgeParameters");
  const Column* const placements = findColumn(fields, "PanelPlacements");
  const Column* const stitches = findColumn(fields, "PanelStitches");
  const Column* const names = findColumn(fields, "PanelNames");
  const Column* const labels = findColumn(fields, "PanelLabels");
  const Column* const edgeLabels = findColumn(fields, "PanelEdgeLabels");
  const std::size_t pieces = source.pieceOfTriangle.empty()
    ? 0
    : static_cast<std::size_t>(
        *std::max_element(source.pieceOfTriangle.begin(), source.pieceOfTriangle.end()) + 1);
  const std::size_t rows = edges->rows();
  const auto has = [](const Column* array, int columns, std::size_t count, bool text = false) {
    return array && array->isText() == text && array->components == columns &&
      array->rows() == count;
  };
  if (!has(edges, 4, rows) || !has(parameters, 4, rows) || !has(edgeLabels, 1, rows, true) ||
    !has(placements, 6, pieces) || !has(names, 1, pieces, true) || !has(labels, 1, pieces, true) ||
    (stitches && !has(stitches, 3, stitches->rows())))
  {
    return misfit("their arrays have other rows");
  }
  SourcePanels panels;
  for (std::size_t p = 0; p < pieces; ++p)
  {
    panels.names.push_back(names->text(p));
    panels.labels.push_back(labels->text(p));
    SourcePanels::Placement& placement = panels.placements.emplace_back();
    for (int k = 0; k < 3; ++k)
    {
      placement.translation[k] = placements->number(p, k);
      placement.rotation[k] = placements->number(p, k + 3);
    }
  }
  for (std::size_t row = 0; row < rows; ++row)
  {
    const auto at = [&](int column) { return edges->number(row, column); };
    if (!isIndex(at(0), pieces) || !isIndex(at(1), source.positions.size()) ||
      !isIndex(at(2), source.positions.size()) || !isIndex(at(3), 4))
    {
      return misfit("row " + std::to_string(row) + " of PanelEdges");
    }
    SourcePanels::Edge& edge = panels.edges.emplace_back();
    edge.piece = static_cast<Index>(at(0));
    edge.ends = { static_cast<Index>(at(1)), static_cast<Index>(at(2)) };
    edge.shape = static_cast<int>(at(3));
    edge.label = edgeLabels->text(row);
    for (int k = 0; k < 4; ++k)
    {
      edge.parameters[static_cast<std::size_t>(k)] = parameters->number(row, k);
    }
  }
  for (std::size_t row = 0; stitches && row < stitches->rows(); ++row)
  {
    if (!isIndex(stitches->number(row, 0), rows) || !isIndex(stitches->number(row, 1), rows))
    {
      return misfit("row " + std::to_string(row) + " of PanelStitches");
    }
    panels.stitches.push_back({ { static_cast<Index>(stitches->number(row, 0)),
                                  static_cast<Index>(stitches->number(row, 1)) },
      stitches->number(row, 2) != 0.0 });
  }
  source.panels = std::move(panels);
  return {};
}
}
