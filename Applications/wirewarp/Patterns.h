// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace wirewarp
{
struct Flattening;
class OutputFiles;

/// Which patterns to write and how. Lengths are millimetres; defaults are those of
/// vtkPatternWriter.
struct PatternRequest
{
  bool svg = false;
  bool pdf = false;
  bool dxf = false;
  bool plt = false;
  bool garmentCode = false;
  bool walk = false;
  std::string unit; ///< empty: not stated, cm is taken
  std::string name; ///< empty: that of the surface's file
  std::string size;
  int quantity = 1;
  std::vector<int> pieceQuantities;
  std::vector<std::string> pieceNames;
  double allowance = 10.0;
  std::vector<std::string> curveAllowances; ///< NAME=MM
  double mitreLimit = 2.0;
  double notchSpacing = 100.0;
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

  bool any() const
  {
    return this->svg || this->pdf || this->dxf || this->plt || this->garmentCode || this->walk ||
      this->fabricWidth > 0.0;
  }
};

void addPatternOptions(CLI::App& app, PatternRequest& request);

/// Adds pattern.svg, pattern.pdf, pattern.dxf, pattern.plt, pattern.json, walk.csv, lay.svg,
/// lay.plt, nest.svg, rules.csv and pattern.rul to the files.
/// Throws InputError where one cannot be drawn. What was done goes into the result, and is printed
/// where it is news: not what was done unasked, and if quiet only what was asked for in vain.
/// \return their names
std::vector<std::string> addPatterns(const PatternRequest& request, const std::string& surface,
  bool quiet, Flattening& result, OutputFiles& files);
}
