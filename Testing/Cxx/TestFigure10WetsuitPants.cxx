// SPDX-License-Identifier: BSD-3-Clause
// Figs. 10a to 10d: front and back of the wetsuit's pants in space; by the progressive scheme, the
// global scheme and LSCM.
#include "FigureTest.h"

int TestFigure10WetsuitPants(int argc, char* argv[])
{
  return figureTest::run([&](figureTest::Checks& checks) {
    const std::string data = figureTest::dataFolder(argc, argv);
    const std::vector<figures::Piece> pieces{ figures::readPiece(data, "wetsuit_pants_front"),
      figures::readPiece(data, "wetsuit_pants_back") };
    const figureTest::Methods methods(pieces);
    methods.expect(checks);

    figures::Figure figure(1000, 1000);
    figures::drawSpace(figure.add(), { pieces[0] }, { 0.0, 0.0, 1.0 });
    figures::drawSpace(figure.add(), { pieces[1] }, { 0.0, 0.0, -1.0 });
    figures::drawFlat(figure.add(), methods.progressive);
    figure.nextRow();
    figures::drawFlat(figure.add(), methods.global);
    figures::drawFlat(figure.add(), methods.conformal);
    figureTest::compare(figure, argc, argv, checks);
  });
}
