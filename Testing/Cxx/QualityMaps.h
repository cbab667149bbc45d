// SPDX-License-Identifier: BSD-3-Clause
// The maps of Figs. 9e, 9f, 10e and 10f.
#ifndef QualityMaps_h
#define QualityMaps_h

#include "FigureTest.h"

namespace figureTest
{
/// The mean of 1 - homogeneity.
inline double meanChange(const figures::FlatPiece& piece)
{
  vtkDataArray* const homogeneity = piece.flat->GetCellData()->GetArray("HomogeneityOfDistortion");
  double sum = 0.0;
  for (vtkIdType cell = 0; cell < piece.flat->GetNumberOfCells(); ++cell)
  {
    sum += 1.0 - homogeneity->GetComponent(cell, 0);
  }
  return sum / static_cast<double>(piece.flat->GetNumberOfCells());
}

inline int drawQualityMaps(int argc, char* argv[], const char* front, const char* back)
{
  return run([&](Checks& checks) {
    const std::string folder = dataDirectory(argc, argv);
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
        means[column] += meanChange(piece);
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
