// SPDX-License-Identifier: BSD-3-Clause
#include "ClosedMeshes.h"
#include "Cloth/ClothMaterial.h"
#include "Embedding/DistortionEnergy.h"
#include "ModelDerivatives.h"
#include "Sewing/SewingModel.h"
#include "Sewing/SheetDensity.h"

#include <Eigen/Eigenvalues>

using namespace flattening;
using namespace testmeshes;

namespace
{
/// A patch whose rest is flat, with nothing held.
SewnCloth clothOf(const TriangleMesh& mesh, const Points2& rest)
{
  SewnCloth cloth;
  cloth.points = mesh.points();
  cloth.triangles = mesh.triangles();
  for (const Triangle& c : mesh.triangles())
  {
    cloth.flat.push_back({ rest[c[0]], rest[c[1]], rest[c[2]] });
  }
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    cloth.twins.push_back(mesh.twin(h));
  }
  cloth.held.assign(mesh.vertexCount(), 0);
  return cloth;
}

/// A cushion over its own ground plan, rough so that nothing vanishes by symmetry.
SewnCloth roughCloth()
{
  const Surface surface = cushion(4, 5, 0.3);
  Points2 rest;
  for (const Point3& p : surface.mesh.points())
  {
    rest.emplace_back(1.1 * p.x(), p.y() + 0.1 * p.x());
  }
  SewnCloth cloth = clothOf(surface.mesh, rest);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-0.02, 0.02);
  for (Point3& p : cloth.points)
  {
    p += Point3(uniform(random), uniform(random), uniform(random));
  }
  return cloth;
}

Eigen::MatrixXd hessianOf(const SewingModel& model)
{
  return Eigen::MatrixXd(SparseMatrix(model.kkt().selfadjointView<Eigen::Lower>()));
}

const ClothProperties stiff{ 0.2, 0.3 };
}

TEST(SewingModel, GradientAndHessianAreThoseOfFiniteDifferences)
{
  SewnCloth cloth = roughCloth();
  // Where a vertex is held, nothing keeps the whole from moving that were no derivative.
  cloth.held[3] = cloth.held[12] = 1;
  ClothProperties anchored = stiff;
  anchored.anchor = 0.7;
  anchored.outsideBias = 0.6;
  for (std::size_t v = 0; v < cloth.points.size(); ++v)
  {
    cloth.outwards.push_back(Point3(std::cos(5.0 * v), 0.3, 1.0).normalized());
  }
  anchored.pressure = 0.3;
  anchored.weight = { 0.1, -0.2, 0.3 };
  const ClothMaterial jersey = *findPreset("jersey");
  for (const ClothMaterial* material : { static_cast<const ClothMaterial*>(nullptr), &jersey })
  {
    anchored.material = material;
    SewingModel model(cloth, anchored);
    EXPECT_EQ(model.unknownCount(), 3 * (static_cast<Index>(cloth.points.size()) - 2));
    // Away from the design, where anchors pull.
    Points3 places = cloth.points;
    for (std::size_t v = 0; v < places.size(); ++v)
    {
      places[v] += 0.05 * Point3(std::sin(1.0 * v), std::cos(2.0 * v), std::sin(3.0 * v));
    }
    const Eigen::VectorXd x = model.unknownsAt(places);
    expectGradientOfObjective(model, x, 1e-5, 1e-7);
    expectHessianOfGradient(model, x, 1e-5, 1e-6);
  }
}

TEST(SewingModel, TheConvexPartHasNoNegativeEigenvalueAndTheExactHessianHasWhereClothIsCompressed)
{
  SewnCloth cloth = roughCloth();
  for (Point3& p : cloth.points)
  {
    p *= 0.8;
  }
  const ClothMaterial jersey = *findPreset("jersey");
  for (const ClothMaterial* material : { static_cast<const ClothMaterial*>(nullptr), &jersey })
  {
    ClothProperties properties{ 0.2, 0.0 };
    properties.material = material;
    SewingModel model(cloth, properties);
    const auto least = [&](Curvature curvature) {
      model.linearize(model.unknownsAt(cloth.points), {}, curvature, 0.0, {});
      return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(hessianOf(model)).eigenvalues()[0];
    };
    EXPECT_GT(least(Curvature::Convex), -1e-12);
    EXPECT_LT(least(Curvature::Exact), -1e-3);
  }
}

TEST(SewingModel, AnUnrolledCylinderIsNotStretchedAndBendsAsAPlateDoes)
{
  // modulus thickness^3 / 12 / radius^2 / 2 an area, here over half the modulus a thickness.
  const double thickness = 0.1;
  const double radius = 2.0;
  for (const bool across : { false, true })
  {
    const Index columns = 40;
    const double step = 0.05;
    const double turn = 2.0 * std::asin(0.5 * step / radius);
    const auto rolled = [&](double s) {
      return Point3(radius * std::cos(turn * s), radius * std::sin(turn * s), 0.0);
    };
    const Surface surface = patch(
      columns, columns,
      [&](double i, double j) -> Point3 {
        return rolled(across ? j : i) + Point3(0.0, 0.0, step * (across ? i : j));
      },
      [&](double i, double j) { return Point2(step * i, step * j); });
    SewingModel model(clothOf(surface.mesh, surface.unrolled), { 0.0, thickness });
    const SewingModel::Terms terms = model.terms(model.unknownsAt(surface.mesh.points()), {});
    EXPECT_LT(terms.membrane, 1e-20);
    const double area = columns * columns * step * step;
    const double plate = thickness * thickness / 12.0 / (radius * radius) * area;
    // Edges on the boundary bend nothing: a row of 40 is missing.
    EXPECT_NEAR(terms.bending * model.unit() * model.unit() / plate, 39.0 / 40.0, 1e-3);
  }
}

TEST(SewingModel, ABodyPushesAsItsEnergySays)
{
  // A plane above the middle of the cloth, facing down.
  const SewnCloth cloth = roughCloth();
  const TriangleMesh plane(
    { { -9.0, -9.0, 0.25 }, { -9.0, 9.0, 0.25 }, { 9.0, 9.0, 0.25 }, { 9.0, -9.0, 0.25 } },
    { { 0, 1, 2 }, { 0, 2, 3 } });
  ClothProperties properties = stiff;
  properties.anchor = 0.1;
  properties.body = &plane;
  properties.gap = 0.3;
  SewingModel model(cloth, properties);
  Points3 below = cloth.points;
  for (Point3& p : below)
  {
    p.z() = 0.02 + 0.5 * p.z();
  }
  const std::vector<std::pair<ContactForce, Points3>> cases{
    { ContactForce::Penalty, cloth.points }, { ContactForce::Barrier, below }
  };
  for (const auto& [force, points] : cases)
  {
    const Eigen::VectorXd x = model.unknownsAt(points);
    model.push(ContactForce::None, 0.0);
    const double without = model.objective(x, {});
    model.push(force, 3.0);
    EXPECT_GT(model.objective(x, {}), without + 1e-3);
    // The plane does not bend, so that the convex part is all.
    expectGradientOfObjective(model, x, 1e-5, 1e-6);
    expectHessianOfGradient(model, x, 1e-5, 1e-5);
  }
  EXPECT_LT(model.leastDistance(model.unknownsAt(cloth.points), {}), 0.0);
  EXPECT_GT(model.leastDistance(model.unknownsAt(below), {}), 0.0);
  EXPECT_TRUE(std::isinf(model.objective(model.unknownsAt(cloth.points), {})));
}

TEST(SewingModel, ThePlaceBesideABodyIsTheDistanceFromASphere)
{
  const ContactBody body(sphere(4)); // whose faces are just within
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.4, 1.4);
  for (int k = 0; k < 200; ++k)
  {
    const Point3 p(uniform(random), uniform(random), uniform(random));
    const ContactBody::Place place = body.locate(p);
    EXPECT_NEAR(place.distance, p.norm() - 1.0, 0.01);
    EXPECT_GT(p.norm() < 0.5 ? 1.0 : place.outwards.dot(p.normalized()), 0.98);
  }
}

namespace
{
/// The metric of a map that stretches weft and warp and shears them.
Eigen::Vector3d metricOf(double warp, double weft, double shear)
{
  return { (1.0 + weft) * (1.0 + weft), (1.0 + warp) * (1.0 + warp),
    (1.0 + weft) * (1.0 + warp) * std::sin(shear) };
}

/// Maps of the plane to itself that turn nothing over.
std::vector<Eigen::Matrix2d> planarMaps()
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<Eigen::Matrix2d> maps;
  while (maps.size() < 50)
  {
    Eigen::Matrix2d map;
    map << uniform(random), uniform(random), uniform(random), uniform(random);
    if (map.determinant() > 0.05)
    {
      maps.push_back(map);
    }
  }
  return maps;
}

Eigen::Vector3d metricOf(const Eigen::Matrix2d& map)
{
  return { map.col(0).squaredNorm(), map.col(1).squaredNorm(), map.col(0).dot(map.col(1)) };
}
}

TEST(SheetDensity, AThreadThatIsDrawnAloneCostsItsStiffnessAndSoDoesShear)
{
  ClothMaterial cloth;
  cloth.warp = 400.0;
  cloth.weft = 1000.0;
  cloth.shear = 30.0;
  const SheetDensity sheet(cloth);
  // In units in which the stiffer thread has 2.
  EXPECT_NEAR(sheet.value(metricOf(0.02, 0.0, 0.0)), 0.5 * 0.8 * 0.02 * 0.02, 1e-15);
  EXPECT_NEAR(sheet.value(metricOf(0.0, -0.02, 0.0)), 0.5 * 2.0 * 0.02 * 0.02, 1e-15);
  EXPECT_NEAR(sheet.value(metricOf(0.0, 0.0, 0.3)), 0.5 * 0.06 * 0.3 * 0.3, 1e-15);
  EXPECT_EQ(sheet.value(metricOf(0.0, 0.0, 0.0)), 0.0);
}

TEST(SheetDensity, AClothAlikeInAllDirectionsIsTheIsotropicSheetForSmallStrains)
{
  ClothMaterial cloth;
  cloth.warp = cloth.weft = 2.0;
  cloth.shear = 1.0;
  const SheetDensity woven(cloth);
  const SheetDensity sheet(0.0);
  const auto difference = [&](double size) {
    const Eigen::Vector3d metric = metricOf(0.7 * size, -0.4 * size, 0.9 * size);
    return std::abs(woven.value(metric) - sheet.value(metric)) / sheet.value(metric);
  };
  EXPECT_LT(difference(1e-3), 2e-3);
  EXPECT_NEAR(difference(1e-3) / difference(1e-4), 10.0, 0.5); // one order more
}

TEST(MetricDensity, IsThatOfTheFlatteningInThePlane)
{
  for (const double bias : { -0.5, 0.0, 0.4 })
  {
    for (const Eigen::Matrix2d& map : planarMaps())
    {
      const Eigen::Vector4d parts(
        map(0, 0) + map(1, 1), map(1, 0) - map(0, 1), map(0, 0) - map(1, 1), map(1, 0) + map(0, 1));
      const double planar =
        distortionEnergyDensity({ DistortionEnergyKind::AsRigidAsPossible, bias }, parts);
      EXPECT_NEAR(isotropicDensity(bias, metricOf(map)), planar, 1e-13 * (1.0 + planar));
    }
  }
}

TEST(MetricDensity, KeepsItsDigitsWhereLittleIsStrained)
{
  // A strain of e in one direction costs e^2, however small.
  for (const double strain : { 1e-3, 1e-6, 1e-9 })
  {
    const Eigen::Vector3d stretched((1.0 + strain) * (1.0 + strain), 1.0, 0.0);
    EXPECT_NEAR(isotropicDensity(0.0, stretched) / (strain * strain), 1.0, 1e-6);
  }
}

TEST(MetricDensity, IsConvexInTheMetricWithoutBias)
{
  for (const Eigen::Matrix2d& map : planarMaps())
  {
    const MetricDensity density = evaluateIsotropicDensity(0.0, metricOf(map));
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(density.hessian);
    EXPECT_GT(solver.eigenvalues()[0], -1e-12 * solver.eigenvalues()[2]);
  }
}
