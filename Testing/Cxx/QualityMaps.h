// SPDX-License-Identifier: BSD-3-Clause
// The maps of Figs. 9e, 9f, 10e and 10f.
#ifndef QualityMaps_h
#define QualityMaps_h

#include "FigureTest.h"

namespace figureTest
{
/// Area and the two sides of a triangle's first corner, as a 2D frame in its own plane.
struct Frame
{
  double ux = 0.0; ///< first side, along x
  double vx = 0.0; ///< second side
  double vy = 0.0;
};

inline Frame frameOf(vtkPolyData* data, vtkIdList* ids)
{
  double a[3];
  double u[3];
  double v[3];
  double normal[3];
  data->GetPoint(ids->GetId(0), a);
  data->GetPoint(ids->GetId(1), u);
  data->GetPoint(ids->GetId(2), v);
  vtkMath::Subtract(u, a, u);
  vtkMath::Subtract(v, a, v);
  vtkMath::Cross(u, v, normal);
  const double length = vtkMath::Norm(u);
  return { length, vtkMath::Dot(u, v) / length, vtkMath::Norm(normal) / length };
}

/// The two indices of a triangle that is not flipped, from its frames in space and in the plane.
inline std::array<double, 2> indicesOf(const Frame& space, const Frame& flat)
{
  // The map's upper triangular matrix; S + s and S - s are the lengths of its conformal and its
  // anticonformal part.
  const double m00 = flat.ux / space.ux;
  const double m01 = (flat.vx - m00 * space.vx) / space.vy;
  const double m11 = flat.vy / space.vy;
  const double area = m00 * m11;
  const double conformal = std::hypot(m00 + m11, m01);
  const double anticonformal = std::hypot(m00 - m11, m01);
  return { std::min(area, 1.0 / area), (conformal - anticonformal) / (conformal + anticonformal) };
}

/// The colours show what a second computation gives. Returns the mean of 1 - homogeneity.
inline double expectIndices(
  const figures::FlatPiece& piece, const std::string& name, Checks& checks)
{
  vtkCellData* const data = piece.flat->GetCellData();
  vtkDataArray* const homogeneity = data->GetArray("HomogeneityOfDistortion");
  vtkDataArray* const aspect = data->GetArray("AspectRatio");
  vtkDataArray* const flipped = data->GetArray("Flipped");
  vtkNew<vtkIdList> ids;
  double worst = 0.0;
  double sum = 0.0;
  for (vtkIdType cell = 0; cell < piece.flat->GetNumberOfCells(); ++cell)
  {
    sum += 1.0 - homogeneity->GetComponent(cell, 0);
    if (flipped->GetComponent(cell, 0) == 0.0)
    {
      piece.flat->GetCellPoints(cell, ids);
      const std::array<double, 2> indices =
        indicesOf(frameOf(piece.cut, ids), frameOf(piece.flat, ids));
      worst = std::max({ worst, std::abs(indices[0] - homogeneity->GetComponent(cell, 0)),
        std::abs(indices[1] - aspect->GetComponent(cell, 0)) });
    }
  }
  checks.near(worst, 0.0, 1e-10, name + ": largest difference of an index");
  return sum / static_cast<double>(piece.flat->GetNumberOfCells());
}

inline int drawQualityMaps(int argc, char* argv[], const char* front, const char* back)
{
  return run([&](Checks& checks) {
    const std::string folder = dataFolder(argc, argv);
    const std::vector<figures::Piece> pieces{ figures::readPiece(folder, front),
      figures::readPiece(folder, back) };
    const std::array<std::vector<figures::FlatPiece>, 4> columns{
      figures::flattenAll(pieces, figures::Method::Global, figures::Interior::Paper),
      figures::flattenAll(pieces, figures::Method::Global, figures::Interior::Rigid),
      figures::flattenAll(pieces, figures::Method::Isometric),
      figures::flattenAll(pieces, figures::Method::LeastSquaresConformal)
    };
    figures::Figure figure(1200, 1000);
    figure.style.wireWidth = 2.5;
    std::array<double, 4> means{};
    for (const char* const index : { "HomogeneityOfDistortion", "AspectRatio" })
    {
      for (const std::vector<figures::FlatPiece>& column : columns)
      {
        figures::drawIndex(figure.add(), column, index);
      }
      figure.nextRow();
    }
    for (std::size_t column = 0; column < columns.size(); ++column)
    {
      for (const figures::FlatPiece& piece : columns[column])
      {
        means[column] += expectIndices(piece, "column " + std::to_string(column), checks);
      }
    }
    checks.that(means[1] < means[0], "the rigid interior changes areas less than Eq. 11");
    checks.that(means[2] < means[1], "the isometric scheme changes areas less than pinned wires");
    checks.that(means[2] < means[3], "the isometric scheme changes areas less than LSCM");
    for (const figures::FlatPiece& piece : columns[2])
    {
      checks.near(piece.number("MaxEdgeLengthError"), 0.0, 1e-12, "isometric: length error");
    }
    compare(figure, argc, argv, checks);
  });
}
}

#endif
