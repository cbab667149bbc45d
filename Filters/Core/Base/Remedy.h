// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace flattening
{
/// Ways out of a defect. Each user interface says them in words of its own, which name its own
/// options; so no message of Core does.
enum class Remedy
{
  // The surface.
  GiveTriangles,
  WriteAgain,
  MendPoints,
  RemeshTriangles,
  RemoveDoubles,
  SeparateSides,
  SeparateSheets,
  DoublePoint,
  JoinByEdge,
  CutBandThrough,
  CutOpen,
  OpenHandles,
  SkipClosed,
  DivideInput,
  // Curves.
  RedrawCurve,
  ProjectPoints,
  RaiseImprintTolerance,
  AddCurvePoints,
  EndAtBoundary,
  SplitTriangles,
  FollowEdges,
  RaiseSnapTolerance,
  SpreadPlanarShape,
  NameCurve,
  TakeEdges,
  // Options.
  Give, ///< subject: what to give
  NamePins,
  OrderRelaxation,
  // The machine.
  FreeMemory,
  // The solution.
  MendSlivers,
  AllowAngleIterations,
  AllowIsometricIterations,
  AllowRigidIterations,
  AllowRelaxationIterations,
  AllowSewingIterations,
  TestPanels,
  UseNewton,
  UseIsometricScheme,
  UseRigidInterior,
  SeamBetweenLoops,
  ReleaseCurves,   ///< subject: which, accessory and key curves
  MakeAccessory,   ///< subject: key curves
  ChangeKeyShapes, ///< subject: key curves
  AllowLengthError,
  AddDarts,
  CloseCuts,
  DivideBySeam,
  NameGrain, ///< subject: curves of the piece
  GiveGrainAngle,
  TakeSofterCloth,
  // The pattern.
  ReadTheFlattening,
  GiveFlatPieces,
  CheckUnit,
  WidenNotches,
  PrintOnPages,
  TakeLargerPaper,
  WriteOtherFormat,
  NameAnotherFile,
};

inline constexpr int remedyCount = static_cast<int>(Remedy::NameAnotherFile) + 1;

/// Short fixed name of a remedy ("CloseCuts"), for user interfaces to look their words up by.
const char* remedyName(Remedy remedy);

/// A remedy and what it is to be applied to.
struct SuggestedRemedy
{
  // NOLINTNEXTLINE(google-explicit-constructor): a list of remedies is a list of ways out
  SuggestedRemedy(Remedy which, std::string what = {})
    : remedy(which)
    , subject(std::move(what))
  {
  }

  Remedy remedy;
  std::string subject; ///< names or numbers, where the remedy has one
};

using SuggestedRemedies = std::vector<SuggestedRemedy>;
}
