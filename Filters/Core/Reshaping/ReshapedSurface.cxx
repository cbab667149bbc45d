// SPDX-License-Identifier: BSD-3-Clause
#include "Reshaping/ReshapedSurface.h"

#include "Base/Types.h"
#include "Quality/StrainMeasures.h"
#include "Sewing/SewingModel.h"
#include "Sewing/SewnTopology.h"
#include "Surface/TriangleMesh.h"
#include "Surface/VertexFan.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flattening
{
namespace
{
/// The surface is flattened again before rest would matter.
constexpr double energyTolerance = 1e-4;
}

ReshapedSurface::ReshapedSurface(const TriangleMesh& design, std::vector<char> held)
  : Design(&design)
  , Held(std::move(held))
  , Outwards(vertexNormals(design))
  , Points(design.points())
{
}

TriangleMesh ReshapedSurface::mesh() const
{
  Indices twins(this->Design->halfedgeCount());
  for (Index h = 0; h < this->Design->halfedgeCount(); ++h)
  {
    twins[h] = this->Design->twin(h);
  }
  return { this->Points, this->Design->triangles(), std::move(twins) };
}

bool ReshapedSurface::canMove() const
{
  return std::find(this->Held.begin(), this->Held.end(), 0) != this->Held.end();
}

bool ReshapedSurface::sew(
  const FlatteningResult& flat, const ReshapingForces& forces, const Execution& execution)
{
  SewnTopology topology = sewnShapes(*flat.cut, flat.positions, SewingTest::Product);
  Points3 sewn = this->Points;
  for (SewnShape& shape : topology.shapes)
  {
    const double area = shape.cloth.restArea();
    if (!(area > 0.0))
    {
      continue;
    }
    Indices original;
    Points3 from;
    for (std::size_t v = 0; v < shape.vertices.size(); ++v)
    {
      original.push_back(flat.cut->originalVertex[shape.vertices[v]]);
      shape.cloth.points[v] = this->Design->point(original[v]);
      shape.cloth.held[v] = this->Held[original[v]];
      shape.cloth.outwards.push_back(this->Outwards[original[v]]);
      from.push_back(this->Points[original[v]]);
    }
    ClothProperties properties;
    properties.thickness = forces.thickness * std::sqrt(area);
    properties.anchor = forces.anchor;
    properties.outsideBias = forces.outsideBias;
    properties.body = forces.body;
    properties.gap = forces.gap * std::sqrt(area);
    SewingModel model(shape.cloth, properties);
    if (model.unknownCount() == 0)
    {
      continue;
    }
    RestOptions rest;
    rest.energyTolerance = energyTolerance;
    rest.maximumIterations = forces.maximumIterations;
    const NewtonKktState end = bringToRest(model, from, rest, execution);
    if (end.cancelled())
    {
      return false;
    }
    const Points3 points = model.positions(end.x);
    for (std::size_t v = 0; v < points.size(); ++v)
    {
      if (!shape.cloth.held[v] && isFinite(points[v]))
      {
        sewn[original[v]] = this->settled(original[v], points[v], forces);
      }
    }
  }
  this->Points = std::move(sewn);
  return true;
}

Point3 ReshapedSurface::settled(
  Index vertex, const Point3& place, const ReshapingForces& forces) const
{
  const Point3& out = this->Outwards[vertex];
  const double along = out.dot(place - this->Design->point(vertex));
  // Springs give, if by little.
  return forces.outsideBias >= 1.0 && along < 0.0 ? Point3(place - along * out) : place;
}

ReshapedSurface ReshapedSurface::partOfTheWay(double share) const
{
  ReshapedSurface part = *this;
  for (Index v = 0; v < this->Design->vertexCount(); ++v)
  {
    const Point3& designed = this->Design->point(v);
    part.Points[v] =
      this->Held[v] ? designed : Point3(designed + share * (this->Points[v] - designed));
  }
  return part;
}

SurfaceShift measureShift(const TriangleMesh& design, const Points3& points)
{
  SurfaceShift shift;
  const std::vector<double> areas =
    vertexAreas(design.triangles(), points.size(), [&design](Index t) { return design.area(t); });
  const double area = design.area();
  std::vector<AreaValue> values;
  const Points3 outwards = vertexNormals(design);
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    const Point3 moved = points[v] - design.point(static_cast<Index>(v));
    shift.ofVertex.push_back(moved.norm());
    shift.outwardsOfVertex.push_back(outwards[v].dot(moved));
    shift.outwardsMean += areas[v] / area * shift.outwardsOfVertex[v];
    shift.inwardsMax = std::max(shift.inwardsMax, -shift.outwardsOfVertex[v]);
    shift.mean += areas[v] / area * shift.ofVertex[v];
    shift.max = std::max(shift.max, shift.ofVertex[v]);
    values.push_back({ shift.ofVertex[v], areas[v] });
  }
  shift.size = std::sqrt(area);
  shift.p95 = areaQuantile(std::move(values));
  return shift;
}
}
