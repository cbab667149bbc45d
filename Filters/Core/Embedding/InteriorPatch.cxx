// SPDX-License-Identifier: BSD-3-Clause
#include "Embedding/InteriorPatch.h"

#include "Base/CompressedRows.h"

#include <algorithm>

namespace flattening
{
std::vector<InteriorPatch> collectInteriorPatches(const Piece& piece, const WireNetwork& network)
{
  const TriangleMesh& mesh = piece.mesh;
  const CompressedRows byPatch = groupBy(network.patchCount, network.patchOfTriangle);
  std::vector<InteriorPatch> patches;
  Indices local(mesh.vertexCount(), none);
  Indices pinned;
  for (Index k = 0; k < network.patchCount; ++k)
  {
    InteriorPatch patch;
    patch.patch = k;
    pinned.clear();
    for (Index t : byPatch[k])
    {
      for (Index v : mesh.triangle(t))
      {
        if (local[v] == none)
        {
          local[v] = 0;
          (network.hostOfVertex[v] == none ? patch.vertices : pinned).push_back(v);
        }
      }
    }
    patch.freeCount = static_cast<Index>(patch.vertices.size());
    if (patch.freeCount > 0)
    {
      std::sort(patch.vertices.begin(), patch.vertices.end());
      std::sort(pinned.begin(), pinned.end());
      patch.vertices.insert(patch.vertices.end(), pinned.begin(), pinned.end());
      for (std::size_t i = 0; i < patch.vertices.size(); ++i)
      {
        local[patch.vertices[i]] = static_cast<Index>(i);
      }
      for (Index t : byPatch[k])
      {
        const Triangle& c = mesh.triangle(t);
        const Triangle corners{ local[c[0]], local[c[1]], local[c[2]] };
        if (*std::min_element(corners.begin(), corners.end()) < patch.freeCount)
        {
          patch.triangles.push_back(corners);
        }
      }
    }
    // Wire vertices belong to several patches.
    for (Index v : pinned)
    {
      local[v] = none;
    }
    if (patch.freeCount > 0)
    {
      patches.push_back(std::move(patch));
    }
  }
  return patches;
}

InteriorPatch restrictedTo(const InteriorPatch& patch, const std::vector<char>& marked)
{
  const auto free = [&](Index v) { return v < patch.freeCount && marked[v]; };
  InteriorPatch part;
  part.patch = patch.patch;
  Indices local(patch.vertices.size(), none);
  const auto take = [&](Index v) {
    local[v] = static_cast<Index>(part.vertices.size());
    part.vertices.push_back(patch.vertices[v]);
  };
  for (Index v = 0; v < patch.freeCount; ++v)
  {
    if (free(v))
    {
      take(v);
    }
  }
  part.freeCount = static_cast<Index>(part.vertices.size());
  for (const Triangle& c : patch.triangles)
  {
    if (std::any_of(c.begin(), c.end(), free))
    {
      for (Index v : c)
      {
        if (local[v] == none)
        {
          take(v);
        }
      }
      part.triangles.push_back({ local[c[0]], local[c[1]], local[c[2]] });
    }
  }
  return part;
}
}
