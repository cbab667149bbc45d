// SPDX-License-Identifier: BSD-3-Clause
#include "Sewing/PieceSewing.h"

#include "Base/Memory.h"
#include "Quality/StrainMeasures.h"
#include "Sewing/SewingModel.h"
#include "Sewing/SheetDensity.h"
#include "Surface/SurfaceLocator.h"
#include "Surface/VertexFan.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <random>

namespace flattening
{
namespace
{
/// Pressure and weight as large as the stiffness would stretch any cloth to twice its size.
constexpr double maxLoad = 1.0;
/// The second start, over the size, and how much of the distance may be chance.
constexpr double shaking = 1e-3;
constexpr double severalBeyond = 0.1;
/// Distances below this share of the size are those of bending alone.
constexpr double nearDesign = 1e-3;

Status checked(const CutSurface& cut, const Points2& positions, const SewingOptions& options)
{
  if (!std::isfinite(options.thickness) || options.thickness < 0.0 || options.thickness > 1.0)
  {
    return invalidOption("the thickness is outside 0..1", "a fraction of the size of a piece");
  }
  if (!std::isfinite(options.areaBias) || std::abs(options.areaBias) >= 1.0)
  {
    return invalidOption("the area bias is outside (-1, 1)", "0 for a plain sheet");
  }
  if (!std::isfinite(options.pressure) || std::abs(options.pressure) > maxLoad)
  {
    return invalidOption(
      "the pressure is outside -1..1", "a share of stiffness over size, such as 0.01");
  }
  const bool finite = std::all_of(options.gravity.begin(), options.gravity.end(),
    [](double component) { return std::isfinite(component); });
  if (!finite || options.gravity.norm() > maxLoad)
  {
    return invalidOption(
      "the gravity is longer than 1", "a share of stiffness over size, such as 0.001");
  }
  if (options.test == SewingTest::Product && !options.body && options.gravity != Point3::Zero())
  {
    return { StatusCode::InvalidOption, "nothing holds what is sewn together against its weight",
      {}, { Remedy::TestPanels, { Remedy::Give, "a body to lie on" } } };
  }
  if (!std::isfinite(options.gap) || options.gap <= 0.0 || options.gap > 1.0)
  {
    return invalidOption(
      "the gap to the body is outside (0, 1]", "a fraction of the size of a piece");
  }
  if (Status material = options.material ? checkMaterial(*options.material) : Status();
      !material.ok())
  {
    return material;
  }
  if (cut.mesh.triangleCount() == 0)
  {
    return { StatusCode::EmptySurface, "there are no pieces", {}, { Remedy::GiveTriangles } };
  }
  if (static_cast<Index>(positions.size()) != cut.mesh.vertexCount())
  {
    return invalidOption("there is not one flat position for each vertex", "the flat pieces");
  }
  return {};
}

/// Every piece must have area at rest, and be sewn to something unless its boundary is held.
Status checkedShapes(const SewnTopology& topology, const SewingOptions& options)
{
  const SewingTest test = options.test;
  Indices open;
  Indices flat;
  Indices loose;
  for (const SewnShape& shape : topology.shapes)
  {
    if (!(shape.cloth.restArea() > 0.0))
    {
      flat.push_back(shape.triangles.front());
    }
    if (test == SewingTest::Product && !shape.sewn)
    {
      loose.push_back(shape.triangles.front());
    }
    const Indices& twins = shape.cloth.twins;
    if (test == SewingTest::Product && std::find(twins.begin(), twins.end(), none) != twins.end())
    {
      open.push_back(shape.triangles.front());
    }
  }
  if (!flat.empty())
  {
    return { StatusCode::DegenerateTriangle,
      "the flat pieces of cells " + listIds(flat) + " have no area", { ElementKind::Cells, flat },
      { { Remedy::Give, "the flat pieces" } } };
  }
  if (!loose.empty())
  {
    return { StatusCode::InvalidOption,
      "the pieces of cells " + listIds(loose) +
        " are sewn to nothing: with a free boundary each comes to rest as the plane, which says "
        "nothing of it",
      { ElementKind::Cells, loose }, { Remedy::TestPanels } };
  }
  if (options.pressure != 0.0 && !open.empty())
  {
    return { StatusCode::InvalidOption,
      "what is sewn together at cells " + listIds(open) + " is open: it holds no pressure",
      { ElementKind::Cells, open },
      { Remedy::TestPanels, { Remedy::Give, "what is sewn to a closed shape" } } };
  }
  return {};
}

bool hasThreads(const SewingOptions& options)
{
  return options.material && !options.material->isotropic;
}

/// The worse of two; the first where they are alike.
Status worse(const Status& first, const Status& second)
{
  return severity(second.code) > severity(first.code) ? second : first;
}

/// Lays a product over the design; of a panel, what is held is as designed but for rounding.
void settlePoints(const SewnShape& shape, const SewingOptions& options, Points3& points)
{
  if (options.test == SewingTest::Product && !options.body)
  {
    alignToDesign(shape.cloth, points);
  }
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    points[v] = shape.cloth.held[v] ? shape.cloth.points[v] : points[v];
  }
}

/// On the other side of the design, as a sheet that buckles the other way would lie, each free
/// vertex moved by chance as well. A body may be there: then the design itself.
Points3 otherStart(const SewnCloth& cloth, const Points3& rest, bool body, double by)
{
  std::mt19937 random(1);
  const auto uniform = [&random] {
    return 2.0 * static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 1.0;
  };
  Points3 points = cloth.points;
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    points[v] -= cloth.held[v] || body ? Point3::Zero() : Point3(rest[v] - cloth.points[v]);
    const double x = uniform();
    const double y = uniform();
    const double z = uniform();
    points[v] += cloth.held[v] ? Point3::Zero() : Point3(by * x, by * y, by * z);
  }
  return points;
}

/// Whether the cloth finds another shape from another start. \param first where it lies.
/// \return false where it was cancelled
bool startAgain(SewingModel& model, const SewnShape& shape, const SewingOptions& options,
  const RestOptions& rest, const Points3& first, const Execution& execution, SewnReport& report)
{
  RestOptions again = rest;
  again.observe = nullptr;
  const Points3 from =
    otherStart(shape.cloth, first, options.body != nullptr, shaking * report.measures.size);
  const NewtonKktState end = bringToRest(model, from, again, execution);
  if (end.cancelled())
  {
    return false;
  }
  Points3 points = model.positions(end.x);
  settlePoints(shape, options, points);
  report.secondDistance = measureSewn(shape.cloth, points, execution).distanceMean;
  const double larger = std::max(report.secondDistance, report.measures.distanceMean);
  report.severalShapes = report.converged && end.converged() &&
    larger > nearDesign * report.measures.size &&
    std::abs(report.secondDistance - report.measures.distanceMean) > severalBeyond * larger;
  return true;
}

/// \param size root of the mean area of a piece
SewnReport broughtToRest(const SewnShape& shape, const SewingOptions& options, double size,
  const Execution& execution, Points3& points)
{
  SewnReport report;
  report.pieces = shape.pieces;
  report.triangles = static_cast<Index>(shape.triangles.size());
  ClothProperties properties;
  properties.areaBias = options.areaBias;
  properties.thickness = options.thickness * size;
  properties.pressure = options.pressure / std::sqrt(shape.cloth.restArea());
  properties.weight = options.gravity / std::sqrt(shape.cloth.restArea());
  properties.material = hasThreads(options) ? &*options.material : nullptr;
  properties.body = options.body;
  properties.gap = options.gap * size;
  SewingModel model(shape.cloth, properties);
  RestOptions rest;
  rest.maximumIterations = options.maximumIterations;
  rest.phase = "Sewing the pieces together";
  rest.observe = [&report](const NewtonKktRecord& record) {
    report.history.push_back(
      { record.objective, record.optimality / isotropicModulus, record.largestMove, record.exact });
    report.iterations += record.iteration > 0 ? 1 : 0;
  };
  const double firstPart = options.secondStart ? 0.5 : 1.0;
  const NewtonKktState end =
    bringToRest(model, shape.cloth.points, rest, execution.part(0.0, firstPart));
  const auto cancelled = [] {
    SewnReport none;
    none.status = { StatusCode::Cancelled, "cancelled while sewing the pieces", {} };
    return none;
  };
  if (end.cancelled())
  {
    return cancelled();
  }
  report.converged = end.converged();
  if (!report.converged)
  {
    const bool exhausted = end.termination == Termination::IterationLimit;
    report.status = { StatusCode::NotConverged,
      exhausted ? "the sewn cloth did not come to rest in " + std::to_string(report.iterations) +
          " iterations"
                : "the sewn cloth stopped short of rest after " +
          std::to_string(report.iterations) + " iterations, and more would change nothing",
      {}, exhausted ? SuggestedRemedies{ Remedy::AllowSewingIterations } : SuggestedRemedies{} };
  }
  const SewingModel::Terms energy = model.terms(end.x, execution);
  report.membraneEnergy = energy.membrane * model.unit() * model.unit();
  report.bendingEnergy = energy.bending * model.unit() * model.unit();
  report.bodyDepth = std::max(0.0, -model.leastDistance(end.x, execution));
  points = model.positions(end.x);
  settlePoints(shape, options, points);
  report.measures = measureSewn(shape.cloth, points, execution);
  if (hasThreads(options))
  {
    report.threads = measureSewnThreads(shape.cloth, points, *options.material);
  }
  if (options.secondStart &&
    !startAgain(model, shape, options, rest, points, execution.part(firstPart, 1.0), report))
  {
    return cancelled();
  }
  return report;
}

std::vector<std::array<double, 2>> seamStrains(
  const CutSurface& cut, const Points2& positions, const Points3& points)
{
  const auto strain = [&](Index h) {
    const Index from = cut.mesh.from(h);
    const Index to = cut.mesh.to(h);
    const double flat = (positions[to] - positions[from]).norm();
    return flat > 0.0 ? (points[to] - points[from]).norm() / flat - 1.0 : 0.0;
  };
  std::vector<std::array<double, 2>> strains;
  for (const SeamPair& pair : cut.seamPairs)
  {
    strains.push_back({ strain(pair.first), strain(pair.second) });
  }
  return strains;
}

/// What the shapes have by their own vertices and triangles, by those of the cut surface.
void gather(const CutSurface& cut, const SewnTopology& topology, const std::vector<Points3>& points,
  SewingResult& result)
{
  result.shapeOfTriangle = topology.shapeOfTriangle;
  result.points = cut.mesh.points();
  result.distance.assign(result.points.size(), 0.0);
  result.designDistance.assign(result.points.size(), 0.0);
  result.normalDeviation.resize(cut.mesh.triangleCount());
  result.stretches.resize(cut.mesh.triangleCount());
  for (std::size_t s = 0; s < topology.shapes.size(); ++s)
  {
    const SewnMeasures& measures = result.shapes[s].measures;
    const std::optional<SewnThreads>& threads = result.shapes[s].threads;
    const Indices& triangles = topology.shapes[s].triangles;
    result.threads.resize(threads ? cut.mesh.triangleCount() : 0);
    for (std::size_t k = 0; k < triangles.size(); ++k)
    {
      result.normalDeviation[triangles[k]] = measures.normalDeviation[k];
      result.stretches[triangles[k]] = measures.stretches[k];
      if (threads)
      {
        result.threads[triangles[k]] = threads->strains[k];
      }
      for (Index v : cut.mesh.triangle(triangles[k]))
      {
        const Index own = topology.vertexInShape[v];
        result.points[v] = points[s][own];
        result.distance[v] = measures.distance[own];
        result.designDistance[v] = measures.designDistance[own];
      }
    }
  }
}

SewingResult sewn(const CutSurface& cut, const Points2& positions, const SewingOptions& options,
  const Execution& execution)
{
  SewingResult result;
  result.status = checked(cut, positions, options);
  if (!result.status.ok())
  {
    return result;
  }
  const SewnTopology topology = sewnShapes(cut, positions, options.test);
  result.status = checkedShapes(topology, options);
  if (!result.status.ok())
  {
    return result;
  }
  double area = 0.0;
  for (const SewnShape& shape : topology.shapes)
  {
    area += shape.cloth.restArea();
  }
  const double size = std::sqrt(area / static_cast<double>(std::max<Index>(1, cut.pieceCount)));
  std::vector<Points3> points(topology.shapes.size());
  for (std::size_t s = 0; s < topology.shapes.size(); ++s)
  {
    const double count = static_cast<double>(topology.shapes.size());
    const Execution part =
      execution.part(static_cast<double>(s) / count, static_cast<double>(s + 1) / count);
    result.shapes.push_back(broughtToRest(topology.shapes[s], options, size, part, points[s]));
    const Status& status = result.shapes.back().status;
    if (status.refused())
    {
      SewingResult refused;
      refused.status = status;
      return refused;
    }
    result.status = worse(result.status, status);
  }
  gather(cut, topology, points, result);
  result.seamStrain = seamStrains(cut, positions, result.points);
  return result;
}
}

SewingResult sewPieces(const CutSurface& cut, const Points2& positions,
  const SewingOptions& options, const Execution& execution)
{
  return withinMemory([&] { return sewn(cut, positions, options, execution); });
}

namespace
{
/// Per vertex a third of the triangles around it, at rest, over the whole.
std::vector<double> vertexShares(const SewnCloth& cloth)
{
  std::vector<double> shares = vertexAreas(
    cloth.triangles, cloth.points.size(), [&cloth](Index t) { return cloth.restArea(t); });
  for (double& share : shares)
  {
    share /= cloth.restArea();
  }
  return shares;
}

double quantile(const std::vector<double>& values, const std::vector<double>& shares)
{
  std::vector<AreaValue> all;
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    all.push_back({ values[k], shares[k] });
  }
  return areaQuantile(std::move(all));
}

/// Distances of points from a surface.
std::vector<double> distancesFrom(
  const TriangleMesh& surface, const Points3& points, const Execution& execution)
{
  const SurfaceLocator locator(surface);
  std::vector<double> distances(points.size());
  execution.forEach(static_cast<Index>(points.size()),
    [&](Index k) { distances[k] = locator.closest(points[k]).distance; });
  return distances;
}

/// Of a triangle without extent at rest, which has no strain, that of the identity.
Eigen::Vector3d metricAt(const TriangleFrame& rest, const Triangle& c, const Points3& points)
{
  return rest.area > 0.0 ? metricOf(mapIntoSpace(rest, points[c[0]], points[c[1]], points[c[2]]))
                         : Eigen::Vector3d(1.0, 1.0, 0.0);
}

void measureTriangles(const SewnCloth& cloth, const Points3& points, SewnMeasures& measures)
{
  TriangleFrames rest;
  std::vector<TriangleQuality> qualities;
  double area = 0.0;
  double designArea = 0.0;
  for (std::size_t t = 0; t < cloth.triangles.size(); ++t)
  {
    const Triangle& c = cloth.triangles[t];
    rest.push_back(restFrame(cloth.flat[t]));
    const double weight = rest.back().area;
    area += weight;
    const Point3 designed = areaVector(cloth.points, c);
    designArea += 0.5 * designed.norm();
    measures.normalDeviation.push_back(angleBetween(designed, areaVector(points, c)));
    measures.normalDeviationMean += weight * measures.normalDeviation.back();
    measures.stretches.push_back(stretchesOf(metricAt(rest.back(), c, points)));
    TriangleQuality quality;
    quality.largeStretch = measures.stretches.back()[0];
    quality.smallStretch = measures.stretches.back()[1];
    qualities.push_back(quality);
    const double least = std::max(quality.smallStretch, std::exp(-largestStrain));
    const double strain =
      std::max(std::abs(std::log(std::max(quality.largeStretch, least))), -std::log(least));
    measures.strainMean += weight * strain;
    measures.strainMax = std::max(measures.strainMax, weight > 0.0 ? strain : 0.0);
    measures.compressedArea += isCompressed(measures.stretches.back()) ? weight : 0.0;
  }
  measures.size = std::sqrt(designArea);
  measures.normalDeviationMean /= area;
  measures.strainMean /= area;
  measures.compressedArea /= area;
  measures.strainP95 = measureStrain(rest, qualities).quantile;
}
}

SewnMeasures measureSewn(const SewnCloth& cloth, const Points3& points, const Execution& execution)
{
  SewnMeasures measures;
  measureTriangles(cloth, points, measures);
  const TriangleMesh design(cloth.points, cloth.triangles, cloth.twins);
  const TriangleMesh sewn(points, cloth.triangles, cloth.twins);
  measures.distance = distancesFrom(design, points, execution);
  measures.designDistance = distancesFrom(sewn, cloth.points, execution);
  const std::vector<double> shares = vertexShares(cloth);
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    measures.distanceMean += shares[v] * measures.distance[v];
    measures.distanceRms += shares[v] * measures.distance[v] * measures.distance[v];
    measures.distanceMax =
      std::max({ measures.distanceMax, measures.distance[v], measures.designDistance[v] });
  }
  measures.distanceRms = std::sqrt(measures.distanceRms);
  measures.distanceP95 = quantile(measures.distance, shares);
  return measures;
}

SewnThreads measureSewnThreads(
  const SewnCloth& cloth, const Points3& points, const ClothMaterial& material)
{
  SewnThreads threads;
  TriangleFrames rest;
  for (std::size_t t = 0; t < cloth.triangles.size(); ++t)
  {
    rest.push_back(restFrame(cloth.flat[t]));
    threads.strains.push_back(threadStrainOf(metricAt(rest.back(), cloth.triangles[t], points)));
  }
  threads.summary = summarizeThreads(rest, threads.strains, material);
  return threads;
}

void alignToDesign(const SewnCloth& cloth, Points3& points)
{
  const std::vector<double> shares = vertexShares(cloth);
  Point3 center = Point3::Zero();
  Point3 designed = Point3::Zero();
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    center += shares[v] * points[v];
    designed += shares[v] * cloth.points[v];
  }
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    covariance += shares[v] * (cloth.points[v] - designed) * (points[v] - center).transpose();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(
    covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  turn = svd.matrixU() * turn * svd.matrixV().transpose();
  for (Point3& p : points)
  {
    p = designed + turn * (p - center);
  }
}
}
