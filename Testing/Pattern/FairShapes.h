// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fairing/FairBorders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

/// Pieces of known shapes with smooth borders, measured by rules of their own.
namespace fairshapes
{
using namespace flattening;
using namespace flattening::pattern;

/// Length of a Bezier curve by Simpson's rule in many steps.
inline double lengthOf(const FairSpan& span)
{
  const int steps = 2000;
  const auto speed = [&span](double u) {
    const double v = 1.0 - u;
    const auto& c = span.control;
    return Point2(
      3.0 * (v * v * (c[1] - c[0]) + 2.0 * u * v * (c[2] - c[1]) + u * u * (c[3] - c[2])))
      .norm();
  };
  double sum = speed(0.0) + speed(1.0);
  for (int k = 1; k < steps; ++k)
  {
    sum += (k % 2 == 1 ? 4.0 : 2.0) * speed(static_cast<double>(k) / steps);
  }
  return sum / (3.0 * steps);
}

inline double lengthOf(const std::vector<FairSpan>& curve)
{
  double length = 0.0;
  for (const FairSpan& span : curve)
  {
    length += lengthOf(span);
  }
  return length;
}

inline double distanceFrom(const std::vector<FairSpan>& curve, const Point2& point)
{
  Points2 points;
  for (const FairSpan& span : curve)
  {
    sampleSpan(span, 1e-5, points);
  }
  points.push_back(curve.back().control[3]);
  Segments segments;
  addSegments(points, false, segments);
  return distance(point, segments);
}

/// A polygon around the point 0 of the source, as one piece with its border as wire.
inline PatternSource polygon(const Points2& corners)
{
  PatternSource source;
  source.positions.emplace_back(0.0, 0.0);
  SourceWire border{ {}, WireType::Boundary, none, 0, "boundary" };
  const auto count = static_cast<Index>(corners.size());
  for (Index k = 0; k < count; ++k)
  {
    source.positions.push_back(corners[static_cast<std::size_t>(k)]);
    source.triangles.push_back({ 0, k + 1, (k + 1) % count + 1 });
    border.points.push_back(k + 1);
  }
  border.points.push_back(1);
  source.pieceOfTriangle.assign(source.triangles.size(), 0);
  source.wires = { border };
  return source;
}

/// The smooth borders of a source in millimetres.
struct Smoothed
{
  PatternSource source;
  DrawingSource all;
  std::unique_ptr<FairBorders> borders;

  Smoothed(const PatternSource& given, double tolerance, double notches = 0.0,
    const PatternOptions& options = {})
    : source(given)
    , all(given, options)
  {
    this->all.options.unit = Unit::Millimetre;
    this->all.options.notchSpacing = notches;
    this->all.options.fairTolerance = tolerance;
    EXPECT_TRUE(findBorders(this->all).ok());
    this->borders = std::make_unique<FairBorders>(this->all);
  }

  std::vector<FairSpan> curve(std::size_t wire) const
  {
    return this->borders->curveOf(this->source.wires[wire]);
  }
  const FairPieceReport& report() const { return this->borders->reports()[0]; }
};
}
