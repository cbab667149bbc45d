// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/SeamAllowance.h"

#include "Outlines/Outline.h"

#include <clipper.hpp>

#include <cmath>

namespace flattening::pattern
{
namespace
{
/// Clipper's grid: a 10,000th of a millimetre, coarser only where the coordinates would leave the
/// range in which Clipper works with 64 bits.
double gridScale(const std::vector<AllowancePolygon>& polygons)
{
  double largest = 1.0;
  for (const AllowancePolygon& polygon : polygons)
  {
    for (std::size_t k = 0; k < polygon.points.size(); ++k)
    {
      largest =
        std::max(largest, polygon.points[k].cwiseAbs().maxCoeff() + 10.0 * polygon.allowance[k]);
    }
  }
  return std::min(1e4, 1e9 / largest);
}

ClipperLib::Path onGrid(const Points2& points, double scale)
{
  ClipperLib::Path path;
  for (const Point2& p : points)
  {
    path.emplace_back(std::llround(p.x() * scale), std::llround(p.y() * scale));
  }
  return path;
}

Points2 fromGrid(const ClipperLib::Path& path, double scale)
{
  Points2 points;
  for (const ClipperLib::IntPoint& p : path)
  {
    points.emplace_back(static_cast<double>(p.X) / scale, static_cast<double>(p.Y) / scale);
  }
  return points;
}

Point2 rightNormal(const Point2& from, const Point2& to)
{
  const Point2 along = (to - from).normalized();
  return { along.y(), -along.x() };
}

/// Outer corner of two strips that meet at a convex vertex, as a polygon that starts at the vertex.
Points2 corner(const Point2& vertex, const Point2& normalBefore, double before,
  const Point2& normalAfter, double after, double mitreLimit)
{
  const Point2 a = vertex + before * normalBefore;
  const Point2 b = vertex + after * normalAfter;
  const double sine = cross(normalBefore, normalAfter);
  const double cosine = normalBefore.dot(normalAfter);
  Points2 polygon{ vertex, a };
  // The tip has the distances `before` and `after` from the two edges' lines.
  const Point2 tip = std::abs(sine) > 1e-9
    ? Point2(vertex +
        (before * Point2(normalAfter.y(), -normalAfter.x()) -
          after * Point2(normalBefore.y(), -normalBefore.x())) /
          sine)
    : a;
  const Point2 forward(-normalBefore.y(), normalBefore.x());
  const Point2 backward(normalAfter.y(), -normalAfter.x());
  const bool ahead = (tip - a).dot(forward) > 0.0 && (tip - b).dot(backward) > 0.0;
  const double longest = mitreLimit * std::max(before, after);
  if (ahead && (tip - vertex).norm() <= longest)
  {
    polygon.push_back(tip);
  }
  else if (before == after && before > 0.0)
  {
    // Square off at the distance of the allowance from the vertex, on the bisector's normal.
    const double tangent = std::tan(std::atan2(sine, cosine) / 4.0);
    polygon.emplace_back(a + before * tangent * forward);
    polygon.emplace_back(b + before * tangent * backward);
  }
  polygon.push_back(b);
  return polygon;
}

void addPositive(ClipperLib::Path path, ClipperLib::Paths& paths)
{
  if (!ClipperLib::Orientation(path))
  {
    ClipperLib::ReversePath(path);
  }
  if (ClipperLib::Area(path) > 0.0)
  {
    paths.push_back(std::move(path));
  }
}

void addStrips(
  const AllowancePolygon& polygon, double mitreLimit, double scale, ClipperLib::Paths& paths)
{
  // Edges without length have no normal.
  std::vector<std::size_t> edges;
  const std::size_t count = polygon.points.size();
  const auto from = [&polygon](std::size_t k) { return polygon.points[k]; };
  const auto to = [&polygon, count](std::size_t k) { return polygon.points[(k + 1) % count]; };
  for (std::size_t k = 0; k < count; ++k)
  {
    if (from(k) != to(k))
    {
      edges.push_back(k);
    }
  }
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    const std::size_t k = edges[i];
    const std::size_t before = edges[(i + edges.size() - 1) % edges.size()];
    const Point2 normal = rightNormal(from(k), to(k));
    const double width = polygon.allowance[k];
    if (width > 0.0)
    {
      addPositive(
        onGrid({ from(k), to(k), to(k) + width * normal, from(k) + width * normal }, scale), paths);
    }
    const Point2 normalBefore = rightNormal(from(before), to(before));
    const double widthBefore = polygon.allowance[before];
    if (cross(normalBefore, normal) > 0.0 && std::max(width, widthBefore) > 0.0)
    {
      addPositive(
        onGrid(corner(from(k), normalBefore, widthBefore, normal, width, mitreLimit), scale),
        paths);
    }
  }
}
}

Status addAllowance(
  const std::vector<AllowancePolygon>& polygons, double mitreLimit, std::vector<Points2>& widened)
{
  widened.clear();
  if (!hasAllowance(polygons))
  {
    for (const AllowancePolygon& polygon : polygons)
    {
      widened.push_back(polygon.points);
    }
    return {};
  }
  const double scale = gridScale(polygons);
  ClipperLib::Paths cloth;
  ClipperLib::Paths strips;
  for (const AllowancePolygon& polygon : polygons)
  {
    cloth.push_back(onGrid(polygon.points, scale));
    addStrips(polygon, mitreLimit, scale, strips);
    for (const Points2& tab : polygon.tabs)
    {
      addPositive(onGrid(tab, scale), strips);
    }
  }
  ClipperLib::Paths borders;
  try
  {
    ClipperLib::Clipper clipper;
    clipper.AddPaths(cloth, ClipperLib::ptSubject, true);
    clipper.AddPaths(strips, ClipperLib::ptSubject, true);
    clipper.Execute(ClipperLib::ctUnion, borders, ClipperLib::pftPositive, ClipperLib::pftPositive);
    ClipperLib::CleanPolygons(borders);
  }
  catch (const ClipperLib::clipperException& error)
  {
    return { StatusCode::InvalidOption,
      std::string("the seam allowance cannot be drawn: ") + error.what(), {},
      { Remedy::CheckUnit, { Remedy::Give, "another seam allowance" } } };
  }
  for (const ClipperLib::Path& border : borders)
  {
    if (border.size() > 2)
    {
      widened.push_back(fromGrid(border, scale));
    }
  }
  const auto largest = std::max_element(widened.begin(), widened.end(),
    [](const Points2& a, const Points2& b) { return doubleArea(a) < doubleArea(b); });
  if (largest == widened.end())
  {
    return { StatusCode::NothingToDraw, "the piece is too small to be drawn at true scale", {},
      { Remedy::CheckUnit } };
  }
  std::iter_swap(widened.begin(), largest);
  return {};
}
}
