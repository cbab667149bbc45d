// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/GarmentCode.h"

#include "Fairing/BorderEdges.h"
#include "Fairing/FairBorders.h"
#include "Formats/Garment.h"
#include "Outlines/PatternSource.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace flattening::pattern
{
namespace
{
constexpr double centimetresPerMillimetre = 0.1;

Garment inCentimetres(Garment garment, double scale)
{
  for (GarmentPanel& panel : garment.panels)
  {
    for (Point2& vertex : panel.vertices)
    {
      vertex *= scale;
    }
    for (GarmentEdge& edge : panel.edges)
    {
      edge.parameters[0] *= edge.shape == EdgeShape::Circle ? scale : 1.0;
    }
  }
  return garment;
}

/// Lays a panel where the points of its piece are nearest to the surface.
void place(const DrawingSource& all, std::size_t piece, GarmentPanel& panel)
{
  const PatternSource& source = all.source;
  const double scale = centimetresPerMillimetre * all.scale();
  Points3 flat;
  Points3 inSpace;
  for (std::size_t t = 0; t < source.triangles.size() && !source.inSpace.empty(); ++t)
  {
    for (const Index v : source.triangles[t])
    {
      if (source.pieceOfTriangle[t] == static_cast<Index>(piece))
      {
        flat.emplace_back(scale * source.positions[v].x(), scale * source.positions[v].y(), 0.0);
        inSpace.emplace_back(scale * source.inSpace[v]);
      }
    }
  }
  if (flat.empty())
  {
    return;
  }
  const auto columns = [](const Points3& points) {
    return Eigen::Map<const Eigen::Matrix3Xd>(
      points.front().data(), 3, static_cast<Eigen::Index>(points.size()));
  };
  const Eigen::Matrix4d motion = Eigen::umeyama(columns(flat), columns(inSpace), false);
  const Eigen::Matrix3d turn = motion.topLeftCorner<3, 3>();
  panel.translation = motion.topRightCorner<3, 1>();
  panel.rotation = 180.0 / pi *
    Eigen::Vector3d(std::atan2(turn(2, 1), turn(2, 2)),
      std::asin(std::clamp(-turn(2, 0), -1.0, 1.0)), std::atan2(turn(1, 0), turn(0, 0)));
}

void draw(const std::vector<BorderEdge>& border, GarmentPanel& panel)
{
  const auto at = [&border](std::size_t k) {
    return Point2(centimetresPerMillimetre * border[k % border.size()].curve.control[0]);
  };
  for (std::size_t k = 0; k < border.size(); ++k)
  {
    panel.vertices.push_back(at(k));
    GarmentEdge& edge = panel.edges.emplace_back();
    edge.ends = { k, (k + 1) % border.size() };
    edge.label = border[k].name;
    if (!border[k].curve.straight())
    {
      edge.shape = EdgeShape::Cubic;
      for (const std::size_t c : { 1U, 2U })
      {
        const Point2 control =
          inFrameOf(centimetresPerMillimetre * border[k].curve.control[c], at(k), at(k + 1));
        edge.parameters[2 * c - 2] = control.x();
        edge.parameters[2 * c - 1] = control.y();
      }
    }
  }
}
}

Status makeGarmentCode(
  const PatternSource& source, const DrawingSource& all, const Pattern& drawing, std::string& json)
{
  if (!source.garment.panels.empty())
  {
    const Garment panels = inCentimetres(source.garment, centimetresPerMillimetre * all.scale());
    Status status = checkGarment(panels);
    json = status.ok() ? writeGarment(panels) : std::string();
    return status;
  }
  for (std::size_t p = 0; p < all.loops.size(); ++p)
  {
    if (all.loops[p].size() > 1)
    {
      return { StatusCode::InvalidPattern,
        "piece " + drawing.names[p] + " has a hole, which a panel of GarmentCode cannot have", {},
        { Remedy::WriteOtherFormat } };
    }
  }
  const std::shared_ptr<const FairBorders> fair =
    all.fair ? all.fair : std::make_shared<const FairBorders>(all);
  const std::vector<std::vector<BorderEdge>> borders = borderEdges(all, *fair);
  std::vector<std::string> names; // members of an object, and so all different
  for (const std::string& name : drawing.names)
  {
    const bool taken = std::find(names.begin(), names.end(), name) != names.end();
    names.push_back(taken ? name + " (" + std::to_string(names.size() + 1) + ")" : name);
  }

  Garment garment;
  for (std::size_t p = 0; p < borders.size(); ++p)
  {
    GarmentPanel& panel = garment.panels.emplace_back();
    panel.name = names[p];
    place(all, p, panel);
    draw(borders[p], panel);
    for (std::size_t k = 0; k < borders[p].size(); ++k)
    {
      const auto [piece, edge] = borders[p][k].sewn;
      if (piece != BorderEdge::nowhere && (piece > p || (piece == p && edge > k)))
      {
        garment.stitches.push_back({ { GarmentSide{ p, k }, GarmentSide{ piece, edge } } });
      }
    }
  }
  Status status = checkGarment(garment); // borders may have collapsed
  if (!status.ok())
  {
    status.remedies = { Remedy::WriteOtherFormat };
    return status;
  }
  json = writeGarment(garment);
  return status;
}
}
