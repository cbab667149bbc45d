// SPDX-License-Identifier: BSD-3-Clause
#include "Quality/ScaleFactor.h"

#include "Quality/IntrinsicDelaunay.h"
#include "Surface/VertexFan.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>

namespace flattening
{
namespace
{
/// Columns that are solved for at once.
constexpr Index blockColumns = 64;
/// What is added to the diagonal of the path's system, relative to its mean: neighbouring clusters
/// may be nearly one.
constexpr double ridge = 1e-12;

/// 2 pi less the angles around inner vertices.
Eigen::VectorXd angleDefects(const TriangleMesh& mesh, const Indices& vertices)
{
  Eigen::VectorXd defects(vertices.size());
  for (std::size_t k = 0; k < vertices.size(); ++k)
  {
    defects[k] = 2.0 * pi - angleSum(mesh, vertices[k]);
  }
  return defects;
}

/// The vertices where u is unknown, ascending.
Indices freeVertices(const TriangleMesh& mesh, const Indices& fixed)
{
  std::vector<char> held(mesh.vertexCount(), 0);
  for (Index v : fixed)
  {
    held[v] = 1;
  }
  Indices members;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    if (!held[v] && mesh.outgoing(v) != none && !mesh.onBoundary(v))
    {
      members.push_back(v);
    }
  }
  return members;
}

/// The free part of the cotangent Laplacian, its lower triangle.
SparseMatrix assemble(
  const IntrinsicTriangulation& triangulation, const Indices& number, Index count)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t t = 0; t < triangulation.triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const double weight = 0.5 * triangulation.cotangents[t][k];
      const Index i = number[triangulation.triangles[t][(k + 1) % 3]];
      const Index j = number[triangulation.triangles[t][(k + 2) % 3]];
      if (i == j)
      {
        continue; // both are fixed, or an edge that runs around to its vertex
      }
      for (Index end : { i, j })
      {
        if (end != none)
        {
          entries.emplace_back(end, end, weight);
        }
      }
      if (i != none && j != none)
      {
        entries.emplace_back(std::max(i, j), std::min(i, j), -weight);
      }
    }
  }
  SparseMatrix matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// Between the free vertices; not ok where it is not positive definite.
LinearSolver factorLaplacian(
  const TriangleMesh& mesh, const Indices& members, const Execution& execution)
{
  Indices number(mesh.vertexCount(), none);
  for (std::size_t k = 0; k < members.size(); ++k)
  {
    number[members[k]] = static_cast<Index>(k);
  }
  const IntrinsicTriangulation triangulation = intrinsicDelaunay(mesh);
  LinearSolver solver(
    dissect(triangulation.triangles, mesh.points()).ofUnknowns(1, [&number](Index v) {
      return number[v];
    }));
  const auto count = static_cast<Index>(members.size());
  if (solver.factorize(assemble(triangulation, number, count), execution) &&
    solver.positive() != count)
  {
    return LinearSolver();
  }
  return solver;
}

/// Column s holds the weights of the mean over site s, by area; rows are free vertices.
SparseMatrix siteMeans(
  const std::vector<double>& areas, const Indices& members, const Indices& siteOfVertex)
{
  std::vector<double> siteArea;
  for (Index v : members)
  {
    siteArea.resize(std::max<std::size_t>(siteArea.size(), siteOfVertex[v] + 1), 0.0);
    siteArea[siteOfVertex[v]] += areas[v];
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t k = 0; k < members.size(); ++k)
  {
    const Index site = siteOfVertex[members[k]];
    entries.emplace_back(static_cast<Index>(k), site, areas[members[k]] / siteArea[site]);
  }
  SparseMatrix means(static_cast<Index>(members.size()), static_cast<Index>(siteArea.size()));
  means.setFromTriplets(entries.begin(), entries.end());
  return means;
}
}

double CutForecast::opening(double s) const
{
  double width = 0.0;
  for (std::size_t i = 0; i < this->arc.size(); ++i)
  {
    width += this->swallowed[i] * std::max(0.0, this->arc[i] - s);
  }
  return width;
}

double CutForecast::leastOpening() const
{
  // From the tip towards the mouth: the angle that the points passed open, and the width so far.
  double angle = 0.0;
  double width = 0.0;
  double least = 0.0;
  for (std::size_t i = this->arc.size(); i-- > 0;)
  {
    angle += this->swallowed[i];
    width += angle * (this->arc[i] - (i > 0 ? this->arc[i - 1] : 0.0));
    least = std::min(least, width);
  }
  return least;
}

double CutForecast::greatestOpening() const
{
  double greatest = this->opening(0.0);
  for (double s : this->arc)
  {
    greatest = std::max(greatest, this->opening(s));
  }
  return greatest;
}

ScaleFactor::ScaleFactor(
  const TriangleMesh& mesh, const ScaleFactorOptions& options, const Execution& execution)
  : Points(mesh.points())
  , Values(mesh.vertexCount(), 0.0)
{
  const std::vector<double> areas =
    vertexAreas(mesh.triangles(), mesh.vertexCount(), [&mesh](Index t) { return mesh.area(t); });
  this->Ok = this->solve(mesh, areas, options, execution);
  if (this->Ok)
  {
    this->integrate(areas, options.weight);
  }
}

bool ScaleFactor::solve(const TriangleMesh& mesh, const std::vector<double>& areas,
  const ScaleFactorOptions& options, const Execution& execution)
{
  const Indices members = freeVertices(mesh, options.fixed);
  const Index count = static_cast<Index>(members.size());
  const bool sites = options.maxSites > 0;
  this->SiteOfVertex =
    sites ? clusterVertices(mesh, members, options.maxSites) : Indices(mesh.vertexCount(), none);
  if (count == 0)
  {
    return mesh.triangleCount() > 0;
  }
  if (options.fixed.empty() && mesh.boundaryLoops().empty())
  {
    return false; // whether the last pivot is zero is left to rounding
  }
  const LinearSolver solver = factorLaplacian(mesh, members, execution);
  const Eigen::MatrixXd u = solver.solve(angleDefects(mesh, members), execution);
  if (u.rows() != count)
  {
    return false;
  }
  for (Index k = 0; k < count; ++k)
  {
    this->Values[members[k]] = u(k, 0);
  }
  if (!sites)
  {
    return true;
  }
  const SparseMatrix means = siteMeans(areas, members, this->SiteOfVertex);
  this->SiteValue = means.transpose() * u.col(0);
  return this->solveBetweenSites(solver, means, execution);
}

bool ScaleFactor::solveBetweenSites(
  const LinearSolver& solver, const SparseMatrix& means, const Execution& execution)
{
  const auto sites = static_cast<Index>(means.cols());
  this->Green.resize(sites, sites);
  const Index blocks = (sites + blockColumns - 1) / blockColumns;
  std::vector<char> solved(blocks, 0);
  execution.forEachTask(blocks, [&](Index b) {
    const Index first = b * blockColumns;
    const Index width = std::min(blockColumns, sites - first);
    const Eigen::MatrixXd columns = solver.solve(Eigen::MatrixXd(means.middleCols(first, width)));
    solved[b] = columns.rows() == means.rows() ? 1 : 0;
    if (solved[b])
    {
      this->Green.middleCols(first, width) = means.transpose() * columns;
    }
  });
  return !execution.cancelled() &&
    std::all_of(solved.begin(), solved.end(), [](char done) { return done != 0; });
}

void ScaleFactor::integrate(const std::vector<double>& areas, const std::vector<double>& weight)
{
  this->SiteArea = Eigen::VectorXd::Zero(this->SiteValue.size());
  for (std::size_t v = 0; v < areas.size(); ++v)
  {
    const Index site = this->SiteOfVertex[v];
    if (site != none)
    {
      this->SiteArea[site] += (weight.empty() ? 1.0 : weight[v]) * areas[v];
    }
  }
  this->Energy = this->SiteArea.dot(this->SiteValue.cwiseAbs2());
}

Indices ScaleFactor::peaks(Indices vertices, double apart, std::size_t most) const
{
  std::stable_sort(vertices.begin(), vertices.end(),
    [this](Index a, Index b) { return std::abs(this->Values[a]) > std::abs(this->Values[b]); });
  Indices peaks;
  for (Index v : vertices)
  {
    const bool near = std::any_of(peaks.begin(), peaks.end(),
      [&](Index peak) { return (this->Points[peak] - this->Points[v]).norm() < apart; });
    if (!near && peaks.size() < most)
    {
      peaks.push_back(v);
    }
  }
  return peaks;
}

CutForecast ScaleFactor::forecast(const Indices& path) const
{
  return this->forecast(path, false);
}

CutForecast ScaleFactor::forecastInside(const Indices& path) const
{
  return this->forecast(path, true);
}

CutForecast ScaleFactor::forecast(const Indices& path, bool inside) const
{
  CutForecast forecast;
  Indices sites;
  double arc = 0.0;
  for (std::size_t k = 0; k < path.size(); ++k)
  {
    arc += k > 0 ? (this->Points[path[k]] - this->Points[path[k - 1]]).norm() : 0.0;
    const Index site = this->SiteOfVertex[path[k]];
    if (site != none && std::find(sites.begin(), sites.end(), site) == sites.end())
    {
      sites.push_back(site);
      forecast.arc.push_back(arc);
    }
  }
  const Index count = static_cast<Index>(sites.size());
  if (!this->Ok || count == 0)
  {
    return forecast;
  }
  Eigen::MatrixXd green(count, count);
  Eigen::VectorXd value(count);
  for (Index j = 0; j < count; ++j)
  {
    value[j] = this->SiteValue[sites[j]];
    for (Index i = 0; i < count; ++i)
    {
      green(i, j) = this->Green(sites[i], sites[j]);
    }
  }
  green.diagonal().array() += ridge * green.trace() / count;
  const Eigen::LLT<Eigen::MatrixXd> factor = green.llt();
  Eigen::VectorXd swallowed = factor.solve(value);
  if (inside)
  {
    if (count < 3)
    {
      return {};
    }
    Eigen::MatrixXd conditions(count, 2);
    conditions.col(0).setOnes();
    conditions.col(1) = Eigen::Map<const Eigen::VectorXd>(forecast.arc.data(), count) / arc;
    const Eigen::MatrixXd spread = factor.solve(conditions);
    const Eigen::Matrix2d normal = conditions.transpose() * spread;
    swallowed -= spread * (normal.inverse() * (conditions.transpose() * swallowed));
  }
  Eigen::VectorXd change = Eigen::VectorXd::Zero(this->SiteValue.size());
  for (Index j = 0; j < count; ++j)
  {
    change += swallowed[j] * this->Green.col(sites[j]);
  }
  // int u^2 - int (u - change)^2
  forecast.gain =
    (this->SiteArea.array() * change.array() * (2.0 * this->SiteValue - change).array()).sum();
  forecast.swallowed.assign(swallowed.data(), swallowed.data() + count);
  return forecast;
}

namespace
{
constexpr double unreached = std::numeric_limits<double>::infinity();

/// A vertex at a distance: nearer ones first, of equally near ones that of the smaller id.
using Reached = std::pair<double, Index>;

class Clustering
{
public:
  Clustering(const TriangleMesh& mesh, const Indices& members)
    : Mesh(mesh)
    , Distance(mesh.vertexCount(), -1.0)
    , Cluster(mesh.vertexCount(), none)
  {
    for (Index v : members)
    {
      this->Distance[v] = unreached;
      this->Farthest.emplace(unreached, -v);
    }
  }

  Indices run(Index most)
  {
    for (Index seed = 0; seed < most && !this->Farthest.empty(); ++seed)
    {
      this->grow(this->nextSeed(), seed);
    }
    // What no seed reaches along edges comes to the last one.
    for (std::size_t v = 0; v < this->Cluster.size(); ++v)
    {
      if (this->Distance[v] == unreached)
      {
        this->Cluster[v] = most - 1;
      }
    }
    return std::move(this->Cluster);
  }

private:
  Index nextSeed()
  {
    while (true)
    {
      const auto [distance, negative] = this->Farthest.top();
      this->Farthest.pop();
      if (this->Farthest.empty() || distance == this->Distance[-negative])
      {
        return -negative;
      }
    }
  }

  /// Takes over the vertices that are nearer to the seed than to those before.
  void grow(Index seed, Index cluster)
  {
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> front;
    this->reach(seed, 0.0, cluster);
    front.emplace(0.0, seed);
    while (!front.empty())
    {
      const auto [distance, v] = front.top();
      front.pop();
      if (distance > this->Distance[v])
      {
        continue;
      }
      for (Index h : VertexFan(this->Mesh, v))
      {
        // Past the last half-edge of a boundary fan there is one more neighbour.
        for (Index w : { this->Mesh.to(h), this->Mesh.from(TriangleMesh::previous(h)) })
        {
          const double further = distance + (this->Mesh.point(w) - this->Mesh.point(v)).norm();
          if (further < this->Distance[w])
          {
            this->reach(w, further, cluster);
            front.emplace(further, w);
          }
        }
      }
    }
  }

  void reach(Index v, double distance, Index cluster)
  {
    this->Distance[v] = distance;
    this->Cluster[v] = cluster;
    this->Farthest.emplace(distance, -v);
  }

  const TriangleMesh& Mesh;
  std::vector<double> Distance; ///< negative: no member
  Indices Cluster;
  std::priority_queue<Reached> Farthest; ///< with the negative id, among them what is out of date
};
}

Indices clusterVertices(const TriangleMesh& mesh, const Indices& members, Index most)
{
  if (static_cast<Index>(members.size()) > most)
  {
    return Clustering(mesh, members).run(most);
  }
  Indices cluster(mesh.vertexCount(), none);
  for (std::size_t k = 0; k < members.size(); ++k)
  {
    cluster[members[k]] = static_cast<Index>(k);
  }
  return cluster;
}
}
