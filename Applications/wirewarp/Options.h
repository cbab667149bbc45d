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

/// The command line. Defaults are those of vtkWireWarpingFilter.
struct Options
{
  std::string surface;
  std::vector<std::string> curves;
  std::string batch; ///< a list of surfaces in their place; empty: none

  std::string scheme = "isometric";
  std::string solver = "newton";
  std::string interior = "arap";
  bool releaseKeys = false;
  bool closeCuts = false;
  bool skipClosed = false;
  std::map<std::string, double> tolerances; ///< of length, by name of curve

  std::string energy = "rigid";
  double areaBias = 0.0;
  double angleWeight = 5.0;
  int isometricMaximumIterations = 100;
  double isometricTolerance = 1e-9;

  int maximumIterations = 300;
  double closureTolerance = 1e-12;
  double optimalityTolerance = 1e-10;
  double relaxationFactor = 1.5;
  double relaxationMovement = 1e-5;
  int relaxationMinimumIterations = 10;
  int relaxationMaximumIterations = 100;
  double rigidTolerance = 1e-9;
  int rigidMaximumIterations = 200;
  std::array<int, 2> pins{ -1, -1 };

  bool split = true;
  double imprintTolerance = 1e-5;
  double snapTolerance = 1e-3;

  bool arrange = true;
  double spacing = 0.05;
  double maximumLengthError = 1e-9;

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
