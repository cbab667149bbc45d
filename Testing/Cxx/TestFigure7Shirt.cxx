// SPDX-License-Identifier: BSD-3-Clause
// Figs. 7b, 1 and 7c: front, back and shoulder of the shirt by the progressive scheme, the global
// scheme and LSCM, from above.
#include "FigureTest.h"

int TestFigure7Shirt(int argc, char* argv[])
{
  return figureTest::run([&](figureTest::Checks& checks) {
    const std::string data = figureTest::dataDirectory(argc, argv);
    const figureTest::Methods methods({ figures::readPiece(data, "shirt_front"),
      figures::readPiece(data, "shirt_back"), figures::readPiece(data, "shirt_shoulder") });
    methods.expect(checks);

    figures::Figure figure(700, 1000);
    figures::drawFlat(figure.add(), methods.progressive);
    figure.nextRow();
    figures::drawFlat(figure.add(), methods.global);
    figure.nextRow();
    figures::drawFlat(figure.add(), methods.conformal);
    figureTest::compare(figure, argc, argv, checks);
  });
}
