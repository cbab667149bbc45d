// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

class vtkFeatureCurveAlgorithm;

namespace CLI
{
class App;
}

namespace wirewarp
{
struct Flattening;
struct Options;
class OutputFiles;

/// A file of a pattern.
struct PatternFile
{
  std::string path;
  int format;           ///< of vtkPatternWriter
  bool onCloth = false; ///< its pieces are laid on cloth
};

/// Which patterns to write and how. Lengths are millimetres; defaults are those of
/// vtkPatternWriter.
struct PatternRequest
{
  std::vector<PatternFile> files;
  bool seamTable = false; ///< in the PDF
  std::string name;       ///< empty: that of the surface's file
  std::string size;
  int quantity = 1;
  std::vector<int> pieceQuantities; ///< 0: that of all
  std::vector<std::string> pieceNames;
  double allowance = -1.0;                  ///< below 0: by the material
  std::vector<std::string> curveAllowances; ///< NAME=MM
  double mitreLimit = 2.0;
  double notchSpacing = -1.0; ///< below 0: by the size of the pieces
  bool cutDartsOut = false;
  std::vector<std::string> curveNotches; ///< NAME=MM
  std::vector<std::string> doubleNotches;
  bool notchCorners = false;
  bool notchCurveEnds = false;
  bool cutOnFold = false;
  std::vector<std::string> folds;
  double dartTip = 0.0;
  std::vector<std::string> curveDartTips; ///< NAME=MM
  bool cutPairs = false;
  double fairTolerance = 0.2;
  bool fairGiven = false;
  bool symmetrize = false;
  std::vector<std::string> curveFairs; ///< NAME=MM
  bool laserColours = false;
  double fabricWidth = 0.0; ///< 0: no lay
  bool nap = false;
  double fabricGap = 5.0;
  std::string paper = "A4";
  double overlap = 10.0;
  int maximumPages = 200;

  bool any() const { return !this->files.empty(); }
};

/// How pieces are drawn.
void addDrawing(CLI::App& app, PatternRequest& request);
/// How they are laid on cloth.
void addNesting(CLI::App& app, PatternRequest& request);

/// Before the surface is flattened: refuses options for curves that are not there.
/// \param filter which has the curves, and may propose others
void checkCurveNames(const PatternRequest& request, const std::string& surface,
  vtkFeatureCurveAlgorithm* filter, Flattening& result);

/// Adds the files of a pattern. Throws InputError where one cannot be drawn. What was done goes
/// into the result, and is printed where it is news: not what was done unasked, and if quiet only
/// what was asked for in vain.
/// \return those that are written
std::vector<std::string> addPatterns(
  const Options& options, Flattening& result, OutputFiles& files);
}
