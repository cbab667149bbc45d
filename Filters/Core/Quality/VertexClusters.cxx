// SPDX-License-Identifier: BSD-3-Clause
#include "Quality/VertexClusters.h"

#include "Surface/VertexFan.h"

#include <functional>
#include <limits>
#include <queue>

namespace flattening
{
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
