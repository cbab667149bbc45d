// SPDX-License-Identifier: BSD-3-Clause
// Fig. 11: the quarter-sphere in space, and by the progressive scheme, the global scheme and LSCM
// with the paper's interior. Tests of the filters have its numbers, those of Table 1.
#include "FigureTest.h"

#include "vtkLeastSquaresConformalFilter.h"

namespace
{
using flatteningTesting::lunePoint;

constexpr int latitudes = 8;
constexpr int longitudes = 4;

/// How far the boundary and the arc are from congruent with their mirror images: pole for pole
/// (`across`), or side for side. Congruent where all pairs of wire points are equally far apart.
double asymmetry(const figures::FlatPiece& piece, bool across)
{
  std::vector<std::array<vtkIdType, 2>> pairs;
  const auto add = [&](int i, int j) {
    pairs.push_back(
      { lunePoint(i, j), across ? lunePoint(i, latitudes - j) : lunePoint(longitudes - i, j) });
  };
  for (int j = 0; j <= latitudes; ++j)
  {
    add(0, j);
    add(longitudes, j);
  }
  for (int i = 0; i <= longitudes; ++i)
  {
    add(i, latitudes / 2);
  }
  double worst = 0.0;
  for (const auto& p : pairs)
  {
    for (const auto& q : pairs)
    {
      worst = std::max(worst,
        std::abs(figureTest::distance(piece.flat, p[0], q[0]) -
          figureTest::distance(piece.flat, p[1], q[1])));
    }
  }
  return worst;
}

figures::FlatPiece leastSquaresConformalMap(const figures::Piece& piece)
{
  vtkNew<vtkLeastSquaresConformalFilter> filter;
  filter->SetInputData(piece.surface);
  filter->SetCurvesData(piece.curves);
  filter->SetPins(lunePoint(0, latitudes / 2), lunePoint(0, latitudes / 2 + 1));
  filter->AreaNormalizedOff();
  filter->Update();
  return figures::outputsOf(filter);
}

/// The piece turned so that one pole stands above the other.
figures::FlatPiece turned(const figures::FlatPiece& piece)
{
  double low[3];
  double high[3];
  piece.flat->GetPoint(lunePoint(0, 0), low);
  piece.flat->GetPoint(lunePoint(0, latitudes), high);
  const double length = figureTest::distance(piece.flat, lunePoint(0, 0), lunePoint(0, latitudes));
  const double up[2] = { (high[0] - low[0]) / length, (high[1] - low[1]) / length };
  return figureTest::mapped(piece, [&](double x, double y) {
    return std::array<double, 2>{ up[1] * x - up[0] * y, up[0] * x + up[1] * y };
  });
}
}

int TestFigure11QuarterSphere(int argc, char* argv[])
{
  return figureTest::run([&](figureTest::Checks& checks) {
    const figures::Piece piece =
      figures::readPiece(figureTest::dataDirectory(argc, argv), "quarter_sphere");
    const auto progressive =
      figures::flatten(piece, figures::Method::Progressive, figures::Interior::Paper);
    const auto global = figures::flatten(piece, figures::Method::Global, figures::Interior::Paper);
    const auto conformal = leastSquaresConformalMap(piece);

    figureTest::expectExactWires(progressive, "progressive", checks);
    figureTest::expectExactWires(global, "global", checks);

    // What the paper says of the symmetry of the three.
    checks.near(asymmetry(progressive, false), 0.0, 1e-9, "progressive, side for side");
    checks.that(asymmetry(progressive, true) > 1e-2, "progressive is symmetric pole for pole");
    checks.near(asymmetry(global, false), 0.0, 1e-9, "global, side for side");
    checks.near(asymmetry(global, true), 0.0, 1e-9, "global, pole for pole");
    checks.that(asymmetry(conformal, false) > 1e-3, "LSCM is symmetric side for side");
    checks.that(asymmetry(conformal, true) > 1e-3, "LSCM is symmetric pole for pole");

    figures::Figure figure(1000, 1000);
    figures::Drawing& space = figure.add();
    figures::drawSpace(space, { piece }, { 0.0, 1.0, 1.0 });
    space.lookFrom({ 0.0, 1.0, 1.0 }, { 1.0, 0.0, 0.0 });
    figures::drawFlat(figure.add(), { turned(progressive) });
    figures::drawFlat(figure.add(), { turned(global) });
    figures::drawFlat(figure.add(), { turned(conformal) });
    figureTest::compare(figure, argc, argv, checks);
  });
}
