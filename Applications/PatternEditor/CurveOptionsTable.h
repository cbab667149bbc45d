// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QTableWidget>

#include <map>
#include <set>
#include <string>

class vtkPatternWriter;

namespace editor
{
/// By how much a curve is longer in one piece than on the surface, as vtkFeatureCurveEditor has it.
struct PieceEase
{
  double fraction = 0.0; ///< 0: no ease
  int piece = -1;        ///< from 0; -1: the only one that it is in
};

using PieceEases = std::map<std::string, PieceEase>; ///< by name

/// What patterns show of single curves, a row each, where it is not as for all: seam allowance,
/// notches, smoothness, tips of darts; and how much longer they are in one of their pieces. Fields
/// that are empty leave it as for all.
class CurveOptionsTable : public QTableWidget
{
public:
  /// Columns, in their order; the name of the curve is before them, beside the row.
  enum Option
  {
    Allowance,
    NotchesAt, ///< distances from the start of the curve, separated by spaces
    DoubleNotches,
    FairTolerance,
    DartTip,
    Ease,    ///< percent
    InPiece, ///< number of the piece, from 1; empty: the only one that the curve is in
    Options  ///< how many there are
  };

  /// \param eases of all curves that can be eased
  /// \param curves those that can be drawn; those that the writer has options of are shown as well
  CurveOptionsTable(const vtkPatternWriter* writer, const PieceEases& eases,
    std::set<std::string> curves, QWidget* parent = nullptr);

  /// What a field says that it cannot mean, as one that is no length from 0; empty where all can be
  /// taken.
  QString defect() const;
  /// Makes the fields those of the writer, in place of all it had of single curves.
  void take(vtkPatternWriter* writer) const;
  /// Those that are not 0.
  PieceEases eases() const;

private:
  QString defectOfLengths(int row) const;
  QString defectOfEase(int row) const;
  std::string curve(int row) const;
  QString text(int row, Option option) const;
};
}
