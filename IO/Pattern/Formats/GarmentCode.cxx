// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/PatternWriters.h"

#include "Fairing/FairBorders.h"
#include "Formats/Garment.h"
#include "Outlines/PatternSource.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace flattening::pattern
{
namespace
{
/// One of the curves and straight lines that the outer border of a piece is made of.
struct BorderEdge
{
  FairSpan curve;
  std::string name;                ///< of its feature curve; empty on the boundary
  std::optional<GarmentSide> sewn; ///< to it, whole to whole
};

constexpr double shortestEdge = 6.0; ///< millimetres; the breaks of both sides are rarely the same
constexpr double crossing = 1e-6;    ///< of an edge: a break so near to its end is no other one

/// Of breaks that are close to each other the mean, the same from either end.
std::vector<double> withoutShortEdges(std::vector<double> breaks, double shortest)
{
  std::sort(breaks.begin(), breaks.end());
  std::vector<double> kept;
  for (std::size_t k = 0; k < breaks.size();)
  {
    double sum = 0.0;
    const std::size_t first = k;
    do
    {
      sum += breaks[k++];
    } while (k < breaks.size() && breaks[k] - breaks[k - 1] < shortest);
    const double mean = sum / static_cast<double>(k - first);
    if (mean > shortest && mean < 1.0 - shortest)
    {
      kept.push_back(mean);
    }
  }
  return kept;
}

/// A part of a chain as one cubic curve, which follows what lies beyond a break near one of its
/// ends by its slope there, and has the same length.
FairSpan oneCubic(const std::vector<FairSpan>& spans, double from, double to, double length)
{
  const double margin = crossing * (to - from);
  const FairSpan& first = spanAt(spans, from + margin);
  const FairSpan& last = spanAt(spans, to - margin);
  if (&first == &last)
  {
    return partOf(first, from, to);
  }
  const Point2 start = first.at(from);
  const Point2 end = last.at(to);
  const auto cubic = [&](double handle) {
    return FairSpan{ from, to,
      { start, start + handle * first.slope(from).normalized(),
        end - handle * last.slope(to).normalized(), end } };
  };
  double low = 0.0;
  double high = length;
  for (int step = 0; step < 60; ++step)
  {
    const double middle = (low + high) / 2.0;
    (cubic(middle).length() < length ? low : high) = middle;
  }
  return cubic((low + high) / 2.0);
}

/// Whether an interval of a chain is part of a spline, and so without corners.
bool isSmooth(const FairBorders& fair, std::size_t chain, std::size_t interval)
{
  return stretchOf(fair.plan()[chain], interval).form == StretchForm::Spline;
}

/// Adds the edges that the interval k of the chain c is made of.
void addEdges(const DrawingSource& all, const FairBorders& fair, std::size_t c, std::size_t k,
  std::vector<BorderEdge>& border)
{
  const PlannedInterval& interval = fair.plan()[c].intervals[k];
  const IntervalCurve curve(fair.spans()[c], interval.places);
  std::vector<double> breaks = curve.breaks(false);
  bool smooth = isSmooth(fair, c, k);
  const auto [other, there] = interval.partner;
  if (other != PlannedInterval::none)
  {
    const IntervalCurve sewn(fair.spans()[other], fair.plan()[other].intervals[there].places);
    const std::vector<double> others = sewn.breaks(interval.reversed);
    breaks.insert(breaks.end(), others.begin(), others.end());
    smooth = smooth && isSmooth(fair, other, there);
  }
  breaks =
    withoutShortEdges(std::move(breaks), smooth ? shortestEdge / interval.length : sameBreak);
  breaks.push_back(1.0);
  const BorderChain& chain = fair.chains().chains()[c];
  const std::size_t at = chain.edgeAt((interval.start + interval.end) / 2.0);
  const SourceWire* const wire =
    wireOf(all.source, all.wires, chain.point(at), chain.point(at + 1));
  double last = 0.0;
  double start = interval.places[0];
  for (const double share : breaks)
  {
    const double end = curve.placeAt(share);
    BorderEdge& edge = border.emplace_back();
    edge.curve = oneCubic(fair.spans()[c], start, end, (share - last) * curve.length());
    edge.name = wire && wire->type != WireType::Boundary ? wire->name : "";
    last = share;
    start = end;
  }
}

/// The outer borders of all pieces, counter-clockwise. What is sewn is divided alike on both sides,
/// so that edges are sewn to edges.
std::vector<std::vector<BorderEdge>> borderEdges(const DrawingSource& all, const FairBorders& fair)
{
  struct Run
  {
    std::size_t piece = 0;
    std::size_t first = 0;
    std::size_t count = 0;
  };
  std::vector<std::vector<BorderEdge>> borders(all.loops.size());
  std::map<std::array<std::size_t, 2>, Run> runs; // by chain and interval
  for (std::size_t p = 0; p < all.loops.size(); ++p)
  {
    const Indices& loop = all.loops[p].front();
    const std::size_t chain = fair.chains().find(loop[0], loop[1])->chain; // all are chains
    for (std::size_t k = 0; k < fair.plan()[chain].intervals.size(); ++k)
    {
      const std::size_t first = borders[p].size();
      addEdges(all, fair, chain, k, borders[p]);
      runs[{ chain, k }] = { p, first, borders[p].size() - first };
    }
  }
  for (const auto& [key, run] : runs)
  {
    const PlannedInterval& interval = fair.plan()[key[0]].intervals[key[1]];
    const auto partner = runs.find(interval.partner);
    if (partner == runs.end() || partner->second.count != run.count)
    {
      continue;
    }
    for (std::size_t k = 0; k < run.count; ++k)
    {
      const std::size_t other = interval.reversed ? run.count - 1 - k : k;
      borders[run.piece][run.first + k].sewn =
        GarmentSide{ partner->second.piece, partner->second.first + other };
    }
  }
  return borders;
}

constexpr double centimetresPerMillimetre = 0.1;

Garment inCentimetres(Garment garment, double scale)
{
  for (GarmentPanel& panel : garment.panels)
  {
    panel.translation *= scale;
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
  if (source.inSpace.empty())
  {
    return;
  }
  for (const Triangle& corners : trianglesOf(source, piece))
  {
    for (const Index v : corners)
    {
      flat.emplace_back(scale * source.positions[v].x(), scale * source.positions[v].y(), 0.0);
      inSpace.emplace_back(scale * source.inSpace[v]);
    }
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
      const std::optional<GarmentSide>& sewn = borders[p][k].sewn;
      if (sewn && (sewn->panel > p || (sewn->panel == p && sewn->edge > k)))
      {
        garment.stitches.push_back({ { GarmentSide{ p, k }, *sewn } });
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
