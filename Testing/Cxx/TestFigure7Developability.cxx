// SPDX-License-Identifier: BSD-3-Clause
// Fig. 7a: how far the shirt is from developable, seen from the front and from the back.
#include "FigureTest.h"

namespace
{
/// Eq. 25 a second time: abs(sum of angles - 2 pi) at the interior points, from VTK's own angles.
double largestDefect(vtkPolyData* surface)
{
  const vtkIdType points = surface->GetNumberOfPoints();
  std::vector<double> angles(points, 0.0);
  std::vector<int> openEdges(points, 0); // one edge in for each edge out, but not on the boundary
  vtkNew<vtkIdList> ids;
  std::vector<std::array<vtkIdType, 2>> edges;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    surface->GetCellPoints(cell, ids);
    for (int k = 0; k < 3; ++k)
    {
      const vtkIdType here = ids->GetId(k);
      const vtkIdType next = ids->GetId((k + 1) % 3);
      const vtkIdType last = ids->GetId((k + 2) % 3);
      double a[3];
      double b[3];
      double c[3];
      surface->GetPoint(here, a);
      surface->GetPoint(next, b);
      surface->GetPoint(last, c);
      vtkMath::Subtract(b, a, b);
      vtkMath::Subtract(c, a, c);
      angles[here] += vtkMath::AngleBetweenVectors(b, c);
      edges.push_back({ std::min(here, next), std::max(here, next) });
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t k = 0; k < edges.size(); ++k)
  {
    const bool paired =
      (k > 0 && edges[k - 1] == edges[k]) || (k + 1 < edges.size() && edges[k + 1] == edges[k]);
    openEdges[edges[k][0]] += !paired;
    openEdges[edges[k][1]] += !paired;
  }
  double largest = 0.0;
  for (vtkIdType point = 0; point < points; ++point)
  {
    if (openEdges[point] == 0)
    {
      largest = std::max(largest, std::abs(angles[point] - 2.0 * vtkMath::Pi()));
    }
  }
  return largest;
}
}

int TestFigure7Developability(int argc, char* argv[])
{
  return figureTest::run([&](figureTest::Checks& checks) {
    const std::string data = figureTest::dataDirectory(argc, argv);
    std::vector<figures::Piece> pieces;
    double expected = 0.0;
    for (const char* name : { "shirt_front", "shirt_back", "shirt_shoulder" })
    {
      pieces.push_back(figures::readPiece(data, name));
      expected = std::max(expected, largestDefect(pieces.back().surface));
    }

    figures::Figure figure(900, 1000);
    const double front = figures::drawDevelopability(figure.add(), pieces, { 0.0, 0.0, 1.0 });
    const double back = figures::drawDevelopability(figure.add(), pieces, { 0.0, 0.0, -1.0 });
    checks.near(front, expected, 1e-12, "largest E_dev");
    checks.equal(back, front, "largest E_dev from the back");
    checks.that(front > 0.01, "the shirt is not developable");
    figureTest::compare(figure, argc, argv, checks);
  });
}
