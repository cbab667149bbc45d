// SPDX-License-Identifier: BSD-3-Clause
// Figs. 10a to 10d: front and back of the wetsuit's pants in space; by the progressive scheme, the
// global scheme and LSCM.
#include "FigureTest.h"

int TestFigure10WetsuitPants(int argc, char* argv[])
{
  return figureTest::drawMethods(argc, argv, "wetsuit_pants_front", "wetsuit_pants_back");
}
