// SPDX-License-Identifier: BSD-3-Clause
// Fig. 2a: the wires of the shirt's front after the darts are opened, its surface, and the
// wire-patches in colors.
#include "FigureTest.h"

#include <map>
#include <numeric>
#include <set>

namespace
{
using Edge = std::array<vtkIdType, 2>;

Edge edgeOf(vtkIdType a, vtkIdType b)
{
  return { std::min(a, b), std::max(a, b) };
}

/// Wire-patches by Definition 4, found a second way: triangles that are connected across edges that
/// are no wires.
std::vector<vtkIdType> findRegions(const figures::FlatPiece& piece)
{
  std::set<Edge> wires;
  figureTest::forEachEdge(
    piece.wires, [&](vtkIdType, vtkIdType a, vtkIdType b) { wires.insert(edgeOf(a, b)); });
  const vtkIdType triangles = piece.cut->GetNumberOfCells();
  std::vector<vtkIdType> root(triangles);
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](vtkIdType t) {
    while (root[t] != t)
    {
      t = root[t] = root[root[t]];
    }
    return t;
  };
  std::map<Edge, vtkIdType> first;
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < triangles; ++t)
  {
    piece.cut->GetCellPoints(t, ids);
    for (int k = 0; k < 3; ++k)
    {
      const Edge edge = edgeOf(ids->GetId(k), ids->GetId((k + 1) % 3));
      if (wires.count(edge) == 0)
      {
        root[find(t)] = find(first.emplace(edge, t).first->second);
      }
    }
  }
  std::vector<vtkIdType> regions(triangles);
  for (vtkIdType t = 0; t < triangles; ++t)
  {
    regions[t] = find(t);
  }
  return regions;
}
}

int TestFigure2WirePatches(int argc, char* argv[])
{
  return figureTest::run([&](figureTest::Checks& checks) {
    const figures::Piece piece =
      figures::readPiece(figureTest::dataDirectory(argc, argv), "shirt_front");
    const figures::FlatPiece flat = figures::flatten(piece, figures::Method::Global);

    vtkDataArray* const patches = flat.cut->GetCellData()->GetArray("WirePatchId");
    const std::vector<vtkIdType> regions = findRegions(flat);
    std::map<vtkIdType, vtkIdType> patchOf;
    bool one = true;
    for (std::size_t t = 0; t < regions.size(); ++t)
    {
      const auto patch =
        static_cast<vtkIdType>(patches->GetComponent(static_cast<vtkIdType>(t), 0));
      one = one && patchOf.emplace(regions[t], patch).first->second == patch;
    }
    std::set<vtkIdType> distinct;
    for (const auto& entry : patchOf)
    {
      distinct.insert(entry.second);
    }
    checks.that(one, "a region between wires has one WirePatchId");
    checks.equal(distinct.size(), patchOf.size(), "number of WirePatchIds");
    checks.equal(flat.number("WirePatches"), static_cast<double>(patchOf.size()), "WirePatches");

    figures::Figure figure(1000, 1000);
    const figures::Vector front{ 0.0, 0.0, 1.0 };
    // Over the cut surface the wires stand in space.
    const auto wires = vtkSmartPointer<vtkPolyData>::New();
    wires->ShallowCopy(flat.wires);
    wires->SetPoints(flat.cut->GetPoints());
    figures::Drawing& left = figure.add();
    left.lookFrom(front);
    left.addWires(wires);
    figures::Drawing& middle = figure.add();
    middle.lookFrom(front);
    middle.addSurface(flat.cut);
    middle.addBoundary(flat.cut);
    figures::Drawing& right = figure.add();
    right.lookFrom(front);
    right.addCategories(flat.cut, "WirePatchId");
    right.addWires(wires);
    figureTest::compare(figure, argc, argv, checks);
  });
}
