// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/Garment.h"

#include "Outlines/PatternText.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace flattening::pattern
{
namespace
{
Status invalid(const std::string& message)
{
  return { StatusCode::InvalidPattern, message };
}

template <typename Vector>
std::string list(const Vector& values)
{
  std::string text = "[";
  for (Eigen::Index k = 0; k < values.size(); ++k)
  {
    text += (k > 0 ? ", " : "") + exactNumber(values[k]);
  }
  return text + "]";
}

std::string quoted(const std::string& text)
{
  std::string result = "\"";
  for (const char c : cleanText(text))
  {
    result += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  }
  return result + "\"";
}

std::string writeShape(const GarmentEdge& edge)
{
  const std::array<double, 4>& p = edge.parameters;
  const auto flag = [](double value) { return value != 0.0 ? "true" : "false"; };
  switch (edge.shape)
  {
    case EdgeShape::Quadratic:
      return R"("curvature": {"type": "quadratic", "params": [)" + list(Point2(p[0], p[1])) + "]}";
    case EdgeShape::Cubic:
      return R"("curvature": {"type": "cubic", "params": [)" + list(Point2(p[0], p[1])) + ", " +
        list(Point2(p[2], p[3])) + "]}";
    case EdgeShape::Circle:
      return R"("curvature": {"type": "circle", "params": [)" + exactNumber(p[0]) + ", " +
        flag(p[1]) + ", " + flag(p[2]) + "]}";
    default:
      return {};
  }
}

std::string writePanel(const GarmentPanel& panel)
{
  std::string text = "{\n";
  text += panel.label.empty() ? "" : "        \"label\": " + quoted(panel.label) + ",\n";
  text += "        \"translation\": " + list(panel.translation) +
    ",\n        \"rotation\": " + list(panel.rotation) + ",\n        \"vertices\": [";
  for (std::size_t k = 0; k < panel.vertices.size(); ++k)
  {
    text += (k > 0 ? ",\n          " : "\n          ") + list(panel.vertices[k]);
  }
  text += "\n        ],\n        \"edges\": [";
  for (std::size_t k = 0; k < panel.edges.size(); ++k)
  {
    const GarmentEdge& edge = panel.edges[k];
    text += (k > 0 ? ",\n          " : "\n          ") + std::string("{\"endpoints\": [") +
      std::to_string(edge.ends[0]) + ", " + std::to_string(edge.ends[1]) + "]";
    const std::string shape = writeShape(edge);
    text += shape.empty() ? "" : ", " + shape;
    text += edge.label.empty() ? "}" : ", \"label\": " + quoted(edge.label) + "}";
  }
  return text + "\n        ]\n      }";
}

Point2 placeOnCircle(
  const Point2& from, const Point2& chord, const std::array<double, 4>& parameters, double t)
{
  const bool large = parameters[1] != 0.0;
  const bool counterClockwise = parameters[2] != 0.0;
  const double half = chord.norm() / 2.0;
  const double radius = std::max(parameters[0], half);
  const double height = std::sqrt(std::max(0.0, radius * radius - half * half));
  // A small arc that turns left has its centre on the left of the chord.
  const double side = large == counterClockwise ? -1.0 : 1.0;
  const Point2 left = Point2(-chord.y(), chord.x()) / (2.0 * half);
  const Point2 centre = from + chord / 2.0 + side * height * left;
  const double small = 2.0 * std::asin(std::min(1.0, half / radius));
  const double turn = (counterClockwise ? 1.0 : -1.0) * (large ? 2.0 * pi - small : small);
  const Point2 start = from - centre;
  const double c = std::cos(t * turn);
  const double s = std::sin(t * turn);
  return centre + Point2(c * start.x() - s * start.y(), s * start.x() + c * start.y());
}

/// A place on an edge, by a parameter from 0 to 1.
Point2 placeOn(const GarmentPanel& panel, const GarmentEdge& edge, double t)
{
  const Point2& from = panel.vertices[edge.ends[0]];
  const Point2 chord = panel.vertices[edge.ends[1]] - from;
  const auto inFrame = [&](double along, double left) {
    return Point2(from + along * chord + left * Point2(-chord.y(), chord.x()));
  };
  const std::array<double, 4>& p = edge.parameters;
  const double s = 1.0 - t;
  switch (edge.shape)
  {
    case EdgeShape::Quadratic:
      return inFrame(2.0 * s * t * p[0] + t * t, 2.0 * s * t * p[1]);
    case EdgeShape::Cubic:
    {
      const double one = 3.0 * s * s * t;
      const double two = 3.0 * s * t * t;
      return inFrame(one * p[0] + two * p[2] + t * t * t, one * p[1] + two * p[3]);
    }
    case EdgeShape::Circle:
      return placeOnCircle(from, chord, p, t);
    default:
      return inFrame(t, 0.0);
  }
}

Status checkShape(const GarmentPanel& panel, std::size_t k)
{
  const GarmentEdge& edge = panel.edges[k];
  const double chord = (panel.vertices[edge.ends[1]] - panel.vertices[edge.ends[0]]).norm();
  if (!(chord > 0.0))
  {
    return invalid(edgeName(panel, k) + " has no length: it ends where it begins");
  }
  const bool finite = std::all_of(edge.parameters.begin(), edge.parameters.end(),
    [](double value) { return std::isfinite(value); });
  if (!finite || !std::isfinite(chord))
  {
    return invalid(edgeName(panel, k) + " has numbers that are not finite");
  }
  if (edge.shape == EdgeShape::Circle && edge.parameters[0] < chord / 2.0 * (1.0 - 1e-6))
  {
    return invalid(edgeName(panel, k) + " is an arc of the radius " +
      shortNumber(edge.parameters[0]) + ", too small for its ends, which are " +
      shortNumber(chord) + " apart");
  }
  return {};
}

Status checkPanel(const GarmentPanel& panel)
{
  const std::size_t count = panel.edges.size();
  if (count < 2)
  {
    return invalid("the panel " + panel.name + " has fewer than two edges");
  }
  if (!isFinite(panel.translation) || !isFinite(panel.rotation))
  {
    return invalid("the panel " + panel.name + " is placed at numbers that are not finite");
  }
  std::set<std::size_t> starts;
  for (std::size_t k = 0; k < count; ++k)
  {
    const GarmentEdge& edge = panel.edges[k];
    for (const std::size_t end : edge.ends)
    {
      if (end >= panel.vertices.size())
      {
        return invalid(edgeName(panel, k) + " ends at the vertex " + std::to_string(end) +
          ", and there are " + std::to_string(panel.vertices.size()));
      }
    }
    if (edge.ends[1] != panel.edges[(k + 1) % count].ends[0])
    {
      return invalid(edgeName(panel, k) + " ends at the vertex " + std::to_string(edge.ends[1]) +
        ", and the next edge begins at the vertex " +
        std::to_string(panel.edges[(k + 1) % count].ends[0]) +
        ": the edges of a panel must be one ring");
    }
    if (!starts.insert(edge.ends[0]).second)
    {
      return invalid(edgeName(panel, k) + " begins at the vertex " + std::to_string(edge.ends[0]) +
        ", through which the border has come before");
    }
    if (Status status = checkShape(panel, k); !status.ok())
    {
      return status;
    }
  }
  return {};
}
}

std::string edgeName(const GarmentPanel& panel, std::size_t edge)
{
  return "edge " + std::to_string(edge) + " of the panel " + panel.name;
}

Status checkGarment(const Garment& garment)
{
  if (garment.panels.empty())
  {
    return { StatusCode::NothingToDraw, "there is no panel" };
  }
  for (const GarmentPanel& panel : garment.panels)
  {
    if (Status status = checkPanel(panel); !status.ok())
    {
      return status;
    }
  }
  std::set<std::array<std::size_t, 2>> sewn;
  for (std::size_t s = 0; s < garment.stitches.size(); ++s)
  {
    for (const GarmentSide& side : garment.stitches[s].sides)
    {
      if (side.panel >= garment.panels.size() ||
        side.edge >= garment.panels[side.panel].edges.size())
      {
        return invalid("stitch " + std::to_string(s) + " takes an edge that is not there");
      }
      if (!sewn.insert({ side.panel, side.edge }).second)
      {
        return invalid(edgeName(garment.panels[side.panel], side.edge) +
          " is sewn to more than one edge, by stitch " + std::to_string(s) + " as well");
      }
    }
  }
  return {};
}

Points2 pointsAlong(
  const GarmentPanel& panel, const GarmentEdge& edge, double distance, std::size_t least)
{
  const Point2 start = panel.vertices[edge.ends[0]];
  const Point2 end = panel.vertices[edge.ends[1]];
  // Lengths along a much finer line, by which places of even length are found.
  const std::size_t fine = edge.shape == EdgeShape::Straight ? 1 : 2048;
  std::vector<double> arc{ 0.0 };
  double sharpest = 0.0;
  Point2 last = start;
  Point2 before = Point2::Zero();
  for (std::size_t k = 1; k <= fine; ++k)
  {
    const Point2 next =
      k == fine ? end : placeOn(panel, edge, static_cast<double>(k) / static_cast<double>(fine));
    const Point2 step = next - last;
    arc.push_back(arc.back() + step.norm());
    if (k > 1 && step.norm() > 0.0 && before.norm() > 0.0)
    {
      const double turn = std::abs(std::atan2(cross(before, step), before.dot(step)));
      sharpest = std::max(sharpest, turn / std::max(step.norm(), before.norm()));
    }
    before = step;
    last = next;
  }
  // An arc of the radius r is within c^2 / (8 r) of its chord c.
  const double wanted = arc.back() * std::sqrt(sharpest / (8.0 * distance));
  const auto count = std::clamp(static_cast<std::size_t>(std::ceil(std::min(wanted, 1000.0))),
    std::max<std::size_t>(least, 1), std::max<std::size_t>(least, 1000));
  Points2 points{ start };
  std::size_t at = 0;
  for (std::size_t k = 1; k < count; ++k)
  {
    const double place = arc.back() * static_cast<double>(k) / static_cast<double>(count);
    while (arc[at + 1] < place)
    {
      ++at;
    }
    const double share = (place - arc[at]) / (arc[at + 1] - arc[at]);
    points.push_back(
      placeOn(panel, edge, (static_cast<double>(at) + share) / static_cast<double>(fine)));
  }
  points.push_back(end);
  return points;
}

Point2 inFrameOf(const Point2& point, const Point2& from, const Point2& to)
{
  const Point2 chord = to - from;
  const Point2 left(-chord.y(), chord.x());
  return Point2((point - from).dot(chord), (point - from).dot(left)) /
    std::max(chord.squaredNorm(), 1e-300);
}

Point3 placedPoint(const GarmentPanel& panel, const Point2& point)
{
  const Point3 angle = panel.rotation * (pi / 180.0);
  const Eigen::Matrix3d turn = (Eigen::AngleAxisd(angle.z(), Point3::UnitZ()) *
    Eigen::AngleAxisd(angle.y(), Point3::UnitY()) * Eigen::AngleAxisd(angle.x(), Point3::UnitX()))
                                 .toRotationMatrix();
  return panel.translation + turn * Point3(point.x(), point.y(), 0.0);
}

std::string writeGarment(const Garment& garment)
{
  std::string json = "{\n  \"pattern\": {\n    \"panels\": {";
  std::string order;
  for (const GarmentPanel& panel : garment.panels)
  {
    json += (order.empty() ? "\n      " : ",\n      ") + quoted(panel.name) + ": ";
    json += writePanel(panel);
    order += (order.empty() ? "" : ", ") + quoted(panel.name);
  }
  json += "\n    },\n    \"stitches\": [";
  for (std::size_t s = 0; s < garment.stitches.size(); ++s)
  {
    json += s > 0 ? ",\n      [" : "\n      [";
    for (const std::size_t k : { 0U, 1U })
    {
      const GarmentSide& side = garment.stitches[s].sides[k];
      json += std::string(k > 0 ? ", " : "") +
        "{\"panel\": " + quoted(garment.panels[side.panel].name) +
        ", \"edge\": " + std::to_string(side.edge) + "}";
    }
    json += garment.stitches[s].rightToWrong ? ", \"right_wrong\"]" : "]";
  }
  return json + "\n    ],\n    \"panel_order\": [" + order +
    "]\n  },\n  \"parameters\": {},\n  \"parameter_order\": [],\n  \"properties\": {\n"
    "    \"curvature_coords\": \"relative\",\n    \"normalize_panel_translation\": false,\n"
    "    \"normalized_edge_loops\": true,\n    \"units_in_meter\": 100\n  }\n}\n";
}
}
