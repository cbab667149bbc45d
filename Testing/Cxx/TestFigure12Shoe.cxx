// SPDX-License-Identifier: BSD-3-Clause
// Fig. 12: how far the shoe's upper is from developable, the upper with its curves, and its flat
// piece by the global scheme.
#include "FigureTest.h"

int TestFigure12Shoe(int argc, char* argv[])
{
  return figureTest::run([&](figureTest::Checks& checks) {
    const figures::Piece piece =
      figures::readPiece(figureTest::dataDirectory(argc, argv), "shoe_upper");
    const std::vector<figures::FlatPiece> flat =
      figures::flattenAll({ piece }, figures::Method::Global);
    figureTest::expectExactWires(flat[0], "shoe", checks);

    figures::Figure figure(1000, 1000);
    const figures::Vector view{ 0.8, 0.7, 0.9 };
    const double largest = figures::drawDevelopability(figure.add(), { piece }, view);
    checks.that(largest > 0.01, "the shoe is not developable");
    figures::drawSpace(figure.add(), { piece }, view);
    figures::drawFlat(figure.add(), flat);
    figureTest::compare(figure, argc, argv, checks);
  });
}
