// SPDX-License-Identifier: BSD-3-Clause
// Figs. 10e and 10f: homogeneity of distortion (above) and aspect ratio (below) on the wetsuit's
// pants, 1 - index from 0, blue, to 0.5, red: global scheme with the paper's interior, global
// scheme with the interior as rigid as possible, isometric scheme, LSCM.
#include "QualityMaps.h"

int TestFigure10Maps(int argc, char* argv[])
{
  return figureTest::drawQualityMaps(argc, argv, "wetsuit_pants_front", "wetsuit_pants_back");
}
