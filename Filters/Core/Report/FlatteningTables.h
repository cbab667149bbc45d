// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Design/KeyPrices.h"
#include "Flattening/FlatteningResult.h"
#include "Input/Columns.h"
#include "Input/CurvedSurface.h"
#include "Quality/FlatteningQuality.h"
#include "Reshaping/FlattenableSurface.h"
#include "Surface/FeatureCurve.h"

#include <string>
#include <vector>

namespace flattening
{
/// What a flattening reports.
struct ReportTables
{
  Columns pieces; ///< as pieceTable() makes it
  Columns curves; ///< a row each
  Columns angleIterations;
  Columns isometricIterations;
  Columns releaseTrials;
  Columns pieceRemedies;
  Columns leftOutPieces;

  /// Tables without columns.
  ReportTables() = default;
  /// The other parameters are those of pieceTable().
  ReportTables(const CurvedSurface& source, const FlatteningResult& result, const std::string& unit,
    const std::vector<std::string>& cellNames);
};

/// One row per piece. \param unit of length; empty where none is stated
/// \param cellNames the name of the piece of each triangle; empty where they have none
Columns pieceTable(const CurvedSurface& source, const FlatteningResult& result,
  const std::string& unit, const std::vector<std::string>& cellNames);

/// A warning for each piece that the plane has no room for, or that was flattened by another energy
/// than the one requested.
std::vector<std::string> describeVerdicts(
  const CurvedSurface& source, const FlatteningResult& result);

/// The one row of a surface without pieces: Piece is -1.
Columns refusalTable(const std::string& status, const std::string& message);

/// The presets, as vtkFlatPieceAlgorithm::ListMaterials() documents them.
Columns materialTable();

/// Output 5 of vtkKeyCurvePrices.
Columns keyPriceTable(const std::vector<FeatureCurve>& curves, const KeyPrices& prices);

/// `Shift`, `ShiftDistance`, `ShiftOutwards` and `Kept` of the vertices.
Columns shiftArrays(const TriangleMesh& design, const FlattenableSurface& result);

/// The one row of the measures.
Columns shiftTable(const FlattenableSurface& result);

/// One row per flattening of the search.
Columns shiftTrialTable(const std::vector<FlattenableTrial>& trials);

/// Adds the columns of summaries of flattenings. \param summaryOf the summary of a row
template <class Row, class SummaryOf>
void addSummaries(const TableColumns<Row>& columns, SummaryOf summaryOf)
{
  const auto add = [&](const char* name, double QualitySummary::*value) {
    columns.add(name, [&](const Row& row) { return summaryOf(row).*value; });
  };
  add("EdgeLengthError", &QualitySummary::edgeLengthError);
  add("MaxEdgeLengthError", &QualitySummary::maximumEdgeLengthError);
  add("EdgeLengthErrorAll", &QualitySummary::edgeLengthErrorAll);
  add("AngleErrorMean", &QualitySummary::angleError);
  add("GlobalHomogeneity", &QualitySummary::globalHomogeneity);
  add("GlobalAspectRatio", &QualitySummary::globalAspectRatio);
  add("AreaError", &QualitySummary::areaError);
  add("StrainP95", &QualitySummary::strainP95);
  add("RigidEnergy", &QualitySummary::rigidEnergy);
  columns.add("FlippedTriangles", [&](const Row& row) { return summaryOf(row).flipped.size(); });
}
}
