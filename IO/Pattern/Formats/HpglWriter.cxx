// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/PatternWriters.h"

#include "Drawing/PatternStrokes.h"
#include "Formats/SheetLayout.h"
#include "Outlines/PatternText.h"

#include <cmath>

namespace flattening::pattern
{
namespace
{
constexpr double unitsPerMillimetre = 40.0;
constexpr char endOfLabel = '\003';
/// Of a character beside its height: HPGL's own face keeps half as much again between characters.
constexpr double widthOfCharacter = 0.4;

/// A pattern on its sheet, in plotter commands.
struct HpglSheet
{
  const Pattern& drawn;
  SheetLayout layout;

  std::string at(std::size_t piece, const Point2& p) const
  {
    const Point2 onSheet = this->layout.place(this->drawn, piece, p);
    const auto units = [](double millimetres) {
      return std::to_string(std::lround(unitsPerMillimetre * millimetres));
    };
    return units(onSheet.x()) + "," + units(this->layout.extent.y() - onSheet.y());
  }

  std::string strokes(std::size_t piece, bool cutLines) const
  {
    std::string text;
    const std::vector<Stroke> all = strokesOf(this->drawn.pieces[piece]);
    // Holes fall out of the cloth before the piece does.
    for (auto stroke = all.rbegin(); stroke != all.rend(); ++stroke)
    {
      if (isCut(stroke->role) != cutLines)
      {
        continue;
      }
      text += "PU" + this->at(piece, stroke->points.front()) + ";PD";
      for (std::size_t k = 1; k < stroke->points.size(); ++k)
      {
        text += (k > 1 ? "," : "") + this->at(piece, stroke->points[k]);
      }
      text += stroke->closed ? "," + this->at(piece, stroke->points.front()) + ";\n" : ";\n";
    }
    return text;
  }

  std::string label(std::size_t piece, const PatternText& text) const
  {
    std::string plain;
    for (const char c : cleanText(text.text))
    {
      const auto byte = static_cast<unsigned char>(c);
      if (byte < 0x80U)
      {
        plain += c;
      }
      else if ((byte & 0xC0U) == 0xC0U) // the first byte of a character
      {
        plain += '?';
      }
    }
    const double width = 1.5 * widthOfCharacter * text.height * static_cast<double>(plain.size());
    const Point2 along(std::cos(text.angle), std::sin(text.angle));
    const Point2 up(-along.y(), along.x());
    return "PU" + this->at(piece, text.position - 0.5 * width * along - 0.35 * text.height * up) +
      ";DI" + formatNumber(along.x(), 4) + "," + formatNumber(along.y(), 4) + ";SI" +
      formatNumber(0.1 * widthOfCharacter * text.height, 4) + "," +
      formatNumber(0.07 * text.height, 4) + ";LB" + plain + endOfLabel + ";\n";
  }
};
}

std::string makeHpgl(const Pattern& pattern)
{
  const HpglSheet sheet{ pattern, layOut(pattern, squareWidth(pattern), 0.0) };
  std::string drawn = "IN;SP1;\n";
  std::string cut = "SP2;\n";
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p)
  {
    drawn += sheet.strokes(p, false);
    for (const PatternText& text : pattern.pieces[p].texts)
    {
      drawn += sheet.label(p, text);
    }
    cut += sheet.strokes(p, true);
  }
  return drawn + cut + "PU0,0;SP0;\n";
}
}
