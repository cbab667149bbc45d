// SPDX-License-Identifier: BSD-3-Clause
// What the tests of pictures share. VTK's comparison of images forgives much, so every picture
// stands beside numbers, and TestWrongPicturesFail shows what the comparison does find.
#ifndef FigureTest_h
#define FigureTest_h

#include "FlatteningTesting.h"
#include "Panels.h"

#include "vtkIdList.h"
#include "vtkRegressionTestImage.h"
#include "vtkRenderWindowInteractor.h"

#include <exception>

namespace figureTest
{
using flatteningTesting::Checks;
using flatteningTesting::dataDirectory;

/// Largest error, in VTK's measure, of a picture that passes.
constexpr double imageThreshold = 5.0;

/// Compares with the baseline, which the option -V names.
inline void compare(figures::Figure& figure, int argc, char* argv[], Checks& checks)
{
  vtkRenderWindow* const window = figure.render();
  const int result = vtkRegressionTestImageThreshold(window, imageThreshold);
  if (result == vtkRegressionTester::DO_INTERACTOR)
  {
    vtkNew<vtkRenderWindowInteractor> interactor;
    interactor->SetRenderWindow(window);
    interactor->Start();
  }
  checks.that(result != vtkRegressionTester::FAILED, "the picture is that of the baseline");
}

inline double distance(vtkPolyData* data, vtkIdType a, vtkIdType b)
{
  double p[3];
  double q[3];
  data->GetPoint(a, p);
  data->GetPoint(b, q);
  return std::sqrt(vtkMath::Distance2BetweenPoints(p, q));
}

/// Calls visit(cell, a, b) for every edge of the wires.
template <typename Visit>
void forEachEdge(vtkPolyData* wires, const Visit& visit)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < wires->GetNumberOfCells(); ++cell)
  {
    wires->GetCellPoints(cell, ids);
    for (vtkIdType k = 0; k + 1 < ids->GetNumberOfIds(); ++k)
    {
      visit(cell, ids->GetId(k), ids->GetId(k + 1));
    }
  }
}

/// The piece with each point of the plane where a function of its coordinates puts it.
template <typename Map>
figures::FlatPiece mapped(const figures::FlatPiece& piece, const Map& map)
{
  figures::FlatPiece result = piece;
  for (figures::PolyData* data : { &result.flat, &result.wires })
  {
    *data = figures::moved(*data, 0.0, 0.0);
    vtkPoints* const points = (*data)->GetPoints();
    for (vtkIdType k = 0; k < points->GetNumberOfPoints(); ++k)
    {
      double point[3];
      points->GetPoint(k, point);
      const std::array<double, 2> place = map(point[0], point[1]);
      points->SetPoint(k, place[0], place[1], point[2]);
    }
  }
  return result;
}

/// Wires have the same edge lengths in the plane and in space.
inline void expectExactWires(
  const figures::FlatPiece& piece, const std::string& name, Checks& checks)
{
  double worst = 0.0;
  double perimeter = 0.0;
  vtkDataArray* const boundary = piece.wires->GetCellData()->GetArray("Boundary");
  forEachEdge(piece.wires, [&](vtkIdType cell, vtkIdType a, vtkIdType b) {
    const double length = distance(piece.cut, a, b);
    worst = std::max(worst, std::abs(distance(piece.flat, a, b) - length) / length);
    perimeter += boundary->GetComponent(cell, 0) != 0.0 ? length : 0.0;
  });
  checks.near(worst, 0.0, 1e-10, name + ": largest length error of a wire edge");
  checks.near(piece.number("ClosureResidual"), 0.0, 1e-12 * perimeter, name + ": closure");
}

/// The conformal map is scaled to the perimeter, keeps no length, and distorts angles less than
/// wires do.
inline void expectConformal(const figures::FlatPiece& conformal, const figures::FlatPiece& wired,
  const std::string& name, Checks& checks)
{
  double flat = 0.0;
  double space = 0.0;
  vtkDataArray* const boundary = conformal.wires->GetCellData()->GetArray("Boundary");
  forEachEdge(conformal.wires, [&](vtkIdType cell, vtkIdType a, vtkIdType b) {
    if (boundary->GetComponent(cell, 0) != 0.0)
    {
      flat += distance(conformal.flat, a, b);
      space += distance(conformal.cut, a, b);
    }
  });
  checks.near(flat / space, 1.0, 1e-10, name + ": perimeter in the plane over that in space");
  checks.that(
    conformal.number("EdgeLengthError") > 1e-3, name + ": the conformal map keeps lengths");
  checks.that(conformal.number("AngleErrorMean") < wired.number("AngleErrorMean"),
    name + ": the conformal map distorts angles more than wires do");
}

/// A figure's three methods: wires exact, the global optimum not above the progressive one, LSCM.
struct Methods
{
  std::vector<figures::FlatPiece> progressive;
  std::vector<figures::FlatPiece> global;
  std::vector<figures::FlatPiece> conformal;

  explicit Methods(const std::vector<figures::Piece>& pieces,
    figures::Interior interior = figures::Interior::Rigid)
    : progressive(figures::flattenAll(pieces, figures::Method::Progressive, interior))
    , global(figures::flattenAll(pieces, figures::Method::Global, interior))
    , conformal(figures::flattenAll(pieces, figures::Method::LeastSquaresConformal))
  {
  }

  void expect(Checks& checks) const
  {
    for (std::size_t k = 0; k < this->global.size(); ++k)
    {
      const std::string piece = "piece " + std::to_string(k);
      expectExactWires(this->progressive[k], "progressive, " + piece, checks);
      expectExactWires(this->global[k], "global, " + piece, checks);
      expectConformal(this->conformal[k], this->global[k], "LSCM, " + piece, checks);
      // Eq. 13 minimizes over all angles what Algorithm 2 minimizes patch by patch.
      checks.that(this->global[k].number("Objective") <=
          this->progressive[k].number("Objective") * (1 + 1e-9),
        piece + ": the global scheme changes angles more than the progressive one");
    }
  }
};

/// Runs a test's body; an exception fails it.
template <typename Body>
int run(const Body& body)
{
  Checks checks;
  try
  {
    body(checks);
  }
  catch (const std::exception& error)
  {
    checks.that(false, error.what());
  }
  return checks.result();
}

inline void drawFrontAndBack(figures::Figure& figure, const std::vector<figures::Piece>& pieces)
{
  figures::drawSpace(figure.add(), { pieces[0] }, { 0.0, 0.0, 1.0 });
  figures::drawSpace(figure.add(), { pieces[1] }, { 0.0, 0.0, -1.0 });
}

/// A front and a back in space, and by all three methods.
inline int drawMethods(int argc, char* argv[], const char* front, const char* back)
{
  return run([&](Checks& checks) {
    const std::string data = dataDirectory(argc, argv);
    const std::vector<figures::Piece> pieces{ figures::readPiece(data, front),
      figures::readPiece(data, back) };
    const Methods methods(pieces);
    methods.expect(checks);

    figures::Figure figure(1000, 1000);
    drawFrontAndBack(figure, pieces);
    figures::drawFlat(figure.add(), methods.progressive);
    figure.nextRow();
    figures::drawFlat(figure.add(), methods.global);
    figures::drawFlat(figure.add(), methods.conformal);
    compare(figure, argc, argv, checks);
  });
}
}

#endif
