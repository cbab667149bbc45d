// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/PanelArrays.h"

#include "Outlines/Outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
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
  return invalidPieces("the panels of the wires do not fit the pieces: " + what);
}

/// Whether a value is a whole number below a limit.
bool isIndex(double value, std::size_t limit)
{
  return value >= 0.0 && value < static_cast<double>(limit) && std::floor(value) == value;
}
}

void writePanels(const PatternSource& source, Columns& fields)
{
  const std::vector<GarmentPanel>& panels = source.garment.panels;
  if (panels.empty())
  {
    return;
  }
  std::vector<std::size_t> first; // edge of each panel, of all edges
  std::vector<GarmentSide> sides; // of all edges
  for (const GarmentPanel& panel : panels)
  {
    first.push_back(sides.size());
    for (std::size_t k = 0; k < panel.edges.size(); ++k)
    {
      sides.push_back({ first.size() - 1, k });
    }
  }
  const auto edgeOf = [&](std::size_t row) -> const GarmentEdge& {
    return panels[sides[row].panel].edges[sides[row].edge];
  };
  addRows<std::string>(
    fields, "PanelNames", panels.size(), [&](std::size_t row) { return panels[row].name; });
  addRows<std::string>(
    fields, "PanelLabels", panels.size(), [&](std::size_t row) { return panels[row].label; });
  addRows<std::string>(
    fields, "PanelEdgeLabels", sides.size(), [&](std::size_t row) { return edgeOf(row).label; });
  addTable<double>(fields, "PanelPlacements", 6, panels.size(), [&](std::size_t row, int column) {
    return column < 3 ? panels[row].translation[column] : panels[row].rotation[column - 3];
  });
  addTable<std::int64_t>(fields, "PanelEdges", 4, sides.size(), [&](std::size_t row, int column) {
    const GarmentEdge& edge = edgeOf(row);
    const Indices& points = source.panelPoints[sides[row].panel];
    const std::array<Index, 4> values{ static_cast<Index>(sides[row].panel), points[edge.ends[0]],
      points[edge.ends[1]], static_cast<Index>(edge.shape) };
    return values[static_cast<std::size_t>(column)];
  });
  addTable<double>(
    fields, "PanelEdgeParameters", 4, sides.size(), [&](std::size_t row, int column) {
      return edgeOf(row).parameters[static_cast<std::size_t>(column)];
    });
  const std::vector<GarmentStitch>& stitches = source.garment.stitches;
  addTable<std::int64_t>(
    fields, "PanelStitches", 3, stitches.size(), [&](std::size_t row, int column) {
      const GarmentSide& side = stitches[row].sides[column == 1 ? 1 : 0];
      return column < 2 ? static_cast<std::int64_t>(first[side.panel] + side.edge)
                        : std::int64_t{ stitches[row].rightToWrong ? 1 : 0 };
    });
}

Status readPanels(const Columns& fields, PatternSource& source)
{
  const Column* const edges = findColumn(fields, "PanelEdges");
  if (!edges || edges->isText() || edges->rows() == 0)
  {
    return {};
  }
  const Column* const parameters = findColumn(fields, "PanelEdgeParameters");
  const Column* const placements = findColumn(fields, "PanelPlacements");
  const Column* const stitches = findColumn(fields, "PanelStitches");
  const Column* const names = findColumn(fields, "PanelNames");
  const Column* const labels = findColumn(fields, "PanelLabels");
  const Column* const edgeLabels = findColumn(fields, "PanelEdgeLabels");
  const std::size_t pieces = pieceCount(source);
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
  Garment garment;
  std::vector<std::set<Index>> points(pieces); // of each panel
  for (std::size_t row = 0; row < rows; ++row)
  {
    const auto at = [&](int column) { return edges->number(row, column); };
    if (!isIndex(at(0), pieces) || !isIndex(at(1), source.positions.size()) ||
      !isIndex(at(2), source.positions.size()) || !isIndex(at(3), 4))
    {
      return misfit("row " + std::to_string(row) + " of PanelEdges");
    }
    points[static_cast<std::size_t>(at(0))].insert(
      { static_cast<Index>(at(1)), static_cast<Index>(at(2)) });
  }
  for (std::size_t p = 0; p < pieces; ++p)
  {
    GarmentPanel& panel = garment.panels.emplace_back();
    panel.name = names->text(p);
    panel.label = labels->text(p);
    for (int k = 0; k < 3; ++k)
    {
      panel.translation[k] = placements->number(p, k);
      panel.rotation[k] = placements->number(p, k + 3);
    }
    for (const Index point : points[p])
    {
      panel.vertices.push_back(source.positions[static_cast<std::size_t>(point)]);
    }
    source.panelPoints.emplace_back(points[p].begin(), points[p].end());
  }
  std::vector<GarmentSide> sides;
  for (std::size_t row = 0; row < rows; ++row)
  {
    const auto p = static_cast<std::size_t>(edges->number(row, 0));
    const auto vertexAt = [&](int column) {
      const Indices& all = source.panelPoints[p];
      const auto point = static_cast<Index>(edges->number(row, column));
      return static_cast<std::size_t>(
        std::lower_bound(all.begin(), all.end(), point) - all.begin());
    };
    sides.push_back({ p, garment.panels[p].edges.size() });
    GarmentEdge& edge = garment.panels[p].edges.emplace_back();
    edge.ends = { vertexAt(1), vertexAt(2) };
    edge.shape = static_cast<EdgeShape>(static_cast<int>(edges->number(row, 3)));
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
    garment.stitches.push_back({ { sides[static_cast<std::size_t>(stitches->number(row, 0))],
                                   sides[static_cast<std::size_t>(stitches->number(row, 1))] },
      stitches->number(row, 2) != 0.0 });
  }
  source.garment = std::move(garment);
  return {};
}
}
