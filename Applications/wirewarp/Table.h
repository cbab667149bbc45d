// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Flattening.h"

#include <string>
#include <vector>

namespace wirewarp
{
/// A row a piece, numbered from 1, with its size, the columns of the paper's Table 1 and what else
/// a user must know.
std::string pieceTable(const Flattening& result);

/// A line a piece in words: size, what has to be eased in and where most.
std::string verdicts(const Flattening& result);

/// Whether a piece overlaps itself or has triangles turned over.
bool coversItself(const Table& pieces, std::size_t piece);

/// What a piece means to its maker: "does not fit" where it covers itself, else by
/// the strain of 95 % of its area, as "fits" or "does not fit: strain 40 %, cut it".
/// \param piece a row \param bound the strain that is good enough; 0: 5 %, or 15 % for material that
/// gives
std::string fitVerdict(const Table& pieces, std::size_t piece, double bound);

/// A row a feature curve: its length on the surface and in the plane.
std::string curveTable(const Flattening& result);

/// How far the curves were from the surface that they were laid on; empty where on it.
std::string curveDistance(const Flattening& result);

/// Where a piece has no good exact solution: which curve to release first, and what that brings.
std::string releaseAdvice(const Flattening& result);
/// A line a piece in which something else was done than was asked for; empty if all is as asked.
std::string fallbacks(const Flattening& result);

/// Which unit is taken since none is stated; empty where one is.
std::string unitNote(const Flattening& result, const std::string& where = {});

/// What was left out of an input that could be used, a line each. \param where stands before each
std::string warnings(const Flattening& result, const std::string& where = "");

/// A line for each file that could not be written.
std::string writeErrors(const Flattening& result);

/// What is wrong with pieces, a line each. \param where stands before each piece
std::string pieceWarnings(const Flattening& result, const std::string& where = "");

/// The proposals of `wirewarp cut`, of vtkFeatureCurveSuggestion's curves: the columns of its lines
/// that are left out, PredictedGain, Opening and MirrorOf (the name of another); no rows for other
/// commands.
Table suggestedCuts(const Flattening& result);

/// The numbers of MirrorPlane or MirrorAxis; none where there is no such mirror.
std::vector<double> mirrorNumbers(const Flattening& result, const char* array);

/// Both as tables with numbers, or in short, or that nothing is proposed; empty where no search
/// ran.
std::string suggestionTable(const Flattening& result, bool numbers);

/// What `wirewarp prices` found; empty for other commands.
std::string keyPriceTable(const Flattening& result);
}
