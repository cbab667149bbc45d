// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/CutArcs.h"

#include "Surface/VertexFan.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace flattening
{
namespace
{
Indices cutEdges(const TriangleMesh& mesh, const std::vector<char>& cut, Index v)
{
  Indices edges;
  for (Index h : VertexFan(mesh, v))
  {
    if (cut[h])
    {
      edges.push_back(h);
    }
  }
  return edges;
}

/// From an edge on to the next node, or round to its start.
CutArc follow(const TriangleMesh& mesh, const std::vector<char>& cut, Index first,
  const std::vector<char>& nodes, std::vector<char>& used)
{
  CutArc arc;
  arc.vertices.push_back(mesh.from(first));
  for (Index h = first; h != none && !used[h];)
  {
    used[h] = used[mesh.twin(h)] = 1;
    arc.edges.push_back(h);
    const Index end = mesh.to(h);
    arc.vertices.push_back(end);
    h = none;
    for (Index next : nodes[end] ? Indices{} : cutEdges(mesh, cut, end))
    {
      h = used[next] ? h : next;
    }
  }
  return arc;
}
}

std::vector<CutArc> cutArcs(
  const TriangleMesh& mesh, const std::vector<char>& cut, const Indices& holeOf, bool opened)
{
  std::vector<CutArc> all;
  std::vector<char> used(mesh.halfedgeCount(), 0);
  Indices meeting(mesh.vertexCount(), 0); // how many cut edges meet
  std::map<Index, Index> atHole;
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    meeting[mesh.from(h)] += cut[h] ? 1 : 0;
    atHole[holeOf[mesh.from(h)]] += cut[h] ? 1 : 0;
  }
  std::vector<char> nodes;
  std::vector<char> ends; // where a single one does
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    const bool inside = !mesh.onBoundary(v);
    const bool hole = !inside && holeOf[v] != none;
    nodes.push_back(!inside || meeting[v] != 2 ? 1 : 0);
    ends.push_back((inside && meeting[v] == 1) || (hole && atHole[holeOf[v]] == 1) ? 1 : 0);
  }
  for (bool closed : { false, true })
  {
    for (Index v = 0; v < mesh.vertexCount(); ++v)
    {
      for (Index h : meeting[v] > 0 && (closed || nodes[v]) ? cutEdges(mesh, cut, v) : Indices{})
      {
        if (!used[h])
        {
          all.push_back(follow(mesh, cut, h, nodes, used));
        }
      }
    }
  }
  std::vector<CutArc> arcs;
  for (CutArc& arc : all)
  {
    const bool closed = arc.vertices.front() == arc.vertices.back();
    if (closed && opened)
    {
      const auto half = static_cast<std::ptrdiff_t>(arc.edges.size() / 2);
      arcs.push_back({ Indices(arc.edges.begin(), arc.edges.begin() + half),
        Indices(arc.vertices.begin(), arc.vertices.begin() + half + 1) });
      arcs.push_back({ Indices(arc.edges.begin() + half, arc.edges.end()),
        Indices(arc.vertices.begin() + half, arc.vertices.end()) });
      continue;
    }
    if (!closed && ends[arc.vertices.front()] && !ends[arc.vertices.back()])
    {
      std::reverse(arc.vertices.begin(), arc.vertices.end());
      std::reverse(arc.edges.begin(), arc.edges.end());
      std::transform(arc.edges.begin(), arc.edges.end(), arc.edges.begin(),
        [&mesh](Index h) { return mesh.twin(h); });
    }
    arc.dart = !closed && !mesh.onBoundary(arc.vertices.back()) && ends[arc.vertices.back()];
    arc.frontFree = ends[arc.vertices.front()];
    arc.backFree = ends[arc.vertices.back()];
    arcs.push_back(std::move(arc));
  }
  return arcs;
}
}
