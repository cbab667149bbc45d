// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FlagWords.h"
#include "Flattening/FlatteningResult.h"
#include "Input/DataSet.h"
#include "Options.h"
#include "ReadSurface.h"
#include "Report/FlatteningTables.h"
#include "Suggestion/CurveSuggestions.h"
#include "SurfaceMending.h"
#include "Units.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace flattening::pattern
{
struct Grading;
}

namespace wirewarp
{
using Table = flattening::Columns;
/// What is written to a file; null: nothing.
using Data = std::shared_ptr<const DataSet>;

using flattening::integerIn;
using flattening::numberIn;
using flattening::rowsOf;
using flattening::textIn;

using flattening::missedBy;

/// The remedies of one piece.
std::vector<Remedy> remediesOf(const flattening::ReportTables& tables, std::size_t piece);

/// What became of one surface.
struct Flattening
{
  int exitCode = Done;
  /// "Ok", the name of a status, or "UnreadableInput".
  std::string status = "Ok";
  std::string message;
  std::vector<std::int64_t> ids; ///< of the elements that the message is about
  std::string idKind;            ///< what they are: "points", "cells", "curves", ...
  std::vector<Remedy> remedies;

  /// The outputs of vtkWireWarpingFilter; none after a refusal.
  Data flat;
  Data wires;
  Data cut;
  flattening::ReportTables tables; ///< without rows after an error
  flattening::StageSeconds seconds;

  /// Of `wirewarp cut`: all curves, as vtkFeatureCurveSuggestion has them, and what else it found.
  Data curves;
  Table search;
  Table leftOutLines;
  /// Of `wirewarp prices`: the prices of vtkKeyCurvePrices.
  Table keyPrices;

  /// Of `wirewarp reshape`: outputs 5 to 9 of vtkMakeFlattenable.
  Data flattenable;
  Data flattenableCurves;
  Table piecesBefore;
  Table shiftMeasures;
  std::size_t shiftTrials = 0;

  /// Of `wirewarp sew`: output 0 of vtkSewnShape.
  Data sewn;
  Table sewnShapes;

  /// Of `wirewarp grade`.
  std::shared_ptr<const flattening::pattern::Grading> grading;

  std::string unit = "cm"; ///< of the surface, as in Units.h
  bool unitStated = false; ///< by --unit or by a file; else it is the likely one
  std::string unitNote;    ///< says which is taken; empty where it is stated

  double curveDistance = 0.0; ///< of the curves' points from the surface, at most
  /// Of the flattening, and behind them what the command itself warns of.
  std::vector<std::string> warnings;
  /// What was done to the pieces of a pattern.
  std::vector<std::string> patternNotes;
  /// What the pieces take of the cloth of --roll-width: lengths in mm; 0: not laid.
  double layWidth = 0.0;
  double layLength = 0.0;
  double layEfficiency = 0.0;
  /// Files that were asked for and cannot be written, with the reasons; the others are.
  std::vector<std::string> unwritten;

  std::string savedReport; ///< of the folder that the result was read from; empty: none

  double secondsRead = 0.0;
  double secondsWrite = 0.0; ///< of all files but the report itself
  double secondsTotal = 0.0;

  bool refused() const { return this->exitCode == InputRefused; }
  /// The exit code of a run that has written what it can.
  int outcome() const { return this->unwritten.empty() ? this->exitCode : InputRefused; }
  /// Takes over how a run ended.
  void conclude(const flattening::Status& outcome);
};

/// The surface of a file, mended as the options say. \param unit of the surface
/// \param proposed whether its curves were, by an earlier run
MendedSurface mendedSurface(const Options& options, const SurfaceContents& contents,
  const std::string& unit, bool proposed = false);

/// Whether the options ask for another size of the surface.
bool isScaled(const Options& options);
/// The factor of --scale and --height. \param unit of the surface
double scaleOf(const Options& options, const DataSet& surface, const std::string& unit);
void scaleBy(double factor, DataSet& data);
/// Of points that have moved.
void dropNormals(DataSet& data);

/// What is said of a unit that is taken since none is stated.
std::string unitTaken(const std::string& surface, const LikelyUnit& taken);

/// A refusal for want of memory.
Flattening outOfMemory(const std::string& surface, const std::string& limit = {});

/// Reads one surface with its curves and flattens it. Bad input ends in the result, not in an
/// exception.
/// \param base the surface of the same connectivity that the curves are of; empty: the one itself
Flattening flattenOne(const Options& options, const std::string& base = {});
}
