// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fairing/FairNetwork.h"
#include "Fairing/FairPlan.h"
#include "Outlines/FairSpan.h"
#include "Outlines/MirrorPairs.h"

#include <string>

namespace flattening::pattern
{
/// By how much sides of an outline that are mirror images may differ in length, in millimetres:
/// their mean is then as near to both as lengths in files are.
inline constexpr double mirroredLengthTolerance = 0.1;
/// By how much they differ if they are said to, millimetres.
inline constexpr double noticedLength = 1e-4;

/// How an outline is its own mirror image.
struct OutlineMirror
{
  std::size_t chain = 0;
  MirrorAxis axis;
  std::vector<MirroredStretches> stretches; ///< each in one of them; none: it is not
  std::string why;                          ///< it is not
  double difference = 0.0; ///< of the lengths of two such stretches of it, at most, millimetres

  bool found() const { return !this->stretches.empty(); }
};

/// The stretches of the outline of a piece that are mirror images of each other, from corner to
/// corner.
OutlineMirror findOutlineMirror(const DrawingSource& all, const BorderChains& chains,
  const std::vector<PlannedChain>& plan, std::size_t piece);

/// Gives mirrored stretches the same form, and as breaks those of both.
void mirrorPlan(const OutlineMirror& mirror, std::vector<PlannedChain>& plan);

/// The breaks of a stretch as its mirror image has them, from start to end.
std::vector<double> mirroredBreaks(const std::vector<double>& breaks, double start, double end);

/// Gives intervals of mirrored stretches lengths that differ little from their own and make the
/// stretches equally long; those that are sewn to them change alike.
/// \param mirrors of the pieces
void equalizeMirroredLengths(
  const std::vector<OutlineMirror>& mirrors, std::vector<PlannedChain>& plan);

/// How far curves of an outline that are drawn, mirrored, are from each other: at most the distance
/// of their control points, millimetres.
double missOfCurves(
  const OutlineMirror& mirror, const PlannedChain& chain, const std::vector<FairSpan>& spans);
}
