// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/SurfaceFlattening.h"
#include "Imprint/CurveImprint.h"
#include "Suggestion/CurveSuggestion.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace testmeshes
{
/// A sheet with a bump on each side of x = 0: its own mirror image in that, and in no other plane.
inline TriangleMesh twoBumps()
{
  return patch(20, 14, [](double i, double j) {
    const double x = i / 10.0 - 1.0;
    const double y = j / 10.0;
    const double square = (std::abs(x) - 0.5) * (std::abs(x) - 0.5) + (y - 0.9) * (y - 0.9);
    return Point3(x, y, 0.25 * std::exp(-9.0 * square));
  }).mesh;
}

/// The unit sphere: an octahedron whose edges are halved again and again.
inline TriangleMesh sphere(int halvings)
{
  Points3 points{ { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
  Triangles triangles{ { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 },
    { 3, 1, 5 }, { 0, 3, 5 } };
  for (int k = 0; k < halvings; ++k)
  {
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b) {
      const auto found = middles.emplace(std::minmax(a, b), static_cast<Index>(points.size()));
      if (found.second)
      {
        points.emplace_back((points[a] + points[b]).normalized());
      }
      return found.first->second;
    };
    Triangles finer;
    for (const auto& [a, b, c] : triangles)
    {
      const Index x = middle(a, b);
      const Index y = middle(b, c);
      const Index z = middle(c, a);
      finer.insert(finer.end(), { { a, x, z }, { b, y, x }, { c, z, y }, { x, y, z } });
    }
    triangles = finer;
  }
  return { std::move(points), std::move(triangles) };
}

/// A sheet whose left and right edges are one: by turn, up to 2 pi, and from 0 to 1 across.
template <class Place>
TriangleMesh rolledUp(Index around, Index across, const Place& place)
{
  const Surface surface = patch(around, across,
    [&](double i, double j) { return Point3(place(2.0 * pi * i / around, j / across)); });
  Triangles triangles = surface.mesh.triangles();
  for (Triangle& t : triangles)
  {
    for (Index& v : t)
    {
      v = v % (around + 1) == around ? v - around : v;
    }
  }
  return { surface.mesh.points(), std::move(triangles) };
}

/// What the caller gets who takes the proposals and flattens.
inline FlatteningResult flattened(
  const TriangleMesh& mesh, std::vector<Polyline> curves, const CurveSuggestions& suggestions)
{
  for (const SuggestedCurve& cut : suggestions.curves)
  {
    curves.push_back(cut.curve);
  }
  const ImprintedSurface surface = imprintCurves(mesh, curves, {});
  EXPECT_TRUE(surface.status.ok()) << surface.status.message;
  return flattenSurface(surface.mesh, surface.curves, {}, {});
}

inline SuggestionOptions optionsOf(double bound, Index most)
{
  SuggestionOptions options;
  options.search.bound = bound;
  options.search.maximumCuts = most;
  options.search.trials = 8;
  return options;
}
}
