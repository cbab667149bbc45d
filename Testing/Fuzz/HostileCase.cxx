// SPDX-License-Identifier: BSD-3-Clause
#include "HostileCase.h"

#include "Cloth/ClothMaterial.h"
#include "HostileSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hostile
{
namespace
{
/// Neighbours of each point along triangle edges; ids out of range have none.
std::vector<Indices> neighboursOf(const Specimen& surface)
{
  std::vector<Indices> neighbours(surface.points.size());
  const Index count = static_cast<Index>(surface.points.size());
  for (const Triangle& t : surface.triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Index a = t[k];
      const Index b = t[(k + 1) % 3];
      if (a >= 0 && a < count && b >= 0 && b < count)
      {
        neighbours[a].push_back(b);
        neighbours[b].push_back(a);
      }
    }
  }
  return neighbours;
}

/// Along edges as chance has it, or straight on, or back to its start.
Indices walk(Bytes& bytes, const Specimen& surface, const std::vector<Indices>& neighbours)
{
  Indices chain{ bytes.below(static_cast<Index>(surface.points.size())) };
  const std::size_t steps = 1 + bytes.next() % 14;
  const bool straight = bytes.oneIn(2);
  while (chain.size() <= steps && !neighbours[chain.back()].empty())
  {
    const Indices& choice = neighbours[chain.back()];
    Index next = choice[bytes.next() % choice.size()];
    if (straight && chain.size() > 1)
    {
      const Point3 here = surface.points[chain.back()];
      const Point3 ahead = here - surface.points[chain[chain.size() - 2]];
      next = *std::max_element(choice.begin(), choice.end(), [&](Index a, Index b) {
        return ahead.dot((surface.points[a] - here).normalized()) <
          ahead.dot((surface.points[b] - here).normalized());
      });
    }
    chain.push_back(next);
  }
  if (bytes.oneIn(12))
  {
    chain.push_back(chain.front());
  }
  return chain;
}

/// A point of a triangle, or one of its corners or edges, or off the surface.
Point3 pointOn(Bytes& bytes, const Specimen& surface)
{
  const Index count = static_cast<Index>(surface.points.size());
  const Triangle& t = surface.triangles[bytes.below(static_cast<Index>(surface.triangles.size()))];
  if (!std::all_of(t.begin(), t.end(), [=](Index v) { return v >= 0 && v < count; }))
  {
    return surface.points.front();
  }
  const double u = bytes.oneIn(4) ? 0.0 : bytes.unit();
  const double v = bytes.oneIn(4) ? 0.0 : bytes.unit() * (1.0 - u);
  Point3 p =
    (1.0 - u - v) * surface.points[t[0]] + u * surface.points[t[1]] + v * surface.points[t[2]];
  if (bytes.oneIn(32))
  {
    p += 0.5 * (surface.points[t[1]] - surface.points[t[0]]).cross(Point3(1.0, 0.0, 0.0));
  }
  return p;
}

void giveManner(Bytes& bytes, CurveType& type, KeyShape& shape, double& tolerance)
{
  type = static_cast<CurveType>(bytes.next() % 4);
  shape = static_cast<KeyShape>(bytes.next() % 3);
  if (bytes.oneIn(5))
  {
    tolerance = 0.3 * bytes.unit();
  }
}

Points2 planarShape(Bytes& bytes, std::size_t count)
{
  Points2 shape;
  for (std::size_t k = 0; k < count; ++k)
  {
    shape.push_back({ static_cast<double>(k) * bytes.unit(), bytes.unit() });
  }
  if (bytes.oneIn(16) && !shape.empty())
  {
    shape.pop_back();
  }
  return shape;
}

void makeCurves(Bytes& bytes, const Specimen& surface, HostileCase& result)
{
  if (surface.points.empty() || surface.triangles.empty())
  {
    return;
  }
  const std::vector<Indices> neighbours = neighboursOf(surface);
  const unsigned counts[] = { 0, 1, 1, 2, 2, 3, 4, 6 };
  const unsigned count = counts[bytes.next() % 8];
  // Either all curves are imprinted or all are chains of vertices, as a caller would do it.
  const bool chains = bytes.oneIn(6);
  for (unsigned c = 0; c < count; ++c)
  {
    Polyline line;
    line.name = "c" + std::to_string(c);
    giveManner(bytes, line.type, line.keyShape, line.tolerance);
    const bool along = chains || !bytes.oneIn(4);
    Indices vertices;
    if (along)
    {
      vertices = walk(bytes, surface, neighbours);
      for (const Index v : vertices)
      {
        line.points.push_back(surface.points[v]);
      }
    }
    else
    {
      const unsigned steps = 1 + bytes.next() % 4;
      for (unsigned k = 0; k <= steps; ++k)
      {
        line.points.push_back(pointOn(bytes, surface));
      }
    }
    if (line.keyShape == KeyShape::Planar)
    {
      line.planarShape = planarShape(bytes, line.points.size());
    }
    for (std::size_t k = 0; k < line.points.size(); ++k)
    {
      line.pointIds.push_back(static_cast<Index>(k));
    }
    if (chains)
    {
      FeatureCurve curve;
      curve.name = line.name;
      curve.type = line.type;
      curve.keyShape = line.keyShape;
      curve.tolerance = line.tolerance;
      curve.vertices = std::move(vertices);
      curve.planarShape = std::move(line.planarShape);
      if (bytes.oneIn(24))
      {
        curve.vertices.push_back(static_cast<Index>(bytes.below(65536)) - 256);
      }
      result.chains.push_back(std::move(curve));
    }
    else
    {
      result.polylines.push_back(std::move(line));
    }
  }
}

/// Mostly sensible; now and then a number that must be refused or starves the iteration.
void makeOptions(Bytes& bytes, HostileCase& result)
{
  FlatteningOptions& options = result.options;
  options.scheme = static_cast<Scheme>(bytes.next() % 4);
  options.angles.method = bytes.oneIn(3) ? AngleMethod::Sequential : AngleMethod::Newton;
  options.interior.method = bytes.oneIn(4) ? static_cast<InteriorMethod>(bytes.next() % 3)
                                           : InteriorMethod::AsRigidAsPossible;
  options.releaseKeys = bytes.oneIn(8);
  options.arrange = !bytes.oneIn(3);
  if (bytes.oneIn(8))
  {
    options.angles.maximumIterations = static_cast<int>(bytes.next() % 4);
    options.interior.maximumRigidIterations = static_cast<int>(bytes.next() % 4);
    options.isometric.maximumIterations = static_cast<int>(bytes.next() % 4);
  }
  if (bytes.oneIn(8))
  {
    options.isometric.angleWeight = 100.0 * bytes.unit();
    options.isometric.energy.kind = bytes.oneIn(2) ? DistortionEnergyKind::SymmetricDirichlet
                                                   : DistortionEnergyKind::AsRigidAsPossible;
    options.isometric.energy.bias = 1.98 * bytes.unit() - 0.99;
    options.interior.relaxation = 2.0 * bytes.unit();
    options.interior.energyTolerance = std::pow(10.0, -16.0 * bytes.unit());
    options.angles.closureTolerance = std::pow(10.0, -16.0 * bytes.unit());
    options.angles.optimalityTolerance = std::pow(10.0, -16.0 * bytes.unit());
    options.spacing = bytes.unit();
  }
  if (bytes.oneIn(24))
  {
    const double values[] = { -1.0, 1e300, std::numeric_limits<double>::quiet_NaN(), 0.0 };
    double* numbers[] = { &options.isometric.angleWeight, &options.interior.relaxation,
      &options.interior.energyTolerance, &options.angles.closureTolerance, &options.spacing,
      &result.imprint.tolerance, &result.imprint.snap, &options.interior.movement };
    *numbers[bytes.next() % 8] = values[bytes.next() % 4];
  }
  if (bytes.oneIn(6))
  {
    result.imprint.split = !bytes.oneIn(3);
    result.imprint.tolerance = std::pow(10.0, -1.0 - 8.0 * bytes.unit());
    result.imprint.snap = 0.5 * bytes.unit();
  }
  if (bytes.oneIn(8))
  {
    options.conformal.pins = { bytes.below(64) - 2, bytes.below(64) - 2 };
  }
  if (bytes.oneIn(16))
  {
    result.cancelAt = bytes.below(64);
  }
}

/// A material by name, or one with numbers that no cloth has, laid by an angle or a curve that may
/// be there.
void makeCloth(Bytes& bytes, FlatteningOptions& options)
{
  const std::vector<ClothMaterial>& presets = materialPresets();
  ClothOptions cloth;
  cloth.material = presets[bytes.next() % presets.size()];
  cloth.grain = static_cast<GrainKind>(bytes.next() % 3);
  cloth.grainAngle = 8.0 * bytes.unit() - 4.0;
  if (cloth.grain == GrainKind::Curve)
  {
    cloth.grainCurves = { "c" + std::to_string(bytes.next() % 4) };
    cloth.grainAngles = { cloth.grainAngle };
  }
  if (bytes.oneIn(3))
  {
    // Of any size that is allowed, and beyond.
    for (double* modulus : { &cloth.material.warp, &cloth.material.weft, &cloth.material.shear })
    {
      *modulus = std::pow(10.0, 6.2 * bytes.unit());
    }
    cloth.material.compression = std::pow(10.0, -3.2 * bytes.unit());
    cloth.material.warpLimits = { -std::pow(10.0, -7.0 * bytes.unit()),
      std::pow(10.0, 2.0 - 9.0 * bytes.unit()) };
    cloth.material.shearLimit = std::pow(10.0, 1.0 - 8.0 * bytes.unit());
  }
  if (bytes.oneIn(8))
  {
    const double values[] = { -1.0, 0.0, 1e300, 1e-300, std::numeric_limits<double>::infinity(),
      std::numeric_limits<double>::quiet_NaN() };
    double* numbers[] = { &cloth.material.warp, &cloth.material.weft, &cloth.material.shear,
      &cloth.material.cross, &cloth.material.compression, &cloth.material.warpLimits.least,
      &cloth.material.weftLimits.greatest, &cloth.material.shearLimit, &cloth.grainAngle };
    *numbers[bytes.next() % 9] = values[bytes.next() % 6];
  }
  options.cloth = std::move(cloth);
}
}

Index Bytes::below(Index count)
{
  const unsigned value = this->next() | this->next() << 8;
  return count > 0 ? static_cast<Index>(value % static_cast<unsigned>(count)) : 0;
}

HostileCase decodeCase(
  Bytes& bytes, const std::vector<Specimen>& specimens, const SizeRange& triangles)
{
  HostileCase result;
  makeOptions(bytes, result);
  result.coincident = static_cast<CoincidentPoints>(bytes.next() % 3);
  Specimen surface = makeSurface(bytes, specimens, triangles);
  mutateSurface(bytes, surface);
  result.origin = surface.name;
  makeCurves(bytes, surface, result);
  // Whole specimens keep their own curves, unless the walks have replaced them.
  if (result.polylines.empty() && result.chains.empty())
  {
    result.polylines = std::move(surface.curves);
  }
  result.options.closeCuts = bytes.oneIn(3);
  if (bytes.oneIn(4))
  {
    makeCloth(bytes, result.options);
  }
  result.points = std::move(surface.points);
  result.triangles = std::move(surface.triangles);
  return result;
}

HostileCase decodeOrdinaryCase(Bytes& bytes, const SizeRange& triangles)
{
  HostileCase result;
  result.options.scheme = static_cast<Scheme>(bytes.next() % 4);
  Specimen surface = makeOrdinarySurface(bytes, triangles);
  result.origin = surface.name;
  if (bytes.oneIn(2))
  {
    makeCurves(bytes, surface, result);
  }
  result.points = std::move(surface.points);
  result.triangles = std::move(surface.triangles);
  return result;
}
}
