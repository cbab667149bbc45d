// SPDX-License-Identifier: BSD-3-Clause
#include "SystemSolver.h"

#include "Base/Stopwatch.h"

#include <cholmod.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace benchmarks
{
using namespace flattening;

namespace
{
double residual(const SystemCase& system, const Eigen::MatrixXd& x)
{
  const Eigen::MatrixXd left = system.lower.selfadjointView<Eigen::Lower>() * x;
  return (left - system.rightHandSide).cwiseAbs().maxCoeff() /
    system.rightHandSide.cwiseAbs().maxCoeff();
}

class Cholmod
{
public:
  Cholmod() { cholmod_start(&this->Common); }
  ~Cholmod()
  {
    cholmod_free_factor(&this->Factor, &this->Common);
    cholmod_finish(&this->Common);
  }
  Cholmod(const Cholmod&) = delete;
  Cholmod& operator=(const Cholmod&) = delete;

  SolverTimes solve(const SystemCase& system, Ordering ordering)
  {
    SolverTimes times;
    cholmod_sparse matrix = view(system.lower);
    this->prefer(ordering, system.definite);
    std::vector<int> own(system.order.order.begin(), system.order.order.end());
    Stopwatch watch;
    // METIS and AMD order within the analysis.
    this->Factor = ordering == Ordering::Own
      ? cholmod_analyze_p(&matrix, own.data(), nullptr, 0, &this->Common)
      : cholmod_analyze(&matrix, &this->Common);
    times.analyze = watch.seconds();
    times.entries = this->Common.lnz;
    watch = {};
    if (!this->Factor || !cholmod_factorize(&matrix, this->Factor, &this->Common) ||
      this->Common.status != CHOLMOD_OK)
    {
      throw std::runtime_error("CHOLMOD gives no factor of " + system.name);
    }
    times.factor = watch.seconds();
    watch = {};
    const Eigen::MatrixXd x = this->substitute(system.rightHandSide);
    times.solve = watch.seconds();
    times.residual = residual(system, x);
    return times;
  }

private:
  static cholmod_sparse view(const SparseMatrix& lower)
  {
    cholmod_sparse matrix{};
    matrix.nrow = matrix.ncol = static_cast<std::size_t>(lower.rows());
    matrix.nzmax = static_cast<std::size_t>(lower.nonZeros());
    matrix.p = const_cast<int*>(lower.outerIndexPtr());
    matrix.i = const_cast<int*>(lower.innerIndexPtr());
    matrix.x = const_cast<double*>(lower.valuePtr());
    matrix.stype = -1;
    matrix.itype = CHOLMOD_INT;
    matrix.xtype = CHOLMOD_REAL;
    matrix.dtype = CHOLMOD_DOUBLE;
    matrix.sorted = 1;
    matrix.packed = 1;
    return matrix;
  }

  void prefer(Ordering ordering, bool definite)
  {
    this->Common.nmethods = 1;
    this->Common.method[0].ordering = ordering == Ordering::Own ? CHOLMOD_GIVEN
      : ordering == Ordering::MinimumDegree                     ? CHOLMOD_AMD
                                                                : CHOLMOD_METIS;
    this->Common.supernodal = definite ? CHOLMOD_SUPERNODAL : CHOLMOD_SIMPLICIAL;
    this->Common.final_ll = definite ? 1 : 0;
    this->Common.print = 0;
  }

  Eigen::MatrixXd substitute(const Eigen::MatrixXd& rightHandSide)
  {
    cholmod_dense b{};
    b.nrow = b.d = static_cast<std::size_t>(rightHandSide.rows());
    b.ncol = static_cast<std::size_t>(rightHandSide.cols());
    b.nzmax = static_cast<std::size_t>(rightHandSide.size());
    b.x = const_cast<double*>(rightHandSide.data());
    b.xtype = CHOLMOD_REAL;
    b.dtype = CHOLMOD_DOUBLE;
    cholmod_dense* x = cholmod_solve(CHOLMOD_A, this->Factor, &b, &this->Common);
    if (!x)
    {
      throw std::runtime_error("CHOLMOD does not solve");
    }
    const Eigen::MatrixXd result = Eigen::Map<Eigen::MatrixXd>(
      static_cast<double*>(x->x), rightHandSide.rows(), rightHandSide.cols());
    cholmod_free_dense(&x, &this->Common);
    return result;
  }

  cholmod_common Common{};
  cholmod_factor* Factor = nullptr;
};
}

SolverTimes solveByCholmod(const SystemCase& system, Ordering ordering)
{
  return Cholmod().solve(system, ordering);
}

SolverTimes solveByOwn(const SystemCase& system, const Execution& execution)
{
  SolverTimes times;
  Stopwatch watch;
  LinearSolver solver(system.order);
  if (!solver.analyze(system.lower))
  {
    throw std::runtime_error("no structure of " + system.name);
  }
  times.analyze = system.orderSeconds + watch.seconds();
  watch = {};
  if (!solver.factorize(system.lower, execution))
  {
    throw std::runtime_error("no factor of " + system.name);
  }
  times.factor = watch.seconds();
  watch = {};
  const Eigen::MatrixXd x = solver.solve(system.rightHandSide);
  times.solve = watch.seconds();
  times.residual = residual(system, x);
  return times;
}
}
