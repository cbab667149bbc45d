// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"
#include "PatternUnit.h"

#include <string>
#include <vector>

namespace flattening
{
namespace pattern
{
/// What a line of a pattern piece tells the one who cuts and sews.
enum class LineKind
{
  CutLine,  ///< outer border of the cloth, closed
  CutOut,   ///< border of a hole in the cloth, closed
  SewLine,  ///< where pieces are joined or hemmed
  DartLeg,  ///< sewn onto the other leg of its dart
  DartFold, ///< where the cloth of a dart is folded
  KeyCurve, ///< feature curve of prescribed shape
  Internal, ///< any other feature curve
};

/// True for the lines that are wires: their lengths are those of the surface.
bool isWire(LineKind kind);

/// A straight-edged line. All lengths of a pattern are millimetres, y points up.
struct PatternLine
{
  LineKind kind = LineKind::Internal;
  bool closed = false;
  Points2 points;
  std::string name;        ///< of the feature curve; empty for the boundary
  double restLength = 0.0; ///< on the surface, of wires
};

/// A mark at the same place of both sides of a seam or dart.
struct Notch
{
  Point2 foot = Point2::Zero(); ///< on the sew line
  Point2 from = Point2::Zero(); ///< start and end of the mark; it starts on the cut line
  Point2 to = Point2::Zero();
  bool onCutLine = true;  ///< false: across the leg of a dart, within the cloth
  double arcLength = 0.0; ///< on the surface, from the first point of the feature curve
  std::string name;       ///< of the feature curve
};

struct Grainline
{
  Point2 from = Point2::Zero();
  Point2 to = Point2::Zero();
  bool fromKeyCurve = false; ///< false: the piece names none, and its upright is taken
};

enum class TextRole
{
  Title, ///< name of the piece
  Label, ///< size, quantity, count
  Curve, ///< name of a seam, dart or feature curve, beside it
};

/// One line of text around `position`, centred.
struct PatternText
{
  TextRole role = TextRole::Label;
  Point2 position = Point2::Zero();
  double height = 5.0; ///< of capitals and ascenders together, about
  double angle = 0.0;  ///< radians
  std::string text;    ///< valid UTF-8 without control characters
};

/// One piece of cloth; the lower left corner of its bounding box is the origin.
struct PatternPiece
{
  std::string name;
  std::string size;
  int quantity = 1;
  int number = 1; ///< from 1
  std::vector<PatternLine> lines;
  std::vector<Notch> notches;
  Points2 drillHoles;
  Grainline grain;
  std::vector<PatternText> texts;
  Point2 extent = Point2::Zero();
};

struct Pattern
{
  std::string name;
  Unit unit = Unit::Centimetre; ///< that the surface was in
  std::string date;             ///< year-month-day
  std::string time;             ///< hour:minute
  std::vector<PatternPiece> pieces;
};
}
}
