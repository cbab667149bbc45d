// SPDX-License-Identifier: BSD-3-Clause
// Fig. 2a: the wires of the shirt's front after the darts are opened, its surface, and the
// wire-patches in colors.
#include "FigureTest.h"

int TestFigure2WirePatches(int argc, char* argv[])
{
  return figureTest::run([&](figureTest::Checks& checks) {
    const figures::Piece piece =
      figures::readPiece(figureTest::dataDirectory(argc, argv), "shirt_front");
    const figures::FlatPiece flat = figures::flatten(piece, figures::Method::Global);

    figureTest::expectExactWires(flat, "shirt front", checks);

    figures::Figure figure(1000, 1000);
    const figures::Vector front{ 0.0, 0.0, 1.0 };
    const figures::PolyData wires = flat.wiresOn(flat.cut);
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
