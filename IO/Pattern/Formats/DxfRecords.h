// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <string>
#include <vector>

namespace flattening
{
namespace pattern
{
/// The layers of ASTM D6673 that patterns are drawn on.
enum class DxfLayer
{
  Boundary = 1,
  TurnPoints = 2,
  CurvePoints = 3,
  Notches = 4,
  MirrorLine = 6,
  GrainLine = 7,
  InternalLines = 8,
  CutOuts = 11,
  DrillHoles = 13,
  SewLines = 14,
  Annotation = 15,
};

/// Whether lines of a layer are dashed.
bool isDashed(DxfLayer layer);

/// The text of a DXF file as it grows, in pairs of a group code and a value. Each entity and each
/// entry of a table gets a handle: R12 can do without, but FreeCAD takes a layer without one for a
/// layer without a name.
class DxfRecords
{
public:
  /// \param inches the unit of the drawing, or millimetres
  explicit DxfRecords(bool inches)
    : Inches(inches)
    , PerMillimetre(inches ? 1.0 / 25.4 : 1.0)
  {
  }

  void add(int code, const std::string& value);
  void add(int code, int value) { this->add(code, std::to_string(value)); }
  /// A number as it is.
  void addNumber(int code, double value);
  void addLength(int code, double millimetres)
  {
    this->addNumber(code, this->PerMillimetre * millimetres);
  }
  /// \param which of the points of an entity, from 0
  void addPoint(const Point2& p, int which = 0);
  void beginSection(const char* name);
  void beginTable(const char* name, int entries);
  /// An entry of a table, with its handle and its name.
  void beginEntry(const char* table, const std::string& name);
  void begin(const char* entity, DxfLayer layer);
  /// Header and tables of a drawing with these corners.
  void addHead(const Point2& low, const Point2& high);
  /// The whole text.
  std::string finish();

private:
  void addHandle();
  /// \param dashes lengths in millimetres, those of gaps less than 0; none: a solid line
  void addLineType(
    const std::string& name, const std::string& words, const std::vector<double>& dashes);

  bool Inches;
  double PerMillimetre;
  unsigned NextHandle = 1;
  std::size_t Seed = 0; ///< where in the text the next free handle is to be told
  std::string Text;
};
}
}
