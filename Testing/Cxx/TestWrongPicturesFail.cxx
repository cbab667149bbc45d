// SPDX-License-Identifier: BSD-3-Clause
// Pictures of the quarter-sphere that are wrong in one way each: the comparison that all tests of
// pictures use passes the right one and fails every wrong one.
#include "FigureTest.h"

#include "vtkTesting.h"

#include <sstream>

namespace
{
using figures::Drawing;
using figures::FlatPiece;
using Draw = std::function<void(Drawing&)>;

/// Whether a picture passes the comparison with the baseline.
bool passes(int argc, char* argv[], const std::string& what, const Draw& draw)
{
  figures::Figure figure(400, 1000);
  draw(figure.add());
  vtkNew<vtkTesting> testing;
  testing->AddArguments(argc, const_cast<const char**>(argv));
  testing->SetRenderWindow(figure.render());
  std::ostringstream output; // a failure here is no failure of the test
  const int result = testing->RegressionTest(figureTest::imageThreshold, output);
  std::cout << what << ": error " << testing->GetImageDifference() << "\n";
  return result == vtkTesting::PASSED;
}

/// The arc as a key curve.
figures::PolyData withKey(const figures::PolyData& wires)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->DeepCopy(wires);
  vtkDataArray* const types = result->GetCellData()->GetArray("CurveType");
  for (vtkIdType cell = 0; cell < result->GetNumberOfCells(); ++cell)
  {
    if (types->GetComponent(cell, 0) == 0.0)
    {
      types->SetComponent(cell, 0, 1.0);
    }
  }
  return result;
}
}

int TestWrongPicturesFail(int argc, char* argv[])
{
  return figureTest::run([&](figureTest::Checks& checks) {
    const figures::Piece piece =
      figures::readPiece(figureTest::dataDirectory(argc, argv), "quarter_sphere");
    const FlatPiece global =
      figures::flatten(piece, figures::Method::Global, figures::Interior::Paper);
    const FlatPiece progressive =
      figures::flatten(piece, figures::Method::Progressive, figures::Interior::Paper);
    const FlatPiece mirror = figureTest::mapped(progressive, [](double x, double y) {
      return std::array<double, 2>{ -x, y };
    });
    const char* const homogeneity = "HomogeneityOfDistortion";

    const bool right = passes(argc, argv, "the right picture",
      [&](Drawing& drawing) { figures::drawIndex(drawing, { progressive }, homogeneity); });
    checks.that(right, "the right picture passes");
    if (!right)
    {
      return; // a wrong picture would fail for the wrong reason
    }
    const auto expectFailure = [&](const std::string& what, const Draw& draw) {
      checks.that(!passes(argc, argv, what, draw), what + " fails");
    };
    expectFailure("another scheme",
      [&](Drawing& drawing) { figures::drawIndex(drawing, { global }, homogeneity); });
    expectFailure("the mirror image",
      [&](Drawing& drawing) { figures::drawIndex(drawing, { mirror }, homogeneity); });
    expectFailure("another index",
      [&](Drawing& drawing) { figures::drawIndex(drawing, { progressive }, "AspectRatio"); });
    expectFailure("another range of colors", [&](Drawing& drawing) {
      drawing.addCellMap(progressive.flat, homogeneity, { 1.0, 0.4 });
      drawing.addWires(progressive.wires);
    });
    expectFailure("no wires", [&](Drawing& drawing) {
      drawing.addCellMap(progressive.flat, homogeneity, figures::indexRange);
      drawing.addBoundary(progressive.flat);
    });
    expectFailure("a key curve in place of an accessory one", [&](Drawing& drawing) {
      drawing.addCellMap(progressive.flat, homogeneity, figures::indexRange);
      drawing.addWires(withKey(progressive.wires));
    });
  });
}
