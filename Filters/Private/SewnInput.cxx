// SPDX-License-Identifier: BSD-3-Clause
#include "SewnInput.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"

namespace flattening
{
namespace bridge
{
namespace
{
Status invalid(vtkIdType row, const std::string& defect)
{
  return { StatusCode::InvalidOption, "row " + std::to_string(row) + " of SeamPairs " + defect, {},
    { { Remedy::Give, "the flat pieces as they came out of the flattening" } } };
}

/// Finds the two half-edges of a row: from a to b and from d to c, or both the other way round.
bool findPair(const TriangleMesh& mesh, const std::array<Index, 4>& v, SeamPair& pair)
{
  pair.first = mesh.find(v[0], v[1]);
  pair.second = mesh.find(v[3], v[2]);
  if (pair.first == none || pair.second == none)
  {
    pair.first = mesh.find(v[1], v[0]);
    pair.second = mesh.find(v[2], v[3]);
  }
  return pair.first != none && pair.second != none && pair.first != pair.second &&
    mesh.twin(pair.first) == none && mesh.twin(pair.second) == none;
}

Status readSeams(vtkPolyData* flat, const Indices& vertexOfPoint, CutSurface& cut)
{
  vtkDataArray* pairs = flat->GetFieldData()->GetArray("SeamPairs");
  if (!pairs)
  {
    return {};
  }
  if (pairs->GetNumberOfComponents() < 4)
  {
    return invalid(0, "has fewer than 4 components");
  }
  std::vector<char> sewn(cut.mesh.halfedgeCount(), 0);
  for (vtkIdType row = 0; row < pairs->GetNumberOfTuples(); ++row)
  {
    std::array<Index, 4> vertices{};
    for (int k = 0; k < 4; ++k)
    {
      const double id = pairs->GetComponent(row, k);
      if (!(id >= 0.0 && id < static_cast<double>(vertexOfPoint.size())) ||
        vertexOfPoint[static_cast<std::size_t>(id)] == none)
      {
        return invalid(row, "uses a point that is not there");
      }
      vertices[static_cast<std::size_t>(k)] = vertexOfPoint[static_cast<std::size_t>(id)];
    }
    SeamPair pair;
    if (!findPair(cut.mesh, vertices, pair))
    {
      return invalid(row, "is not two edges on the boundaries of pieces");
    }
    if (sewn[pair.first] || sewn[pair.second])
    {
      return invalid(row, "sews an edge that another row sews");
    }
    sewn[pair.first] = sewn[pair.second] = 1;
    if (pairs->GetNumberOfComponents() > 4)
    {
      pair.curve = static_cast<Index>(pairs->GetComponent(row, 4));
    }
    cut.seamPairs.push_back(pair);
  }
  return {};
}
}

SewnInput loadSewnInput(vtkPolyData* flat, vtkPolyData* design)
{
  SewnInput result;
  result.map = loadMappedSurface(design, flat, nullptr);
  result.outcome = result.map.outcome;
  if (result.outcome.ok())
  {
    // Without curves this finds the pieces and leaves vertices and triangles as they are.
    result.cut = cutSurface(result.map.surface.prepared.mesh, {});
    result.outcome = result.cut.status;
  }
  if (result.outcome.ok())
  {
    result.outcome = readSeams(flat, result.map.surface.prepared.vertexOfPoint, result.cut);
  }
  return result;
}
}
}
