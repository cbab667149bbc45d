// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ClosedMeshes.h"
#include "Flattening/SurfaceFlattening.h"
#include "Imprint/CurveImprint.h"
#include "Suggestion/CurveSuggestion.h"

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

/// What the caller gets who takes the proposals and flattens.
inline FlatteningResult flattened(const TriangleMesh& mesh, std::vector<Polyline> curves,
  const std::vector<SuggestedCurve>& cuts, const FlatteningOptions& options = {})
{
  for (const SuggestedCurve& cut : cuts)
  {
    curves.push_back(cut.curve);
  }
  const ImprintedSurface surface = imprintCurves(mesh, curves, {});
  EXPECT_TRUE(surface.status.ok()) << surface.status.message;
  return flattenSurface(surface.mesh, surface.curves, options, {});
}

inline FlatteningResult flattened(const TriangleMesh& mesh, const std::vector<Polyline>& curves,
  const CurveSuggestions& suggestions, const FlatteningOptions& options = {})
{
  return flattened(mesh, curves, suggestions.curves, options);
}

/// To the last bit.
inline void expectSameCurves(const CurveSuggestions& one, const CurveSuggestions& other)
{
  ASSERT_EQ(one.curves.size(), other.curves.size());
  for (std::size_t k = 0; k < one.curves.size(); ++k)
  {
    EXPECT_EQ(one.curves[k].curve.points, other.curves[k].curve.points);
    EXPECT_EQ(one.curves[k].gain, other.curves[k].gain);
    EXPECT_EQ(one.curves[k].predictedGain, other.curves[k].predictedGain);
  }
}

/// A curve over vertices of a mesh.
inline Polyline lineOver(const TriangleMesh& mesh, const Indices& vertices,
  CurveType type = CurveType::Accessory, const std::string& name = {})
{
  Polyline line;
  line.type = type;
  line.name = name;
  for (const Index v : vertices)
  {
    line.points.push_back(mesh.point(v));
  }
  return line;
}

/// The largest 95 % strain of its pieces.
inline double worstStrain(const FlatteningResult& result)
{
  double worst = 0.0;
  for (const PieceReport& piece : result.pieces)
  {
    worst = std::max(worst, piece.quality.strainP95);
  }
  return worst;
}

inline double totalLength(const std::vector<SuggestedCurve>& cuts)
{
  double length = 0.0;
  for (const SuggestedCurve& cut : cuts)
  {
    length += cut.length;
  }
  return length;
}

inline SuggestionOptions optionsOf(double bound, Index most,
  SuggestedCuts cuts = SuggestedCuts::All, double work = SearchOptions().maximumWork)
{
  SuggestionOptions options;
  options.search.cuts = cuts;
  options.search.maximumWork = work;
  options.search.bound = bound;
  options.search.maximumCuts = most;
  options.search.trials = 8;
  return options;
}
}
