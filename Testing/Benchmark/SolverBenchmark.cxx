// SPDX-License-Identifier: BSD-3-Clause
// The project's sparse factorization and order of elimination beside CHOLMOD's, AMD's and METIS's,
// on the systems that a trouser leg of several sizes gives. Prints a table in Markdown.
#include "Measure.h"
#include "SystemSolver.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <functional>
#include <iostream>
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
  int repeats = 5;
  std::string json;
};

struct Method
{
  std::string name;
  std::function<SolverTimes(const SystemCase&)> solve;
};

/// CHOLMOD takes as many threads as its BLAS; OPENBLAS_NUM_THREADS sets them.
std::vector<Method> allMethods()
{
  const auto own = [](int threads) {
    return [threads](
             const SystemCase& system) { return solveByOwn(system, threadedExecution(threads)); };
  };
  const auto cholmod = [](Ordering ordering) {
    return [ordering](const SystemCase& system) { return solveByCholmod(system, ordering); };
  };
  return { { "own, 1 thread", own(1) }, { "own, 2 threads", own(2) },
    { "CHOLMOD, own order", cholmod(Ordering::Own) },
    { "CHOLMOD, AMD", cholmod(Ordering::MinimumDegree) },
    { "CHOLMOD, METIS", cholmod(Ordering::Metis) } };
}

/// The least of several runs, each stage for itself: other programs only add to it.
SolverTimes least(const Settings& settings, const std::function<SolverTimes()>& run)
{
  SolverTimes best = run();
  for (int k = 1; k < settings.repeats; ++k)
  {
    const SolverTimes again = run();
    best.analyze = std::min(best.analyze, again.analyze);
    best.factor = std::min(best.factor, again.factor);
    best.solve = std::min(best.solve, again.solve);
    best.residual = std::max(best.residual, again.residual);
  }
  return best;
}

void addRows(
  const Settings& settings, const SystemCase& system, Index triangles, nlohmann::ordered_json& rows)
{
  for (const Method& method : allMethods())
  {
    const SolverTimes times = least(settings, [&] { return method.solve(system); });
    std::printf("| %s | %d | %s | %.3g | %.3g | %.3g | %.3g | %.1e |\n", system.name.c_str(),
      triangles, method.name.c_str(), 1e3 * times.analyze, 1e3 * times.factor, 1e3 * times.solve,
      times.entries, times.residual);
    std::fflush(stdout);
    rows.push_back(
      { { "system", system.name }, { "triangles", triangles }, { "unknowns", system.lower.rows() },
        { "method", method.name }, { "seconds_analyze", times.analyze },
        { "seconds_factor", times.factor }, { "seconds_solve", times.solve },
        { "entries", times.entries }, { "residual", times.residual } });
  }
}

void write(const std::string& path, const nlohmann::ordered_json& rows)
{
  std::ofstream file(path);
  file << rows.dump(2) << '\n';
  file.close();
  if (!file)
  {
    throw std::runtime_error("cannot write " + path);
  }
}
}

int main(int argc, char** argv)
{
  Settings settings;
  CLI::App app("The sparse factorization beside CHOLMOD and METIS");
  app.add_option("DATA", settings.folder, "Folder of the pieces")->required();
  app.add_option("--piece", settings.piece, "Name of the piece")->capture_default_str();
  app.add_option("--divisions", settings.divisions, "Parts of each edge")->capture_default_str();
  app.add_option("--repeats", settings.repeats, "Runs, of which the least counts")
    ->capture_default_str();
  app.add_option("--json", settings.json, "File for the table");
  CLI11_PARSE(app, argc, argv);
  try
  {
    std::printf("| system | triangles | method | analyze, ms | factor, ms | solve, ms | entries | "
                "residual |\n|---|---|---|---|---|---|---|---|\n");
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const int division : settings.divisions)
    {
      const PreparedPiece piece(readRefined(settings.folder, settings.piece, division), {});
      const Index triangles = piece.surface.mesh.triangleCount();
      addRows(settings, interiorSystem(piece), triangles, rows);
      addRows(settings, isometricSystem(piece, {}), triangles, rows);
    }
    if (!settings.json.empty())
    {
      write(settings.json, rows);
    }
  }
  catch (const std::exception& error)
  {
    std::cerr << "SolverBenchmark: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
