// SPDX-License-Identifier: BSD-3-Clause
#include "Sewing/SewnMeasures.h"

#include "Quality/StrainMeasures.h"
#include "Surface/SurfaceLocator.h"
#include "Surface/VertexFan.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace flattening
{
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

Point3 areaVectorOf(const Points3& points, const Triangle& c)
{
  return areaVector(points[c[0]], points[c[1]], points[c[2]]);
}

/// Of a triangle without extent at rest, which has no strain, that of the identity.
Eigen::Vector3d metricAt(const TriangleFrame& rest, const Triangle& c, const Points3& points)
{
  return rest.area > 0.0 ? metricOf(mapIntoSpace(rest, points[c[0]], points[c[1]], points[c[2]]))
                         : Eigen::Vector3d(1.0, 1.0, 0.0);
}

void measureTriangles(const SewnCloth& cloth, const Points3& points, SewnMeasures& measures)
{
  std::vector<TriangleFrame> rest;
  std::vector<TriangleQuality> qualities;
  double area = 0.0;
  double designArea = 0.0;
  for (std::size_t t = 0; t < cloth.triangles.size(); ++t)
  {
    const Triangle& c = cloth.triangles[t];
    rest.push_back(restFrame(cloth.flat[t]));
    const double weight = rest.back().area;
    area += weight;
    const Point3 designed = areaVectorOf(cloth.points, c);
    designArea += 0.5 * designed.norm();
    measures.normalDeviation.push_back(angleBetween(designed, areaVectorOf(points, c)));
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
  std::vector<TriangleFrame> rest;
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
