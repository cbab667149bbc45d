// SPDX-License-Identifier: BSD-3-Clause
// A free boundary: the least energy that an independent minimizer finds, named lengths exact.
#include "ClosedMeshes.h"
#include "Embedding/ConvexEmbedding.h"
#include "Flattened.h"
#include "ModelDerivatives.h"
#include "StatusTesting.h"
#include "Suggestion/ChartClusters.h"
#include "Suggestion/SeamTree.h"

using namespace flattening;
using namespace testmeshes;

namespace
{
/// Mean of |J|^2 + |J^-1|^2 - 4 by the metrics of triangles, |J|^2 = tr(G^-1 g) and det J =
/// sqrt(det g / det G), and mu times the squared relative errors of edges: written without the
/// library, and minimized by the method of limited memory from a convex map.
class IndependentMinimum
{
public:
  /// \param weights of triangles, with a mean of 1 over the area
  IndependentMinimum(const Surface& surface, double penalty, RegionWeights weights = {})
    : Mesh(surface.mesh)
    , Penalty(penalty)
    , Weights(std::move(weights))
  {
    this->Weights.resize(this->Mesh.triangleCount(), 1.0);
    for (const FeatureCurve& curve : surface.curves)
    {
      for (std::size_t k = 0; k + 1 < curve.vertices.size(); ++k)
      {
        this->Edges.push_back({ curve.vertices[k], curve.vertices[k + 1] });
      }
    }
    for (const Triangle& c : this->Mesh.triangles())
    {
      Eigen::Matrix<double, 3, 2> space;
      space << this->Mesh.point(c[1]) - this->Mesh.point(c[0]),
        this->Mesh.point(c[2]) - this->Mesh.point(c[0]);
      const Eigen::Matrix2d metric = space.transpose() * space;
      this->Roots.push_back(std::sqrt(metric.determinant()));
      this->Inverses.emplace_back(metric.inverse());
      this->Area += 0.5 * this->Roots.back();
    }
    this->X.resize(2 * this->Mesh.vertexCount());
    const Points2 start = embedConvexly(this->Mesh, {});
    for (Index v = 0; v < this->Mesh.vertexCount(); ++v)
    {
      this->X.segment<2>(2 * v) = start[v];
    }
    const auto function = [this](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
      return this->evaluate(x, gradient);
    };
    minimizeByGradients(function, this->X, 20000, 1e-8);
    Eigen::VectorXd gradient;
    this->evaluate(this->X, gradient);
  }

  /// Of the triangles alone.
  double energy() const { return this->Triangles; }

private:
  Eigen::Vector2d at(const Eigen::VectorXd& x, Index v) const { return x.segment<2>(2 * v); }

  double evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& gradient)
  {
    gradient = Eigen::VectorXd::Zero(x.size());
    double sum = 0.0;
    for (Index t = 0; t < this->Mesh.triangleCount(); ++t)
    {
      const Triangle& c = this->Mesh.triangle(t);
      Eigen::Matrix2d flat;
      flat << this->at(x, c[1]) - this->at(x, c[0]), this->at(x, c[2]) - this->at(x, c[0]);
      const double root = this->Roots[t];
      const double det = flat.determinant() / root;
      if (!(det > 0.0))
      {
        return std::numeric_limits<double>::infinity();
      }
      const double weight = this->Weights[t] * 0.5 * root / this->Area;
      const Eigen::Matrix2d byNorm = flat * this->Inverses[t];
      const double norm = (byNorm.transpose() * flat).trace();
      Eigen::Matrix2d cofactor;
      cofactor << flat(1, 1), -flat(1, 0), -flat(0, 1), flat(0, 0);
      sum += weight * (norm + norm / (det * det) - 4.0);
      const Eigen::Matrix2d slope = weight *
        (2.0 * (1.0 + 1.0 / (det * det)) * byNorm -
          2.0 * norm / (det * det * det * root) * cofactor);
      gradient.segment<2>(2 * c[1]) += slope.col(0);
      gradient.segment<2>(2 * c[2]) += slope.col(1);
      gradient.segment<2>(2 * c[0]) -= slope.rowwise().sum();
    }
    this->Triangles = sum;
    for (const auto& [a, b] : this->Edges)
    {
      const double rest = (this->Mesh.point(b) - this->Mesh.point(a)).norm();
      const Eigen::Vector2d d = this->at(x, b) - this->at(x, a);
      const double error = d.norm() / rest - 1.0;
      sum += this->Penalty * error * error;
      const Eigen::Vector2d slope = 2.0 * this->Penalty * error / (rest * d.norm()) * d;
      gradient.segment<2>(2 * b) += slope;
      gradient.segment<2>(2 * a) -= slope;
    }
    return sum;
  }

  const TriangleMesh& Mesh;
  double Penalty;
  RegionWeights Weights;
  std::vector<std::array<Index, 2>> Edges;
  std::vector<double> Roots; ///< per triangle, of det G
  std::vector<Eigen::Matrix2d> Inverses;
  double Area = 0.0;
  Eigen::VectorXd X;
  double Triangles = 0.0;
};

Surface foldedSheet()
{
  return patch(12, 8, [](double i, double j) -> Point3 {
    return { 0.3 * i, 0.4 * std::sin(1.1 * i) + 0.02 * i * std::sin(0.4 * j), 0.25 * j };
  });
}

Surface spiral()
{
  return patch(16, 6, [](double i, double j) -> Point3 {
    const double turn = 1.0 + 0.5 * i;
    const double radius = 0.1 * turn * (1.0 + 0.004 * j * j);
    return { radius * std::cos(turn), radius * std::sin(turn), 0.15 * j };
  });
}

/// Sheets and cups, some with a curve along a row or a diameter.
std::vector<Surface> formulas(bool curves)
{
  std::vector<Surface> all{ foldedSheet(), spiral(), cushion(9, 8, 0.4) };
  if (curves)
  {
    all[0].curves = { rowCurve(12, 4) };
    all[1].curves = { rowCurve(16, 3) };
    all[2].curves = { rowCurve(9, 4) };
  }
  for (const double degrees : { 50.0, 90.0, 130.0 })
  {
    all.push_back(sphereCap(degrees * pi / 180.0, 6, curves && degrees < 100.0 ? 1 : 0));
  }
  return all;
}

/// Of the triangles, over the area.
double energyOf(const FlatteningResult& result)
{
  return result.pieces[0].distortionEnergy / result.pieces[0].triangles;
}

double strainOf(const TriangleQuality& triangle)
{
  return std::max(
    std::abs(std::log(triangle.smallStretch)), std::abs(std::log(triangle.largeStretch)));
}
}

TEST(FreeBoundary, HasTheLeastEnergyThatAnotherMinimizerFinds)
{
  for (const bool curves : { false, true })
  {
    FlatteningOptions options = freeBoundary();
    options.isometric.angleWeight = curves ? 0.0 : options.isometric.angleWeight;
    for (const Surface& surface : formulas(curves))
    {
      const FlatteningResult result = flattenOk(surface, options);
      EXPECT_TRUE(result.pieces[0].quality.flipped.empty());
      EXPECT_LT(result.pieces[0].quality.maximumEdgeLengthError, 1e-12);
      EXPECT_EQ(result.pieces[0].energyUsed, DistortionEnergyKind::SymmetricDirichlet);
      EXPECT_TRUE(curves || result.pieces[0].iterations <= 15);
      // Lengths that a penalty holds are not exact.
      const double least = IndependentMinimum(surface, curves ? 1e3 : 0.0).energy();
      EXPECT_NEAR(energyOf(result), least, (curves ? 0.01 : 1e-4) * least + 1e-10);
    }
  }
}

TEST(FreeBoundary, HasTheLeastEnergyOfWeightedTriangles)
{
  for (const Surface& surface : { cushion(9, 8, 0.4), sphereCap(130.0 * pi / 180.0, 6, 0) })
  {
    RegionWeights weights;
    for (Index t = 0; t < surface.mesh.triangleCount(); ++t)
    {
      weights.push_back(surface.mesh.centroid(t).x() > 0.3 ? 50.0 : 1.0);
    }
    FlatteningOptions options = freeBoundary();
    options.isometric.weights = weights;
    const FlatteningResult result = flattenOk(surface, options);
    EXPECT_TRUE(result.pieces[0].quality.flipped.empty());
    const double least =
      IndependentMinimum(surface, 0.0, relativeWeights(surface.mesh, weights)).energy();
    EXPECT_NEAR(energyOf(result), least, 1e-4 * least);

    // Only ratios count.
    std::transform(weights.begin(), weights.end(), options.isometric.weights.begin(),
      [](double weight) { return 1e-3 * weight; });
    const FlatteningResult scaled = flatten(surface, options);
    EXPECT_NEAR(energyOf(scaled), energyOf(result), 1e-9 * least);
  }
}

TEST(FreeBoundary, WeightsTakeDistortionElsewhereWhereTheBoundaryIsExactAsWell)
{
  const Surface surface = cushion(9, 8, 0.4);
  const auto cares = [&](Index t) { return surface.mesh.centroid(t).x() > 0.4; };
  FlatteningOptions options;
  const FlatteningResult plain = flatten(surface);
  for (Index t = 0; t < surface.mesh.triangleCount(); ++t)
  {
    options.isometric.weights.push_back(cares(t) ? 1.0 : 0.0);
  }
  const FlatteningResult result = flattenOk(surface, options);
  EXPECT_LT(result.pieces[0].quality.maximumEdgeLengthError, 1e-12);
  double before = 0.0;
  double after = 0.0;
  for (Index t = 0; t < surface.mesh.triangleCount(); ++t)
  {
    before += cares(t) ? strainOf(plain.triangles[t]) : 0.0;
    after += cares(t) ? strainOf(result.triangles[t]) : 0.0;
  }
  EXPECT_LT(after, 0.8 * before);

  options.isometric.weights.assign(surface.mesh.triangleCount(), 7.0);
  EXPECT_EQ(flatten(surface, options).positions, plain.positions);
  options.isometric.weights[3] = -1.0;
  const FlatteningResult negative = flatten(surface, options);
  EXPECT_EQ(negative.status.code, StatusCode::InvalidOption);
  EXPECT_EQ(negative.status.ids.values, std::vector<std::int64_t>{ 3 });
  options.isometric.weights.resize(5);
  EXPECT_EQ(flatten(surface, options).status.code, StatusCode::InvalidOption);
}

TEST(FreeBoundary, MeasuresAllEdgesBesideThoseThatKeepTheirLength)
{
  Surface surface = withCurves(cushion(9, 8, 0.4), { rowCurve(9, 4) });
  const FlatteningResult exact = flatten(surface);
  const FlatteningResult result = flatten(surface, freeBoundary());
  double sum = 0.0;
  double count = 0.0;
  for (Index h = 0; h < surface.mesh.halfedgeCount(); ++h)
  {
    const double weight = surface.mesh.twin(h) == none ? 1.0 : 0.5;
    const double flat =
      (result.positions[surface.mesh.to(h)] - result.positions[surface.mesh.from(h)]).norm();
    sum += weight * std::abs(flat / surface.mesh.length(h) - 1.0);
    count += weight;
  }
  const QualitySummary& quality = result.pieces[0].quality;
  EXPECT_NEAR(quality.edgeLengthErrorAll, sum / count, 1e-13);
  EXPECT_LT(quality.edgeLengthErrorAll, exact.pieces[0].quality.edgeLengthErrorAll);
  EXPECT_LT(quality.maximumEdgeLengthError, 1e-12);
  EXPECT_GT(worstLength(result), 1e-3); // of the boundary
}

TEST(FreeBoundary, KeepsTheStretchesThatCurvesName)
{
  Surface surface = cushion(9, 8, 0.4);
  const double without = energyOf(flatten(surface, freeBoundary()));
  surface.curves = { accessory("hem", { 0, 1, 2, 3, 4, 5, 6 }), rowCurve(9, 4, CurveType::Key) };
  surface.curves[1].keyShape = KeyShape::Straight;
  const FlatteningResult result = flattenOk(surface, freeBoundary());
  EXPECT_LT(result.curves[0].error, 1e-12);
  EXPECT_LT(result.curves[1].error, 1e-12);
  EXPECT_GT(energyOf(result), without);
  const Indices& key = surface.curves[1].vertices;
  const Point2 along = result.positions[key.back()] - result.positions[key.front()];
  EXPECT_NEAR(along.norm(), result.curves[1].restLength, 1e-9);

  surface.curves[0].tolerance = 0.02;
  const FlatteningResult elastic = flattenOk(surface, freeBoundary());
  EXPECT_LT(energyOf(elastic), energyOf(result));
  EXPECT_LE(elastic.curves[0].error, 0.02 + 1e-12);
}

TEST(FreeBoundary, LeavesTheSidesOfCutsAndHolesFree)
{
  Surface surface = withCurves(cushion(10, 8, 0.4),
    { curveOf(CurveType::Dart, "dart", { 5, 16, 27 }), columnCurve(10, 8, 8, CurveType::Seam) });
  FlatteningOptions options = freeBoundary();
  options.dartLegs = DartLegs::Mirrored; // without an effect
  const FlatteningResult result = flatten(surface, options);
  ASSERT_FALSE(result.status.refused()) << result.status.message;
  EXPECT_EQ(result.pieces.size(), 2u);
  EXPECT_GT(result.curves[0].error, 1e-4);
  EXPECT_EQ(result.pieces[0].quality.maximumEdgeLengthError, 0.0);

  Surface holed;
  holed.mesh = partWhere(cushion(10, 8, 0.4).mesh, [](const Point3& p) {
    return std::hypot(p.x() - 0.4, p.y() - 0.4) > 0.2;
  }).mesh;
  const FlatteningResult around = flattenOk(holed, freeBoundary());
  EXPECT_EQ(around.pieces[0].boundaryLoops, 2);
  EXPECT_TRUE(around.pieces[0].quality.flipped.empty());
  const double least = IndependentMinimum(holed, 0.0).energy();
  EXPECT_NEAR(energyOf(around), least, 1e-4 * least);
}

TEST(FreeBoundary, TakesTheRigidEnergyOnRequestWhereItDoesNotFold)
{
  FlatteningOptions rigid = freeBoundary();
  rigid.isometric.energy.kind = DistortionEnergyKind::AsRigidAsPossible;
  const Surface shallow = cushion(9, 8, 0.4);
  const FlatteningResult result = flattenOk(shallow, rigid);
  EXPECT_EQ(result.pieces[0].energyUsed, DistortionEnergyKind::AsRigidAsPossible);
  EXPECT_LT(result.pieces[0].quality.rigidEnergy,
    flatten(shallow, freeBoundary()).pieces[0].quality.rigidEnergy);
  const FlatteningResult deep = flatten(sphereCap(170.0 * pi / 180.0, 12, 0), rigid);
  EXPECT_EQ(deep.pieces[0].energyUsed, DistortionEnergyKind::SymmetricDirichlet);
  EXPECT_TRUE(deep.pieces[0].quality.flipped.empty());
}

namespace
{
/// A ramp around an axis: flat, it is a ring of about the same number of turns.
Surface ramp(double turns, double pitch)
{
  return patch(static_cast<Index>(40 * turns), 5, [&](double i, double j) -> Point3 {
    const double turn = i / 20.0 * pi;
    const double radius = 1.0 + 0.2 * j;
    return { radius * std::cos(turn), radius * std::sin(turn), pitch * turn };
  });
}

/// A saddle with the given number of waves, whose rim is far too long for its radius.
Surface ruff(double height, int waves)
{
  Surface surface = sphereCap(60.0 * pi / 180.0, 10, 0);
  surface.mesh = moved(surface.mesh, [=](const Point3& p) {
    const double radius = std::hypot(p.x(), p.y());
    const double wave = std::sin(waves * std::atan2(p.y(), p.x()));
    return Point3(p.x(), p.y(), height * radius * radius * wave);
  });
  return surface;
}

/// Of a plane ring around the middle of the ramp's width whose angle is divided by the turns.
double energyOfOneTurn(double turns)
{
  double sum = 0.0;
  double weight = 0.0;
  for (int k = 0; k < 1000; ++k)
  {
    const double radius = 1.0 + (k + 0.5) / 1000.0;
    const double stretch = (1.5 * turns + radius - 1.5) / (turns * radius);
    sum += radius * (stretch * stretch + 1.0 / (stretch * stretch) - 2.0);
    weight += radius;
  }
  return sum / weight;
}

FlatteningOptions withoutOverlap()
{
  FlatteningOptions options = freeBoundary();
  options.preventOverlap = true;
  return options;
}
}

TEST(OverlapFreeBoundary, DoesNotCrossItselfWhereAFreeOneDoes)
{
  for (const double turns : { 1.1, 1.5, 2.3 })
  {
    SCOPED_TRACE(std::to_string(turns) + " turns");
    const Surface surface = ramp(turns, 0.03);
    const FlatteningResult crossing = flatten(surface, freeBoundary());
    ASSERT_EQ(crossing.pieces[0].status.code, StatusCode::Overlap);
    EXPECT_EQ(crossing.pieces[0].status.remedies.front().remedy, Remedy::PreventOverlap);
    const FlatteningResult result = flattenOk(surface, withoutOverlap());
    EXPECT_TRUE(result.pieces[0].quality.flipped.empty());
    EXPECT_EQ(result.pieces[0].overlaps.count, 0u);
    // Wound up evenly to one turn it does not overlap either.
    EXPECT_LT(energyOf(result), energyOfOneTurn(turns));
    EXPECT_GT(energyOf(result), energyOf(crossing));
  }
}

TEST(OverlapFreeBoundary, IsThereForSaddlesWithAndWithoutAHole)
{
  Surface whole = ruff(3.0, 3);
  Surface holed;
  holed.mesh =
    partWhere(whole.mesh, [](const Point3& p) { return std::hypot(p.x(), p.y()) > 0.2; }).mesh;
  for (const Surface& surface : { whole, holed, ruff(5.0, 3) })
  {
    SCOPED_TRACE(std::to_string(surface.mesh.triangleCount()) + " triangles");
    ASSERT_EQ(flatten(surface, freeBoundary()).pieces[0].status.code, StatusCode::Overlap);
    const FlatteningResult result = flatten(surface, withoutOverlap());
    EXPECT_EQ(result.pieces[0].overlaps.count, 0u);
    EXPECT_TRUE(result.pieces[0].quality.flipped.empty());
    EXPECT_TRUE(result.status.ok()) << result.status.message;
  }
}

TEST(OverlapFreeBoundary, ComesFromAfarToWhatOneThatMayCrossItselfReaches)
{
  for (double limbs : { 0.8, 1.6, 2.4 })
  {
    const TriangleMesh body = limbedBall(3, limbs);
    SeamTree tree(body);
    TrialBudget unlimited(std::numeric_limits<double>::infinity());
    Indices all(body.triangleCount());
    std::iota(all.begin(), all.end(), 0);
    for (double bound : { 1.2, 0.9, 0.7, 0.5 })
    {
      SCOPED_TRACE(std::to_string(limbs) + " long, cut to " + std::to_string(bound));
      ASSERT_TRUE(tree.grow(bound, unlimited, {}));
      Surface surface;
      surface.mesh = openedPart(body, all, tree.cut()).mesh;
      const double crossing = energyOf(flatten(surface, freeBoundary()));
      const FlatteningResult result = flattenOk(surface, withoutOverlap());
      EXPECT_EQ(result.pieces[0].overlaps.count, 0u);
      // Which has the least energy; maps that did not move from their start had 250 times that.
      EXPECT_LE(energyOf(result), 2.0 * crossing);
    }
  }
}

TEST(OverlapFreeBoundary, IsTheFreeOneWhereThatDoesNotCrossItself)
{
  for (const Surface& surface : { foldedSheet(), cushion(9, 8, 0.4), ramp(0.8, 0.03) })
  {
    EXPECT_EQ(
      flatten(surface, withoutOverlap()).positions, flatten(surface, freeBoundary()).positions);
  }
}

TEST(OverlapFreeBoundary, KeepsTheLengthsOfCurvesAsWell)
{
  Surface surface = withCurves(ramp(1.3, 0.03), { rowCurve(52, 2) });
  const FlatteningResult result = flattenOk(surface, withoutOverlap());
  EXPECT_LT(result.curves[0].error, 1e-12);
  EXPECT_EQ(result.pieces[0].overlaps.count, 0u);

  // The innermost row would have to be longer.
  surface.curves = { rowCurve(52, 0) };
  const double rigid = energyOf(flatten(surface, withoutOverlap()));
  surface.curves[0].tolerance = 0.02;
  const FlatteningResult elastic = flattenOk(surface, withoutOverlap());
  EXPECT_EQ(elastic.pieces[0].overlaps.count, 0u);
  EXPECT_LE(elastic.curves[0].error, 0.02 + 1e-12);
  EXPECT_GT(elastic.curves[0].error, 1e-4);
  EXPECT_LT(energyOf(elastic), rigid);
}

TEST(FreeBoundary, RefusesWhatHasNoEffect)
{
  Surface surface = withCurves(cushion(9, 8, 0.4), { columnCurve(9, 8, 5, CurveType::Seam) });
  const auto code = [&](const FlatteningOptions& options) {
    return statustesting::codeOf(flatten(surface, options).status);
  };
  std::vector<FlatteningOptions> idle;
  for (const Scheme scheme : { Scheme::Global, Scheme::Progressive, Scheme::LeastSquaresConformal })
  {
    idle.emplace_back(freeBoundary()).scheme = scheme;
  }
  idle.emplace_back(freeBoundary()).isometric.energy.bias = 0.5;
  idle.emplace_back(freeBoundary()).eases = { { surface.curves[0].name, none, 0.01 } };
  idle.emplace_back(freeBoundary()).boundaryTolerance = 0.02;
  idle.emplace_back(withoutOverlap()).boundary = BoundaryMode::Exact;
  for (const FlatteningOptions& options : idle)
  {
    EXPECT_EQ(code(options), StatusCode::InvalidOption);
  }
  EXPECT_NE(code(freeBoundary()), StatusCode::InvalidOption);
  surface.curves[0].tolerance = 0.01;
  EXPECT_EQ(code(freeBoundary()), StatusCode::InvalidOption);
}

TEST(ElasticBoundary, EachStretchBetweenEndsOfWiresHasOneFactorWithinTheTolerance)
{
  constexpr double tolerance = 0.02;
  Surface surface = withCurves(cushion(12, 15, 0.3), { columnCurve(12, 15, 5), rowCurve(12, 9) });
  FlatteningOptions options;
  const FlatteningResult exact = flatten(surface, options);
  options.boundaryTolerance = tolerance;
  const FlatteningResult elastic = flattenOk(surface, options);
  EXPECT_LT(elastic.pieces[0].quality.maximumEdgeLengthError, 1e-12) << "of the two curves";
  EXPECT_LT(elastic.pieces[0].quality.rigidEnergy, 0.95 * exact.pieces[0].quality.rigidEnergy);

  // By the quarters that the curves divide it into.
  std::array<std::vector<double>, 4> factors;
  const TriangleMesh& mesh = surface.mesh;
  for (Index h = 0; h < 3 * mesh.triangleCount(); ++h)
  {
    if (mesh.twin(h) == none)
    {
      const Index a = mesh.from(h);
      const Index b = mesh.to(h);
      const bool right = a % 13 + b % 13 > 2 * 5;
      const bool above = a / 13 + b / 13 > 2 * 9;
      factors[2 * right + above].push_back((elastic.positions[b] - elastic.positions[a]).norm() /
        (mesh.point(b) - mesh.point(a)).norm());
    }
  }
  for (const std::vector<double>& stretch : factors)
  {
    const auto [least, most] = std::minmax_element(stretch.begin(), stretch.end());
    EXPECT_LT(*most - *least, 1e-12);
    EXPECT_LE(std::abs(*most - 1.0), tolerance + 1e-12);
    EXPECT_GT(std::abs(*most - 1.0), 1e-4);
  }
}
