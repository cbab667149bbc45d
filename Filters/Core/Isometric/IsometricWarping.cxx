// SPDX-License-Identifier: BSD-3-Clause
#include "Isometric/IsometricWarping.h"

#include "Angles/WireLayout.h"
#include "Isometric/IsometricModel.h"
#include "Sparse/NewtonKkt.h"
#include "Sparse/PenaltyDescent.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace flattening
{
namespace
{
/// In the model's unit of length.
constexpr double stepTolerance = 1e-10;
constexpr double stepLengthTolerance = 1e-8;
/// Far from the minimum the exact Hessian is seldom convex; it pays once no vertex moves by
/// that unit.
constexpr double exactWithin = 1.0;
/// Threads that are relaid onto a cloth make it seldom convex until little is left to gain.
constexpr double clothExactWithin = 0.05;
/// Wires nearly close where the scheme starts and multipliers change little; with the margin of the
/// directions form, 1.5, hard pieces take up to half as many steps more.
constexpr double penaltyMargin = 1.2;
/// Torques of locked angles are many times the forces of lengths.
constexpr double penaltyShare = 0.1;
/// A key's locked angles add up along it and bend its far end off the linear step.
constexpr int corrections = 5;
/// Forces change so little from there on that the piece does not: with 1e-1 and 1e-5 all measures
/// of 72 pieces are the same to three digits.
constexpr double finalObjectiveReduction = 0.1;
constexpr double finalObjectiveConstraint = 1e-2;
/// Threads that are relaid bend the Hessian downwards all the way, not at saddles alone.
constexpr double clothSaddleReduction = 1e-3;
/// A step by an earlier factorization costs about a tenth of one by its own.
constexpr double chordReduction = 0.1;
/// A piece that has not come near a minimum by then may do so with other wires.
constexpr int finalObjectiveIteration = 30;

/// Factorizations for triangles, so that time is bounded on every mesh: about 0.1 s each for the
/// first number of triangles on a core of 2024, and no more for the second than anything needs.
constexpr double triangleFactorizations = 4e6;
constexpr int fewestFactorizations = 40;
constexpr int maximumFactorizations = 180;
/// From this number of coordinates on the memory of a factor is what limits solving with it.
constexpr Index singleFrom = 10000;
/// Below this number of coordinates of a plain sheet threads take longer to start than they save.
constexpr Index threadsFrom = 4000;
/// The way from afar is long; what is left after it is short.
constexpr double descentShare = 2.0;

/// Counted, not timed: the same on any machine.
int allowance(const IsometricModel& model, double share)
{
  const double triangles = 0.5 * static_cast<double>(model.coordinateCount());
  return static_cast<int>(share *
    std::clamp(triangleFactorizations / (2.0 * triangles), double{ fewestFactorizations },
      double{ maximumFactorizations }));
}

NewtonKktOptions newtonOptions(const IsometricOptions& options)
{
  NewtonKktOptions newton;
  newton.maximumIterations = options.maximumIterations;
  newton.constraintTolerance = options.rough ? finalObjectiveConstraint : options.lengthTolerance;
  newton.optimalityTolerance = options.tolerance;
  newton.reductionTolerance =
    options.rough ? finalObjectiveReduction : options.tolerance * options.tolerance;
  newton.stepTolerance = stepTolerance;
  newton.stepConstraintTolerance = stepLengthTolerance;
  newton.exactWithin = exactWithin;
  newton.exactBeforeSettling = options.cloth ? clothExactWithin : exactWithin;
  newton.penaltyMargin = penaltyMargin;
  newton.penaltyShare = penaltyShare;
  newton.corrections = corrections;
  newton.finalObjectiveReduction = finalObjectiveReduction;
  newton.finalObjectiveConstraint = finalObjectiveConstraint;
  newton.finalObjectiveIteration = finalObjectiveIteration;
  // Threads come to rest in fewer iterations by them as well, but not sooner.
  newton.correctsAgain = !options.cloth;
  newton.saddleReduction = options.cloth ? clothSaddleReduction : finalObjectiveReduction;
  if (options.inRounds)
  {
    newton.exactWithin = newton.exactBeforeSettling = 0.0;
    newton.saddleReduction = 0.0;
  }
  newton.phase = "Warping wires and interior together";
  return newton;
}

/// Those of its triangles, none so small that it has no barrier; empty where all are alike.
RegionWeights weightsOf(const Piece& piece, const RegionWeights& ofSurface)
{
  RegionWeights weights;
  for (const Index t : ofSurface.empty() ? Indices() : piece.triangles)
  {
    weights.push_back(ofSurface[t]);
  }
  weights = relativeWeights(piece.mesh, weights);
  for (double& weight : weights)
  {
    weight = std::max(weight, BoundaryFilling::share);
  }
  return weights;
}

/// A piece's problem, and an order of elimination for it.
struct IsometricSetup
{
  std::optional<IsometricModel> model;
  Dissection order;

  /// \param start where its vertices lie
  IsometricSetup(const Piece& piece, const AngleProblem& problem, const SheetEnergy& energy,
    const IsometricOptions& options, const Points2& start, const Execution& execution,
    const BoundaryFilling& filling = {})
  {
    const auto pose = [&](Index part) {
      if (part == 0)
      {
        this->model.emplace(piece, problem, energy, options.angleWeight,
          options.cloth ? options.cloth->hold : GrainHold(), filling,
          weightsOf(piece, options.weights));
      }
      else
      {
        Triangles cells = piece.mesh.triangles();
        cells.insert(cells.end(), filling.triangles.begin(), filling.triangles.end());
        this->order = dissectVertices(std::move(cells), *problem.network, start);
      }
    };
    const bool few = 2 * piece.mesh.vertexCount() < threadsFrom;
    const Execution run = few ? execution.onOneThread() : execution;
    run.forEachTask(2, [&pose](Index part) { pose(part); });
    this->order = this->model->eliminationOrder(this->order);
    if (options.rough)
    {
      this->model->keepStiffness();
    }
  }
};

IsometricSolution minimized(IsometricSetup& posed, NewtonKktState start,
  const IsometricOptions& options, bool fromAfar, const Execution& execution)
{
  IsometricModel& model = *posed.model;
  IsometricSolution solution;
  NewtonKktOptions newton = newtonOptions(options);
  newton.maximumFactorizations = allowance(model, 1.0);
  newton.amongSaddles = fromAfar || options.cloth.has_value();
  // Where little is left of triangles, the matrix of one point says little of the next.
  newton.chordReduction = fromAfar ? 0.0 : chordReduction;
  newton.observe = [&](const NewtonKktRecord& record) {
    solution.history.push_back(
      { record.objective, record.violation, record.optimality, record.largestMove, record.exact });
    solution.iterations = record.iteration;
  };
  LinearSolver solver(posed.order,
    model.coordinateCount() < singleFrom ? FactorPrecision::Double : FactorPrecision::Single);
  const bool alone = !options.cloth && model.coordinateCount() < threadsFrom;
  const NewtonKktState end = minimize(model, std::move(start), std::move(solver), newton,
    alone ? execution.onOneThread() : execution);
  solution.factorizations = end.factorizations;
  if (end.cancelled())
  {
    solution = {};
    solution.status = { StatusCode::Cancelled, "cancelled while solving for the piece", {} };
    return solution;
  }
  const IsometricModel::Terms terms = model.terms(end.x, execution);
  solution.positions = model.positions(end.x);
  solution.stretch = model.stretches(end.x);
  solution.distortionEnergy = terms.sheet;
  solution.angleEnergy = terms.angles;
  solution.stiffness = model.stiffness();
  if (!end.converged())
  {
    const bool exhausted = end.termination == Termination::IterationLimit;
    const bool mayGoOn = solution.iterations >= options.maximumIterations;
    const std::string iterations = std::to_string(solution.iterations) + " iterations";
    solution.status = { StatusCode::NotConverged,
      exhausted ? "the isometric scheme did not converge in " + iterations
                : "the isometric scheme stopped short of a minimum after " + iterations +
          ", and more would change nothing",
      {},
      exhausted && mayGoOn ? SuggestedRemedies{ Remedy::AllowIsometricIterations }
                           : SuggestedRemedies{} };
  }
  return solution;
}

/// Takes out what the iteration left of the lengths' errors.
void correctLengths(const AngleProblem& problem, IsometricSolution& solution)
{
  if (solution.status.refused())
  {
    return;
  }
  const WireNetwork& network = *problem.network;
  std::vector<double> length = stretchedLengths(problem, solution.stretch);
  for (Index e = 0; e < network.edgeCount(); ++e)
  {
    const WireEdge& edge = network.edges[e];
    length[e] = problem.held[e]
      ? length[e]
      : (solution.positions[edge.to] - solution.positions[edge.from]).norm();
  }
  correctWireLengths(network, length, solution.positions);
}
}

IsometricSolution warpIsometrically(const Piece& piece, const AngleProblem& problem,
  const Points2& start, const std::vector<double>& startStretch, const IsometricOptions& options,
  const Execution& execution, const BoundaryFilling& filling)
{
  const SheetEnergy energy = options.cloth
    ? SheetEnergy(ClothEnergy(options.cloth->material, options.cloth->limitStiffness))
    : SheetEnergy(options.energy);
  IsometricSetup posed(piece, problem, energy, options, start, execution, filling);
  IsometricSolution solution =
    minimized(posed, { posed.model->unknowns(start, startStretch), {} }, options, false, execution);
  correctLengths(problem, solution);
  return solution;
}

IsometricSolution warpByPenaltyContinuation(const Piece& piece, const AngleProblem& problem,
  const Points2& start, const std::vector<double>& startStretch, const IsometricOptions& options,
  const Execution& execution)
{
  IsometricSetup posed(piece, problem, options.energy, options, start, execution);
  PenaltyDescentOptions descent;
  descent.maximumFactorizations = allowance(*posed.model, descentShare);
  NewtonKktState near = descend(*posed.model, posed.model->unknowns(start, startStretch),
    LinearSolver(posed.order), descent, execution);
  IsometricSolution solution;
  if (near.cancelled())
  {
    solution.status = { StatusCode::Cancelled, "cancelled while solving for the piece", {} };
    return solution;
  }
  const int before = near.factorizations;
  solution = minimized(posed, std::move(near), options, true, execution);
  solution.factorizations += before;
  correctLengths(problem, solution);
  return solution;
}
}
