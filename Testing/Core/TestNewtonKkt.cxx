// SPDX-License-Identifier: BSD-3-Clause
#include "Sparse/LinearSolver.h"
#include "Sparse/NewtonKkt.h"
#include "Sparse/PenaltyDescent.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <numeric>

using namespace flattening;

namespace
{
/// A problem whose matrix is dense, with functions to put in.
struct DenseModel : NewtonKktModel
{
  Index unknowns = 2;
  std::vector<double> bound;
  std::function<double(const Eigen::VectorXd&)> f;
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> gradient;
  std::function<Eigen::MatrixXd(const Eigen::VectorXd&)> hessian;
  /// At most one constraint.
  std::function<double(const Eigen::VectorXd&)> c;
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> cGradient;
  std::function<Eigen::MatrixXd(const Eigen::VectorXd&)> cHessian;

  std::function<bool(const Eigen::VectorXd&)> whenSettling;
  int matrices = 0; ///< that were made

  Index unknownCount() const override { return this->unknowns; }
  bool switchToFinalObjective(const Eigen::VectorXd& multipliers) override
  {
    return this->whenSettling && this->whenSettling(multipliers);
  }
  Index constraintCount() const override { return this->c ? 1 : 0; }
  std::vector<double> bounds() const override { return this->bound; }
  double objective(const Eigen::VectorXd& x, const Execution&) const override { return this->f(x); }
  Eigen::VectorXd constraints(const Eigen::VectorXd& x) const override
  {
    return this->c ? Eigen::VectorXd::Constant(1, this->c(x)) : Eigen::VectorXd();
  }
  double constraintRounding(const Eigen::VectorXd&, double) const override { return 1e-15; }
  std::optional<Linearization> differentiate(const Eigen::VectorXd& x, const Execution&) override
  {
    if (this->c)
    {
      this->Row = this->cGradient(x);
    }
    return Linearization{ this->gradient(x), this->constraints(x) };
  }
  Linearization linearize(const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers, Curvature,
    double delta, const Execution&) override
  {
    ++this->matrices;
    const Index size = this->unknowns + this->constraintCount();
    this->Dense = Eigen::MatrixXd::Zero(size, size);
    this->Dense.topLeftCorner(this->unknowns, this->unknowns) = this->hessian(x);
    if (this->c)
    {
      this->Row = this->cGradient(x);
      this->Dense.topLeftCorner(this->unknowns, this->unknowns) +=
        multipliers[0] * this->cHessian(x);
      this->Dense.bottomLeftCorner(1, this->unknowns) = this->Row.transpose();
      this->Dense(size - 1, size - 1) = -delta;
    }
    this->refresh();
    return { this->gradient(x), this->constraints(x) };
  }
  void shift(double tau) override
  {
    this->Dense.diagonal().head(this->unknowns).array() += tau;
    this->refresh();
  }
  void stiffen(Index k, double stiffness) override
  {
    const Index at = this->unknowns - static_cast<Index>(this->bound.size()) + k;
    this->Dense(at, at) += stiffness;
    this->refresh();
  }
  const SparseMatrix& kkt() const override { return this->Sparse; }
  Eigen::VectorXd transposedJacobianTimes(const Eigen::VectorXd& multipliers) const override
  {
    return this->c ? Eigen::VectorXd(multipliers[0] * this->Row)
                   : Eigen::VectorXd(Eigen::VectorXd::Zero(this->unknowns));
  }

private:
  /// All entries of the lower triangle are there, zeros too, so that the pattern stays.
  void refresh()
  {
    std::vector<Eigen::Triplet<double>> entries;
    for (Index j = 0; j < this->Dense.cols(); ++j)
    {
      for (Index i = j; i < this->Dense.rows(); ++i)
      {
        entries.emplace_back(i, j, this->Dense(i, j));
      }
    }
    this->Sparse.resize(this->Dense.rows(), this->Dense.cols());
    this->Sparse.setFromTriplets(entries.begin(), entries.end());
  }

  Eigen::MatrixXd Dense;
  Eigen::VectorXd Row;
  SparseMatrix Sparse;
};

/// Least of sum (x - goal)^2 / 2.
DenseModel nearestTo(const Eigen::VectorXd& goal)
{
  DenseModel model;
  model.unknowns = static_cast<Index>(goal.size());
  model.f = [goal](const Eigen::VectorXd& x) { return 0.5 * (x - goal).squaredNorm(); };
  model.gradient = [goal](const Eigen::VectorXd& x) { return Eigen::VectorXd(x - goal); };
  model.hessian = [](const Eigen::VectorXd& x) {
    return Eigen::MatrixXd(Eigen::MatrixXd::Identity(x.size(), x.size()));
  };
  return model;
}

/// Least of x H x / 2 + b x, and a constant.
DenseModel quadratic(const Eigen::MatrixXd& h, const Eigen::VectorXd& b, double constant = 0.0)
{
  DenseModel model;
  model.unknowns = static_cast<Index>(b.size());
  model.f = [=](const Eigen::VectorXd& x) { return constant + 0.5 * x.dot(h * x) + b.dot(x); };
  model.gradient = [=](const Eigen::VectorXd& x) { return Eigen::VectorXd(h * x + b); };
  model.hessian = [=](const Eigen::VectorXd&) { return h; };
  return model;
}

/// With all unknowns on the unit circle.
DenseModel onTheCircle(DenseModel model = {})
{
  model.c = [](const Eigen::VectorXd& x) { return 0.5 * (x.squaredNorm() - 1.0); };
  model.cGradient = [](const Eigen::VectorXd& x) { return x; };
  model.cHessian = [](const Eigen::VectorXd& x) {
    return Eigen::MatrixXd(Eigen::MatrixXd::Identity(x.size(), x.size()));
  };
  return model;
}

/// With row x = right.
DenseModel onThePlane(const Eigen::VectorXd& row, double right, DenseModel model)
{
  model.c = [=](const Eigen::VectorXd& x) { return row.dot(x) - right; };
  model.cGradient = [=](const Eigen::VectorXd&) { return row; };
  model.cHessian = [](const Eigen::VectorXd& x) {
    return Eigen::MatrixXd(Eigen::MatrixXd::Zero(x.size(), x.size()));
  };
  return model;
}

/// The orthonormal basis of the cosine transform, the longest wave first.
Eigen::MatrixXd cosines(Index n)
{
  Eigen::MatrixXd waves(n, n);
  for (Index i = 0; i < n; ++i)
  {
    for (Index j = 0; j < n; ++j)
    {
      waves(i, j) =
        std::sqrt((j == 0 ? 1.0 : 2.0) / n) * std::cos(std::acos(-1.0) * (i + 0.5) * j / n);
    }
  }
  return waves;
}

/// One that leaves its unknowns in their order.
LinearSolver inSinglePrecision(const DenseModel& model)
{
  Dissection order;
  order.end = { model.unknowns + model.constraintCount() };
  order.order.resize(order.end.front());
  std::iota(order.order.begin(), order.order.end(), 0);
  return LinearSolver(order, FactorPrecision::Single);
}

NewtonKktState solved(
  DenseModel& model, const Eigen::VectorXd& start, const NewtonKktOptions& options = {})
{
  return minimize(model, { start, {} }, LinearSolver(), options, {});
}
}

TEST(NewtonKkt, KeepsTheFactorInDoublePrecisionWhereSingleIsNotEnough)
{
  // Along the line y = 2 x it is (1e-9 / 2 + 2 + 1.2) x^2 + 2 x. The first pivot is so small that
  // it swamps what the second column says of itself.
  DenseModel model = onThePlane(Eigen::Vector2d(-2.0, 1.0), 0.0,
    quadratic(Eigen::Matrix2d{ { 1e-9, 1.0 }, { 1.0, 0.6 } }, Eigen::Vector2d(0.0, 1.0)));
  const NewtonKktState end =
    minimize(model, { Eigen::Vector2d(3.0, 1.0), {} }, inSinglePrecision(model), {}, {});
  EXPECT_TRUE(end.converged());
  EXPECT_NEAR(end.x[0], -2.0 / (1e-9 + 6.4), 1e-9);
  EXPECT_LE(model.matrices, 3);
}

TEST(NewtonKkt, AFactorInSinglePrecisionEndsAtTheSameMinimumWhereTheMultiplierIsLarge)
{
  // Least of x H x / 2 + (s a + b) x with a x = 0, which s does not move: H x + b + m a = 0 gives
  // x, and s is taken from the multiplier; a larger s leaves rounding in the gradient above its
  // tolerance. H reaches from 1 to 1e5 along the waves of a cosine transform.
  constexpr Index n = 12;
  constexpr double s = 1e5;
  const Eigen::MatrixXd waves = cosines(n);
  const Eigen::VectorXd bent =
    pow(10.0, Eigen::ArrayXd::LinSpaced(n, 0.0, 5.0)).matrix(); // curvatures
  const Eigen::MatrixXd h = waves * bent.asDiagonal() * waves.transpose();
  const Eigen::VectorXd a = Eigen::VectorXd::LinSpaced(n, 0.3, 1.7);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, -1.0, 2.0);
  DenseModel model = onThePlane(a, 0.0, quadratic(h, s * a + b, 1.0));
  NewtonKktOptions options;
  options.stepTolerance = 0.0;

  const NewtonKktState end =
    minimize(model, { Eigen::VectorXd::Zero(n), {} }, inSinglePrecision(model), options, {});

  EXPECT_TRUE(end.converged());
  EXPECT_LE(model.matrices, 6);
  const Eigen::VectorXd bySpectrum =
    waves * bent.cwiseInverse().asDiagonal() * waves.transpose() * b;
  const Eigen::VectorXd along = waves * bent.cwiseInverse().asDiagonal() * waves.transpose() * a;
  const Eigen::VectorXd expected = a.dot(bySpectrum) / a.dot(along) * along - bySpectrum;
  EXPECT_LT((end.x - expected).norm(), 1e-7 * expected.norm());
}

TEST(NewtonKkt, AFactorInSinglePrecisionStaysWhereRefiningLeavesLittle)
{
  // Least of x H x / 2 - b x with a x = 0, b along the softest wave, whose curvature is 1e-7 of the
  // stiffest one's: x is so large beside b that rounding of H leaves half of b at first.
  constexpr Index n = 200;
  const Eigen::MatrixXd waves = cosines(n);
  const Eigen::VectorXd bent = pow(10.0, Eigen::ArrayXd::LinSpaced(n, -7.0, 0.0)).matrix();
  const Eigen::MatrixXd h = waves * bent.asDiagonal() * waves.transpose();
  const Eigen::VectorXd b = 1e-3 * waves.col(0);
  DenseModel model = onThePlane(waves.col(1), 0.0, quadratic(h, -b, 1.0));
  std::atomic<std::int64_t> work{ 0 };
  Execution execution;
  execution.factorized = &work;

  const NewtonKktState end =
    minimize(model, { Eigen::VectorXd::Zero(n), {} }, inSinglePrecision(model), {}, execution);

  EXPECT_TRUE(end.converged());
  EXPECT_LT((end.x - 1e7 * b).norm(), 1e7 * 1e-6 * b.norm());
  EXPECT_EQ(work, std::llround(factorizationWork(n + 1))); // of one
}

TEST(NewtonKkt, FindsTheNearestPointOfALineInOneStepAndItsMultiplier)
{
  DenseModel model =
    onThePlane(Eigen::VectorXd::Ones(2), 1.0, nearestTo(Eigen::Vector2d(0.0, 0.0)));
  int steps = 0;
  NewtonKktOptions options;
  options.observe = [&](const NewtonKktRecord& record) { steps = record.iteration; };
  const NewtonKktState end = solved(model, Eigen::Vector2d(7.0, -3.0), options);
  EXPECT_TRUE(end.converged());
  EXPECT_EQ(steps, 1);
  EXPECT_LT((end.x - Eigen::Vector2d(0.5, 0.5)).norm(), 1e-12);
  // gradient + multiplier * (1, 1) = 0
  EXPECT_NEAR(end.multipliers[0], -0.5, 1e-12);
}

TEST(NewtonKkt, AModelSettlesOnceWithTheMultipliersAtItsMinimumAndIsSolvedAnew)
{
  // The point of the circle next to (2, 0), where the multiplier is 1; then that next to (0, 3).
  DenseModel model = onTheCircle(nearestTo(Eigen::Vector2d(2.0, 0.0)));
  std::vector<double> told;
  model.whenSettling = [&](const Eigen::VectorXd& multipliers) {
    told.push_back(multipliers[0]);
    const DenseModel other = nearestTo(Eigen::Vector2d(0.0, 3.0));
    model.f = other.f;
    model.gradient = other.gradient;
    return true;
  };
  const NewtonKktState end = solved(model, Eigen::Vector2d(0.8, 0.5));
  EXPECT_TRUE(end.converged());
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NEAR(told[0], 1.0, 1e-6);
  EXPECT_LT((end.x - Eigen::Vector2d(0.0, 1.0)).norm(), 1e-9);
  EXPECT_NEAR(end.multipliers[0], 2.0, 1e-9);
}

TEST(NewtonKkt, CorrectionsOfShorterStepsGoRoundASharpBend)
{
  // Along a narrow ring, nearly half round it: each step leaves the ring by the square of its
  // length.
  const auto iterations = [](int corrections) {
    DenseModel model = onTheCircle(nearestTo(Eigen::Vector2d(-100.0, 0.0)));
    int steps = 0;
    NewtonKktOptions options;
    options.corrections = corrections;
    options.observe = [&](const NewtonKktRecord& record) { steps = record.iteration; };
    const NewtonKktState end =
      solved(model, Eigen::Vector2d(std::cos(0.1), std::sin(0.1)), options);
    EXPECT_TRUE(end.converged());
    EXPECT_LT((end.x - Eigen::Vector2d(-1.0, 0.0)).norm(), 1e-9);
    return steps;
  };
  EXPECT_LT(iterations(5), iterations(0));
}

TEST(NewtonKkt, EndsAtAMinimumNotAtASaddleWhereTheHessianIsIndefinite)
{
  // x y on the unit circle: maxima on the diagonal, minima -1/2 across it. The start lies next to
  // a maximum, where Newton's method without regard to the inertia stays.
  DenseModel model =
    onTheCircle(quadratic(Eigen::Matrix2d{ { 0.0, 1.0 }, { 1.0, 0.0 } }, Eigen::Vector2d::Zero()));
  const NewtonKktState end = solved(model, Eigen::Vector2d(0.71, 0.70));
  EXPECT_TRUE(end.converged());
  EXPECT_NEAR(end.x[0] * end.x[1], -0.5, 1e-9);
  EXPECT_NEAR(end.x.squaredNorm(), 1.0, 1e-9);
}

TEST(NewtonKkt, AnUnknownGoesToItsBoundExactlyAndTheOthersAdapt)
{
  // Nearest point to (2, 1) with x + y = 3 would be itself; with |y| <= 0.25 it is (2.75, 0.25).
  DenseModel model =
    onThePlane(Eigen::VectorXd::Ones(2), 3.0, nearestTo(Eigen::Vector2d(2.0, 1.0)));
  model.bound = { 0.25 };
  const NewtonKktState end = solved(model, Eigen::Vector2d(0.0, 0.0));
  EXPECT_TRUE(end.converged());
  EXPECT_EQ(end.x[1], 0.25);
  EXPECT_NEAR(end.x[0], 2.75, 1e-14);
  EXPECT_NEAR(end.multipliers[0], -0.75, 1e-12);
}

TEST(NewtonKkt, UnknownsThatStartOnTheirBoundsAreHeldOrFreedAtOnce)
{
  // Nearest point of a box to a point: each coordinate clamped by itself.
  Eigen::VectorXd goal(12);
  for (Index k = 0; k < goal.size(); ++k)
  {
    goal[k] = std::sin(3.0 * k);
  }
  for (const double start : { 0.5, -0.5 })
  {
    DenseModel model = nearestTo(goal);
    model.bound.assign(12, 0.5);
    const NewtonKktState end = solved(model, Eigen::VectorXd::Constant(12, start));
    EXPECT_TRUE(end.converged());
    EXPECT_LT((end.x - goal.cwiseMax(-0.5).cwiseMin(0.5)).norm(), 1e-12) << start;
  }
}

TEST(NewtonKkt, StepsByAnEarlierMatrixEndWhereThoseByTheirOwnDoWithFewerMatrices)
{
  // Least of a quartic on the circle, from near and from far.
  for (const double angle : { 0.3, 1.4 })
  {
    const auto solve = [&](double chordReduction) {
      DenseModel model = onTheCircle();
      const Eigen::Vector2d goal(0.3, 2.0);
      model.f = [=](const Eigen::VectorXd& x) {
        return 0.5 * (x - goal).squaredNorm() + 0.25 * (x - goal).array().pow(4).sum();
      };
      model.gradient = [=](const Eigen::VectorXd& x) {
        return Eigen::VectorXd((x - goal).array() + (x - goal).array().cube());
      };
      model.hessian = [=](const Eigen::VectorXd& x) {
        return Eigen::MatrixXd(
          Eigen::VectorXd(1.0 + 3.0 * (x - goal).array().square()).asDiagonal());
      };
      NewtonKktOptions options;
      options.chordReduction = chordReduction;
      const NewtonKktState end =
        solved(model, Eigen::Vector2d(std::cos(angle), std::sin(angle)), options);
      EXPECT_TRUE(end.converged());
      return std::make_pair(end, model.matrices);
    };
    const auto [own, ownMatrices] = solve(0.0);
    const auto [followed, fewerMatrices] = solve(0.25);
    EXPECT_LT((own.x - followed.x).norm(), 1e-9);
    EXPECT_NEAR(own.multipliers[0], followed.multipliers[0], 1e-8);
    EXPECT_LT(fewerMatrices, ownMatrices);
  }
}

TEST(PenaltyDescent, GivesTheMultipliersOfItsLastWeightWhereverItEnds)
{
  // The point of x + y = 1 that is nearest to (2, 2) has the multiplier 1.5. It starts so near to
  // the constraint that the first descent settles.
  for (const bool another : { false, true })
  {
    for (const int steps : { 1, 2, 100 })
    {
      for (const double offset : { -0.01, 0.0, 0.02 })
      {
        SCOPED_TRACE(std::to_string(another) + ", " + std::to_string(steps) + " steps, from " +
          std::to_string(offset));
        DenseModel model =
          onThePlane(Eigen::VectorXd::Ones(2), 1.0, nearestTo(Eigen::Vector2d(2.0, 2.0)));
        model.whenSettling = [another](const Eigen::VectorXd&) { return another; };
        PenaltyDescentOptions options;
        options.maxSteps = steps;
        const NewtonKktState end =
          descend(model, Eigen::Vector2d(0.3, 0.7 + offset), LinearSolver(), options, {});
        EXPECT_NEAR(end.multipliers[0], 1.5, 1e-3);
      }
    }
  }
}
