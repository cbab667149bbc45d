// SPDX-License-Identifier: BSD-3-Clause
#include "Imprint/SplitNodes.h"

namespace flattening
{
SplitNodes::SplitNodes(const TriangleMesh& mesh, const SnapDistance& snap)
  : Mesh(mesh)
  , Snap(snap)
  , VertexCount(mesh.vertexCount())
{
}

SurfacePoint SplitNodes::point(Index node) const
{
  return node < this->VertexCount ? vertexPoint(this->Mesh, node)
                                  : this->Nodes[node - this->VertexCount];
}

Index SplitNodes::add(const SurfacePoint& point)
{
  this->Nodes.push_back(point);
  this->Alias.push_back(none);
  return this->VertexCount + static_cast<Index>(this->Nodes.size()) - 1;
}

SplitNodes::Place SplitNodes::place(const SurfacePoint& point)
{
  if (point.carrier == Carrier::Vertex)
  {
    return { point.id, false };
  }
  const auto [known, isUnknown] =
    this->Known.emplace(std::make_tuple(point.carrier, point.id, point.weights), none);
  if (!isUnknown)
  {
    return { known->second, false };
  }
  if (point.carrier == Carrier::Edge)
  {
    const double near = this->Snap.ofEdge(point.id) / this->Mesh.length(point.id);
    known->second = this->OnEdge.nearest(point.id, point.weights[1], near);
    if (known->second != none)
    {
      return { known->second, false };
    }
  }
  known->second = this->add(point);
  if (point.carrier == Carrier::Edge)
  {
    this->OnEdge.insert(point.id, point.weights[1], known->second);
  }
  return { known->second, true };
}

void SplitNodes::merge(Index node, Index into)
{
  this->Alias[node - this->VertexCount] = into;
}

std::vector<VertexSource> SplitNodes::numberVertices()
{
  std::vector<VertexSource> sources(this->VertexCount);
  for (Index v = 0; v < this->VertexCount; ++v)
  {
    sources[v].vertices = { v, v, v };
  }
  this->VertexOfNode.assign(this->Nodes.size(), none);
  for (std::size_t i = 0; i < this->Nodes.size(); ++i)
  {
    if (this->Alias[i] != none)
    {
      continue;
    }
    const SurfacePoint& point = this->Nodes[i];
    const bool onEdge = point.carrier == Carrier::Edge;
    const Index from = onEdge ? this->Mesh.from(point.id) : none;
    this->VertexOfNode[i] = static_cast<Index>(sources.size());
    sources.push_back(
      { onEdge ? Triangle{ from, this->Mesh.to(point.id), from } : this->Mesh.triangle(point.id),
        point.weights });
  }
  return sources;
}

Index SplitNodes::vertex(Index node) const
{
  while (node >= this->VertexCount && this->Alias[node - this->VertexCount] != none)
  {
    node = this->Alias[node - this->VertexCount];
  }
  return node < this->VertexCount ? node : this->VertexOfNode[node - this->VertexCount];
}
}
