// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CurvedSurface.h"
#include "Flattening/FlatteningResult.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkPolyData;
class vtkTable;

namespace flattening
{
namespace bridge
{
/// The tables that vtkFlatPieceAlgorithm gives by methods.
struct ReportTables
{
  vtkSmartPointer<vtkTable> angleIterations;
  vtkSmartPointer<vtkTable> isometricIterations;
  vtkSmartPointer<vtkTable> releaseTrials;
  vtkSmartPointer<vtkTable> pieceRemedies;
  vtkSmartPointer<vtkTable> leftOutPieces;

  /// Tables without rows and columns. The caller may keep those of the last run.
  ReportTables();
  ReportTables(const CurvedSurface& source, const FlatteningResult& result);
};

/// Writes one row per piece. \param flat the written pieces, whose cells have their names
/// \param unit of length; empty where none is stated
void writePieceTable(const CurvedSurface& source, const FlatteningResult& result,
  const std::string& unit, vtkPolyData* flat, vtkTable* table);

/// A warning for each piece that the plane has no room for, or that was flattened by another energy
/// than the one requested.
std::vector<std::string> describeVerdicts(
  const CurvedSurface& source, const FlatteningResult& result);

/// Writes one row per feature curve.
void writeCurveTable(const std::vector<CurveReport>& curves, vtkTable* table);

/// Writes the one row of a surface without pieces: Piece is -1.
void writeRefusalRow(const std::string& status, const std::string& message, vtkTable* table);
}
}
