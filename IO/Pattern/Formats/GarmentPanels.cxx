// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/GarmentPanels.h"

#include <iterator>
#include <set>

namespace flattening
{
namespace pattern
{
Status garmentOf(const PatternSource& source, double scale, Garment& garment)
{
  const SourcePanels& panels = source.panels;
  garment = Garment();
  garment.panels.resize(panels.names.size());
  std::vector<GarmentSide> sides;
  std::vector<std::set<Index>> points(panels.names.size());
  for (const SourcePanels::Edge& edge : panels.edges)
  {
    points[static_cast<std::size_t>(edge.piece)].insert(edge.ends.begin(), edge.ends.end());
  }
  for (std::size_t p = 0; p < garment.panels.size(); ++p)
  {
    GarmentPanel& panel = garment.panels[p];
    panel.name = panels.names[p];
    panel.label = panels.labels[p];
    panel.translation = panels.placements[p].translation;
    panel.rotation = panels.placements[p].rotation;
    for (const Index point : points[p])
    {
      panel.vertices.emplace_back(scale * source.positions[static_cast<std::size_t>(point)]);
    }
  }
  for (const SourcePanels::Edge& edge : panels.edges)
  {
    const auto p = static_cast<std::size_t>(edge.piece);
    const auto place = [&](Index point) {
      return static_cast<std::size_t>(std::distance(points[p].begin(), points[p].find(point)));
    };
    sides.push_back({ p, garment.panels[p].edges.size() });
    GarmentEdge& made = garment.panels[p].edges.emplace_back();
    made.ends = { place(edge.ends[0]), place(edge.ends[1]) };
    made.shape = static_cast<EdgeShape>(edge.shape);
    made.parameters = edge.parameters;
    made.parameters[0] *= made.shape == EdgeShape::Circle ? scale : 1.0;
    made.label = edge.label;
  }
  for (const SourcePanels::Stitch& stitch : panels.stitches)
  {
    garment.stitches.push_back({ { sides[static_cast<std::size_t>(stitch.edges[0])],
                                   sides[static_cast<std::size_t>(stitch.edges[1])] },
      stitch.rightToWrong });
  }
  return checkGarment(garment);
}
}
}
