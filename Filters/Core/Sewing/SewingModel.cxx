// SPDX-License-Identifier: BSD-3-Clause
#include "Sewing/SewingModel.h"

#include "Base/CompressedRows.h"
#include "Base/Types.h"
#include "Sewing/SheetDensity.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace
{
/// Of what keeps the whole from moving, beside entries about 1.
constexpr double gaugeStiffness = 1.0;

double unitOf(const SewnCloth& cloth)
{
  return std::sqrt(cloth.restArea() / static_cast<double>(cloth.flat.size()));
}

Point3 centerOf(const Points3& points)
{
  Point3 sum = Point3::Zero();
  for (const Point3& p : points)
  {
    sum += p / static_cast<double>(points.size());
  }
  return sum;
}

SpaceUnknowns unknownsOf(const SewnCloth& cloth, const Point3& center, double unit)
{
  SpaceUnknowns unknowns;
  Index next = 0;
  for (std::size_t v = 0; v < cloth.points.size(); ++v)
  {
    unknowns.points.emplace_back((cloth.points[v] - center) / unit);
    unknowns.first.push_back(cloth.held[v] ? none : next);
    next += cloth.held[v] ? 0 : 3;
  }
  return unknowns;
}

TriangleFrames restOf(const SewnCloth& cloth, double unit)
{
  TriangleFrames rest;
  rest.reserve(cloth.flat.size());
  for (const std::array<Point2, 3>& corner : cloth.flat)
  {
    rest.push_back(restFrame({ corner[0] / unit, corner[1] / unit, corner[2] / unit }));
  }
  return rest;
}

std::unique_ptr<ContactBody> bodyOf(const TriangleMesh* body, const Point3& center, double unit)
{
  if (!body || body->triangleCount() == 0)
  {
    return nullptr;
  }
  Points3 points;
  for (const Point3& p : body->points())
  {
    points.emplace_back((p - center) / unit);
  }
  return std::make_unique<ContactBody>(TriangleMesh(std::move(points), body->triangles()));
}

Index countOf(const SpaceUnknowns& unknowns)
{
  return 3 *
    static_cast<Index>(std::count_if(
      unknowns.first.begin(), unknowns.first.end(), [](Index first) { return first != none; }));
}
}

double SewnCloth::restArea(std::size_t triangle) const
{
  const std::array<Point2, 3>& corner = this->flat[triangle];
  return 0.5 * std::abs(cross(corner[1] - corner[0], corner[2] - corner[0]));
}

double SewnCloth::restArea() const
{
  double area = 0.0;
  for (std::size_t t = 0; t < this->flat.size(); ++t)
  {
    area += this->restArea(t);
  }
  return area;
}

SewingModel::SewingModel(const SewnCloth& cloth, const ClothProperties& properties)
  : Center(centerOf(cloth.points))
  , Unit(unitOf(cloth))
  , Unknowns(unknownsOf(cloth, Center, Unit))
  , Count(countOf(Unknowns))
  , Membrane(Unknowns, cloth.triangles, restOf(cloth, Unit),
      properties.material ? SheetDensity(*properties.material) : SheetDensity(properties.areaBias))
  , Bending(Unknowns, Membrane, cloth.twins,
      isotropicModulus * properties.thickness * properties.thickness / (12.0 * Unit * Unit))
  , Anchor(Unknowns, Membrane, properties.anchor, properties.outsideBias, cloth.outwards)
  , Pressure(Unknowns, Membrane, isotropicModulus * properties.pressure * Unit)
  , Weight(Unknowns, Membrane, isotropicModulus * Unit * properties.weight)
  , Body(bodyOf(properties.body, Center, Unit))
  , Contact(Unknowns, Membrane, Body.get(), properties.gap / Unit)
  , Hessian(Count)
{
  if (!(properties.anchor > 0.0))
  {
    this->chooseGauge();
  }
  this->Membrane.declare(this->Hessian);
  this->Bending.declare(this->Hessian);
  this->Pressure.declare(this->Hessian);
  this->Hessian.finish();
}

/// The vertex farthest from the centre, the one farthest from it, and the one farthest from their
/// line.
void SewingModel::chooseGauge()
{
  if (this->Count < 3 * static_cast<Index>(this->Unknowns.points.size()) || this->Count < 9)
  {
    return;
  }
  const auto farthest = [this](const auto& distance) {
    Index best = 0;
    double largest = -1.0;
    for (Index v = 0; v < static_cast<Index>(this->Unknowns.points.size()); ++v)
    {
      const double d = distance(this->Unknowns.points[v]);
      if (d > largest)
      {
        largest = d;
        best = v;
      }
    }
    return best;
  };
  const Index a = farthest([](const Point3& p) { return p.squaredNorm(); });
  const Point3 from = this->Unknowns.points[a];
  const Index b = farthest([&from](const Point3& p) { return (p - from).squaredNorm(); });
  const Point3 along = (this->Unknowns.points[b] - from).normalized();
  const Index c = farthest([&](const Point3& p) { return along.cross(p - from).squaredNorm(); });
  this->Gauge = { a, b, c };
}

Eigen::VectorXd SewingModel::unknownsAt(const Points3& points) const
{
  Eigen::VectorXd x(this->Count);
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    if (this->Unknowns.first[v] != none)
    {
      x.segment<3>(this->Unknowns.first[v]) = (points[v] - this->Center) / this->Unit;
    }
  }
  return x;
}

Points3 SewingModel::positions(const Eigen::VectorXd& x) const
{
  Points3 points;
  points.reserve(this->Unknowns.points.size());
  for (Index v = 0; v < static_cast<Index>(this->Unknowns.points.size()); ++v)
  {
    points.emplace_back(this->Center + this->Unit * this->Unknowns.at(v, x));
  }
  return points;
}

SewingModel::Terms SewingModel::terms(const Eigen::VectorXd& x, const Execution& execution) const
{
  return { this->Membrane.energy(x, execution), this->Bending.energy(x), this->Anchor.energy(x),
    this->Pressure.energy(x), this->Weight.energy(x), this->Contact.energy(x, execution) };
}

double SewingModel::objective(const Eigen::VectorXd& x, const Execution& execution) const
{
  const Terms energy = this->terms(x, execution);
  return energy.membrane + energy.bending + energy.anchor + energy.pressure + energy.weight +
    energy.contact;
}

NewtonKktModel::Linearization SewingModel::linearize(const Eigen::VectorXd& x,
  const Eigen::VectorXd& /*multipliers*/, Curvature curvature, double /*delta*/,
  const Execution& execution)
{
  Linearization result;
  result.gradient = Eigen::VectorXd::Zero(this->Count);
  this->Hessian.clear();
  this->Membrane.add(x, curvature, this->Hessian, result.gradient, execution);
  this->Bending.add(x, this->Hessian, result.gradient);
  this->Anchor.add(x, this->Hessian, result.gradient);
  this->Pressure.add(x, curvature, this->Hessian, result.gradient);
  this->Weight.add(result.gradient);
  this->Contact.add(x, this->Hessian, result.gradient, execution);
  if (this->Gauge[0] != none)
  {
    this->holdMotion(x);
  }
  return result;
}

/// The first vertex does not move, the second only towards it, the third only in their plane: steps
/// of the whole that the energy, and so its gradient, knows nothing of.
void SewingModel::holdMotion(const Eigen::VectorXd& x)
{
  std::array<Point3, 3> at;
  for (std::size_t k = 0; k < 3; ++k)
  {
    at[k] = this->Unknowns.at(this->Gauge[k], x);
  }
  const Point3 along = (at[1] - at[0]).normalized();
  const Point3 across = along.cross(at[2] - at[0]).normalized();
  const Eigen::Matrix3d all = Eigen::Matrix3d::Identity();
  const std::array<Eigen::Matrix3d, 3> held{ all, all - along * along.transpose(),
    across * across.transpose() };
  for (std::size_t k = 0; k < 3; ++k)
  {
    this->Hessian.addOwn(this->Unknowns.first[this->Gauge[k]], gaugeStiffness * held[k]);
  }
}

void SewingModel::shift(double tau)
{
  for (Index x = 0; x < this->Count; x += 3)
  {
    this->Hessian.addOwn(x, tau * Eigen::Matrix3d::Identity());
  }
}

Dissection SewingModel::eliminationOrder() const
{
  Triangles cliques = this->Membrane.triangles();
  this->Bending.addCliques(cliques);
  return dissect(cliques, this->Unknowns.points).ofUnknowns(3, [this](Index v) {
    return this->Unknowns.first[v];
  });
}

namespace
{
/// Far from rest the exact Hessian is seldom convex; it pays once no vertex moves by that many
/// roots of the mean triangle area.
constexpr double exactWithin = 0.3;
/// A step that moves a vertex farther could turn triangles over.
constexpr double maximumMove = 1.0;
/// Nothing moves any more, in roots of the mean triangle area.
constexpr double stepTolerance = 1e-11;
/// Of the body beside that of the cloth, an area, where lengths are in roots of the mean triangle
/// area: first soft, then, while a vertex is inside, ten times as hard.
constexpr double firstPush = 1.0;
constexpr double hardening = 10.0;
constexpr int maxHardenings = 4;
/// No force on a vertex, over modulus times the root of the mean triangle area, is larger at rest.
constexpr double forceRounding = 1e-12;
}

NewtonKktState bringToRest(
  SewingModel& model, const Points3& from, const RestOptions& options, const Execution& execution)
{
  NewtonKktOptions newton;
  newton.maximumIterations = options.maximumIterations;
  newton.optimalityTolerance = isotropicModulus * forceRounding;
  newton.reductionTolerance = options.energyTolerance;
  newton.stepTolerance = stepTolerance;
  newton.exactWithin = exactWithin;
  newton.maximumMove = maximumMove;
  newton.phase = options.phase;
  newton.observe = options.observe;
  const auto minimumFrom = [&](const Eigen::VectorXd& x) {
    return minimize(model, { x, {} }, LinearSolver(model.eliminationOrder()), newton, execution);
  };
  if (!model.hasBody())
  {
    return minimumFrom(model.unknownsAt(from));
  }
  NewtonKktState state{ model.unknownsAt(from), {} };
  double stiffness = firstPush;
  for (int k = 0; k <= maxHardenings; ++k)
  {
    model.push(ContactForce::Penalty, stiffness);
    state = minimumFrom(state.x);
    if (state.cancelled())
    {
      return state;
    }
    if (model.leastDistance(state.x, execution) > 0.0)
    {
      model.push(ContactForce::Barrier, stiffness);
      return minimumFrom(state.x);
    }
    stiffness *= hardening;
  }
  return state;
}

namespace
{
/// Numbers sets in the order of their names; \param shapeOf filled per member.
Index numbered(JoinedSets& sets, Index count, Indices& shapeOf)
{
  Index next = 0;
  shapeOf.assign(count, none);
  for (Index k = 0; k < count; ++k)
  {
    const Index name = sets.find(k);
    shapeOf[k] = name == k ? next++ : shapeOf[name];
  }
  return next;
}
}

SewnTopology sewnShapes(const CutSurface& cut, const Points2& positions, SewingTest test)
{
  const TriangleMesh& mesh = cut.mesh;
  const bool product = test == SewingTest::Product;
  JoinedSets vertices(mesh.vertexCount());
  JoinedSets pieces(cut.pieceCount);
  std::vector<char> sewn(cut.pieceCount, 0);
  Indices twins = mesh.twins();
  for (const SeamPair& pair : cut.seamPairs)
  {
    if (product)
    {
      vertices.join(mesh.from(pair.first), mesh.to(pair.second));
      vertices.join(mesh.to(pair.first), mesh.from(pair.second));
      pieces.join(cut.pieceOfTriangle[pair.first / 3], cut.pieceOfTriangle[pair.second / 3]);
      sewn[cut.pieceOfTriangle[pair.first / 3]] = 1;
      twins[pair.first] = pair.second;
      twins[pair.second] = pair.first;
    }
  }

  SewnTopology result;
  Indices shapeOfPiece;
  result.shapes.resize(numbered(pieces, cut.pieceCount, shapeOfPiece));
  for (Index p = 0; p < cut.pieceCount; ++p)
  {
    SewnShape& shape = result.shapes[shapeOfPiece[p]];
    ++shape.pieces;
    shape.sewn = shape.sewn || sewn[p];
  }
  result.vertexInShape.assign(mesh.vertexCount(), none);
  Indices triangleInShape(mesh.triangleCount());
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    result.shapeOfTriangle.push_back(shapeOfPiece[cut.pieceOfTriangle[t]]);
    SewnShape& shape = result.shapes[result.shapeOfTriangle.back()];
    Triangle corners{};
    std::array<Point2, 3> flat;
    for (int k = 0; k < 3; ++k)
    {
      const Index copy = mesh.triangle(t)[k];
      const Index vertex = vertices.find(copy);
      if (result.vertexInShape[vertex] == none)
      {
        result.vertexInShape[vertex] = static_cast<Index>(shape.vertices.size());
        shape.vertices.push_back(vertex);
        shape.cloth.points.push_back(mesh.point(vertex));
        shape.cloth.held.push_back(!product && mesh.onBoundary(vertex) ? 1 : 0);
      }
      result.vertexInShape[copy] = result.vertexInShape[vertex];
      corners[k] = result.vertexInShape[vertex];
      flat[k] = positions[copy];
    }
    triangleInShape[t] = static_cast<Index>(shape.triangles.size());
    shape.triangles.push_back(t);
    shape.cloth.triangles.push_back(corners);
    shape.cloth.flat.push_back(flat);
  }
  for (SewnShape& shape : result.shapes)
  {
    for (Index t : shape.triangles)
    {
      for (Index h = 3 * t; h < 3 * t + 3; ++h)
      {
        const Index twin = twins[h];
        shape.cloth.twins.push_back(twin == none ? none : 3 * triangleInShape[twin / 3] + twin % 3);
      }
    }
  }
  return result;
}
}
