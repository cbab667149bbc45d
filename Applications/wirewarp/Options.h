// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Patterns.h"
#include "Picture.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace wirewarp
{
/// What the process returns.
enum ExitCode
{
  Done = 0,
  BadUsage = 2,
  InputRefused = 3,
  PromiseBroken = 4,
};

/// The command line. Of what vtkWireWarpingFilter is told defaultOptions() has the defaults.
struct Options
{
  std::string surface;
  std::vector<std::string> curves;
  std::string batch; ///< a list of surfaces in their place; empty: none

  std::string scheme;
  std::string solver;
  std::string interior;
  bool releaseKeys = false;
  bool releaseTrials = false;
  bool closeCuts = false;
  bool skipClosed = false;
  std::map<std::string, double> tolerances; ///< of length, by name of curve

  std::string energy;
  double areaBias = 0.0;
  double angleWeight = 0.0;
  int isometricMaximumIterations = 0;
  double isometricTolerance = 0.0;

  int maximumIterations = 0;
  double closureTolerance = 0.0;
  double optimalityTolerance = 0.0;
  double relaxationFactor = 0.0;
  double relaxationMovement = 0.0;
  int relaxationMinimumIterations = 0;
  int relaxationMaximumIterations = 0;
  double rigidTolerance = 0.0;
  int rigidMaximumIterations = 0;
  std::array<int, 2> pins{};

  bool split = false;
  double imprintTolerance = 0.0;
  double snapTolerance = 0.0;

  bool arrange = false;
  double spacing = 0.0;
  double maximumLengthError = 0.0;

  std::string suggest; ///< which cuts to propose; empty: none
  double bound = 0.0;
  int maximumCuts = 0;
  double maximumCutLength = 0.0; ///< 0: no limit
  std::string symmetric;
  std::map<std::string, double> preferences; ///< weights by name of curve

  PatternRequest pattern;
  PictureRequest picture;

  std::string output; ///< empty: outputFolder() makes one of the input's name
  int threads = 0;    ///< 0: as many as there are cores
  bool listCurves = false;
  bool quiet = false;
};

/// Where the files go.
std::string outputFolder(const Options& options);

/// Reads the command line. No value: everything is said already, and `exitCode` is what to return.
std::optional<Options> parseCommandLine(int argc, char** argv, int& exitCode);
}
