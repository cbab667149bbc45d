// SPDX-License-Identifier: BSD-3-Clause
// The project's sparse factorization and order of elimination beside CHOLMOD's, AMD's and METIS's,
// on the systems that a trouser leg of several sizes gives. Prints a table in Markdown.
#include "Base/Execution.h"
#include "Measure.h"
#include "SystemCase.h"

#include <CLI/CLI.hpp>
#include <Eigen/CholmodSupport>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
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

/// What a direct solver took for one system.
struct SolverTimes
{
  double analyze = 0.0; ///< seconds for the order of elimination and the structure of the factor
  double factor = 0.0;
  double solve = 0.0;
  double entries = 0.0;  ///< of the factor in CHOLMOD; 0 for the project's own
  double residual = 0.0; ///< largest |A x - b| over the largest |b|
};

/// Takes the time of the steps of a solver. Throws std::runtime_error where one fails.
SolverTimes timesOf(const SystemCase& system, const std::function<bool()>& analyze,
  const std::function<bool()>& factorize, const std::function<Eigen::MatrixXd()>& solve)
{
  SolverTimes times;
  Stopwatch watch;
  const bool analyzed = analyze();
  times.analyze = watch.seconds();
  watch = {};
  if (!analyzed || !factorize())
  {
    throw std::runtime_error("no factor of " + system.name);
  }
  times.factor = watch.seconds();
  watch = {};
  const Eigen::MatrixXd x = solve();
  times.solve = watch.seconds();
  const Eigen::MatrixXd left = system.lower.selfadjointView<Eigen::Lower>() * x;
  times.residual = (left - system.rightHandSide).cwiseAbs().maxCoeff() /
    system.rightHandSide.cwiseAbs().maxCoeff();
  return times;
}

SolverTimes solveByOwn(const SystemCase& system, int threads)
{
  const Execution execution = threadedExecution(threads);
  LinearSolver solver(system.order);
  SolverTimes times = timesOf(
    system, [&] { return solver.analyze(system.lower); },
    [&] { return solver.factorize(system.lower, execution); },
    [&] { return solver.solve(system.rightHandSide); });
  times.analyze += system.orderSeconds;
  return times;
}

template <class Factorization>
SolverTimes solveBy(const SystemCase& system, int ordering)
{
  Factorization solver;
  cholmod_common& common = solver.cholmod();
  common.nmethods = 1;
  common.method[0].ordering = ordering;
  common.print = 0;
  SolverTimes times = timesOf(
    system,
    [&] {
      solver.analyzePattern(system.lower); // METIS and AMD order within it
      return solver.info() == Eigen::Success;
    },
    [&] {
      solver.factorize(system.lower);
      return solver.info() == Eigen::Success;
    },
    [&]() -> Eigen::MatrixXd { return solver.solve(system.rightHandSide); });
  times.entries = common.lnz;
  return times;
}

/// By dense blocks (supernodes, on BLAS) where the system is definite, where CHOLMOD knows no such
/// factor, column by column otherwise.
SolverTimes solveByCholmod(const SystemCase& system, int ordering)
{
  return system.definite ? solveBy<Eigen::CholmodSupernodalLLT<SparseMatrix>>(system, ordering)
                         : solveBy<Eigen::CholmodSimplicialLDLT<SparseMatrix>>(system, ordering);
}

/// The system with its unknowns in the order in which the project eliminates them.
SystemCase inOwnOrder(const SystemCase& system)
{
  const Indices& order = system.order.order;
  Eigen::PermutationMatrix<Eigen::Dynamic> place(system.lower.rows());
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    place.indices()[order[k]] = static_cast<int>(k);
  }
  SystemCase ordered = system;
  ordered.lower.selfadjointView<Eigen::Lower>() =
    system.lower.selfadjointView<Eigen::Lower>().twistedBy(place);
  // CHOLMOD takes columns as sorted, as they are once transposed twice.
  const SparseMatrix upper = ordered.lower.transpose();
  ordered.lower = upper.transpose();
  ordered.rightHandSide = place * system.rightHandSide;
  return ordered;
}

struct Method
{
  std::string name;
  std::function<SolverTimes(const SystemCase&)> solve;
};

/// CHOLMOD takes as many threads as its BLAS; OPENBLAS_NUM_THREADS sets them.
std::vector<Method> allMethods()
{
  const auto own = [](int threads) {
    return [=](const SystemCase& system) { return solveByOwn(system, threads); };
  };
  const auto cholmod = [](int ordering) {
    return [=](const SystemCase& system) { return solveByCholmod(system, ordering); };
  };
  return { { "own, 1 thread", own(1) }, { "own, 2 threads", own(2) },
    { "CHOLMOD, own order",
      [](
        const SystemCase& system) { return solveByCholmod(inOwnOrder(system), CHOLMOD_NATURAL); } },
    { "CHOLMOD, AMD", cholmod(CHOLMOD_AMD) }, { "CHOLMOD, METIS", cholmod(CHOLMOD_METIS) } };
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
      writeFile(settings.json, rows.dump(2) + '\n');
    }
  }
  catch (const std::exception& error)
  {
    std::cerr << "SolverBenchmark: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
