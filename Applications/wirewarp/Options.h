// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FaceSeams.h"
#include "Options/OptionValues.h"
#include "Patterns.h"
#include "Picture.h"
#include "Sizes.h"

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
  Flawed = 4,
};

/// The command line.
struct Options
{
  std::string command = "flatten";       ///< a name of the table in CommandLine.cxx
  std::string batchCommand = "flatten";  ///< that a batch runs on each surface
  std::vector<std::string> batchOutputs; ///< files of each surface in its folder
  std::string madeFor;                   ///< a kind of Make.cxx; empty: not made
  std::string seams;                     ///< template of make
  std::string surface;
  std::string source; ///< the folder of a result that takes the place of a flattening; empty: none
  std::vector<std::string> curves;
  std::string batch; ///< a list of surfaces in their place; empty: none

  std::string unit;          ///< empty: not stated
  std::string unitOtherwise; ///< where files state none either; empty: the likely one

  /// The options of the table, with the defaults of the algorithms.
  flattening::OptionValues values{ flattening::OptionOwner::Suggestion };

  /// Of properties in the unit of the surface; empty: that one.
  std::map<std::string, std::string> unitsOfLengths;

  /// Millimetres; "0": points that lie on each other; "false": none; empty: not given.
  std::string weld;
  double fillHoles = 0.0;                  ///< mm; 0: none
  std::string outerSide;                   ///< true, false; empty: where a sheet clearly has two
  double scale = 1.0;                      ///< of SURFACE
  double neutralLayer = 0.0;               ///< how far it lies within SURFACE, mm
  double height = 0.0;                     ///< to which it is scaled, mm; 0: not
  SeamSource seamsFrom = SeamSource::None; ///< of SURFACE's faces

  std::string body; ///< a file; empty: none
  flattening::OptionValues reshaping{ flattening::OptionOwner::Reshaping };
  flattening::OptionValues resewing{ flattening::OptionOwner::Sewing };
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
  bool table = false;
  bool quiet = false;
};
}
