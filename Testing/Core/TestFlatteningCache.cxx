// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceFlattening.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

using namespace flattening;
using namespace testmeshes;

namespace
{
const std::vector<InteriorMethod> methods{ InteriorMethod::Laplacian,
  InteriorMethod::AsRigidAsPossible };

Surface curvedCushion(double height = 0.4)
{
  Surface surface = cushion(24, 18, height);
  surface.curves = { rowCurve(24, 7), columnCurve(24, 18, 9) };
  return surface;
}

FlatteningOptions optionsOf(Scheme scheme, InteriorMethod method)
{
  FlatteningOptions options;
  options.scheme = scheme;
  options.interior.method = method;
  return options;
}

/// A run with the cache gives the bits of a run without.
void expectTheSame(const Surface& surface, const FlatteningOptions& options, FlatteningCache& cache)
{
  const FlatteningResult with = flattenSurface(surface.mesh, surface.curves, options, {}, &cache);
  const FlatteningResult without = flattenSurface(surface.mesh, surface.curves, options, {});
  ASSERT_FALSE(without.status.refused());
  EXPECT_EQ(with.status.code, without.status.code);
  EXPECT_EQ(with.positions, without.positions);
  EXPECT_EQ(with.developability, without.developability);
  ASSERT_EQ(with.pieces.size(), without.pieces.size());
  for (std::size_t p = 0; p < with.pieces.size(); ++p)
  {
    EXPECT_EQ(with.pieces[p].quality.angleError, without.pieces[p].quality.angleError);
    EXPECT_EQ(
      with.pieces[p].quality.globalHomogeneity, without.pieces[p].quality.globalHomogeneity);
  }
}

const LinearSolver* factorOf(FlatteningCache& cache, InteriorWeights weights)
{
  return cache.pieces.at(0).at(0).factor(weights, {});
}
}

TEST(FlatteningCache, ChangesNoBitOfAnyResult)
{
  for (const InteriorMethod method : methods)
  {
    FlatteningCache cache;
    Surface surface = curvedCushion();
    expectTheSame(surface, optionsOf(Scheme::Global, method), cache);
    expectTheSame(surface, optionsOf(Scheme::Progressive, method), cache);
    surface.curves[0].type = CurveType::Key;
    expectTheSame(surface, optionsOf(Scheme::Global, method), cache);
    surface.curves[1].tolerance = 0.05;
    expectTheSame(surface, optionsOf(Scheme::Global, method), cache);
    expectTheSame(surface, optionsOf(Scheme::Isometric, method), cache);
    surface.curves[1].type = CurveType::Dart;
    expectTheSame(surface, optionsOf(Scheme::Global, method), cache);
    expectTheSame(curvedCushion(0.1), optionsOf(Scheme::Global, method), cache);
    expectTheSame(curvedCushion(), optionsOf(Scheme::Global, method), cache);
  }
}

TEST(FlatteningCache, KeepsFactorsWhereTheSurfaceIsTheSameAndTheirPatternWhereItMoves)
{
  FlatteningCache cache;
  Surface surface = curvedCushion();
  const FlatteningOptions options = optionsOf(Scheme::Global, InteriorMethod::AsRigidAsPossible);
  flattenSurface(surface.mesh, surface.curves, options, {}, &cache);
  const LinearSolver* const first = factorOf(cache, InteriorWeights::Cotangent);
  ASSERT_NE(first, nullptr);
  const Index unknowns = first->positive();
  surface.curves[0].type = CurveType::Key;
  flattenSurface(surface.mesh, surface.curves, options, {}, &cache);
  EXPECT_EQ(factorOf(cache, InteriorWeights::Cotangent), first);
  const Surface moved = curvedCushion(0.2);
  flattenSurface(moved.mesh, surface.curves, options, {}, &cache);
  EXPECT_EQ(factorOf(cache, InteriorWeights::Cotangent), first);
  surface.curves.pop_back();
  flattenSurface(surface.mesh, surface.curves, options, {}, &cache);
  EXPECT_NE(factorOf(cache, InteriorWeights::Cotangent)->positive(), unknowns)
    << "other wire-patches";
}

TEST(FlatteningCache, ServesAfterARunThatWasCancelled)
{
  FlatteningCache cache;
  const Surface surface = curvedCushion();
  const FlatteningOptions options = optionsOf(Scheme::Global, InteriorMethod::AsRigidAsPossible);
  for (int questions = 0; questions < 12; ++questions)
  {
    int left = questions;
    Execution execution;
    execution.cancel = [&left] { return left-- <= 0; };
    flattenSurface(surface.mesh, surface.curves, options, execution, &cache);
    expectTheSame(surface, options, cache);
  }
}
