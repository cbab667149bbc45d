// SPDX-License-Identifier: BSD-3-Clause
// The isometric scheme's problem once more, written down from its definition and solved by other
// means: an augmented Lagrangian, minimized by a quasi-Newton method from gradients alone. How
// stiff the wires are is taken from the scheme; TestWireStiffness.cxx holds that against the
// mechanics.
#include "Flattened.h"
#include "Isometric/IsometricWarping.h"
#include "WiredSurface.h"

#include <gtest/gtest.h>

#include <deque>
#include <random>

using namespace flattening;
using namespace testmeshes;

namespace
{
/// sum a_t |J - R|^2 + sum k_i (theta_i - alpha_i)^2 under exact lengths, in units of the root of
/// the mean triangle area.
class Problem
{
public:
  explicit Problem(const Surface& surface)
    : Wired(surface)
  {
    const TriangleMesh& mesh = this->Wired.piece.mesh;
    double area = 0.0;
    for (const Triangle& c : mesh.triangles())
    {
      const Point3 u = mesh.point(c[1]) - mesh.point(c[0]);
      const Point3 v = mesh.point(c[2]) - mesh.point(c[0]);
      area += 0.5 * u.cross(v).norm();
      Eigen::Matrix2d sides;
      sides << u.norm(), u.dot(v) / u.norm(), 0.0, u.cross(v).norm() / u.norm();
      this->Sides.push_back(sides);
    }
    this->Unit = std::sqrt(area / mesh.triangleCount());
    this->solve(surface);
    for (Eigen::Matrix2d& sides : this->Sides)
    {
      sides /= this->Unit;
    }
  }

  Eigen::VectorXd unknowns(const FlatteningResult& result) const
  {
    Eigen::VectorXd x(2 * this->Wired.piece.mesh.vertexCount());
    for (Index v = 0; v < this->Wired.piece.mesh.vertexCount(); ++v)
    {
      x.segment<2>(2 * v) = result.positions[this->Wired.piece.vertices[v]] / this->Unit;
    }
    return x;
  }

  double energy(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) const
  {
    double sum = 0.0;
    gradient.setZero(x.size());
    const Triangles& triangles = this->Wired.piece.mesh.triangles();
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      const Triangle& c = triangles[t];
      const Eigen::Matrix2d inverse = this->Sides[t].inverse();
      Eigen::Matrix2d flat;
      flat << x.segment<2>(2 * c[1]) - x.segment<2>(2 * c[0]),
        x.segment<2>(2 * c[2]) - x.segment<2>(2 * c[0]);
      const Eigen::Matrix2d map = flat * inverse;
      // The nearest rotation.
      Point2 q(map(0, 0) + map(1, 1), map(1, 0) - map(0, 1));
      q.normalize();
      Eigen::Matrix2d rest = map;
      rest -= (Eigen::Matrix2d() << q.x(), -q.y(), q.y(), q.x()).finished();
      const double area = 0.5 * this->Sides[t].determinant();
      sum += area * rest.squaredNorm();
      const Eigen::Matrix2d slope = 2.0 * area * rest * inverse.transpose();
      gradient.segment<2>(2 * c[1]) += slope.col(0);
      gradient.segment<2>(2 * c[2]) += slope.col(1);
      gradient.segment<2>(2 * c[0]) -= slope.col(0) + slope.col(1);
    }
    const WireNetwork& net = this->Wired.network;
    for (Index i = 0; i < net.nodeCount(); ++i)
    {
      const Index before = net.vertex[net.previous[i]];
      const Index at = net.vertex[i];
      const Index after = net.endVertex(i);
      const Point2 in = x.segment<2>(2 * before) - x.segment<2>(2 * at);
      const Point2 out = x.segment<2>(2 * after) - x.segment<2>(2 * at);
      const double angle = std::atan2(in.y(), in.x()) - std::atan2(out.y(), out.x());
      const double change = std::remainder(angle - net.alpha[i], 2.0 * pi);
      const double stiffness = this->Solution.stiffness[i];
      sum += stiffness * change * change;
      const Point2 byIn = 2.0 * stiffness * change / in.squaredNorm() * Point2(-in.y(), in.x());
      const Point2 byOut =
        -2.0 * stiffness * change / out.squaredNorm() * Point2(-out.y(), out.x());
      gradient.segment<2>(2 * before) += byIn;
      gradient.segment<2>(2 * after) += byOut;
      gradient.segment<2>(2 * at) -= byIn + byOut;
    }
    return sum;
  }

  /// By how much each wire edge is too long.
  Eigen::VectorXd lengthErrors(const Eigen::VectorXd& x) const
  {
    const std::vector<WireEdge>& edges = this->Wired.network.edges;
    Eigen::VectorXd errors(edges.size());
    for (std::size_t e = 0; e < edges.size(); ++e)
    {
      errors[e] = (x.segment<2>(2 * edges[e].to) - x.segment<2>(2 * edges[e].from)).norm() -
        edges[e].length / this->Unit;
    }
    return errors;
  }

  /// Energy, plus the lengths with their multipliers and penalty.
  double lagrangian(const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers, double penalty,
    Eigen::VectorXd& gradient) const
  {
    const double sum = this->energy(x, gradient);
    const Eigen::VectorXd errors = this->lengthErrors(x);
    const Eigen::VectorXd force = multipliers + penalty * errors;
    for (Index e = 0; e < errors.size(); ++e)
    {
      const WireEdge& edge = this->Wired.network.edges[e];
      const Point2 along =
        (x.segment<2>(2 * edge.to) - x.segment<2>(2 * edge.from)).normalized() * force[e];
      gradient.segment<2>(2 * edge.to) += along;
      gradient.segment<2>(2 * edge.from) -= along;
    }
    return sum + multipliers.dot(errors) + 0.5 * penalty * errors.squaredNorm();
  }

private:
  void solve(const Surface& surface)
  {
    const FlatteningResult start = flatten(surface, withScheme(Scheme::Global));
    Points2 positions;
    for (Index v : this->Wired.piece.vertices)
    {
      positions.push_back(start.positions[v]);
    }
    const AngleProblem problem = this->Wired.problem();
    this->Solution = warpIsometrically(this->Wired.piece, problem, positions, {}, {}, {});
  }

  WiredSurface Wired;
  IsometricSolution Solution;
  std::vector<Eigen::Matrix2d> Sides; ///< of each triangle, in its own plane
  double Unit = 1.0;
};

/// Limited-memory BFGS with halved steps.
template <typename Function>
void minimize(const Function& function, Eigen::VectorXd& x)
{
  struct Pair
  {
    Eigen::VectorXd step;
    Eigen::VectorXd change;
  };
  std::deque<Pair> pairs;
  Eigen::VectorXd gradient;
  double value = function(x, gradient);
  for (int iteration = 0; iteration < 300 && gradient.norm() > 1e-6; ++iteration)
  {
    Eigen::VectorXd direction = -gradient;
    std::vector<double> share;
    for (auto pair = pairs.rbegin(); pair != pairs.rend(); ++pair)
    {
      share.push_back(pair->step.dot(direction) / pair->step.dot(pair->change));
      direction -= share.back() * pair->change;
    }
    if (!pairs.empty())
    {
      direction *= pairs.back().step.dot(pairs.back().change) / pairs.back().change.squaredNorm();
    }
    for (const Pair& pair : pairs)
    {
      direction +=
        (share.back() - pair.change.dot(direction) / pair.step.dot(pair.change)) * pair.step;
      share.pop_back();
    }
    Eigen::VectorXd moved;
    Eigen::VectorXd movedGradient;
    double scale = pairs.empty() ? 1e-3 : 1.0;
    double movedValue = 0.0;
    do
    {
      moved = x + scale * direction;
      movedValue = function(moved, movedGradient);
      scale *= 0.5;
    } while (movedValue > value + 1e-4 * scale * gradient.dot(direction) && scale > 1e-12);
    Pair pair{ moved - x, movedGradient - gradient };
    x = moved;
    value = movedValue;
    gradient = movedGradient;
    if (pair.step.dot(pair.change) > 1e-16)
    {
      pairs.push_back(std::move(pair));
    }
    if (pairs.size() > 20)
    {
      pairs.pop_front();
    }
  }
}

/// The least energy under the lengths that is found from x on.
double solveOtherwise(const Problem& problem, Eigen::VectorXd& x)
{
  const double penalty = 100.0;
  Eigen::VectorXd multipliers = Eigen::VectorXd::Zero(problem.lengthErrors(x).size());
  for (int round = 0; round < 30; ++round)
  {
    if (round > 0 && problem.lengthErrors(x).cwiseAbs().maxCoeff() < 1e-8)
    {
      break;
    }
    minimize(
      [&](const Eigen::VectorXd& at, Eigen::VectorXd& gradient) {
        return problem.lagrangian(at, multipliers, penalty, gradient);
      },
      x);
    multipliers += penalty * problem.lengthErrors(x);
  }
  Eigen::VectorXd gradient;
  return problem.energy(x, gradient);
}

Surface smallCushion()
{
  Surface surface = cushion(6, 7, 0.3);
  surface.curves = { columnCurve(6, 7, 3), rowCurve(6, 4) };
  return surface;
}

}

TEST(IsometricMinimum, AnotherMinimizerFindsNothingBelow)
{
  const Surface surface = smallCushion();
  const Problem problem(surface);
  const FlatteningResult result = flatten(surface);
  ASSERT_TRUE(result.status.ok()) << result.status.message;
  const Eigen::VectorXd solution = problem.unknowns(result);
  Eigen::VectorXd gradient;
  const double least = problem.energy(solution, gradient);
  EXPECT_LT(problem.lengthErrors(solution).cwiseAbs().maxCoeff(), 1e-11);

  const Eigen::VectorXd global = problem.unknowns(flatten(surface, withScheme(Scheme::Global)));
  EXPECT_GT(problem.energy(global, gradient), 1.005 * least) << "the start is the answer already";
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-0.3, 0.3);
  for (int start = 0; start < 4; ++start)
  {
    Eigen::VectorXd x = global;
    for (Index k = 0; k < x.size() && start > 0; ++k)
    {
      x[k] += uniform(random);
    }
    const double found = solveOtherwise(problem, x);
    EXPECT_LT(problem.lengthErrors(x).cwiseAbs().maxCoeff(), 1e-8) << "start " << start;
    EXPECT_NEAR(found, least, 1e-6 * least) << "start " << start;
  }
}

TEST(IsometricMinimum, TheReportedEnergiesAreThoseOfThePositions)
{
  const Surface surface = smallCushion();
  const Problem problem(surface);
  const FlatteningResult result = flatten(surface);
  Eigen::VectorXd gradient;
  const double energy = problem.energy(problem.unknowns(result), gradient);
  const PieceReport& report = result.pieces[0];
  // The last correction of lengths comes after them.
  EXPECT_NEAR(report.distortionEnergy + report.angleEnergy, energy, 1e-9 * energy);
  EXPECT_GT(report.distortionEnergy, 0.0);
  EXPECT_GT(report.angleEnergy, 0.0);
}
