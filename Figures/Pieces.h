// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>

#include <array>
#include <string>
#include <vector>

class vtkFlatPieceAlgorithm;

namespace figures
{
using PolyData = vtkSmartPointer<vtkPolyData>;

/// A surface and its feature curves.
struct Piece
{
  PolyData surface;
  PolyData curves;
};

/// Reads `folder/name.vtp` and `folder/name_curves<set>.vtp`. Throws std::runtime_error.
Piece readPiece(const std::string& folder, const std::string& name, const std::string& set = "");

/// Names of the surfaces in a folder, in alphabetical order.
std::vector<std::string> listPieces(const std::string& folder);

enum class Method
{
  Progressive,
  Global,
  Isometric,
  LeastSquaresConformal
};

enum class Interior
{
  Paper, ///< Eq. 11
  Rigid  ///< as rigid as possible with the wires pinned
};

/// The outputs of vtkWireWarpingFilter.
struct FlatPiece
{
  PolyData flat;
  PolyData wires;
  PolyData cut;
  vtkSmartPointer<vtkTable> pieces = nullptr; ///< null: not known
  vtkSmartPointer<vtkTable> curves = nullptr;
  std::array<double, 4> seconds{}; ///< as vtkFlatPieceAlgorithm::GetSeconds()

  /// The wires on a surface that is point for point the flat piece.
  PolyData wiresOn(const PolyData& surface) const;
  /// A value of the table of pieces; not a number where there is none.
  double number(const char* column, vtkIdType row = 0) const;
};

/// The outputs of a filter that has run.
FlatPiece outputsOf(vtkFlatPieceAlgorithm* filter);

/// Throws std::runtime_error with the filter's message where the piece is refused.
FlatPiece flatten(const Piece& piece, Method method, Interior interior = Interior::Rigid);

/// Adds the point array `Developability`. Throws std::runtime_error.
PolyData measureDevelopability(const PolyData& surface);

/// The same data at another place.
PolyData moved(const PolyData& data, double x, double y, double z = 0.0);

/// Moves flat pieces beside each other, bottom edges on one line.
void layBeside(std::vector<FlatPiece>& pieces);
}
