// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FlagWords.h"
#include "Options.h"
#include "ReadSurface.h"
#include "SurfaceMending.h"
#include "TriangleList.h"
#include "Units.h"

#include <vtkBoundingBox.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include <array>
#include <string>
#include <vector>

class vtkStringArray;

namespace wirewarp
{
/// A table without rows.
inline vtkSmartPointer<vtkTable> noTable()
{
  return vtkSmartPointer<vtkTable>::New();
}

/// A value of a table.
inline double numberIn(vtkTable* table, vtkIdType row, const char* column)
{
  return table->GetValueByName(row, column).ToDouble();
}
inline long long integerIn(vtkTable* table, vtkIdType row, const char* column)
{
  return table->GetValueByName(row, column).ToLongLong();
}
inline std::string textIn(vtkTable* table, vtkIdType row, const char* column)
{
  return table->GetValueByName(row, column).ToString();
}

/// The values of an array.
std::vector<std::string> textsOf(vtkStringArray* array);

/// A strain above this multiple of the bound misses it.
constexpr double missedBy = 1.5;

/// The tables of pieces that vtkFlatPieceAlgorithm gives.
struct PieceTables
{
  vtkSmartPointer<vtkTable> pieces = noTable();
  vtkSmartPointer<vtkTable> angleIterations = noTable();
  vtkSmartPointer<vtkTable> isometricIterations = noTable();
  vtkSmartPointer<vtkTable> releaseTrials = noTable();
  vtkSmartPointer<vtkTable> remedies = noTable();
};

/// The remedies of one piece.
std::vector<Remedy> remediesOf(const PieceTables& tables, vtkIdType piece);

/// What became of one surface.
struct Flattening
{
  int exitCode = Done;
  /// "Ok", a status name of vtkFlatteningAlgorithm, or "UnreadableInput".
  std::string status = "Ok";
  std::string message;
  std::vector<vtkIdType> ids; ///< of the elements that the message is about
  std::string idKind;         ///< what they are: "points", "cells", "curves", ...
  std::vector<Remedy> remedies;

  /// The outputs of vtkWireWarpingFilter; without points after a refusal.
  vtkSmartPointer<vtkPolyData> flat;
  vtkSmartPointer<vtkPolyData> wires;
  vtkSmartPointer<vtkPolyData> cut;
  PieceTables tables; ///< without rows after an error
  vtkSmartPointer<vtkTable> leftOutPieces = noTable();
  vtkSmartPointer<vtkTable> curveTable = noTable();
  std::array<double, 4> seconds{}; ///< of wires, interior and quality, and in total

  /// Of `wirewarp cut`: all curves, as vtkFeatureCurveSuggestion has them, and what else it found.
  vtkSmartPointer<vtkPolyData> curves;
  vtkSmartPointer<vtkTable> search = noTable();
  vtkSmartPointer<vtkTable> leftOutLines = noTable();
  /// Of `wirewarp prices`: the prices of vtkKeyCurvePrices.
  vtkSmartPointer<vtkTable> keyPrices = noTable();

  /// Of `wirewarp reshape`: outputs 5 to 9 of vtkMakeFlattenable.
  vtkSmartPointer<vtkPolyData> flattenable;
  vtkSmartPointer<vtkPolyData> flattenableCurves;
  vtkSmartPointer<vtkPolyData> flatBefore;
  PieceTables tablesBefore; ///< pieces alone
  vtkSmartPointer<vtkTable> shiftMeasures = noTable();
  vtkIdType shiftTrials = 0;

  /// Of `wirewarp sew`: output 0 of vtkSewnShape.
  vtkSmartPointer<vtkPolyData> sewn;
  vtkSmartPointer<vtkTable> sewnShapes = noTable();

  /// Of `wirewarp grade`: the output of vtkPatternGrading.
  vtkSmartPointer<vtkPolyData> grading;

  std::string unit = "cm"; ///< of the surface, as in Units.h
  bool unitStated = false; ///< by --unit or by a file; else it is the likely one
  std::string unitNote;    ///< says which is taken; empty where it is stated

  double curveDistance = 0.0;        ///< of the curves' points from the surface, at most
  std::vector<std::string> warnings; ///< of the filter
  std::vector<std::string> notes;    ///< what the command itself warns of
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
};

/// The surface of a file, mended as the options say. \param unit of the surface
MendedSurface mendedSurface(
  const Options& options, const SurfaceContents& contents, const std::string& unit);

/// Whether the options ask for another size of the surface.
bool isScaled(const Options& options);
/// The factor of --scale and --height. \param unit of the surface
double scaleOf(const Options& options, vtkPolyData* surface, const std::string& unit);
void scaleBy(double factor, vtkPolyData* data);
/// Of the triangles alone.
vtkBoundingBox boxOf(const TriangleList& list);

/// What is said of a unit that is taken since none is stated.
std::string unitTaken(const std::string& surface, const LikelyUnit& taken);

/// A refusal for want of memory.
Flattening outOfMemory(const std::string& surface, const std::string& limit = {});

/// Reads one surface with its curves and flattens it. Bad input ends in the result, not in an
/// exception.
/// \param base the surface of the same connectivity that the curves are of; empty: the one itself
Flattening flattenOne(const Options& options, const std::string& base = {});
}
