// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/ChartClusters.h"

#include "Base/CompressedRows.h"
#include "Quality/StrainMeasures.h"
#include "Sparse/LinearSolver.h"
#include "Suggestion/SeamDrawing.h"
#include "Suggestion/SymmetryPlane.h"
#include "Surface/SurfacePoint.h"
#include "Surface/VertexFan.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <tuple>

namespace flattening
{
namespace
{
/// Cotangents are held above this, so that the system of a surface with obtuse triangles stays
/// definite.
constexpr double minCotangent = 1e-3;
/// What the outline weighs where normals fit alike, as a share of the bound.
constexpr double outlineShare = 0.1;

class Clustering
{
public:
  Clustering(const TriangleMesh& mesh, double bound)
    : Mesh(mesh)
    , Bound(bound)
    , NoCuts(mesh.halfedgeCount(), 0)
    , Area(mesh.area())
  {
  }

  Indices run(const std::vector<Indices>& loops, const std::vector<char>& holes)
  {
    this->HoleOf = holesByVertex(this->Mesh, loops, holes);
    this->start();
    while (!this->Queue.empty())
    {
      const Merge merge = this->Queue.top();
      this->Queue.pop();
      if (this->Clusters[merge.first].version == merge.firstVersion &&
        this->Clusters[merge.second].version == merge.secondVersion &&
        this->allowed(this->Clusters[merge.first], this->Clusters[merge.second]))
      {
        this->join(merge.first, merge.second);
      }
    }
    Indices label(this->Mesh.triangleCount(), none);
    for (std::size_t c = 0; c < this->Clusters.size(); ++c)
    {
      for (Index t : this->Clusters[c].triangles)
      {
        label[t] = static_cast<Index>(c);
      }
    }
    return label;
  }

private:
  struct Cluster
  {
    Indices triangles;
    double area = 0.0;
    double outline = 0.0;
    Point3 normals = Point3::Zero(); ///< integral
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    std::map<Index, double> neighbours; ///< length of what is shared
    Index version = 0;
  };
  struct Merge
  {
    double cost;
    Index first;
    Index second;
    Index firstVersion;
    Index secondVersion;
    bool operator<(const Merge& other) const
    {
      return std::tie(this->cost, this->first, this->second) >
        std::tie(other.cost, other.first, other.second);
    }
  };

  void start()
  {
    this->Clusters.resize(this->Mesh.triangleCount());
    const std::vector<char> creases = creasesOf(this->Mesh, sharpCosine);
    for (Index t = 0; t < this->Mesh.triangleCount(); ++t)
    {
      Cluster& cluster = this->Clusters[t];
      cluster.triangles = { t };
      cluster.area = this->Mesh.area(t);
      const Point3 normal = triangleNormal(this->Mesh, t);
      cluster.normals = cluster.area * normal;
      cluster.squares = cluster.area * normal * normal.transpose();
      for (int k = 0; k < 3; ++k)
      {
        const Index twin = this->Mesh.twin(3 * t + k);
        const double length = this->Mesh.length(3 * t + k);
        cluster.outline += length;
        if (twin != none && twin / 3 != t && !creases[3 * t + k])
        {
          cluster.neighbours[twin / 3] += length;
        }
      }
    }
    for (Index t = 0; t < this->Mesh.triangleCount(); ++t)
    {
      for (const auto& [other, length] : this->Clusters[t].neighbours)
      {
        if (other > t)
        {
          this->push(t, other);
        }
      }
    }
  }

  void push(Index a, Index b)
  {
    const Cluster& first = this->Clusters[a];
    const Cluster& second = this->Clusters[b];
    const double area = first.area + second.area;
    const Point3 mean = (first.normals + second.normals) / area;
    const Eigen::Matrix3d spread =
      (first.squares + second.squares) / area - mean * mean.transpose();
    // The variance of the normals' component along the axis that varies least.
    const double misfit = std::max(
      0.0, Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>().computeDirect(spread).eigenvalues()[0]);
    const double outline = first.outline + second.outline - 2.0 * first.neighbours.at(b);
    const double round = outline * outline / (4.0 * pi * area);
    const double flat = outlineShare * this->Bound;
    this->Queue.push({ area / this->Area * (misfit + flat * flat) * round * round, a, b,
      first.version, second.version });
  }

  /// Whether two clusters together are a disk, holes filled, that can be flattened by the forecast.
  bool allowed(const Cluster& a, const Cluster& b)
  {
    const Cluster& small = a.triangles.size() < b.triangles.size() ? a : b;
    const Cluster& large = &small == &a ? b : a;
    std::vector<char>& inLarge = this->Marked;
    inLarge.assign(this->Mesh.triangleCount(), 0);
    for (Index t : large.triangles)
    {
      inLarge[t] = 1;
    }
    std::map<Index, Index> number; // of the shared vertices, those of a hole under one
    Indices edges;
    const auto key = [this](Index v) { return this->HoleOf[v] == none ? v : -2 - this->HoleOf[v]; };
    for (Index t : small.triangles)
    {
      for (Index h = 3 * t; h < 3 * t + 3; ++h)
      {
        const Index twin = this->Mesh.twin(h);
        if (twin != none && inLarge[twin / 3])
        {
          edges.push_back(h);
          number.emplace(key(this->Mesh.from(h)), static_cast<Index>(number.size()));
          number.emplace(key(this->Mesh.to(h)), static_cast<Index>(number.size()));
        }
      }
    }
    JoinedSets parts(static_cast<Index>(number.size()));
    auto left = number.size();
    for (Index h : edges)
    {
      const Index from = number.at(key(this->Mesh.from(h)));
      const Index to = number.at(key(this->Mesh.to(h)));
      left -= parts.find(from) != parts.find(to) ? 1 : 0;
      parts.join(from, to);
    }
    const double shared = a.neighbours.at(static_cast<Index>(&b - this->Clusters.data()));
    const double outline = a.outline + b.outline - 2.0 * shared;
    if (left != 1 || outline < 1e-9 * (a.outline + b.outline))
    {
      return false;
    }
    Indices both = a.triangles;
    both.insert(both.end(), b.triangles.begin(), b.triangles.end());
    return forecastStrain(openedPart(this->Mesh, both, this->NoCuts).mesh) <= this->Bound;
  }

  void join(Index a, Index b)
  {
    if (this->Clusters[a].triangles.size() < this->Clusters[b].triangles.size())
    {
      std::swap(a, b);
    }
    Cluster& kept = this->Clusters[a];
    Cluster& gone = this->Clusters[b];
    kept.outline += gone.outline - 2.0 * kept.neighbours.at(b);
    kept.triangles.insert(kept.triangles.end(), gone.triangles.begin(), gone.triangles.end());
    kept.area += gone.area;
    kept.normals += gone.normals;
    kept.squares += gone.squares;
    kept.neighbours.erase(b);
    for (const auto& [other, length] : gone.neighbours)
    {
      if (other != a)
      {
        kept.neighbours[other] += length;
        std::map<Index, double>& back = this->Clusters[other].neighbours;
        back.erase(b);
        back[a] += length;
      }
    }
    ++kept.version;
    gone = Cluster();
    gone.version = -1;
    for (const auto& [other, length] : kept.neighbours)
    {
      this->push(a, other);
    }
  }

  const TriangleMesh& Mesh;
  double Bound;
  Indices HoleOf; ///< by vertex
  std::vector<char> NoCuts;
  double Area;
  std::vector<char> Marked; ///< scratch of allowed()
  std::vector<Cluster> Clusters;
  std::priority_queue<Merge> Queue;
};
}

Indices holesByVertex(
  const TriangleMesh& mesh, const std::vector<Indices>& loops, const std::vector<char>& holes)
{
  Indices holeOf(mesh.vertexCount(), none);
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    for (Index h : holes[l] ? loops[l] : Indices{})
    {
      holeOf[mesh.from(h)] = static_cast<Index>(l);
    }
  }
  return holeOf;
}

OpenedPart openedPart(
  const TriangleMesh& mesh, const Indices& triangles, const std::vector<char>& cut)
{
  Indices place(mesh.triangleCount(), none);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    place[triangles[t]] = static_cast<Index>(t);
  }
  JoinedSets corners(static_cast<Index>(3 * triangles.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (Index k = 0; k < 3; ++k)
    {
      const Index h = 3 * triangles[t] + k;
      const Index twin = mesh.twin(h);
      const Index other = twin == none || cut[h] ? none : place[twin / 3];
      if (other != none)
      {
        const auto here = static_cast<Index>(3 * t);
        corners.join(here + k, 3 * other + TriangleMesh::next(twin) % 3);
        corners.join(here + (k + 1) % 3, 3 * other + twin % 3);
      }
    }
  }
  Points3 points;
  Indices vertices;
  Triangles cells;
  Indices number(3 * triangles.size(), none);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    Triangle cell;
    for (Index k = 0; k < 3; ++k)
    {
      Index& known = number[corners.find(static_cast<Index>(3 * t) + k)];
      if (known == none)
      {
        known = static_cast<Index>(points.size());
        vertices.push_back(mesh.triangle(triangles[t])[k]);
        points.push_back(mesh.point(vertices.back()));
      }
      cell[k] = known;
    }
    cells.push_back(cell);
  }
  return { TriangleMesh(std::move(points), std::move(cells)), std::move(vertices) };
}

double forecastStrain(const TriangleMesh& piece)
{
  Indices inner;
  Indices number(piece.vertexCount(), none);
  for (Index v = 0; v < piece.vertexCount(); ++v)
  {
    if (!piece.onBoundary(v))
    {
      number[v] = static_cast<Index>(inner.size());
      inner.push_back(v);
    }
  }
  if (inner.empty())
  {
    return 0.0;
  }
  const auto count = static_cast<Index>(inner.size());
  Eigen::VectorXd defect(count);
  std::vector<Eigen::Triplet<double>> entries;
  for (Index k = 0; k < count; ++k)
  {
    double sum = 0.0;
    double angles = 0.0;
    for (Index h : VertexFan(piece, inner[k]))
    {
      const Index twin = piece.twin(h);
      const double weight = std::max(minCotangent,
        0.5 / std::tan(piece.angle(TriangleMesh::previous(h))) +
          0.5 / std::tan(piece.angle(TriangleMesh::previous(twin))));
      sum += weight;
      angles += piece.angle(h);
      const Index other = number[piece.to(h)];
      if (other != none && other < k)
      {
        entries.emplace_back(k, other, -weight);
      }
    }
    entries.emplace_back(k, k, sum);
    defect[k] = 2.0 * pi - angles;
  }
  SparseMatrix laplacian(count, count);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  LinearSolver solver;
  const Eigen::MatrixXd factor =
    solver.factorize(laplacian) ? solver.solve(defect) : Eigen::MatrixXd();
  if (factor.rows() != count)
  {
    return std::numeric_limits<double>::infinity();
  }
  std::vector<std::pair<double, double>> strains;
  double beyond = (1.0 - quantileShare) * piece.area();
  for (Index k = 0; k < count; ++k)
  {
    strains.emplace_back(std::abs(factor(k, 0)), vertexArea(piece, inner[k]));
  }
  std::sort(strains.rbegin(), strains.rend());
  for (const auto& [strain, area] : strains)
  {
    beyond -= area;
    if (beyond < 0.0)
    {
      return strain;
    }
  }
  return 0.0;
}

Indices clusterTriangles(const TriangleMesh& mesh, const std::vector<Indices>& loops,
  const std::vector<char>& holes, double bound)
{
  return Clustering(mesh, bound).run(loops, holes);
}

Indices halvesOf(const TriangleMesh& mesh)
{
  const SurfaceMoments moments = momentsOf(mesh);
  Indices side;
  for (Index t = 0; t < mesh.triangleCount(); ++t)
  {
    side.push_back(moments.axes.col(2).dot(mesh.centroid(t) - moments.center) > 0.0 ? 1 : 0);
  }
  return side;
}
}
