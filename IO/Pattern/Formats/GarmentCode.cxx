// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/GarmentCode.h"

#include "Drawing/PatternBuilder.h"
#include "Fairing/BorderEdges.h"
#include "Fairing/FairBorders.h"
#include "Formats/Garment.h"
#include "Outlines/PatternSource.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace flattening::pattern
{
namespace
{
/// The panels that makePieces() made pieces of: vertices are where the points of the source are
/// now.
/// \param scale centimetres of its unit
/// \return InvalidPattern where checkGarment() does
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

constexpr double centimetresPerMillimetre = 0.1;

/// The rigid motion that brings the points of a piece nearest to the surface (W. Kabsch, Acta
/// Crystallographica A32, 1976).
void place(const DrawingSource& all, std::size_t piece, GarmentPanel& panel)
{
  const PatternSource& source = all.source;
  const double scale = centimetresPerMillimetre * all.scale();
  Indices points;
  for (std::size_t t = 0; t < source.triangles.size(); ++t)
  {
    if (source.pieceOfTriangle[t] == static_cast<Index>(piece))
    {
      points.insert(points.end(), source.triangles[t].begin(), source.triangles[t].end());
    }
  }
  if (source.inSpace.empty())
  {
    return;
  }
  const auto flat = [&](Index v) {
    const Point2& p = source.positions[v];
    return Eigen::Vector3d(scale * p.x(), scale * p.y(), 0.0);
  };
  Eigen::Vector3d flatMean = Eigen::Vector3d::Zero();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Index v : points)
  {
    flatMean += flat(v) / static_cast<double>(points.size());
    mean += scale * source.inSpace[v] / static_cast<double>(points.size());
  }
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Index v : points)
  {
    spread += (scale * source.inSpace[v] - mean) * (flat(v) - flatMean).transpose();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(spread, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Vector3d signs(
    1.0, 1.0, (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0);
  const Eigen::Matrix3d turn = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  panel.translation = mean - turn * flatMean;
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

Status makeGarmentCode(const PatternSource& source, const PatternOptions& options,
  const Pattern& drawing, std::string& json, FairCache* cache)
{
  if (!source.panels.edges.empty())
  {
    Garment garment;
    Status status =
      garmentOf(source, centimetresPerMillimetre * millimetresPer(options.unit), garment);
    json = status.ok() ? writeGarment(garment) : std::string();
    return status;
  }
  DrawingSource all(source, completed(options, source));
  Status status = findBorders(all);
  for (std::size_t p = 0; status.ok() && p < all.loops.size(); ++p)
  {
    if (all.loops[p].size() > 1)
    {
      status = { StatusCode::InvalidPattern,
        "piece " + drawing.names[p] + " has a hole, which a panel of GarmentCode cannot have", {},
        { Remedy::WriteOtherFormat } };
    }
  }
  if (!status.ok())
  {
    return status;
  }
  FairCache own;
  const std::shared_ptr<const FairBorders> fair = (cache ? cache : &own)->of(all);
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
  status = checkGarment(garment); // borders may have collapsed
  if (!status.ok())
  {
    status.remedies = { Remedy::WriteOtherFormat };
    return status;
  }
  json = writeGarment(garment);
  return status;
}
}
