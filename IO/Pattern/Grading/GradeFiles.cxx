// SPDX-License-Identifier: BSD-3-Clause
#include "Grading/GradeFiles.h"

#include "Outlines/PatternText.h"
#include "Outlines/PlaneGeometry.h"

#include <algorithm>
#include <array>
#include <map>

namespace flattening::pattern
{
namespace
{
constexpr double nestMargin = 10.0;
constexpr double gapOfPieces = 20.0; ///< between pieces
constexpr double headHeight = 20.0;  ///< for the names of the sizes
constexpr double nameSpace = 25.0;
constexpr std::array<const char*, 8> colors{ "#000000", "#c00000", "#0060c0", "#008040", "#a000a0",
  "#c07000", "#606060", "#00a0a0" };

/// A number of the nest; a wire of a millimetre still keeps its length to 1e-8.
std::string nestNumber(double value)
{
  return formatNumber(value, 9);
}

/// A size as a rule table can name it, where blanks part the names.
std::string oneWord(const std::string& text)
{
  std::string word = escapeDxf(text);
  std::replace(word.begin(), word.end(), ' ', '_');
  return word;
}

std::string fixed(double value, int digits)
{
  std::string text = formatNumber(value, digits);
  const std::size_t point = text.find('.');
  const std::size_t given = point == std::string::npos ? 0 : text.size() - point - 1;
  return text + (given == 0 ? "." : "") +
    std::string(static_cast<std::size_t>(digits) - given, '0');
}

/// The wires of a size, and its name. \param shifts by piece
std::string nestLayer(const Grading& grading, std::size_t s, const std::map<Index, Point2>& shifts)
{
  const std::string name = escapeXml(grading.sizes[s]);
  const std::string color = colors[s % colors.size()];
  std::string text = "<g inkscape:groupmode=\"layer\" inkscape:label=\"" + name +
    "\" data-size=\"" + name + "\" stroke=\"" + color + "\">\n<text x=\"" +
    nestNumber(nestMargin + nameSpace * static_cast<double>(s)) + "\" y=\"" +
    nestNumber(nestMargin + 5.0) + "\" font-size=\"5\" stroke=\"none\" fill=\"" + color + "\">" +
    name + "</text>\n";
  for (const SourceWire& wire : grading.wires)
  {
    text += "<path data-piece=\"" + std::to_string(wire.piece + 1) + "\" data-curve=\"" +
      escapeXml(wire.name) + "\" d=\"";
    for (std::size_t k = 0; k < wire.points.size(); ++k)
    {
      const Point2& p = grading.positions[s][wire.points[k]];
      const Point2& shift = shifts.at(wire.piece);
      text +=
        (k == 0 ? "M" : " L") + nestNumber(shift.x() + p.x()) + "," + nestNumber(shift.y() - p.y());
    }
    text += "\"/>\n";
  }
  return text + "</g>\n";
}
}

std::string makeNest(const Grading& grading, const std::string& name)
{
  std::map<Index, Box> boxes;
  for (const SourceWire& wire : grading.wires)
  {
    for (const Points2& positions : grading.positions)
    {
      for (const Index point : wire.points)
      {
        boxes[wire.piece].extend(positions[point]);
      }
    }
  }
  std::map<Index, Point2> shifts;
  double x = nestMargin;
  double highest = 0.0;
  for (const auto& [piece, box] : boxes)
  {
    shifts[piece] = Point2(x - box.min().x(), nestMargin + headHeight + box.max().y());
    x += box.sizes().x() + gapOfPieces;
    highest = std::max(highest, box.sizes().y());
  }
  const std::string width = nestNumber(x - gapOfPieces + nestMargin);
  const std::string height = nestNumber(highest + headHeight + 2.0 * nestMargin);
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                     "<svg xmlns=\"http://www.w3.org/2000/svg\" "
                     "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "
                     "version=\"1.1\" width=\"" +
    width + "mm\" height=\"" + height + "mm\" viewBox=\"0 0 " + width + " " + height +
    "\" font-family=\"sans-serif\" fill=\"none\" stroke-width=\"0.25\">\n<title>" +
    escapeXml(name) + "</title>\n";
  for (std::size_t s = 0; s < grading.sizes.size(); ++s)
  {
    text += nestLayer(grading, s, shifts);
  }
  return text + "</svg>\n";
}

std::string makeRuleList(const Grading& grading)
{
  std::string list = "piece,point,name";
  for (const std::string& size : grading.sizes)
  {
    list += "," + csvField("dx " + cleanText(size) + " mm");
    list += "," + csvField("dy " + cleanText(size) + " mm");
  }
  list += "\n";
  for (const GradeRule& rule : grading.rules)
  {
    list += std::to_string(rule.piece + 1) + "," + std::to_string(rule.point) + "," +
      csvField(cleanText(rule.name));
    for (const Point2& delta : rule.deltas)
    {
      list += "," + fixed(delta.x(), 4) + "," + fixed(delta.y(), 4);
    }
    list += "\n";
  }
  return list;
}

std::string makeRuleTable(const Grading& grading, const std::string& name, Unit unit,
  const std::string& date, const std::string& time)
{
  const bool inches = unit == Unit::Inch;
  std::string sizes;
  for (const std::string& size : grading.sizes)
  {
    sizes += " " + oneWord(size);
  }
  std::string table = "ASTM/D13Proposal 1 Version: D 6673-04\nAUTHOR: SurfaceFlattening\n";
  if (!date.empty())
  {
    table += "CREATION DATE: " + date + "\nCREATION TIME: " + time + "\n";
  }
  table += std::string("UNITS: ") + (inches ? "ENGLISH" : "METRIC") +
    "\nGRADE RULE TABLE: " + escapeDxf(name) +
    "\nNUMBER OF SIZES: " + std::to_string(grading.sizes.size()) + "\nSIZE LIST:" + sizes +
    "\nSAMPLE SIZE: " + oneWord(grading.sizes[grading.base]) + "\n";
  for (std::size_t k = 0; k < grading.rules.size(); ++k)
  {
    const GradeRule& rule = grading.rules[k];
    const Point2& grain = grading.grains[static_cast<std::size_t>(rule.piece)];
    table += "RULE: DELTA " + std::to_string(k + 1) + "\n";
    for (const Point2& delta : rule.deltas)
    {
      const Point2 drawn = (inches ? 1.0 / 25.4 : 1.0) *
        (delta.x() * Point2(grain.y(), -grain.x()) + delta.y() * grain);
      table += "  " + fixed(drawn.x(), 6) + ", " + fixed(drawn.y(), 6) + "\n";
    }
  }
  return table + "END\n";
}
}
