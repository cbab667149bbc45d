// SPDX-License-Identifier: BSD-3-Clause
// A free boundary: the least energy that an independent minimizer finds, named lengths exact.
#include "ClosedMeshes.h"
#include "Embedding/ConvexEmbedding.h"
#include "Flattened.h"
#include "ModelDerivatives.h"
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

namespace
{
FlatteningOptions withoutOverlap()
{
  FlatteningOptions options = freeBoundary();
  options.preventOverlap = true;
  return options;
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
