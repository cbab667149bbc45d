// SPDX-License-Identifier: BSD-3-Clause
// Fig. 4: the order in which the progressive scheme warps the wire-patches of the shirt's front,
// from blue to red, on the surface and in the plane.
#include "FigureTest.h"

#include <map>
#include <set>

int TestFigure4WarpingOrder(int argc, char* argv[])
{
  return figureTest::run([&](figureTest::Checks& checks) {
    const figures::Piece piece =
      figures::readPiece(figureTest::dataDirectory(argc, argv), "shirt_front");
    const std::vector<figures::FlatPiece> flats =
      figures::flattenAll({ piece }, figures::Method::Progressive);
    const figures::FlatPiece& flat = flats[0];
    figureTest::expectExactWires(flat, "progressive", checks);

    // Every wire-patch is warped once.
    vtkDataArray* const order = flat.cut->GetCellData()->GetArray("WarpingOrder");
    vtkDataArray* const patches = flat.cut->GetCellData()->GetArray("WirePatchId");
    std::map<double, double> turnOf;
    std::set<double> turns;
    std::map<double, std::set<vtkIdType>> pointsAt;
    vtkNew<vtkIdList> ids;
    bool uniform = true;
    for (vtkIdType t = 0; t < flat.cut->GetNumberOfCells(); ++t)
    {
      const double turn = order->GetComponent(t, 0);
      uniform = uniform && turnOf.emplace(patches->GetComponent(t, 0), turn).first->second == turn;
      turns.insert(turn);
      flat.cut->GetCellPoints(t, ids);
      pointsAt[turn].insert(ids->begin(), ids->end());
    }
    checks.that(uniform, "a wire-patch is warped once");
    checks.equal(turns.size(), turnOf.size(), "number of turns");
    checks.equal(*turns.begin(), 0.0, "first turn");
    checks.equal(*turns.rbegin(), static_cast<double>(turnOf.size()) - 1.0, "last turn");

    // Only a patch that touches what is known has any shape evidence (Eq. 10): first a key curve,
    // later also the patches before it.
    std::set<vtkIdType> known;
    vtkDataArray* const types = flat.wires->GetCellData()->GetArray("CurveType");
    figureTest::forEachEdge(flat.wires, [&](vtkIdType cell, vtkIdType a, vtkIdType b) {
      if (types->GetComponent(cell, 0) == 1.0)
      {
        known.insert({ a, b });
      }
    });
    checks.that(!known.empty(), "there is a key curve");
    for (const auto& [turn, points] : pointsAt)
    {
      const bool touches = std::any_of(
        points.begin(), points.end(), [&](vtkIdType point) { return known.count(point) != 0; });
      checks.that(touches, "patch " + std::to_string(turn) + " touches what is known");
      known.insert(points.begin(), points.end());
    }

    figures::Figure figure(900, 1000);
    const figures::ColorRange range{ 0.0, static_cast<double>(turnOf.size()) - 1.0 };
    const figures::PolyData wires = flat.wiresOn(flat.cut);
    figures::Drawing& space = figure.add();
    space.lookFrom({ 0.0, 0.0, 1.0 });
    space.addCellMap(flat.cut, "WarpingOrder", range);
    space.addWires(wires);
    figures::Drawing& plane = figure.add();
    plane.addCellMap(flat.flat, "WarpingOrder", range);
    plane.addWires(flat.wires);
    figureTest::compare(figure, argc, argv, checks);
  });
}
