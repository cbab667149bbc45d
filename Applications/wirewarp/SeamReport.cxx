// SPDX-License-Identifier: BSD-3-Clause
#include "SeamReport.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace wirewarp
{
namespace
{
/// Per point the piece of one of its triangles; pieces share no points.
std::vector<long long> pieceOfPoint(vtkPolyData* flat)
{
  std::vector<long long> pieces(flat->GetNumberOfPoints(), 0);
  vtkDataArray* const pieceOfCell = flat->GetCellData()->GetArray("PieceId");
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  for (vtkIdType cell = 0; pieceOfCell && cell < flat->GetNumberOfCells(); ++cell)
  {
    flat->GetCellPoints(cell, count, ids);
    for (vtkIdType k = 0; k < count; ++k)
    {
      pieces[ids[k]] = static_cast<long long>(pieceOfCell->GetTuple1(cell));
    }
  }
  return pieces;
}

double distance(vtkPolyData* flat, vtkIdType a, vtkIdType b)
{
  std::array<double, 3> p{};
  std::array<double, 3> q{};
  flat->GetPoint(a, p.data());
  flat->GetPoint(b, q.data());
  return std::sqrt(vtkMath::Distance2BetweenPoints(p.data(), q.data()));
}
}

//------------------------------------------------------------------------------
std::vector<SewnBanks> sewnBanks(const Flattening& result)
{
  vtkDataArray* const pairs =
    result.flat ? result.flat->GetFieldData()->GetArray("SeamPairs") : nullptr;
  if (!pairs || pairs->GetNumberOfComponents() != 5)
  {
    return {};
  }
  const std::vector<long long> pieces = pieceOfPoint(result.flat);
  std::map<std::array<long long, 3>, SewnBanks> found;
  for (vtkIdType row = 0; row < pairs->GetNumberOfTuples(); ++row)
  {
    std::array<double, 5> ids{};
    pairs->GetTuple(row, ids.data());
    const auto point = [&ids](int k) { return static_cast<vtkIdType>(ids[k]); };
    std::array<long long, 2> sides{ pieces[point(0)], pieces[point(2)] };
    std::array<double, 2> lengths{ distance(result.flat, point(0), point(1)),
      distance(result.flat, point(2), point(3)) };
    if (sides[1] < sides[0])
    {
      std::swap(sides[0], sides[1]);
      std::swap(lengths[0], lengths[1]);
    }
    SewnBanks& banks = found[{ point(4), sides[0], sides[1] }];
    banks.curve = textIn(result.curveTable, point(4), "Name");
    banks.pieces = sides;
    ++banks.edges;
    banks.lengths[0] += lengths[0];
    banks.lengths[1] += lengths[1];
    const double larger = std::max(lengths[0], lengths[1]);
    banks.difference =
      std::max(banks.difference, larger > 0.0 ? std::abs(lengths[0] - lengths[1]) / larger : 0.0);
  }
  std::vector<SewnBanks> list;
  for (auto& entry : found)
  {
    list.push_back(std::move(entry.second));
  }
  return list;
}
}
