// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/PieceOrigin.h"

#include "Outlines/PlaneGeometry.h"

namespace flattening
{
namespace pattern
{
void moveToOrigin(PatternPiece& piece)
{
  Box box;
  for (const PatternLine& line : piece.lines)
  {
    for (const Point2& p : line.points)
    {
      box.add(p);
    }
  }
  for (PatternLine& line : piece.lines)
  {
    for (Point2& p : line.points)
    {
      p -= box.low;
    }
    for (FairSpan& span : line.curve)
    {
      for (Point2& p : span.control)
      {
        p -= box.low;
      }
    }
  }
  for (Notch& notch : piece.notches)
  {
    notch.foot -= box.low;
    notch.from -= box.low;
    notch.to -= box.low;
  }
  for (Point2& p : piece.drillHoles)
  {
    p -= box.low;
  }
  for (GradePoint& point : piece.gradePoints)
  {
    point.place -= box.low;
  }
  for (PatternText& text : piece.texts)
  {
    text.position -= box.low;
  }
  piece.grain.from -= box.low;
  piece.grain.to -= box.low;
  piece.extent = box.extent();
}
}
}
