// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening/FlatteningOptions.h"
#include "Report/FlatteningData.h"
#include "Report/FlatteningRun.h"
#include "Report/ReportRows.h"

#include <map>
#include <string>
#include <vector>

namespace flattening
{
/// A run on data sets of a surface and of its curves, for front ends that get and give arrays.
struct SurfaceRun
{
  DataSet surface;
  CurveInput curves;
  CurvedSurface source;
  FlatteningRun run{ this->source }; ///< its warnings begin with those of the arrays
  SurfaceArrays arrays;
  std::string unit;        ///< the first that one of the data sets states; empty: none
  bool unitStated = false; ///< else outputs state none, and sizes are no reason for a warning

  /// \param lines further data sets whose lines are curves \param defect why the surface cannot be
  /// read
  SurfaceRun(DataSet given, const std::vector<DataSet>& lines, Status defect = {});
  SurfaceRun(const SurfaceRun&) = delete; // the arrays are those of the surface
  SurfaceRun& operator=(const SurfaceRun&) = delete;

  /// Loads the surface with its curves, and weighs its triangles. \param weightArray of the cells;
  /// empty: none \return whether that could be done
  bool load(const OptionStructures& options, const std::map<std::string, double>& tolerances,
    const std::string& weightArray, const Execution& execution);

private:
  Status Defect;

  void read(const DataSet& data, int number);
};

/// What a front end that gets arrays makes of a result.
struct FlatteningReport
{
  FlatteningData data;
  ReportTables tables;
  StageSeconds seconds;
};

/// \pre the status of the run is that of the result
FlatteningReport reportFlattening(
  SurfaceRun& source, const FlatteningResult& result, const FlatteningOptions& options);

/// By the keys "pieces", "curves", "left_out" and "seconds" of report.json.
ReportObject objectOf(const FlatteningReport& report);
}
