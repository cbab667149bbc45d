// SPDX-License-Identifier: BSD-3-Clause
// Fig. 8: front and back of the pants. Above, set 1, the grainline is key: space, progressive,
// global, LSCM. Below, set 2, mid-thigh and the grainline below it are key: space, progressive,
// global.
#include "FigureTest.h"

int TestFigure8Pants(int argc, char* argv[])
{
  return figureTest::run([&](figureTest::Checks& checks) {
    const std::string data = figureTest::dataDirectory(argc, argv);
    const auto read = [&](const char* set) {
      return std::vector<figures::Piece>{ figures::readPiece(data, "pants_front", set),
        figures::readPiece(data, "pants_back", set) };
    };
    const std::vector<figures::Piece> pieces1 = read("");
    const std::vector<figures::Piece> pieces2 = read("_set2");
    const figureTest::Methods set1(pieces1);
    const figureTest::Methods set2(pieces2);
    set1.expect(checks);
    set2.expect(checks);
    for (int k = 0; k < 2; ++k)
    {
      // Other keys, another shape.
      checks.that(
        std::abs(set1.global[k].number("Objective") - set2.global[k].number("Objective")) > 1e-3,
        "the choice of keys makes no difference");
    }

    figures::Figure figure(1000, 1000);
    figureTest::drawFrontAndBack(figure, pieces1);
    figures::drawFlat(figure.add(), set1.progressive);
    figures::drawFlat(figure.add(), set1.global);
    figures::drawFlat(figure.add(), set1.conformal);
    figure.nextRow();
    figureTest::drawFrontAndBack(figure, pieces2);
    figures::drawFlat(figure.add(), set2.progressive);
    figures::drawFlat(figure.add(), set2.global);
    figureTest::compare(figure, argc, argv, checks);
  });
}
