// SPDX-License-Identifier: BSD-3-Clause
#include "Isometric/IsometricModel.h"

#include "Base/Types.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{
// All per unit of weight, chosen by 49 pieces of garments and shoes at a weight of 5.

/// Bending stiffness over the area to the power 1.5. The least one spreads the bend that a wire's
/// end makes in another over about a thirtieth of the piece; the first holds wires nearly in their
/// shape while forces are found; beyond the largest the wires' own stiffness makes the forces.
constexpr double minBending = 7.3e-6;
constexpr double firstBending = 2e-5;
constexpr double largestBending = 8e-5;
/// Bending stiffness over the cube of the force: seven times what keeps the edge of a sheet from
/// wrinkling, which is 1.9 times the force.
constexpr double bendingByForce = 0.06;
/// Inside, the sheet holds four times as much (c^2), and two hinges bend together.
constexpr double shareInside = 1.0 / 8.0;
/// Wires that meet, and corners, bend in one point: least stiffness there, in triangles of mean
/// area, so that what finer meshes smooth over is no kink in coarser ones. It fades out where the
/// angle nears a straight one, from a turn of 37 degrees on.
constexpr double cornerStiffness = 0.2;
constexpr double cornerSlope = 5.0;
}

WireStiffness::WireStiffness(double weight, double sheetArea, double sheetModulus)
  : Weight(weight)
  , Area(sheetArea)
  , Modulus(sheetModulus)
{
}

double WireStiffness::ofBending(const WireHinge& hinge, double bending) const
{
  const double corner =
    cornerStiffness * std::min(1.0, cornerSlope * (1.0 + std::cos(hinge.angle)));
  return this->Weight * this->Modulus * std::max(bending / hinge.length, corner);
}

double WireStiffness::unknownForce(const WireHinge& hinge) const
{
  return this->ofBending(hinge, firstBending * std::pow(this->Area, 1.5));
}

double WireStiffness::underForce(const WireHinge& hinge, double force) const
{
  const double unit = std::pow(this->Area, 1.5);
  const double pressing = std::max(0.0, force) / this->Modulus;
  const double needed =
    (hinge.sheetOnBothSides ? shareInside : 1.0) * bendingByForce * std::pow(pressing, 3);
  return this->ofBending(hinge, std::clamp(needed, minBending * unit, largestBending * unit));
}

namespace
{
/// Stiffness against turns of a cloth that nothing holds: unstrained it knows of none, and rounding
/// in the gradient must not turn it.
constexpr double minTurning = 1e-7;
}

IsometricModel::IsometricModel(const Piece& piece, const AngleProblem& problem,
  const SheetEnergy& energy, double bendingWeight, const GrainHold& hold,
  const BoundaryFilling& filling, const RegionWeights& weights)
  : Problem(problem)
  , Unit(std::sqrt(piece.mesh.area() / piece.mesh.triangleCount()))
  , Sheet(piece.mesh, Unit, energy, filling, weights)
  , Hold(energy.turnsFreely() ? GrainHold() : hold)
  , Stiffness(bendingWeight, piece.mesh.triangleCount(), Sheet.modulus())
  , CoordinateCount(2 * piece.mesh.vertexCount())
  , Assembler(0)
{
  const TriangleMesh& mesh = piece.mesh;
  const WireNetwork& net = *problem.network;
  for (Index e = 0; e < net.edgeCount(); ++e)
  {
    if (problem.held[e])
    {
      this->LengthEdges.push_back(e);
      this->Length.push_back(problem.length[e] / this->Unit);
    }
  }
  double farthest = -1.0;
  this->FixedVertices[0] = net.vertex.front();
  for (Index v : net.hostVertices)
  {
    const double d = (mesh.point(v) - mesh.point(this->FixedVertices[0])).squaredNorm();
    if (d > farthest)
    {
      farthest = d;
      this->FixedVertices[1] = v;
    }
  }
  this->addNodes();
  this->declareEntries();
}

IsometricModel::Node IsometricModel::makeNode(Index node, const Indices& lengthOfEdge) const
{
  const WireNetwork& net = *this->Problem.network;
  const std::array<Index, 2> edges{ net.edge[net.previous[node]], net.edge[node] };
  Node result{ net.vertex[net.previous[node]], net.vertex[node], net.endVertex(node),
    this->Problem.target[node], node, { lengthOfEdge[edges[0]], lengthOfEdge[edges[1]] }, {}, 0.0 };
  result.hinge.angle = net.alpha[node];
  for (Index e : edges)
  {
    result.hinge.length += 0.5 * net.edges[e].length / this->Unit;
  }
  result.hinge.sheetOnBothSides =
    net.edges[edges[0]].otherSide != none || net.edges[edges[1]].otherSide != none;
  result.stiffness = this->Problem.weight[node] * this->Stiffness.unknownForce(result.hinge);
  return result;
}

void IsometricModel::addNodes()
{
  const WireNetwork& net = *this->Problem.network;
  Indices lengthOfEdge(net.edgeCount(), none);
  for (std::size_t k = 0; k < this->LengthEdges.size(); ++k)
  {
    lengthOfEdge[this->LengthEdges[k]] = static_cast<Index>(k);
  }
  for (std::size_t host = 0; host < net.hostVertices.size(); ++host)
  {
    // Where all nodes of an interior vertex are locked, the last follows from the others.
    Index lockedHere = 0;
    const Index count = net.vertexNodeBegin[host + 1] - net.vertexNodeBegin[host];
    for (Index k = net.vertexNodeBegin[host]; k < net.vertexNodeBegin[host + 1]; ++k)
    {
      const Index i = net.vertexNodes[k];
      const Index in = net.edge[net.previous[i]];
      const Index out = net.edge[i];
      if (in == out || !this->Problem.held[in] || !this->Problem.held[out])
      {
        continue;
      }
      Node node = this->makeNode(i, lengthOfEdge);
      if (this->Problem.locks.locked[i])
      {
        ++lockedHere;
        if (!net.interior[host] || lockedHere < count)
        {
          node.target = this->Problem.locks.angle[i];
          this->LockedNodes.push_back(node);
        }
      }
      else if (node.stiffness > 0.0)
      {
        this->Nodes.push_back(node);
      }
    }
  }
}

void IsometricModel::declareEntries()
{
  const Index n = this->unknownCount();
  this->Assembler = SymmetricAssembler(n + this->constraintCount());
  this->Assembler.reserve(this->Sheet.entryCount() + 21 * this->Nodes.size() +
    15 * this->LengthEdges.size() + 27 * this->LockedNodes.size() +
    2 * static_cast<std::size_t>(n + this->constraintCount()));
  const auto coordinates = [](const std::array<Index, 3>& v) {
    return std::array<Index, 6>{ 2 * v[0], 2 * v[0] + 1, 2 * v[1], 2 * v[1] + 1, 2 * v[2],
      2 * v[2] + 1 };
  };
  this->Sheet.declare(this->Assembler);
  for (const Node& node : this->Nodes)
  {
    this->NodeBlocks.emplace_back(
      this->Assembler, coordinates({ node.before, node.at, node.after }));
  }
  const WireNetwork& net = *this->Problem.network;
  Index row = n;
  for (Index e : this->LengthEdges)
  {
    const Index from = 2 * net.edges[e].from;
    const Index to = 2 * net.edges[e].to;
    const Index group = this->Problem.stretchGroup[e];
    const Index stretch = group == none ? none : this->CoordinateCount + group;
    this->LengthBlocks.emplace_back(
      this->Assembler, std::array<Index, 4>{ from, from + 1, to, to + 1 });
    this->LengthRowBlocks.emplace_back(
      this->Assembler, row++, std::array<Index, 5>{ from, from + 1, to, to + 1, stretch });
  }
  for (const Node& node : this->LockedNodes)
  {
    const auto unknowns = coordinates({ node.before, node.at, node.after });
    this->LockedBlocks.emplace_back(this->Assembler, unknowns);
    this->LockedRowBlocks.emplace_back(this->Assembler, row++, unknowns);
  }
  for (const GrainHold::Weight& part : this->Hold.weights)
  {
    this->HoldBlocks.emplace_back(
      this->Assembler, row, std::array<Index, 2>{ 2 * part.vertex, 2 * part.vertex + 1 });
  }
  this->Diagonal = { this->Assembler, 0, n + this->constraintCount() };
  const Index far = this->FixedVertices[1];
  this->FarVertexBlock = { this->Assembler, { 2 * far, 2 * far + 1 } };
  this->Assembler.finish();
  this->LengthRows.resize(this->LengthEdges.size());
  this->LockedRows.resize(this->LockedNodes.size());
}

Eigen::VectorXd IsometricModel::unknowns(
  const Points2& positions, const std::vector<double>& stretch) const
{
  Eigen::VectorXd x = Eigen::VectorXd::Zero(this->unknownCount());
  for (std::size_t v = 0; v < positions.size(); ++v)
  {
    x.segment<2>(2 * static_cast<Eigen::Index>(v)) = positions[v] / this->Unit;
  }
  for (std::size_t g = 0; g < stretch.size(); ++g)
  {
    x[this->CoordinateCount + static_cast<Eigen::Index>(g)] = stretch[g];
  }
  return x;
}

Points2 IsometricModel::positions(const Eigen::VectorXd& x) const
{
  Points2 result(this->CoordinateCount / 2);
  for (std::size_t v = 0; v < result.size(); ++v)
  {
    result[v] = this->Unit * planePoint(x, static_cast<Index>(v));
  }
  return result;
}

std::vector<double> IsometricModel::stretches(const Eigen::VectorXd& x) const
{
  return { x.data() + this->CoordinateCount, x.data() + this->unknownCount() };
}

/// The interior angle to the left of the path before - at - after, on the branch next to its
/// target.
double IsometricModel::nodeAngle(const Node& node, const Eigen::VectorXd& x)
{
  return nearestBranch(
    interiorAngle(planePoint(x, node.before), planePoint(x, node.at), planePoint(x, node.after)),
    node.target);
}

IsometricModel::Terms IsometricModel::terms(
  const Eigen::VectorXd& x, const Execution& execution) const
{
  Terms terms;
  terms.sheet = this->Sheet.energy(x, execution);
  for (const Node& node : this->Nodes)
  {
    const double d = this->nodeAngle(node, x) - node.target;
    terms.angles += node.stiffness * d * d;
  }
  terms.total = terms.sheet + terms.angles;
  for (Index g = 0; g < this->groupCount(); ++g)
  {
    const double h = x[this->CoordinateCount + g];
    terms.total += 0.5 * this->Problem.groups[g].weight * h * h;
  }
  return terms;
}

bool IsometricModel::switchToFinalObjective(const Eigen::VectorXd& multipliers)
{
  if (this->KeepsStiffness || this->Settled)
  {
    return false;
  }
  this->Settled = true;
  for (Node& node : this->Nodes)
  {
    // A multiplier above zero draws.
    const double pressing = -std::min(multipliers[node.lengths[0]], multipliers[node.lengths[1]]);
    node.stiffness =
      this->Problem.weight[node.node] * this->Stiffness.underForce(node.hinge, pressing);
  }
  return !this->Nodes.empty();
}

std::vector<double> IsometricModel::stiffness() const
{
  std::vector<double> result(this->Problem.network->nodeCount(), 0.0);
  for (const Node& node : this->Nodes)
  {
    result[node.node] = node.stiffness;
  }
  return result;
}

Eigen::VectorXd IsometricModel::constraints(const Eigen::VectorXd& x) const
{
  const WireNetwork& net = *this->Problem.network;
  Eigen::VectorXd c(this->constraintCount());
  for (Index k = 0; k < this->lengthCount(); ++k)
  {
    const WireEdge& edge = net.edges[this->LengthEdges[k]];
    const Index group = this->Problem.stretchGroup[this->LengthEdges[k]];
    const double stretch = group == none ? 1.0 : 1.0 + x[this->CoordinateCount + group];
    c[k] = (planePoint(x, edge.to) - planePoint(x, edge.from)).norm() - stretch * this->Length[k];
  }
  for (std::size_t k = 0; k < this->LockedNodes.size(); ++k)
  {
    c[this->lengthCount() + static_cast<Index>(k)] =
      this->nodeAngle(this->LockedNodes[k], x) - this->LockedNodes[k].target;
  }
  if (this->Hold.holds())
  {
    double sum = 0.0;
    for (const GrainHold::Weight& part : this->Hold.weights)
    {
      sum += part.weight.dot(planePoint(x, part.vertex));
    }
    c[this->holdRow()] = sum;
  }
  return c;
}

/// That of lengths between points as far from the origin as these.
double IsometricModel::constraintRounding(const Eigen::VectorXd& x, double) const
{
  const double farthest = x.size() ? x.cwiseAbs().maxCoeff() : 0.0;
  return std::numeric_limits<double>::epsilon() * farthest *
    static_cast<double>(this->constraintCount());
}

/// The gradient is that of a sum of squares. A developable piece has no energy; the floor is what
/// rounding leaves of the gradient.
double IsometricModel::gradientScale(double objective) const
{
  constexpr double floor = 1e-2;
  return std::max(std::sqrt(objective), floor);
}

/// Wires are stiffer against the rounding of positions than the sheet is, the more so the finer the
/// mesh. Each coordinate is off by half a unit of its last place, six make an angle, and three
/// angles the gradient at a vertex.
double IsometricModel::gradientRounding(const Eigen::VectorXd& x) const
{
  double stiffest = 0.0;
  for (const Node& node : this->Nodes)
  {
    const double squared = nodeGradient(node, x).squaredNorm();
    stiffest = std::max(stiffest, 2.0 * node.stiffness * squared);
  }
  const double farthest = x.size() ? x.cwiseAbs().maxCoeff() : 0.0;
  return 2.0 * std::numeric_limits<double>::epsilon() * farthest * stiffest;
}

void IsometricModel::shift(double tau)
{
  for (Index k = 0; k < this->CoordinateCount; ++k)
  {
    this->Diagonal.add(this->Assembler, k, tau);
  }
}

void IsometricModel::stiffen(Index bounded, double stiffness)
{
  this->Diagonal.add(this->Assembler, this->CoordinateCount + bounded, stiffness);
}

void IsometricModel::fixMotion(const Eigen::VectorXd& x)
{
  const Index near = this->FixedVertices[0];
  const Eigen::Vector2d d = planePoint(x, this->FixedVertices[1]) - planePoint(x, near);
  const Eigen::Vector2d across = Eigen::Vector2d(-d.y(), d.x()).normalized();
  this->Diagonal.add(this->Assembler, 2 * near, 1.0);
  this->Diagonal.add(this->Assembler, 2 * near + 1, 1.0);
  const double turning = this->Sheet.turnsFreely() ? 1.0 : this->Hold.holds() ? 0.0 : minTurning;
  this->FarVertexBlock.add(
    this->Assembler, [&](int a, int b) { return turning * across[a] * across[b]; });
}

/// Per vertex.
std::vector<char> IsometricModel::hubsOfWires() const
{
  const WireNetwork& net = *this->Problem.network;
  Indices valence(this->CoordinateCount / 2, 0);
  for (Index e : this->LengthEdges)
  {
    ++valence[net.edges[e].from];
    ++valence[net.edges[e].to];
  }
  std::vector<char> hub(valence.size());
  std::transform(valence.begin(), valence.end(), hub.begin(),
    [enough = hubValence(this->lengthCount())](Index wires) { return wires > enough; });
  return hub;
}

Dissection dissectVertices(Triangles cells, const WireNetwork& network, const Points2& positions)
{
  // The ends of a wire-node's two edges are coupled as if a triangle joined them.
  for (Index i = 0; i < network.nodeCount(); ++i)
  {
    cells.push_back(
      { network.vertex[network.previous[i]], network.vertex[i], network.endVertex(i) });
  }
  Points3 places;
  places.reserve(positions.size());
  for (const Point2& p : positions)
  {
    places.emplace_back(p.x(), p.y(), 0.0);
  }
  return dissect(cells, places);
}

Dissection IsometricModel::eliminationOrder(const Dissection& dissection) const
{
  const WireNetwork& net = *this->Problem.network;
  const Indices& vertices = dissection.order;
  Indices place(vertices.size());
  for (std::size_t k = 0; k < vertices.size(); ++k)
  {
    place[vertices[k]] = static_cast<Index>(k);
  }
  // Behind a hub of wires they would stand together, all coupled: there they come before it, one
  // after each other end, which has two coordinates to pay for it.
  const std::vector<char> hub = this->hubsOfWires();
  std::vector<char> paid(vertices.size(), 0);
  std::vector<Indices> constraintsAfter(vertices.size());
  for (Index k = 0; k < this->lengthCount(); ++k)
  {
    const WireEdge& edge = net.edges[this->LengthEdges[k]];
    Index after = std::max(place[edge.from], place[edge.to]);
    const Index before = std::min(place[edge.from], place[edge.to]);
    if (hub[vertices[after]] && !hub[vertices[before]] && !paid[before])
    {
      paid[before] = 1;
      after = before;
    }
    constraintsAfter[after].push_back(k);
  }
  for (std::size_t k = 0; k < this->LockedNodes.size(); ++k)
  {
    const Node& node = this->LockedNodes[k];
    const Index ends = std::max(place[node.before], place[node.after]);
    constraintsAfter[hub[node.at] ? ends : std::max(ends, place[node.at])].push_back(
      this->lengthCount() + static_cast<Index>(k));
  }
  Dissection result = dissection.replaced([&](Index k, Indices& order) {
    order.push_back(2 * vertices[k]);
    order.push_back(2 * vertices[k] + 1);
    for (Index constraint : constraintsAfter[k])
    {
      order.push_back(this->unknownCount() + constraint);
    }
  });
  for (Index g = 0; g < this->groupCount(); ++g)
  {
    result.order.push_back(this->CoordinateCount + g);
  }
  if (this->Hold.holds())
  {
    result.order.push_back(
      this->unknownCount() + this->holdRow()); // it couples what lies far apart
  }
  result.endRange(static_cast<Index>(result.order.size()));
  return result;
}

namespace
{
/// Gradient and Hessian of the direction angle of a vector.
Eigen::Vector2d angleGradient(const Eigen::Vector2d& d)
{
  return Eigen::Vector2d(-d.y(), d.x()) / d.squaredNorm();
}
Eigen::Matrix2d angleHessian(const Eigen::Vector2d& d)
{
  const double r2 = d.squaredNorm();
  const double a = 2.0 * d.x() * d.y() / (r2 * r2);
  const double b = (d.y() * d.y() - d.x() * d.x()) / (r2 * r2);
  Eigen::Matrix2d h;
  h << a, b, b, -a;
  return h;
}
}

Eigen::Matrix<double, 6, 1> IsometricModel::nodeGradient(const Node& node, const Eigen::VectorXd& x)
{
  // theta = pi + phi_in - phi_out (Eq. 3)
  const Eigen::Vector2d gIn = angleGradient(planePoint(x, node.at) - planePoint(x, node.before));
  const Eigen::Vector2d gOut = angleGradient(planePoint(x, node.after) - planePoint(x, node.at));
  Eigen::Matrix<double, 6, 1> gradient;
  gradient << -gIn, gIn + gOut, -gOut;
  return gradient;
}

IsometricModel::NodeGeometry IsometricModel::nodeGeometry(
  const Node& node, const Eigen::VectorXd& x, bool second)
{
  NodeGeometry geometry;
  geometry.angle = nodeAngle(node, x);
  geometry.gradient = nodeGradient(node, x);
  geometry.hessian.setZero();
  if (second)
  {
    const Eigen::Vector2d in = planePoint(x, node.at) - planePoint(x, node.before);
    const Eigen::Vector2d out = planePoint(x, node.after) - planePoint(x, node.at);
    const Eigen::Matrix2d hIn = angleHessian(in);
    const Eigen::Matrix2d hOut = angleHessian(out);
    geometry.hessian.block<2, 2>(0, 0) = hIn;
    geometry.hessian.block<2, 2>(2, 0) = -hIn;
    geometry.hessian.block<2, 2>(0, 2) = -hIn;
    geometry.hessian.block<2, 2>(2, 2) = hIn - hOut;
    geometry.hessian.block<2, 2>(4, 2) = hOut;
    geometry.hessian.block<2, 2>(2, 4) = hOut;
    geometry.hessian.block<2, 2>(4, 4) = -hOut;
  }
  return geometry;
}

void IsometricModel::addAngles(const Eigen::VectorXd& x, bool exact, Eigen::VectorXd& gradient)
{
  for (std::size_t k = 0; k < this->Nodes.size(); ++k)
  {
    const Node& node = this->Nodes[k];
    const NodeGeometry geometry = this->nodeGeometry(node, x, exact);
    const double d = geometry.angle - node.target;
    Eigen::Matrix<double, 6, 6> H =
      2.0 * node.stiffness * (geometry.gradient * geometry.gradient.transpose());
    H += 2.0 * node.stiffness * d * geometry.hessian;
    this->NodeBlocks[k].add(this->Assembler, H);
    this->NodeBlocks[k].scatter(
      Eigen::Matrix<double, 6, 1>(2.0 * node.stiffness * d * geometry.gradient), gradient);
  }
}

/// The constraint's row of the Jacobian. \return the edge
Eigen::Vector2d IsometricModel::takeLengthRow(Index k, const Eigen::VectorXd& x)
{
  const WireEdge& edge = this->Problem.network->edges[this->LengthEdges[k]];
  Eigen::Vector2d d = planePoint(x, edge.to) - planePoint(x, edge.from);
  const Eigen::Vector2d along = d.normalized();
  this->LengthRows[k] << -along.transpose(), along.transpose(), -this->Length[k];
  return d;
}

void IsometricModel::addStretches(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) const
{
  for (Index g = 0; g < this->groupCount(); ++g)
  {
    const Index at = this->CoordinateCount + g;
    gradient[at] += this->Problem.groups[g].weight * x[at];
  }
}

void IsometricModel::addLengths(
  const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers, bool exact)
{
  for (Index k = 0; k < this->lengthCount(); ++k)
  {
    const Eigen::Vector2d d = this->takeLengthRow(k, x);
    const double length = d.norm();
    const Eigen::Vector2d along = d / length;
    const double lambda = exact ? multipliers[k] : std::max(0.0, multipliers[k]);
    const Eigen::Matrix2d bend =
      lambda / length * (Eigen::Matrix2d::Identity() - along * along.transpose());
    Eigen::Matrix4d H;
    H << bend, -bend, -bend, bend;
    this->LengthBlocks[k].add(this->Assembler, H);
    this->LengthRowBlocks[k].add(this->Assembler, this->LengthRows[k]);
  }
}

void IsometricModel::addLocks(
  const Eigen::VectorXd& x, const Eigen::VectorXd& multipliers, bool exact)
{
  for (std::size_t k = 0; k < this->LockedNodes.size(); ++k)
  {
    const NodeGeometry geometry = this->nodeGeometry(this->LockedNodes[k], x, exact);
    const double lambda = multipliers[this->lengthCount() + static_cast<Index>(k)];
    this->LockedBlocks[k].add(
      this->Assembler, Eigen::Matrix<double, 6, 6>(lambda * geometry.hessian));
    this->LockedRows[k] = geometry.gradient.transpose();
    this->LockedRowBlocks[k].add(this->Assembler, this->LockedRows[k]);
  }
}

IsometricModel::Linearization IsometricModel::linearize(const Eigen::VectorXd& x,
  const Eigen::VectorXd& multipliers, Curvature curvature, double delta, const Execution& execution)
{
  const bool exact = curvature == Curvature::Exact;
  this->Assembler.clear();
  Linearization result;
  result.gradient = Eigen::VectorXd::Zero(this->unknownCount());
  result.constraints = this->constraints(x);
  this->Sheet.add(x, curvature, this->Assembler, result.gradient, execution);
  this->addAngles(x, exact, result.gradient);
  this->addLengths(x, multipliers, exact);
  this->addLocks(x, multipliers, exact);
  for (std::size_t k = 0; k < this->HoldBlocks.size(); ++k)
  {
    this->HoldBlocks[k].add(
      this->Assembler, [&](int, int column) { return this->Hold.weights[k].weight[column]; });
  }
  this->addStretches(x, result.gradient);
  for (Index g = 0; g < this->groupCount(); ++g)
  {
    this->stiffen(g, this->Problem.groups[g].weight);
  }
  for (Index k = 0; k < this->constraintCount(); ++k)
  {
    this->Diagonal.add(this->Assembler, this->unknownCount() + k, -delta);
  }
  this->fixMotion(x);
  return result;
}

std::optional<IsometricModel::Linearization> IsometricModel::differentiate(
  const Eigen::VectorXd& x, const Execution& execution)
{
  Linearization result;
  result.gradient = Eigen::VectorXd::Zero(this->unknownCount());
  result.constraints = this->constraints(x);
  this->Sheet.addGradient(x, result.gradient, execution);
  for (std::size_t k = 0; k < this->Nodes.size(); ++k)
  {
    const Node& node = this->Nodes[k];
    const NodeGeometry geometry = this->nodeGeometry(node, x, false);
    const double torque = 2.0 * node.stiffness * (geometry.angle - node.target);
    this->NodeBlocks[k].scatter(
      Eigen::Matrix<double, 6, 1>(torque * geometry.gradient), result.gradient);
  }
  for (Index k = 0; k < this->lengthCount(); ++k)
  {
    this->takeLengthRow(k, x);
  }
  for (std::size_t k = 0; k < this->LockedNodes.size(); ++k)
  {
    this->LockedRows[k] = nodeGradient(this->LockedNodes[k], x).transpose();
  }
  this->addStretches(x, result.gradient);
  return result;
}

Eigen::VectorXd IsometricModel::transposedJacobianTimes(const Eigen::VectorXd& multipliers) const
{
  Eigen::VectorXd result = Eigen::VectorXd::Zero(this->unknownCount());
  for (Index k = 0; k < this->lengthCount(); ++k)
  {
    this->LengthRowBlocks[k].addTransposedTimes(
      this->LengthRows[k], multipliers.segment<1>(k), result);
  }
  for (std::size_t k = 0; k < this->LockedNodes.size(); ++k)
  {
    this->LockedRowBlocks[k].addTransposedTimes(this->LockedRows[k],
      multipliers.segment<1>(this->lengthCount() + static_cast<Eigen::Index>(k)), result);
  }
  for (const GrainHold::Weight& part : this->Hold.weights)
  {
    result.segment<2>(2 * part.vertex) += multipliers[this->holdRow()] * part.weight;
  }
  return result;
}
}
