// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/DxfRecords.h"

#include "Outlines/PatternText.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>

namespace flattening
{
namespace pattern
{
namespace
{
struct LayerColour
{
  DxfLayer layer;
  int colour; ///< AutoCAD's colour index
};
/// Colours that can be read on black and on white alike.
constexpr LayerColour layerColours[] = { { DxfLayer::Boundary, 7 }, { DxfLayer::TurnPoints, 8 },
  { DxfLayer::CurvePoints, 8 }, { DxfLayer::Notches, 1 }, { DxfLayer::MirrorLine, 190 },
  { DxfLayer::GrainLine, 6 }, { DxfLayer::InternalLines, 94 }, { DxfLayer::CutOuts, 7 },
  { DxfLayer::DrillHoles, 1 }, { DxfLayer::SewLines, 150 }, { DxfLayer::Annotation, 32 } };

// Some programs have dashes of their own by names: the shortest, since they begin anew at each
// point.
const char* const solid = "CONTINUOUS";
const char* const dashed = "DASHEDTINY";
// Millimetres.
constexpr double dashLength = 4.0;
constexpr double gapLength = 2.0;

std::string hexadecimal(unsigned value)
{
  std::array<char, 16> digits{};
  std::snprintf(digits.data(), digits.size(), "%08X", value);
  return digits.data();
}
}

bool isDashed(DxfLayer layer)
{
  return layer == DxfLayer::SewLines;
}

void DxfRecords::add(int code, const std::string& value)
{
  const std::string digits = std::to_string(code);
  this->Text += std::string(3 - digits.size(), ' ') + digits + "\r\n" + value + "\r\n";
}

void DxfRecords::addNumber(int code, double value)
{
  const std::string text = formatNumber(value, 8);
  this->add(code, text.find('.') == std::string::npos ? text + ".0" : text);
}

void DxfRecords::addPoint(const Point2& p, int which)
{
  this->addLength(10 + which, p.x());
  this->addLength(20 + which, p.y());
  this->addNumber(30 + which, 0.0);
}

void DxfRecords::addHandle()
{
  this->add(5, hexadecimal(this->NextHandle));
  ++this->NextHandle;
}

void DxfRecords::beginSection(const char* name)
{
  this->add(0, "SECTION");
  this->add(2, name);
}

void DxfRecords::beginTable(const char* name, int entries)
{
  this->add(0, "TABLE");
  this->add(2, name);
  this->add(70, entries);
}

void DxfRecords::beginEntry(const char* table, const std::string& name)
{
  this->add(0, table);
  this->addHandle();
  this->add(2, name);
}

void DxfRecords::begin(const char* entity, DxfLayer layer)
{
  this->add(0, entity);
  this->addHandle();
  this->add(8, static_cast<int>(layer));
}

void DxfRecords::addLineType(
  const std::string& name, const std::string& words, const std::vector<double>& dashes)
{
  this->beginEntry("LTYPE", name);
  this->add(70, 0);
  this->add(3, words);
  this->add(72, 65);
  this->add(73, static_cast<int>(dashes.size()));
  double length = 0.0;
  for (const double dash : dashes)
  {
    length += std::abs(dash);
  }
  this->addLength(40, length);
  for (const double dash : dashes)
  {
    this->addLength(49, dash);
  }
}

void DxfRecords::addHead(const Point2& low, const Point2& high)
{
  this->beginSection("HEADER");
  this->add(9, "$ACADVER");
  this->add(1, "AC1009");
  // R12 knows neither, and what reads it takes inches where both are missing.
  this->add(9, "$INSUNITS");
  this->add(70, this->Inches ? 1 : 4);
  this->add(9, "$MEASUREMENT");
  this->add(70, this->Inches ? 0 : 1);
  this->add(9, "$EXTMIN");
  this->addPoint(low);
  this->add(9, "$EXTMAX");
  this->addPoint(high);
  this->add(9, "$HANDLING");
  this->add(70, 1);
  this->add(9, "$HANDSEED");
  this->Seed = this->Text.size();
  this->add(5, hexadecimal(0));
  this->add(0, "ENDSEC");

  this->beginSection("TABLES");
  this->beginTable("LTYPE", 2);
  this->addLineType(solid, "Solid line", {});
  this->addLineType(dashed, "Dashed __ __ __ __", { dashLength, -gapLength });
  this->add(0, "ENDTAB");
  this->beginTable("LAYER", static_cast<int>(std::size(layerColours)));
  for (const LayerColour& layer : layerColours)
  {
    this->beginEntry("LAYER", std::to_string(static_cast<int>(layer.layer)));
    this->add(70, 0);
    this->add(62, layer.colour);
    this->add(6, isDashed(layer.layer) ? dashed : solid);
  }
  this->add(0, "ENDTAB");
  this->beginTable("STYLE", 1);
  this->beginEntry("STYLE", "STANDARD");
  this->add(70, 0);
  this->addNumber(40, 0.0);
  this->addNumber(41, 1.0);
  this->addNumber(50, 0.0);
  this->add(71, 0);
  this->addNumber(42, 2.5);
  this->add(3, "txt");
  this->add(4, "");
  this->add(0, "ENDTAB");
  this->add(0, "ENDSEC");
}

std::string DxfRecords::finish()
{
  this->add(0, "EOF");
  const std::string first = "  5\r\n";
  this->Text.replace(this->Seed + first.size(), 8, hexadecimal(this->NextHandle));
  return std::move(this->Text);
}
}
}
