// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FaceSeams.h"
#include "PatternOptions.h"
#include "Picture.h"
#include "Resewing.h"
#include "Reshaping.h"
#include "SizeOptions.h"

#include <array>
#include <map>
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

/// A curve that is longer in one piece than on the surface.
struct EaseRequest
{
  std::string curve;
  int piece = -1; ///< from 0; -1: the only one
  double fraction = 0.0;
};

/// The command line. Of what vtkWireWarpingFilter is told defaultOptions() has the defaults.
struct Options
{
  std::string command = "flatten";       ///< a name of the table in CommandLine.cxx
  std::string batchCommand = "flatten";  ///< that a batch runs on each surface
  std::vector<std::string> batchOutputs; ///< files of each surface in its folder
  std::string surface;
  std::string source; ///< the folder of a result that takes the place of a flattening; empty: none
  std::vector<std::string> curves;
  std::string batch; ///< a list of surfaces in their place; empty: none

  std::string unit; ///< empty: not stated, cm is taken

  std::string scheme;
  std::string solver;
  std::string interior;
  bool releaseKeys = false;
  bool releaseTrials = false;
  bool closeCuts = false;
  std::string dartLegs;
  bool skipClosed = false;
  std::string weld;       ///< millimetres, "0": points that lie on each other; empty: not given
  double fillHoles = 0.0; ///< mm; 0: none
  bool outerSide = false;
  SeamSource seamsFrom = SeamSource::None;  ///< of SURFACE's faces
  std::map<std::string, double> tolerances; ///< of length, by name of curve
  std::vector<EaseRequest> eases;

  std::string energy;
  double areaBias = 0.0;
  double angleWeight = 0.0;
  int isometricMaximumIterations = 0;
  double isometricTolerance = 0.0;

  std::string material; ///< a name or a file; empty: none
  std::string grain;    ///< as vtkWireWarpingFilter has it

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

  bool priceKeys = false;
  std::string suggest; ///< which cuts to propose; empty: none
  double bound = 0.0;
  bool boundGiven = false;
  int maximumCuts = 0;
  double maximumCutLength = 0.0; ///< 0: no limit
  double maximumWork = 0.0;      ///< 0: no limit
  std::string symmetric;
  std::map<std::string, double> preferences; ///< weights by name of curve
  std::string weights;                       ///< a cell array; empty: none

  std::string body; ///< a file; empty: none
  ReshapingRequest reshaping;
  ResewingRequest resewing;
  PatternRequest pattern;
  SizeRequest sizes;
  PictureRequest picture;

  std::vector<std::string> outputs; ///< files and at most one folder, as --output has them
  std::string output;               ///< the folder that keeps the result; empty: none
  bool outputGiven = false;         ///< it is not the default
  std::string curvesFile;           ///< of proposals or moved curves; empty: none
  std::string surfaceFile;          ///< of the moved surface; empty: none
  std::string sewnFile;             ///< of the sewn shape; empty: none
  int threads = 0;                  ///< 0: as many as there are cores
  bool listCurves = false;
  bool table = false;
  bool quiet = false;
};
}
