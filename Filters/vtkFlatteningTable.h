// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFlatteningTable
 * @brief measures of flat pieces or of their curves as a table
 *
 * What vtkWireWarpingFilter and vtkLeastSquaresConformalFilter measure stands in the field data of
 * their outputs; this filter makes a vtkTable of it, for spreadsheets, charts and files:
 *
 * - of output 0, the flat pieces: a row a piece. Columns: `Piece` (vtkIdType, counted from 0, as in
 *   the cell array `PieceId`), then each array of the field data that has a value a piece, under
 * its name (see vtkWireWarpingFilter): `Status`, `StatusMessage`, counts, lengths' and angles'
 * errors, `AreaError`, `StrainP95`, ...;
 * - of output 1, the wires: a row a feature curve, in the order of the ids in the cell array
 *   `CurveId`. Columns: `CurveNames`, `CurveTypes` (0 accessory, 1 key, 2 dart, 3 seam),
 *   `CurveRestLengths`, `CurveFlatLengths`, ...;
 * - of output 3 of vtkKeyCurvePrices: one row per trial, with its columns;
 * - of output 0 of vtkSewnShape: one row per shape. Columns: `Shape` (vtkIdType, counted from 0, as in
 *   the cell array `ShapeId`), `DistanceMean`, `StrainP95`, ...
 *
 * A surface that was refused has one row, with the `Piece` -1, its `Status` and `StatusMessage`.
 * Wires without a feature curve give a table without rows and columns; so does any other
 * vtkPolyData, with a warning.
 *
 * @code
 * vtkNew<vtkWireWarpingFilter> flattening;
 * flattening->SetInputData(surface);
 * vtkNew<vtkFlatteningTable> pieces;
 * pieces->SetInputConnection(flattening->GetOutputPort());
 * vtkNew<vtkDelimitedTextWriter> writer;
 * writer->SetInputConnection(pieces->GetOutputPort());
 * writer->SetFileName("pieces.csv");
 * writer->Write();
 * @endcode
 *
 * @warning Rows of composite data sets are those of each block: Piece counts from 0 in each.
 *
 * @sa vtkWireWarpingFilter
 */
#ifndef vtkFlatteningTable_h
#define vtkFlatteningTable_h

#include "vtkFiltersFlatteningModule.h" // for the export macro
#include "vtkTableAlgorithm.h"

class VTKFILTERSFLATTENING_EXPORT vtkFlatteningTable : public vtkTableAlgorithm
{
public:
  static vtkFlatteningTable* New();
  vtkTypeMacro(vtkFlatteningTable, vtkTableAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkFlatteningTable();
  ~vtkFlatteningTable() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkFlatteningTable(const vtkFlatteningTable&) = delete;
  void operator=(const vtkFlatteningTable&) = delete;
};

#endif
