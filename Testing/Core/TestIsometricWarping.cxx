// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/WireLayout.h"
#include "Flattened.h"
#include "Isometric/IsometricModel.h"
#include "Isometric/IsometricWarping.h"
#include "ModelDerivatives.h"
#include "WiredSurface.h"

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
    this->Unit = std::sqrt(mesh.area() / mesh.triangleCount());
    for (const Triangle& c : mesh.triangles())
    {
      const Point3 u = (mesh.point(c[1]) - mesh.point(c[0])) / this->Unit;
      const Point3 v = (mesh.point(c[2]) - mesh.point(c[0])) / this->Unit;
      Eigen::Matrix2d sides;
      sides << u.norm(), u.dot(v) / u.norm(), 0.0, u.cross(v).norm() / u.norm();
      this->Sides.push_back(sides);
    }
    const FlatteningResult start = flatten(surface, withScheme(Scheme::Global));
    Points2 positions;
    for (Index v : this->Wired.piece.vertices)
    {
      positions.push_back(start.positions[v]);
    }
    const AngleProblem problem = this->Wired.problem();
    this->Solution = warpIsometrically(this->Wired.piece, problem, positions, {}, {}, {});
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
  WiredSurface Wired;
  IsometricSolution Solution;
  std::vector<Eigen::Matrix2d> Sides; ///< of each triangle, in its own plane
  double Unit = 1.0;
};

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
    minimizeByGradients(
      [&](const Eigen::VectorXd& at, Eigen::VectorXd& gradient) {
        return problem.lagrangian(at, multipliers, penalty, gradient);
      },
      x, 300, 1e-6);
    multipliers += penalty * problem.lengthErrors(x);
  }
  Eigen::VectorXd gradient;
  return problem.energy(x, gradient);
}

Surface smallCushion()
{
  return withCurves(cushion(6, 7, 0.3), { columnCurve(6, 7, 3), rowCurve(6, 4) });
}
}

TEST(IsometricMinimum, AnotherMinimizerFindsNothingBelow)
{
  const Surface surface = smallCushion();
  const Problem problem(surface);
  const FlatteningResult result = flattenOk(surface);
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

namespace
{
/// A cushion with a key, an elastic and a rigid curve, a little away from its flat layout.
struct Example
{
  WiredSurface wired;
  AngleProblem problem;

  Example()
    : wired(cushion(6, 8, 0.25).mesh,
        { columnCurve(6, 8, 3, CurveType::Key), rowCurve(6, 3), rowCurve(6, 6) })
    , problem(wired.problem())
  {
    this->problem.groups.push_back({ 0.05, 0.1 });
    for (Index e = 0; e < this->wired.network.edgeCount(); ++e)
    {
      this->problem.stretchGroup[e] = this->wired.network.edges[e].curve == 1 ? 0 : none;
    }
  }

  static Eigen::VectorXd multipliers(const IsometricModel& model)
  {
    Eigen::VectorXd result(model.constraintCount());
    for (Index k = 0; k < result.size(); ++k)
    {
      result[k] = std::sin(1.7 * k);
    }
    return result;
  }

  Eigen::VectorXd point(const IsometricModel& model) const
  {
    Points2 positions;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-0.01, 0.01);
    for (const Point3& p : this->wired.piece.mesh.points())
    {
      positions.emplace_back(p.x() + uniform(random), p.y() + uniform(random));
    }
    return model.unknowns(positions, { 0.01 });
  }
};

std::vector<DistortionEnergy> energies()
{
  return { { DistortionEnergyKind::AsRigidAsPossible, 0.3 },
    { DistortionEnergyKind::SymmetricDirichlet, 0.0 } };
}
}

TEST(IsometricModel, DerivativesWithoutTheMatrixAreThoseBesideIt)
{
  const Example example;
  for (const DistortionEnergy& energy : energies())
  {
    IsometricModel model(example.wired.piece, example.problem, energy, 5.0);
    const Eigen::VectorXd x = example.point(model);
    const Eigen::VectorXd away = 1.1 * x;
    const Eigen::VectorXd multipliers = Example::multipliers(model);
    const auto linear = model.linearize(x, multipliers, Curvature::Exact, 0.0, {});
    const Eigen::VectorXd forces = model.transposedJacobianTimes(multipliers);
    model.linearize(away, multipliers, Curvature::Exact, 0.0, {});
    const SparseMatrix matrix = model.kkt();
    const auto alone = model.differentiate(x, {});
    ASSERT_TRUE(alone.has_value());
    EXPECT_LT((alone->gradient - linear.gradient).norm(), 1e-13 * linear.gradient.norm());
    EXPECT_EQ(alone->constraints, linear.constraints);
    EXPECT_LT((model.transposedJacobianTimes(multipliers) - forces).norm(), 1e-13 * forces.norm());
    EXPECT_EQ((model.kkt() - matrix).norm(), 0.0);
  }
}

TEST(IsometricModel, DerivativesAreThoseOfFiniteDifferences)
{
  const Example example;
  for (const DistortionEnergy& energy : energies())
  {
    IsometricModel model(example.wired.piece, example.problem, energy, 5.0);
    const Eigen::VectorXd x = example.point(model);
    const Eigen::VectorXd multipliers = Example::multipliers(model);
    expectGradientOfObjective(model, x, 1e-6, 1e-5);
    // What takes out the rigid motions is no derivative.
    const std::array<Index, 2> fixed = model.fixedVertices();
    expectKktOfLagrangian(model, x, multipliers, 1e-6, 1e-4, 1e-6,
      [&fixed](Index k) { return k / 2 == fixed[0] || k / 2 == fixed[1]; });
  }
}

namespace
{
constexpr double hingeWeight = 5.0;
constexpr double hingeArea = 1600.0;

WireHinge smoothHinge(double length, bool inside)
{
  return { length, pi, inside };
}

/// A panel over [-1, 1] x [-1, 1].
Surface panel(Index side, const std::function<Point3(double, double)>& place)
{
  return patch(side, side,
    [&](double i, double j) { return place(2.0 * i / side - 1.0, 2.0 * j / side - 1.0); });
}

std::vector<std::function<Point3(double, double)>> panels()
{
  return { [](double x, double y) { return Point3(x, y, 0.4 * (x * x + y * y)); },
    [](double x, double y) { return Point3(x, y, 0.4 * (x * x - y * y)); },
    [](double x, double y) { return Point3(x, y, 0.15 * std::sin(3.0 * x) * std::cos(2.5 * y)); },
    [](double x, double y) {
      const double radius = 1.0 + 0.3 * std::sin(2.0 * y);
      return Point3(radius * std::sin(1.2 * x), radius * std::cos(1.2 * x), 1.5 * y);
    } };
}

QualitySummary qualityOf(const Surface& surface, double angleWeight = hingeWeight)
{
  FlatteningOptions options;
  options.isometric.angleWeight = angleWeight;
  const FlatteningResult result = flattenOk(surface, options);
  EXPECT_TRUE(result.pieces[0].quality.flipped.empty());
  return result.pieces[0].quality;
}
}

TEST(WireStiffness, AChainOfHingesBendsTheSameHoweverFinelyItIsDivided)
{
  // Springs in a row: n hinges of a length l / n are together as stiff as one of length l.
  const WireStiffness stiffness(hingeWeight, hingeArea, 1.0);
  for (double force : { -3.0, 0.0, 2.0, 5.0, 50.0 })
  {
    const double whole = stiffness.underForce(smoothHinge(1.0, true), force);
    for (int parts : { 2, 3, 16 })
    {
      const double part = stiffness.underForce(smoothHinge(1.0 / parts, true), force);
      EXPECT_NEAR(part / parts, whole, 1e-12 * whole) << force << " " << parts;
    }
  }
}

TEST(WireStiffness, IsEnoughAgainstWrinklingAtTheEdgeOfASheet)
{
  // A wire of bending energy B per squared curvature at the edge of a sheet that answers a ripple
  // of wave number q by c q: ripples cost 2 B q^4 + c q, what presses gains N q^2.
  const WireStiffness stiffness(hingeWeight, hingeArea, 1.0);
  constexpr double perRipple = 4.0 / 3.0; // a half-plane of modulus 2 whose edge keeps its length
  for (double force : { 0.5, 1.0, 2.0, 3.0 })
  {
    const double bending = stiffness.underForce(smoothHinge(1.0, false), force);
    for (double q = 0.01; q < 100.0; q *= 1.1)
    {
      EXPECT_LT(force * q * q, 2.0 * bending * q * q * q * q + perRipple * q) << force << " " << q;
    }
  }
}

TEST(WireStiffness, WiresThatAreDrawnStaySoftAndPressedOnesGetStiffer)
{
  const WireStiffness stiffness(hingeWeight, hingeArea, 1.0);
  for (bool inside : { false, true })
  {
    const WireHinge hinge = smoothHinge(1.2, inside);
    const double least = stiffness.underForce(hinge, 0.0);
    EXPECT_GT(least, 0.0);
    EXPECT_EQ(stiffness.underForce(hinge, -100.0), least);
    EXPECT_GT(stiffness.underForce(hinge, 8.0), 1.5 * least);
    EXPECT_GE(stiffness.underForce(hinge, 1e9), stiffness.underForce(hinge, 8.0));
    EXPECT_TRUE(std::isfinite(stiffness.underForce(hinge, 1e9)));
  }
}

TEST(WireStiffness, AMeshOfFourTimesTheTrianglesGivesTheSameShape)
{
  for (const auto& place : panels())
  {
    const QualitySummary coarse = qualityOf(panel(20, place));
    const QualitySummary fine = qualityOf(panel(40, place));
    EXPECT_NEAR(coarse.areaError, fine.areaError, 0.04 * fine.areaError);
    EXPECT_NEAR(coarse.rigidEnergy, fine.rigidEnergy, 0.015 * fine.rigidEnergy);
  }
}

TEST(WireStiffness, WithoutCurvesItCostsAFewPercentOfEnergyAtMost)
{
  // Coarse enough for boundaries to keep their shape without any stiffness.
  for (const auto& place : panels())
  {
    const Surface surface = panel(14, place);
    EXPECT_LT(qualityOf(surface).rigidEnergy, 1.05 * qualityOf(surface, 0.0).rigidEnergy);
  }
}

TEST(WireStiffness, DoesNotDependOnWhatElseIsCutFromTheSurface)
{
  // The lower half of a cushion, alone and beside the upper half, in strips of another width.
  const auto place = [](double i, double j) {
    return Point3(i / 8.0, j <= 4.0 ? j / 8.0 : 0.5 + (j - 4.0) / 32.0,
      0.3 * std::sin(pi * i / 8.0) * std::sin(0.3 * j));
  };
  const Surface alone = patch(8, 4, place);
  Surface both = withCurves(patch(8, 20, place), { rowCurve(8, 4, CurveType::Seam) });
  const FlatteningResult one = flatten(alone);
  const FlatteningResult two = flatten(both);
  ASSERT_TRUE(one.status.ok() && two.status.ok()) << one.status.message << two.status.message;
  ASSERT_EQ(two.pieces.size(), 2u);
  const bool first = two.pieces[0].triangles == one.pieces[0].triangles;
  const PieceReport& same = two.pieces[first ? 0 : 1];
  EXPECT_NEAR(same.distortionEnergy, one.pieces[0].distortionEnergy, 1e-9);
  EXPECT_NEAR(same.angleEnergy, one.pieces[0].angleEnergy, 1e-9);
}
