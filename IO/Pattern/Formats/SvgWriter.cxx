// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/PatternWriters.h"

#include "Drawing/PatternStrokes.h"
#include "Formats/ArcPolyline.h"
#include "Formats/SheetLayout.h"
#include "Outlines/PatternText.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace flattening::pattern
{
namespace
{
constexpr double margin = 10.0;
constexpr double legendHeight = 50.0;
constexpr double legendWidth = 200.0;
constexpr double laserWidth = 0.1;
constexpr int digits = 9; // a wire of a millimetre still keeps its length to 1e-8

std::string number(double value)
{
  return formatNumber(value, digits);
}

std::string attribute(const std::string& name, const std::string& value)
{
  return " " + name + "=\"" + escapeXml(value) + "\"";
}

/// What makes a group a layer to Inkscape; other readers pass over it.
std::string layerAttributes(const std::string& label)
{
  return attribute("inkscape:groupmode", "layer") + attribute("inkscape:label", label);
}

std::string hexOf(const Color& color)
{
  std::string hex = "#";
  for (const double part : color)
  {
    char buffer[8];
    std::snprintf(buffer, sizeof buffer, "%02x", static_cast<unsigned>(std::lround(255.0 * part)));
    hex += buffer;
  }
  return hex;
}

std::string styleAttributes(const StrokeStyle& style)
{
  std::string dashes;
  for (const double dash : style.dashes)
  {
    if (dash > 0.0)
    {
      dashes += (dashes.empty() ? "" : " ") + formatNumber(dash, 3);
    }
  }
  return attribute("fill", "none") + attribute("stroke", hexOf(style.color)) +
    attribute("stroke-width", formatNumber(style.width, 3)) +
    (dashes.empty() ? "" : attribute("stroke-dasharray", dashes));
}

/// \param at middle of the text's height
std::string textElement(
  const std::string& words, double height, const Point2& at, const char* anchor, double angle = 0.0)
{
  const Point2 down = 0.35 * height * Point2(std::sin(angle), std::cos(angle));
  const Point2 base = at + down;
  std::string element = "<text" + attribute("x", formatNumber(base.x(), 3)) +
    attribute("y", formatNumber(base.y(), 3)) + attribute("font-size", formatNumber(height, 3)) +
    attribute("text-anchor", anchor);
  if (angle != 0.0)
  {
    element += attribute("transform",
      "rotate(" + formatNumber(-angle * 180.0 / pi, 3) + " " + formatNumber(base.x(), 3) + " " +
        formatNumber(base.y(), 3) + ")");
  }
  return element + ">" + escapeXml(words) + "</text>\n";
}

struct SvgDrawing
{
  std::string make()
  {
    const Point2 sheet =
      this->Layout.extent.cwiseMax(Point2(legendWidth, 0.0)) + Point2::Constant(2.0 * margin);
    this->Text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                 "<svg xmlns=\"http://www.w3.org/2000/svg\" "
                 "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\" "
                 "font-family=\"sans-serif\"" +
      attribute("width", number(sheet.x()) + "mm") + attribute("height", number(sheet.y()) + "mm") +
      attribute("viewBox", "0 0 " + number(sheet.x()) + " " + number(sheet.y())) + ">\n<title>" +
      escapeXml(this->Drawn.name) +
      "</title>\n<desc>Pattern to cut at scale 1:1. The user unit is the millimetre; the surface "
      "was "
      "in " +
      unitName(this->Drawn.unit) + ".</desc>\n";
    this->addLegend();
    if (this->Drawn.fabric)
    {
      this->addFabric();
    }
    for (std::size_t p = 0; p < this->Drawn.pieces.size(); ++p)
    {
      this->addPiece(p);
    }
    this->Text += "</svg>\n";
    return std::move(this->Text);
  }

  Point2 at(std::size_t piece, const Point2& p) const
  {
    return Point2::Constant(margin) + this->Layout.place(this->Drawn, piece, p);
  }

  void addLegend()
  {
    this->Text += "<g id=\"scale-check\"" + layerAttributes("scale check") +
      "><rect x=\"10\" y=\"10\" width=\"100\" height=\"50\" "
      "fill=\"none\" stroke=\"#000000\" stroke-width=\"0.25\"/>\n";
    this->Text += textElement("100 mm x 50 mm", 4.0, { 60.0, 30.0 }, "middle") +
      textElement("Print at 100 % and measure this rectangle.", 4.0, { 60.0, 38.0 }, "middle") +
      textElement(
        fitText(this->Drawn.name, 7.0, legendWidth - 106.0), 7.0, { 116.0, 15.0 }, "start") +
      textElement(std::string("scale 1:1; unit of the surface: ") + unitName(this->Drawn.unit), 4.0,
        { 116.0, 24.0 }, "start") +
      "</g>\n";
  }

  void addFabric()
  {
    const Fabric& fabric = *this->Drawn.fabric;
    const double top = margin + this->Layout.extent.y() - fabric.length;
    const std::string words = "cloth " + formatNumber(fabric.width, 1) + " mm x " +
      formatNumber(fabric.length, 0) + " mm, " + formatNumber(100.0 * fabric.efficiency, 1) +
      " % used";
    this->Text += "<g id=\"fabric\"" + layerAttributes("fabric") + "><rect" +
      attribute("x", number(margin)) + attribute("y", number(top)) +
      attribute("width", number(fabric.width)) + attribute("height", number(fabric.length)) +
      " fill=\"none\" stroke=\"#808080\" stroke-width=\"0.25\"/>\n" +
      textElement(words, 4.0, { 116.0, 33.0 }, "start") + "</g>\n";
  }

  void addPiece(std::size_t p)
  {
    const PatternPiece& piece = this->Drawn.pieces[p];
    const std::string copy = this->Drawn.fabric ? "-" + std::to_string(p + 1) : std::string();
    this->Text += "<g id=\"piece-" + std::to_string(piece.number) + copy + "\"" +
      layerAttributes(piece.name) + attribute("data-name", piece.name) +
      attribute("data-size", piece.size) +
      attribute("data-quantity", std::to_string(piece.quantity)) + ">\n";
    const std::vector<Stroke> strokes = strokesOf(piece);
    for (std::size_t k = 0; k < strokes.size(); ++k)
    {
      if (k == 0 || strokes[k].role != strokes[k - 1].role)
      {
        this->Text += k == 0 ? "" : "</g>\n";
        this->openRole(strokes[k].role);
      }
      this->addStroke(p, strokes[k]);
    }
    this->Text += strokes.empty() ? "" : "</g>\n";
    this->Text += "<g class=\"text\"" + layerAttributes("text") + ">\n";
    for (const PatternText& text : piece.texts)
    {
      this->Text +=
        textElement(text.text, text.height, this->at(p, text.position), "middle", text.angle);
    }
    this->Text += "</g>\n</g>\n";
  }

  void openRole(LineKind role)
  {
    StrokeStyle style = styleOf(role);
    std::string label = style.name;
    std::replace(label.begin(), label.end(), '-', ' ');
    if (this->LaserColors)
    {
      style.color = laserColor(role);
      style.width = laserWidth;
      style.dashes = {};
    }
    this->Text += "<g" + attribute("class", style.name) + layerAttributes(label) +
      styleAttributes(style) + ">\n";
  }

  void addStroke(std::size_t p, const Stroke& stroke)
  {
    this->Text += "<path";
    if (!stroke.curve.empty())
    {
      this->Text += attribute("data-curve", stroke.curve);
    }
    if (isWire(stroke.role))
    {
      this->Text += attribute("data-length", number(stroke.measure));
    }
    if (stroke.filled && !this->LaserColors) // a laser would engrave the area
    {
      this->Text += attribute("fill", hexOf(styleOf(stroke.role).color));
    }
    if (stroke.role == LineKind::Notch || stroke.role == LineKind::DartMark)
    {
      this->Text += attribute("data-arc-length", number(stroke.measure));
    }
    this->Text += " d=\"";
    if (this->LaserColors && stroke.points.size() > 2)
    {
      this->addArcs(p, stroke);
    }
    else if (!stroke.smooth.empty())
    {
      this->addSmooth(p, stroke);
    }
    else
    {
      for (std::size_t k = 0; k < stroke.points.size(); ++k)
      {
        this->addPoint(k == 0 ? "M" : " L", p, stroke.points[k]);
      }
    }
    this->Text += stroke.closed ? " Z\"/>\n" : "\"/>\n";
  }

  /// \param command of a path, with all but its last point
  void addPoint(const std::string& command, std::size_t p, const Point2& point)
  {
    const Point2 q = this->at(p, point);
    this->Text += command + number(q.x()) + "," + number(q.y());
  }

  /// Few long arcs, at which a laser does not slow down as at points.
  void addArcs(std::size_t p, const Stroke& stroke)
  {
    const std::vector<ArcVertex> vertices = arcPolyline(stroke.points, stroke.closed, arcTolerance);
    const auto add = [&](const ArcVertex& from, const Point2& to) {
      const double chord = (to - from.at).norm();
      const double bulge = std::abs(from.bulge);
      const std::string radius = number(chord * (1.0 + bulge * bulge) / (4.0 * bulge));
      // Counter-clockwise in the pattern, whose y points up.
      this->addPoint(bulge == 0.0
          ? " L"
          : " A" + radius + "," + radius + (from.bulge > 0.0 ? " 0 0 0 " : " 0 0 1 "),
        p, to);
    };
    this->addPoint("M", p, vertices.front().at);
    for (std::size_t k = 0; k + 1 < vertices.size(); ++k)
    {
      add(vertices[k], vertices[k + 1].at);
    }
    if (stroke.closed)
    {
      add(vertices.back(), vertices.front().at);
    }
  }

  void addSmooth(std::size_t p, const Stroke& stroke)
  {
    this->addPoint("M", p, stroke.smooth.front().control[0]);
    for (const FairSpan& span : stroke.smooth)
    {
      const bool straight = span.straight();
      for (std::size_t c = straight ? 3 : 1; c < 4; ++c)
      {
        this->addPoint(straight ? " L" : c == 1 ? " C" : " ", p, span.control[c]);
      }
    }
  }

  const Pattern& Drawn;
  const bool LaserColors;
  SheetLayout Layout = layOut(Drawn, squareWidth(Drawn), legendHeight + margin);
  std::string Text{};
};
}

std::string makeSvg(const Pattern& pattern, bool laserColors)
{
  return SvgDrawing{ pattern, laserColors }.make();
}
}
