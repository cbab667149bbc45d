// SPDX-License-Identifier: BSD-3-Clause
#include "Angles/DirectionsForm.h"

#include "Base/CompressedRows.h"
#include "Sparse/LinearSolver.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace flattening
{
namespace
{
/// Locked angles that miss each other by more than this contradict each other, in radians.
constexpr double contradiction = 1e-9;

/// Edges joined by locked nodes, with psi[edge] = offset[edge] + rotation of the run.
struct Runs
{
  Indices ofEdge;
  Indices size; ///< edges per run
  std::vector<double> offset;
  Indices contradictions; ///< nodes where locked angles disagree

  Index largest() const
  {
    return static_cast<Index>(
      std::max_element(this->size.begin(), this->size.end()) - this->size.begin());
  }
};

CompressedRows lockedNodesByEdge(const AngleProblem& problem)
{
  const WireNetwork& net = *problem.network;
  return groupMembers(net.edgeCount(), [&](const auto& visit) {
    for (Index i = 0; i < net.nodeCount(); ++i)
    {
      if (problem.locks.locked[i])
      {
        visit(net.edge[i], i);
        visit(net.edge[net.previous[i]], i);
      }
    }
  });
}

/// Grows the last run from its seed over all edges that locked nodes tie to it.
void growRun(const AngleProblem& problem, const std::vector<double>& branch,
  const CompressedRows& lockedNodes, Index seed, Runs& runs)
{
  const WireNetwork& net = *problem.network;
  const auto id = static_cast<Index>(runs.size.size()) - 1;
  runs.ofEdge[seed] = id;
  Indices stack{ seed };
  while (!stack.empty())
  {
    const Index e = stack.back();
    stack.pop_back();
    ++runs.size[id];
    for (Index node : lockedNodes[e])
    {
      // theta = c + psi_in - psi_out
      const Index in = net.edge[net.previous[node]];
      const Index out = net.edge[node];
      if (in == out)
      {
        continue; // the tip of a wire: 2 pi whatever its direction
      }
      const double inMinusOut = problem.locks.angle[node] - branch[node];
      const Index other = in == e ? out : in;
      const double offset = in == e ? runs.offset[e] - inMinusOut : runs.offset[e] + inMinusOut;
      if (runs.ofEdge[other] == none)
      {
        runs.ofEdge[other] = id;
        runs.offset[other] = offset;
        stack.push_back(other);
      }
      else if (std::abs(runs.offset[other] - offset) > contradiction)
      {
        runs.contradictions.push_back(node);
      }
    }
  }
}

Runs joinLockedEdges(const AngleProblem& problem, const std::vector<double>& branch)
{
  const Index edges = problem.network->edgeCount();
  const CompressedRows lockedNodes = lockedNodesByEdge(problem);
  Runs runs;
  runs.ofEdge.assign(edges, none);
  runs.offset.assign(edges, 0.0);
  for (Index seed = 0; seed < edges; ++seed)
  {
    if (runs.ofEdge[seed] == none)
    {
      runs.size.push_back(0);
      growRun(problem, branch, lockedNodes, seed, runs);
    }
  }
  sortUnique(runs.contradictions);
  return runs;
}

/// Ranks of the runs in their order. Single edges along wires come first: edges follow each other
/// along a wire by their numbers, so that each in turn leaves one neighbor only. Larger runs, edges
/// at junctions of wires and the fixed run come last.
RankedFirst rankRuns(const WireNetwork& net, const Runs& runs, Index fixed)
{
  const Indices degrees = hostDegrees(net);
  std::vector<char> along(runs.size.size(), 0);
  for (Index e = 0; e < net.edgeCount(); ++e)
  {
    const Index run = runs.ofEdge[e];
    along[run] = run != fixed && runs.size[run] == 1 &&
        degrees[net.hostOfVertex[net.edges[e].from]] == 2 &&
        degrees[net.hostOfVertex[net.edges[e].to]] == 2
      ? 1
      : 0;
  }
  return rankFirst(along.size(), [&along](std::size_t run) { return along[run] != 0; });
}
}

DirectionsForm::DirectionsForm(const AngleProblem& problem)
  : Problem(&problem)
{
  const double sum = std::accumulate(problem.length.begin(), problem.length.end(), 0.0);
  this->Unit = sum / static_cast<double>(std::max<std::size_t>(1, problem.length.size()));
  this->setLengths(problem.length);
  this->projectAngles();
  const std::vector<double> psi = edgeDirections(*problem.network, this->Projected);
  this->fixBranches(psi);
  this->formRuns(psi);
}

void DirectionsForm::setLengths(const std::vector<double>& length)
{
  this->Length.resize(length.size());
  for (std::size_t e = 0; e < length.size(); ++e)
  {
    this->Length[e] = length[e] / this->Unit;
  }
}

double DirectionsForm::signedLength(Index side) const
{
  const WireNetwork& net = *this->Problem->network;
  return net.alongEdge(side) ? this->Length[net.edge[side]] : -this->Length[net.edge[side]];
}

void DirectionsForm::projectAngles()
{
  // Least squares: theta = alpha + C' y with C C' y = b - C alpha; C holds the loops and the
  // interior vertices, two ones a column at the most. Vertices go first: eliminating them fills in
  // between loops alone. But hubs of wires go last, since they would couple all their loops.
  const WireNetwork& net = *this->Problem->network;
  const Index loops = net.loopCount();
  Indices vertexRow(net.hostVertices.size(), none);
  Index rows = 0;
  const auto numberVertices = [&](bool hubs) {
    for (std::size_t host = 0; host < net.hostVertices.size(); ++host)
    {
      const Index nodes = net.vertexNodeBegin[host + 1] - net.vertexNodeBegin[host];
      if (net.interior[host] && (nodes > hubValence(loops)) == hubs)
      {
        vertexRow[host] = rows++;
      }
    }
  };
  numberVertices(false);
  const Index loopRow = rows;
  rows += loops;
  numberVertices(true);
  Eigen::VectorXd missing = Eigen::VectorXd::Zero(rows);
  std::vector<Eigen::Triplet<double>> entries;
  for (Index loop = 0; loop < loops; ++loop)
  {
    const Index count = net.loopBegin[loop + 1] - net.loopBegin[loop];
    missing[loopRow + loop] = (count - 2) * pi;
    entries.emplace_back(loopRow + loop, loopRow + loop, count);
  }
  for (std::size_t host = 0; host < net.hostVertices.size(); ++host)
  {
    if (vertexRow[host] != none)
    {
      missing[vertexRow[host]] = 2.0 * pi;
      entries.emplace_back(vertexRow[host], vertexRow[host],
        net.vertexNodeBegin[host + 1] - net.vertexNodeBegin[host]);
    }
  }
  for (Index i = 0; i < net.nodeCount(); ++i)
  {
    const Index row = vertexRow[net.hostOfVertex[net.vertex[i]]];
    missing[loopRow + net.loop[i]] -= net.alpha[i];
    if (row != none)
    {
      missing[row] -= net.alpha[i];
      const Index loopAt = loopRow + net.loop[i];
      entries.emplace_back(std::max(loopAt, row), std::min(loopAt, row), 1.0);
    }
  }
  SparseMatrix normal(rows, rows);
  normal.setFromTriplets(entries.begin(), entries.end());
  LinearSolver solver(LeadingColumns{ loopRow });
  this->Projected = net.alpha;
  solver.factorize(normal); // definite, since a piece has a boundary
  const Eigen::MatrixXd y = solver.solve(missing);
  for (Index i = 0; i < net.nodeCount() && y.rows() == rows; ++i)
  {
    const Index row = vertexRow[net.hostOfVertex[net.vertex[i]]];
    this->Projected[i] += y(loopRow + net.loop[i], 0) + (row == none ? 0.0 : y(row, 0));
  }
}

void DirectionsForm::fixBranches(const std::vector<double>& psi)
{
  const WireNetwork& net = *this->Problem->network;
  this->Branch.resize(net.nodeCount());
  for (Index i = 0; i < net.nodeCount(); ++i)
  {
    const double difference = psi[net.edge[net.previous[i]]] - psi[net.edge[i]];
    this->Branch[i] = pi * std::round((this->Projected[i] - difference) / pi);
  }
}

void DirectionsForm::formRuns(const std::vector<double>& psi)
{
  const WireNetwork& net = *this->Problem->network;
  Runs runs = joinLockedEdges(*this->Problem, this->Branch);
  this->Offset = std::move(runs.offset);
  this->Contradictions = std::move(runs.contradictions);
  const Index fixed = runs.largest();
  const RankedFirst order = rankRuns(net, runs, fixed);
  this->RotationsAlong = order.first;
  this->Rotations = static_cast<Index>(runs.size.size()) - 1;
  this->UnknownOfEdge.assign(net.edgeCount(), none);
  double rotation = 0.0;
  for (Index e = 0; e < net.edgeCount(); ++e)
  {
    if (runs.ofEdge[e] == fixed)
    {
      rotation += (psi[e] - this->Offset[e]) / runs.size[fixed];
    }
  }
  for (Index e = 0; e < net.edgeCount(); ++e)
  {
    const Index place = order.rank[runs.ofEdge[e]];
    if (runs.ofEdge[e] == fixed)
    {
      this->Offset[e] += rotation;
    }
    else
    {
      this->UnknownOfEdge[e] = place < order.rank[fixed] ? place : place - 1;
    }
  }
}

Eigen::VectorXd DirectionsForm::unknowns(const std::vector<double>& theta) const
{
  const std::vector<double> psi = edgeDirections(*this->Problem->network, theta);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(this->unknownCount());
  Eigen::VectorXd count = Eigen::VectorXd::Zero(this->Rotations);
  double turn = 0.0;
  double fixedCount = 0.0;
  for (std::size_t e = 0; e < psi.size(); ++e)
  {
    const Index unknown = this->UnknownOfEdge[e];
    (unknown == none ? fixedCount : count[unknown]) += 1.0;
    (unknown == none ? turn : x[unknown]) += psi[e] - this->Offset[e];
  }
  for (Index r = 0; r < this->Rotations; ++r)
  {
    x[r] = x[r] / count[r] - turn / fixedCount;
  }
  return x;
}

std::vector<double> DirectionsForm::angles(const Eigen::VectorXd& x) const
{
  const WireNetwork& net = *this->Problem->network;
  std::vector<double> theta(net.nodeCount());
  for (Index i = 0; i < net.nodeCount(); ++i)
  {
    theta[i] = this->Problem->locks.locked[i] && this->Contradictions.empty()
      ? this->Problem->locks.angle[i]
      : this->Branch[i] + this->direction(net.edge[net.previous[i]], x) -
        this->direction(net.edge[i], x);
  }
  return theta;
}

std::vector<double> DirectionsForm::directions(const Eigen::VectorXd& x) const
{
  const WireNetwork& net = *this->Problem->network;
  std::vector<double> phi(net.nodeCount());
  for (Index side = 0; side < net.nodeCount(); ++side)
  {
    phi[side] = this->direction(net.edge[side], x) + (net.alongEdge(side) ? 0.0 : pi);
  }
  return phi;
}

std::vector<double> DirectionsForm::stretches(const Eigen::VectorXd& x) const
{
  return { x.data() + this->Rotations, x.data() + this->unknownCount() };
}

std::vector<double> DirectionsForm::lengths(const Eigen::VectorXd& x) const
{
  std::vector<double> result(this->Length.size());
  for (std::size_t e = 0; e < result.size(); ++e)
  {
    result[e] = this->Problem->length[e] * this->stretch(static_cast<Index>(e), x);
  }
  return result;
}

double DirectionsForm::objective(const Eigen::VectorXd& x) const
{
  double sum = angleObjective(*this->Problem, this->angles(x));
  for (Index g = 0; g < this->groupCount(); ++g)
  {
    const double h = x[this->Rotations + g];
    sum += 0.5 * this->Problem->groups[g].weight * h * h;
  }
  return sum;
}

Eigen::VectorXd DirectionsForm::gradient(const Eigen::VectorXd& x) const
{
  const WireNetwork& net = *this->Problem->network;
  Eigen::VectorXd g = Eigen::VectorXd::Zero(this->unknownCount());
  const std::vector<double> theta = this->angles(x);
  for (Index i = 0; i < net.nodeCount(); ++i)
  {
    const Index in = this->UnknownOfEdge[net.edge[net.previous[i]]];
    const Index out = this->UnknownOfEdge[net.edge[i]];
    const double d = this->Problem->weight[i] * (theta[i] - this->Problem->target[i]);
    if (in != none)
    {
      g[in] += d;
    }
    if (out != none)
    {
      g[out] -= d;
    }
  }
  for (Index k = 0; k < this->groupCount(); ++k)
  {
    g[this->Rotations + k] = this->Problem->groups[k].weight * x[this->Rotations + k];
  }
  return g;
}

Points2 DirectionsForm::unitVectors(const Eigen::VectorXd& x) const
{
  Points2 units;
  units.reserve(this->Length.size());
  for (Index e = 0; e < this->Problem->network->edgeCount(); ++e)
  {
    const double psi = this->direction(e, x);
    units.emplace_back(std::cos(psi), std::sin(psi));
  }
  return units;
}

Eigen::VectorXd DirectionsForm::closure(const Eigen::VectorXd& x, const Points2& units) const
{
  const WireNetwork& net = *this->Problem->network;
  Eigen::VectorXd c = Eigen::VectorXd::Zero(this->constraintCount());
  for (Index side = 0; side < net.nodeCount(); ++side)
  {
    const Index e = net.edge[side];
    const double l = this->signedLength(side) * this->stretch(e, x);
    c[2 * net.loop[side]] += l * units[e].x();
    c[2 * net.loop[side] + 1] += l * units[e].y();
  }
  return c;
}

DirectionsKkt::DirectionsKkt(const DirectionsForm& form)
  : Form(form)
  , Assembler(form.unknownCount() + form.constraintCount())
{
  const AngleProblem& problem = form.problem();
  const WireNetwork& net = *problem.network;
  this->Sides.reserve(net.nodeCount());
  for (Index s = 0; s < net.nodeCount(); ++s)
  {
    const Index edge = net.edge[s];
    const Index group = problem.stretchGroup[edge];
    const Index in = form.rotation(net.edge[net.previous[s]]);
    const Index out = form.rotation(edge);
    const Index stretch = group == none ? none : form.rotationCount() + group;
    const Index row = 2 * net.loop[s];
    // Within a run the angle is fixed.
    const std::array<Index, 2> turning{ in == out ? none : in, in == out ? none : out };
    Side side{ edge, row, problem.weight[s], form.signedLength(s), {}, {}, {} };
    side.angle = { this->Assembler, turning };
    side.bend = { this->Assembler, { out, stretch } };
    side.closes = { this->Assembler, form.unknownCount() + row, { out, stretch } };
    this->Sides.push_back(side);
  }
  this->Diagonal = { this->Assembler, 0, form.unknownCount() + form.constraintCount() };
  this->Assembler.finish();
}

double DirectionsKkt::objective(const Eigen::VectorXd& x, const Execution&) const
{
  return this->Form.objective(x);
}

Eigen::VectorXd DirectionsKkt::constraints(const Eigen::VectorXd& x) const
{
  return this->Form.closure(x);
}

/// Closures that contradict each other drive the penalty up, and with it what rounding of the merit
/// function means for them.
double DirectionsKkt::constraintRounding(const Eigen::VectorXd&, double merit) const
{
  constexpr double rounding = 1e-13; // of sums of some hundreds of sines and cosines
  return rounding * (1.0 + std::abs(merit));
}

Eigen::Matrix2d DirectionsKkt::closureDerivative(const Side& side) const
{
  const Eigen::Vector2d along = side.length * this->Units[side.edge];
  const double factor = this->Factor[side.edge];
  Eigen::Matrix2d derivative;
  derivative << -factor * along.y(), along.x(), factor * along.x(), along.y();
  return derivative;
}

NewtonKktModel::Linearization DirectionsKkt::linearize(const Eigen::VectorXd& x,
  const Eigen::VectorXd& multipliers, Curvature, double delta, const Execution&)
{
  this->Units = this->Form.unitVectors(x);
  this->Factor.resize(this->Units.size());
  for (std::size_t e = 0; e < this->Factor.size(); ++e)
  {
    this->Factor[e] = this->Form.stretch(static_cast<Index>(e), x);
  }
  this->Assembler.clear();
  for (const Side& side : this->Sides)
  {
    side.angle.add(
      this->Assembler, [&](int a, int b) { return a == b ? side.weight : -side.weight; });
    const Eigen::Matrix2d derivative = this->closureDerivative(side);
    const Eigen::Vector2d lambda = multipliers.segment<2>(side.row);
    // The second derivatives by rotation and by rotation and stretch; that by stretch is zero.
    const double along = lambda.y() * derivative(0, 1) - lambda.x() * derivative(1, 1);
    const double bend = lambda.y() * derivative(0, 0) - lambda.x() * derivative(1, 0);
    side.bend.add(this->Assembler, [&](int a, int b) {
      return a == 0 ? bend : b == 0 ? along : 0.0;
    });
    side.closes.add(this->Assembler, derivative);
  }
  for (Index g = 0; g < this->Form.groupCount(); ++g)
  {
    this->stiffen(g, this->Form.problem().groups[g].weight);
  }
  for (Index c = 0; c < this->constraintCount(); ++c)
  {
    this->Diagonal.add(this->Assembler, this->unknownCount() + c, -delta);
  }
  return { this->Form.gradient(x), this->Form.closure(x, this->Units) };
}

void DirectionsKkt::shift(double tau)
{
  for (Index k = 0; k < this->unknownCount(); ++k)
  {
    this->Diagonal.add(this->Assembler, k, tau);
  }
}

void DirectionsKkt::stiffen(Index bounded, double stiffness)
{
  this->Diagonal.add(this->Assembler, this->Form.rotationCount() + bounded, stiffness);
}

Eigen::VectorXd DirectionsKkt::transposedJacobianTimes(const Eigen::VectorXd& multipliers) const
{
  Eigen::VectorXd product = Eigen::VectorXd::Zero(this->unknownCount());
  for (const Side& side : this->Sides)
  {
    side.closes.addTransposedTimes(
      this->closureDerivative(side), multipliers.segment<2>(side.row), product);
  }
  return product;
}
}
