// SPDX-License-Identifier: BSD-3-Clause
// Figs. 9a to 9d: front and back of the wetsuit's upper body in space; by the progressive scheme,
// the global scheme and LSCM.
#include "FigureTest.h"

int TestFigure9Wetsuit(int argc, char* argv[])
{
  return figureTest::drawMethods(argc, argv, "wetsuit_upper_front", "wetsuit_upper_back");
}
