// SPDX-License-Identifier: BSD-3-Clause
// Fig. 7a: how far the shirt is from developable, seen from the front and from the back.
#include "FigureTest.h"

int TestFigure7Developability(int argc, char* argv[])
{
  return figureTest::run([&](figureTest::Checks& checks) {
    const std::string data = figureTest::dataDirectory(argc, argv);
    std::vector<figures::Piece> pieces;
    for (const char* name : { "shirt_front", "shirt_back", "shirt_shoulder" })
    {
      pieces.push_back(figures::readPiece(data, name));
    }

    figures::Figure figure(900, 1000);
    const double front = figures::drawDevelopability(figure.add(), pieces, { 0.0, 0.0, 1.0 });
    const double back = figures::drawDevelopability(figure.add(), pieces, { 0.0, 0.0, -1.0 });
    checks.equal(back, front, "largest E_dev from the back");
    checks.that(front > 0.01, "the shirt is not developable");
    figureTest::compare(figure, argc, argv, checks);
  });
}
