// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/LengthUnit.h"
#include "Outlines/FairSpan.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace flattening::pattern
{
/// What a line of a pattern piece, or a stroke that it is drawn by, tells the one who cuts and
/// sews.
enum class LineKind
{
  CutLine,  ///< outer border of the cloth, closed
  CutOut,   ///< border of a hole in the cloth, closed
  SewLine,  ///< where pieces are joined or hemmed
  DartLeg,  ///< sewn onto the other leg of its dart
  DartFold, ///< where the cloth of a dart is folded
  Fold,     ///< where the cloth is folded before a half of a piece is cut
  KeyCurve, ///< feature curve of prescribed shape
  Internal, ///< any other feature curve
  // Strokes that are no lines of a piece.
  Notch,
  DartMark, ///< a notch across the leg of a dart
  DrillHole,
  Grain,
};

/// True for the lines that are wires: their lengths are those of the surface.
bool isWire(LineKind kind);

/// True for those along which the cloth is cut.
bool isCut(LineKind kind);

/// A line. All lengths of a pattern are millimetres, y points up.
struct PatternLine
{
  LineKind kind = LineKind::Internal;
  bool closed = false;
  bool isCut = false; ///< a sew line without allowance: the cut line is drawn in its place
  Points2 points; ///< with straight sides, within sampleDistance of the curve where there is one
  std::vector<FairSpan>
    curve;                 ///< the line as it is meant, where it was made smooth; otherwise empty
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

/// A point that another size has elsewhere.
struct GradePoint
{
  Point2 place = Point2::Zero();
  int rule = 0; ///< from 1
};

struct Grainline
{
  Point2 from = Point2::Zero();
  Point2 to = Point2::Zero();
  bool known = false; ///< false: the piece names none, and its upright is taken
};

enum class TextRole
{
  Title, ///< name of the piece
  Label, ///< size, quantity, count
  Curve, ///< name of a seam, dart or feature curve, beside it
  Join,  ///< mark of a join, along the sew line
  Grain, ///< "grain" or "upright", beside the grainline
};

/// One line of text around `position`, centred.
struct PatternText
{
  TextRole role = TextRole::Label;
  std::string text; ///< valid UTF-8 without control characters
  Point2 position = Point2::Zero();
  double height = 5.0; ///< of capitals and ascenders together, about
  double angle = 0.0;  ///< radians
};

enum class NoteKind
{
  Drawn,       ///< as it was asked for, or what is of it
  Smoothed,    ///< lines were made smooth
  LeftRough,   ///< some lines could not be
  NotSmoothed, ///< nothing of a piece could be
  Mirrored,    ///< an outline was made its own mirror image
  NotMirrored, ///< one could not be
};

/// What was done to a piece that who cuts may want to know.
struct PatternNote
{
  std::string text;
  NoteKind kind = NoteKind::Drawn;
};

/// The sew line of one side of a join with its mark.
struct JoinSide
{
  std::string mark;
  Points2 line;
};

/// One piece of cloth; the lower left corner of its bounding box is the origin.
struct PatternPiece
{
  std::string name;
  std::string size;
  int quantity = 1;
  int turnedOver = 0; ///< so many of these are cut from cloth that is turned over
  int number = 1;     ///< from 1
  std::vector<PatternLine> lines;
  std::vector<Notch> notches;
  Points2 drillHoles;
  std::vector<GradePoint> gradePoints;
  Grainline grain;
  std::vector<PatternNote> notes;
  std::vector<std::string> warnings; ///< what is drawn otherwise than may be expected
  std::vector<PatternText> texts;
  Point2 extent = Point2::Zero();

  void addNote(const std::string& text, NoteKind kind = NoteKind::Drawn)
  {
    this->notes.push_back({ "piece " + this->name + ": " + text, kind });
  }
};

/// Calls f(point) for each point and control point of a line.
template <typename Function>
void forEachPoint(PatternLine& line, const Function& f)
{
  std::for_each(line.points.begin(), line.points.end(), f);
  for (FairSpan& span : line.curve)
  {
    std::for_each(span.control.begin(), span.control.end(), f);
  }
}

/// The same for everything of a piece.
template <typename Function>
void forEachPoint(PatternPiece& piece, const Function& f)
{
  for (PatternLine& line : piece.lines)
  {
    forEachPoint(line, f);
  }
  for (Notch& notch : piece.notches)
  {
    f(notch.foot);
    f(notch.from);
    f(notch.to);
  }
  std::for_each(piece.drillHoles.begin(), piece.drillHoles.end(), f);
  for (GradePoint& point : piece.gradePoints)
  {
    f(point.place);
  }
  for (PatternText& text : piece.texts)
  {
    f(text.position);
  }
  f(piece.grain.from);
  f(piece.grain.to);
}

/// The length of a line as it is drawn.
double lengthOf(const PatternLine& line);

/// Around the lines of a piece.
Eigen::AlignedBox2d boxOf(const PatternPiece& piece);

/// Cloth on which the pieces lie.
struct Fabric
{
  double width = 0.0;
  double length = 0.0;
  double efficiency = 0.0; ///< share of the cloth that is pieces
  Points2 corners;         ///< upper left corner of each piece, y down
};

/// A table for people to read; without rows it is not drawn.
struct PatternTable
{
  std::string title;
  std::vector<double> columns;                ///< where they start, in millimetres from the first
  std::vector<std::vector<std::string>> rows; ///< the first is the head
};

struct Pattern
{
  std::string name;
  Unit unit = Unit::Centimetre; ///< that the surface was in
  std::string date;             ///< year-month-day
  std::string time;             ///< hour:minute
  std::vector<PatternPiece> pieces;
  std::optional<Fabric> fabric;     ///< the pieces are laid on it; otherwise they are put in rows
  std::vector<PatternTable> tables; ///< on the pages after the pattern
  bool isSheet = false;             ///< its pieces have no grain
  std::vector<std::string> names;   ///< of all flat pieces, those that are not drawn among them
};
}
