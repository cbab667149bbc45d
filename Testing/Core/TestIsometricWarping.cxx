// SPDX-License-Identifier: BSD-3-Clause
#include "Flattened.h"
#include "Imprint/CurveImprint.h"
#include "Isometric/IsometricWarping.h"
#include "ModelDerivatives.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
FlatteningOptions isometricWith(DistortionEnergy energy, double angleWeight = 5.0)
{
  FlatteningOptions options;
  options.isometric.energy = energy;
  options.isometric.angleWeight = angleWeight;
  return options;
}

/// \param fine of more triangles between the wires, so that these can bend
Surface cushionWithCurves(Index fine = 1)
{
  Surface surface = cushion(8 * fine, 10 * fine, 0.3);
  surface.curves = { columnCurve(8 * fine, 10 * fine, 4 * fine), rowCurve(8 * fine, 3 * fine),
    rowCurve(8 * fine, 7 * fine) };
  return surface;
}

/// A cone and a cylinder with two curves that cross.
std::array<Surface, 2> developables()
{
  std::array<Surface, 2> surfaces{ cone(12, 6), cylinder(10, 8) };
  surfaces[0].curves = { rowCurve(12, 3), columnCurve(12, 6, 6) };
  surfaces[1].curves = { rowCurve(10, 4), columnCurve(10, 8, 5) };
  return surfaces;
}
}

TEST(IsometricWarping, KeepsEveryWireExactAndBeatsThePinnedInterior)
{
  const Surface surface = cushionWithCurves(2);
  const FlatteningResult before = flatten(surface, withScheme(Scheme::Global));
  const FlatteningResult after = flattenOk(surface);
  const QualitySummary& a = before.pieces[0].quality;
  const QualitySummary& b = after.pieces[0].quality;
  EXPECT_LT(b.maximumEdgeLengthError, 1e-12);
  EXPECT_LT(b.angleError, a.angleError);
  EXPECT_LT(b.areaError, a.areaError);
  EXPECT_GT(b.globalHomogeneity, a.globalHomogeneity);
  EXPECT_TRUE(b.flipped.empty());
}

TEST(IsometricWarping, ConvergesQuadraticallyToAStationaryPoint)
{
  const FlatteningResult result = flatten(cushionWithCurves());
  const auto& history = result.pieces[0].history;
  ASSERT_GE(history.size(), 3u);
  EXPECT_LE(result.pieces[0].iterations, 8);
  EXPECT_LT(history.back().optimality, 1e-9 * std::sqrt(history.back().objective) + 1e-11);
  // The last step squares the error, up to a constant.
  const double last = history[history.size() - 1].step;
  const double before = history[history.size() - 2].step;
  EXPECT_LT(last, 10.0 * before * before + 1e-12);
}

TEST(IsometricWarping, AFinerMeshOfTheSameSurfaceGivesTheSameShape)
{
  // The same cushion with a curve along its middle, 60 and 120 triangles across.
  std::array<double, 2> angleError{};
  std::array<double, 2> width{};
  for (int fine = 0; fine < 2; ++fine)
  {
    const Index side = fine ? 120 : 60;
    Surface surface = cushion(side, side, 0.15);
    surface.curves.push_back(rowCurve(side, side / 2));
    const FlatteningResult result = flattenOk(surface);
    angleError[fine] = result.pieces[0].quality.angleError;
    Eigen::AlignedBox2d box;
    for (const Point2& p : result.positions)
    {
      box.extend(p);
    }
    width[fine] = box.diagonal().norm();
  }
  EXPECT_NEAR(angleError[1], angleError[0], 0.03 * angleError[0]);
  EXPECT_NEAR(width[1], width[0], 2e-3 * width[0]);
}

TEST(IsometricWarping, ASymmetricSurfaceStaysSymmetricInBothDirections)
{
  // The diagonals of its squares alternate, so that both mirrors take triangles to triangles.
  Surface surface = cushion(8, 8, 0.2);
  surface.curves = { rowCurve(8, 2), rowCurve(8, 6), columnCurve(8, 8, 2), columnCurve(8, 8, 6) };
  const FlatteningResult result = flattenOk(surface);
  EXPECT_LT(result.pieces[0].quality.maximumEdgeLengthError, 1e-12);
  for (const bool across : { false, true })
  {
    Points2 image;
    for (Index v = 0; v < surface.mesh.vertexCount(); ++v)
    {
      const Index i = v % 9;
      const Index j = v / 9;
      const Point2& p = result.positions[across ? 9 * (8 - j) + i : 9 * j + 8 - i];
      image.emplace_back(-p.x(), p.y());
    }
    EXPECT_LT(rigidDistance(result.positions, image), 1e-9);
  }
}

TEST(IsometricWarping, StopsWhereSliversLeaveOnlyRoundingInTheGradient)
{
  // Curves between places inside triangles divide these into thin ones.
  const Surface panel = cone(12, 10);
  std::mt19937 random(5);
  const auto place = [&] {
    const Index t = static_cast<Index>(random() % panel.mesh.triangleCount());
    const Triangle& corners = panel.mesh.triangle(t);
    const double a = random() / 4294967296.0;
    const double b = (1.0 - a) * (random() / 4294967296.0);
    return Point3(a * panel.mesh.point(corners[0]) + b * panel.mesh.point(corners[1]) +
      (1.0 - a - b) * panel.mesh.point(corners[2]));
  };
  int imprintedOnes = 0;
  for (int trial = 0; trial < 20; ++trial)
  {
    Polyline line;
    line.name = "across";
    line.points = { place(), place() };
    const ImprintedSurface imprinted = imprintCurves(panel.mesh, { line }, {});
    if (!imprinted.status.ok())
    {
      continue; // the section may leave the panel
    }
    ++imprintedOnes;
    const FlatteningResult result = flatten({ imprinted.mesh, imprinted.curves, {} });
    EXPECT_TRUE(result.status.ok()) << trial << ": " << result.status.message;
    EXPECT_LT(result.pieces[0].iterations, 20) << trial;
    EXPECT_NEAR(result.pieces[0].quality.globalHomogeneity, 1.0, 1e-6) << trial;
  }
  EXPECT_GE(imprintedOnes, 10);
}

TEST(IsometricWarping, StopsOnAFineMeshWhereTheRoundingOfAllLengthsIsWhatIsLeft)
{
  constexpr Index n = 99;
  const auto place = [](double i, double j) {
    const double x = 10.0 * i / n;
    const double y = 10.0 * j / n;
    return Point3(x, y, 0.3 * std::sin(0.5 * x) * std::cos(0.4 * y) + 0.2 * std::sin(x * y / 3.0));
  };
  const Surface sheet = patch(n, n, place);
  Polyline row;
  for (Index i = 0; i <= n; ++i)
  {
    row.points.push_back(place(i, 50));
  }
  Polyline across;
  across.points = { place(5, 5), place(33, 50), place(6, 90) };
  const ImprintedSurface imprinted = imprintCurves(sheet.mesh, { row, across }, {});
  ASSERT_TRUE(imprinted.status.ok()) << imprinted.status.message;
  const FlatteningResult result = flattenOk({ imprinted.mesh, imprinted.curves, {} });
  EXPECT_LT(result.pieces[0].iterations, 20);
  EXPECT_LT(result.pieces[0].quality.maximumEdgeLengthError, 1e-11);
}

TEST(IsometricWarping, SymmetricDirichletNeverFlipsAndAgreesOnDevelopables)
{
  const FlatteningOptions dirichlet =
    isometricWith({ DistortionEnergyKind::SymmetricDirichlet, 0.0 });
  const FlatteningResult result = flattenOk(cushionWithCurves(), dirichlet);
  EXPECT_LT(result.pieces[0].quality.maximumEdgeLengthError, 1e-12);
  EXPECT_TRUE(result.pieces[0].quality.flipped.empty());
  EXPECT_EQ(countFlipped(result.cut->mesh, result.positions), 0);

  // Where there is an isometry, it has no energy of either kind.
  for (const Surface& surface : developables())
  {
    const FlatteningResult one = flatten(surface);
    const FlatteningResult other = flattenOk(surface, dirichlet);
    EXPECT_LT(rigidDistance(one.positions, other.positions), 1e-9);
    EXPECT_LT(rigidDistance(surface.unrolled, other.positions), 1e-9);
  }
  // Elsewhere they are two.
  EXPECT_GT(rigidDistance(flatten(cushionWithCurves()).positions, result.positions), 1e-4);
}

TEST(IsometricWarping, ABiasTowardsAreaOrAnglesAndAWeightOfTheWiresAnglesLowerTheirErrors)
{
  const Surface surface = cushionWithCurves();
  const auto quality = [&](double bias) {
    return flatten(surface, isometricWith({ DistortionEnergyKind::AsRigidAsPossible, bias }))
      .pieces[0]
      .quality;
  };
  EXPECT_LT(quality(0.8).areaError, quality(0.0).areaError);
  EXPECT_LT(quality(-0.8).angleError, quality(0.0).angleError);
  const double loose = flatten(surface, isometricWith({}, 1.0)).pieces[0].angleEnergy / 1.0;
  const double tight = flatten(surface, isometricWith({}, 10.0)).pieces[0].angleEnergy / 10.0;
  EXPECT_LT(tight, loose);
}

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
  Surface surface = cushion(6, 7, 0.3);
  surface.curves = { columnCurve(6, 7, 3), rowCurve(6, 4) };
  return surface;
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
