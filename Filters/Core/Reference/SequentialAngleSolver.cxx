// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/SequentialAngleSolver.h"

#include "Angles/AngleSolver.h"
#include "Base/Types.h"
#include "Reference/SuperLUFactorization.h"
#include "Sparse/LinearSolver.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// Change of the free angles and the new multipliers from one linearization, both empty on failure.
struct Step
{
  Eigen::VectorXd angles;
  Eigen::VectorXd multipliers;
};

/// Eq. 15 with its unknown lambda taken as the new multiplier instead of its change, which is the
/// same step: [I H^T; H 0] [d; lambda] = [alpha - theta; -r].
Step globalStep(const Eigen::SparseMatrix<double>& H, const Eigen::VectorXd& gradient,
  const Eigen::VectorXd& residual)
{
  const Eigen::Index n = H.cols();
  const Eigen::Index m = H.rows();
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(n + 2 * H.nonZeros()));
  for (Eigen::Index i = 0; i < n; ++i)
  {
    entries.emplace_back(i, i, 1.0);
  }
  for (Eigen::Index column = 0; column < n; ++column)
  {
    for (Eigen::SparseMatrix<double>::InnerIterator it(H, column); it; ++it)
    {
      entries.emplace_back(n + it.row(), column, it.value());
      entries.emplace_back(column, n + it.row(), it.value());
    }
  }
  // A constraint whose angles are all locked has nothing to say to the step.
  std::vector<char> empty(static_cast<std::size_t>(m), 1);
  for (Eigen::Index k = 0; k < H.nonZeros(); ++k)
  {
    empty[H.innerIndexPtr()[k]] = 0;
  }
  for (Eigen::Index row = 0; row < m; ++row)
  {
    entries.emplace_back(n + row, n + row, empty[row] ? -1.0 : 0.0);
  }
  SparseMatrix kkt(n + m, n + m);
  kkt.setFromTriplets(entries.begin(), entries.end());
  Eigen::VectorXd rhs(n + m);
  rhs << -gradient, -residual;
  SuperLUFactorization factors;
  if (!factors.factorize(kkt))
  {
    // Dependent constraints: a small block makes the system regular, refinement takes it out.
    SparseMatrix regular = kkt;
    for (Eigen::Index row = n; row < n + m; ++row)
    {
      regular.coeffRef(row, row) -= regularization;
    }
    if (!factors.factorize(regular))
    {
      return {};
    }
  }
  Eigen::VectorXd x = factors.solve(rhs);
  if (!isFinite(x))
  {
    return {};
  }
  const Eigen::VectorXd left = rhs - kkt * x;
  x += factors.solve(left);
  return { x.head(n), x.tail(m) };
}

/// Eqs. 6 and 7 by singular value decomposition.
Step loopStep(const Eigen::SparseMatrix<double>& H, const Eigen::VectorXd& gradient,
  const Eigen::VectorXd& residual)
{
  const Eigen::MatrixXd normal = Eigen::MatrixXd(H * H.transpose());
  // A square matrix needs no QR decomposition first.
  Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::NoQRPreconditioner> svd(
    normal, Eigen::ComputeFullU | Eigen::ComputeFullV);
  svd.setThreshold(1e-12);
  const Eigen::VectorXd multipliers = svd.solve(residual - H * gradient);
  return { -gradient - H.transpose() * multipliers, multipliers };
}

AngleSolution iterate(const AngleProblem& problem, const AngleSolverOptions& options,
  const Execution& execution, decltype(loopStep) step)
{
  const WireNetwork& net = *problem.network;
  const AngleConstraints constraints(problem);
  const Indices& freeNodes = constraints.freeNodes();
  const double size = perimeter(problem);

  AngleSolution solution;
  solution.length = problem.length;
  solution.theta = problem.target;
  for (Index i = 0; i < net.nodeCount(); ++i)
  {
    if (problem.locks.locked[i])
    {
      solution.theta[i] = problem.locks.angle[i];
    }
  }
  // Closures in units of the size, so that the system does not depend on the unit of length.
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(constraints.rowCount());
  for (Index loop = 0; loop < net.loopCount(); ++loop)
  {
    scale[3 * loop + 1] = scale[3 * loop + 2] = 1.0 / size;
  }
  Eigen::VectorXd multipliers = Eigen::VectorXd::Zero(constraints.rowCount());
  auto storeMultipliers = [&] {
    solution.multiplierX.resize(net.loopCount());
    solution.multiplierY.resize(net.loopCount());
    for (Index loop = 0; loop < net.loopCount(); ++loop)
    {
      solution.multiplierX[loop] = multipliers[3 * loop + 1] / size;
      solution.multiplierY[loop] = multipliers[3 * loop + 2] / size;
    }
  };
  bool converged = false;
  double stepSize = 0.0;
  for (int iteration = 0;; ++iteration)
  {
    const Eigen::SparseMatrix<double> H = scale.asDiagonal() * constraints.jacobian(solution.theta);
    const Eigen::VectorXd residual = scale.asDiagonal() * constraints.residual(solution.theta);
    Eigen::VectorXd gradient(constraints.freeCount());
    for (Index k = 0; k < constraints.freeCount(); ++k)
    {
      const Index node = freeNodes[k];
      gradient[k] = problem.weight[node] * (solution.theta[node] - problem.target[node]);
    }
    IterationRecord record;
    record.phase = "sequential";
    record.objective = angleObjective(problem, solution.theta);
    record.closure = residual.size() ? residual.cwiseAbs().maxCoeff() : 0.0;
    record.optimality =
      gradient.size() ? (gradient + H.transpose() * multipliers).cwiseAbs().maxCoeff() : 0.0;
    record.step = stepSize;
    solution.history.push_back(record);
    solution.iterations = iteration;
    if (record.closure < options.closureTolerance &&
      record.optimality < options.optimalityTolerance)
    {
      converged = true;
      break;
    }
    if (iteration >= options.maximumIterations || !std::isfinite(record.objective))
    {
      break;
    }
    if (execution.cancelled())
    {
      solution.status = { StatusCode::Cancelled, "cancelled while solving for the wires", {} };
      return solution;
    }
    const Step change = step(H, gradient, residual);
    if (change.angles.size() == 0 || !isFinite(change.angles) || !isFinite(change.multipliers))
    {
      break;
    }
    for (Index k = 0; k < constraints.freeCount(); ++k)
    {
      solution.theta[freeNodes[k]] += change.angles[k];
    }
    multipliers = change.multipliers;
    stepSize = change.angles.norm() / std::sqrt(std::max<double>(1.0, constraints.freeCount()));
  }
  storeMultipliers();
  solution.sideDirection = sideDirections(net, solution.theta);
  solution.objective = angleObjective(problem, solution.theta);
  solution.closure = closureResidual(net, solution.theta, problem.length);
  if (!converged)
  {
    solution.status = { StatusCode::NotConverged,
      "the sequential iteration did not converge in " + std::to_string(solution.iterations) +
        " iterations",
      {}, { Remedy::UseNewton } };
  }
  return solution;
}
}

AngleSolution solveAnglesSequentially(
  const AngleProblem& problem, const AngleSolverOptions& options, const Execution& execution)
{
  AngleSolution solution =
    iterate(problem, options, execution, problem.network->loopCount() == 1 ? loopStep : globalStep);
  solution.method = AngleMethod::Sequential;
  return solution;
}

AngleSolution solveAngles(
  const AngleProblem& problem, const AngleSolverOptions& options, const Execution& execution)
{
  return options.method == AngleMethod::Sequential && problem.groups.empty()
    ? solveAnglesSequentially(problem, options, execution)
    : solveAnglesByNewton(problem, options, execution);
}
}
