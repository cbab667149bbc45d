// SPDX-License-Identifier: BSD-3-Clause
// The stages of flattening, each on what the stages before it give, on a trouser leg of several
// sizes. One thread, so that its processor time can count, which other programs hardly change.
// Takes the options of Google Benchmark as well.
#include "FilterRun.h"
#include "GrowthReporter.h"
#include "PreparedPiece.h"

#include "Angles/WireLayout.h"
#include "Embedding/InteriorEmbedding.h"
#include "Isometric/IsometricWarping.h"
#include "Quality/BoundaryOverlap.h"
#include "Quality/FlatteningQuality.h"
#include "Quality/SurfaceDevelopability.h"

#include <vtkSMPTools.h>

#include <CLI/CLI.hpp>
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
using namespace benchmarks;
using namespace flattening;

struct Settings
{
  std::string folder;
  std::string piece = "pants_front";
  std::vector<int> divisions{ 1, 4, 11 };
};

/// As many overlaps as flattenSurface() lists at most.
constexpr std::size_t mostOverlaps = 1000;

void require(const Status& status)
{
  if (status.refused())
  {
    throw std::runtime_error(status.message);
  }
}

void embed(const PreparedPiece& p, InteriorMethod method, const Execution& execution)
{
  InteriorOptions options;
  options.method = method;
  Points2 positions = p.wires;
  require(embedInterior(p.piece, p.network, options, execution, positions).status);
  benchmark::DoNotOptimize(positions.data());
}

void measureQuality(const PreparedPiece& p, const Execution& execution)
{
  Indices edges;
  for (const WireEdge& edge : p.network.edges)
  {
    edges.push_back(p.network.halfedge[edge.side]);
  }
  benchmark::DoNotOptimize(measureFlattening(p.piece.mesh, p.rigid, edges, execution));
  benchmark::DoNotOptimize(findBoundaryOverlaps(p.piece.mesh, p.rigid, mostOverlaps));
  benchmark::DoNotOptimize(surfaceDevelopability(p.cut.mesh, cornerAngles(p.cut.mesh, execution)));
}

/// Times a stage that is free of side effects.
void add(const std::string& stage, Index triangles, const std::function<void()>& body)
{
  benchmark::RegisterBenchmark((stage + "/" + std::to_string(triangles)).c_str(),
    [body, triangles](benchmark::State& state) {
      for (auto _ : state)
      {
        body();
      }
      state.counters["triangles"] = triangles;
    })
    ->Unit(benchmark::kMillisecond);
}

/// What the filter adds to Core: the time of Update() less that of Core.
void addFilter(Index triangles, const std::shared_ptr<FilterRun>& filter)
{
  benchmark::RegisterBenchmark(("filter overhead/" + std::to_string(triangles)).c_str(),
    [filter, triangles](benchmark::State& state) {
      double core = 0.0;
      double overhead = 0.0;
      for (auto _ : state)
      {
        filter->update();
        core += filter->coreSeconds();
        overhead += filter->overheadSeconds();
        state.SetIterationTime(filter->overheadSeconds());
      }
      state.counters["triangles"] = triangles;
      state.counters["of_core"] = overhead / core;
    })
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();
}

void addStages(const Settings& settings, int division)
{
  const Execution execution; // one thread
  const auto p = std::make_shared<const PreparedPiece>(
    readRefined(settings.folder, settings.piece, division), execution);
  const Index triangles = p->surface.mesh.triangleCount();
  add("cut", triangles, [p] {
    benchmark::DoNotOptimize(extractPieces(cutSurface(p->surface.mesh, p->surface.curves)));
  });
  add("network", triangles, [p] { benchmark::DoNotOptimize(buildWireNetwork(p->piece)); });
  add("wires", triangles,
    [p, execution] { benchmark::DoNotOptimize(solveAnglesByNewton(p->problem, {}, execution)); });
  add("layout", triangles,
    [p] { benchmark::DoNotOptimize(layOutWires(p->network, p->angles.theta, p->angles.length)); });
  add("interior, Laplacian", triangles,
    [p, execution] { embed(*p, InteriorMethod::Laplacian, execution); });
  add("interior, rigid", triangles,
    [p, execution] { embed(*p, InteriorMethod::AsRigidAsPossible, execution); });
  add("isometric", triangles, [p, execution] {
    require(
      warpIsometrically(p->piece, p->problem, p->rigid, p->angles.stretch, {}, execution).status);
  });
  add("quality", triangles, [p, execution] { measureQuality(*p, execution); });
  for (const auto& [name, interior] :
    { std::make_pair("Laplacian", vtkWireWarpingFilter::LAPLACIAN),
      std::make_pair("rigid", vtkWireWarpingFilter::AS_RIGID_AS_POSSIBLE) })
  {
    for (const bool caching : { false, true })
    {
      const auto filter = std::make_shared<FilterRun>(p->surface, interior, caching);
      filter->update(); // what is kept is there from the second on
      add(std::string(caching ? "update again, " : "update, ") + name, triangles,
        [filter] { filter->update(); });
    }
  }
  addFilter(
    triangles, std::make_shared<FilterRun>(p->surface, vtkWireWarpingFilter::LAPLACIAN, false));
}
}

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  Settings settings;
  CLI::App app("Time of each stage against the number of triangles");
  app.add_option("DATA", settings.folder, "Folder of the pieces")->required();
  app.add_option("--piece", settings.piece, "Name of the piece")->capture_default_str();
  app.add_option("--divisions", settings.divisions, "Parts of each edge")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  vtkSMPTools::Initialize(1);
  try
  {
    for (const int division : settings.divisions)
    {
      addStages(settings, division);
    }
    GrowthReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
  }
  catch (const std::exception& error)
  {
    std::cerr << "StageBenchmark: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
