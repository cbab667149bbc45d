// SPDX-License-Identifier: BSD-3-Clause
#include "SvgWriter.h"

#include "PatternStrokes.h"
#include "PatternText.h"
#include "SheetLayout.h"

#include <cmath>
#include <cstdio>

namespace flattening
{
namespace pattern
{
namespace
{
constexpr double margin = 10.0;
constexpr double legendHeight = 50.0;
constexpr double legendWidth = 200.0;
constexpr int digits = 9; // a wire of a millimetre still keeps its length to 1e-8

std::string number(double value)
{
  return formatNumber(value, digits);
}

std::string attribute(const std::string& name, const std::string& value)
{
  return " " + name + "=\"" + escapeXml(value) + "\"";
}

std::string styleAttributes(const StrokeStyle& style)
{
  std::string colour;
  for (const double part : style.colour)
  {
    char buffer[8];
    std::snprintf(buffer, sizeof buffer, "%02x", static_cast<unsigned>(std::lround(255.0 * part)));
    colour += buffer;
  }
  std::string dashes;
  for (const double dash : style.dashes)
  {
    if (dash > 0.0)
    {
      dashes += (dashes.empty() ? "" : " ") + formatNumber(dash, 3);
    }
  }
  return attribute("fill", "none") + attribute("stroke", "#" + colour) +
    attribute("stroke-width", formatNumber(style.width, 3)) +
    (dashes.empty() ? "" : attribute("stroke-dasharray", dashes));
}

std::string textElement(const PatternText& text, const Point2& at, const char* anchor)
{
  const Point2 down = 0.35 * text.height * Point2(std::sin(text.angle), std::cos(text.angle));
  const Point2 base = at + down;
  std::string element = "<text" + attribute("x", formatNumber(base.x(), 3)) +
    attribute("y", formatNumber(base.y(), 3)) +
    attribute("font-size", formatNumber(text.height, 3)) + attribute("text-anchor", anchor);
  if (text.angle != 0.0)
  {
    element += attribute("transform",
      "rotate(" + formatNumber(-text.angle * 180.0 / pi, 3) + " " + formatNumber(base.x(), 3) +
        " " + formatNumber(base.y(), 3) + ")");
  }
  return element + ">" + escapeXml(text.text) + "</text>\n";
}

class SvgDrawing
{
public:
  explicit SvgDrawing(const Pattern& pattern)
    : Drawn(pattern)
    , Layout(layOut(pattern, squareWidth(pattern), legendHeight + margin))
  {
  }

  std::string make()
  {
    const Point2 sheet =
      this->Layout.extent.cwiseMax(Point2(legendWidth, 0.0)) + Point2::Constant(2.0 * margin);
    this->Text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                 "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\"" +
      attribute("width", number(sheet.x()) + "mm") + attribute("height", number(sheet.y()) + "mm") +
      attribute("viewBox", "0 0 " + number(sheet.x()) + " " + number(sheet.y())) + ">\n<title>" +
      escapeXml(this->Drawn.name) +
      "</title>\n<desc>Pattern to cut at scale 1:1. The user unit is the millimetre; the surface "
      "was "
      "in " +
      unitName(this->Drawn.unit) + ".</desc>\n<g font-family=\"sans-serif\">\n";
    this->addLegend();
    for (std::size_t p = 0; p < this->Drawn.pieces.size(); ++p)
    {
      this->addPiece(p);
    }
    this->Text += "</g>\n</svg>\n";
    return std::move(this->Text);
  }

private:
  Point2 at(std::size_t piece, const Point2& p) const
  {
    return Point2::Constant(margin) + this->Layout.place(this->Drawn, piece, p);
  }

  void addLegend()
  {
    this->Text += "<g id=\"scale-check\"><rect x=\"10\" y=\"10\" width=\"100\" height=\"50\" "
                  "fill=\"none\" stroke=\"#000000\" stroke-width=\"0.25\"/>\n";
    const std::vector<std::string> lines{ "100 mm x 50 mm",
      "Print at 100 % and measure this rectangle." };
    for (std::size_t k = 0; k < lines.size(); ++k)
    {
      PatternText text;
      text.text = lines[k];
      text.height = 4.0;
      this->Text += textElement(text, Point2(60.0, 30.0 + 8.0 * static_cast<double>(k)), "middle");
    }
    PatternText title;
    title.height = 7.0;
    title.text = fitText(this->Drawn.name, title.height, legendWidth - 106.0);
    this->Text += textElement(title, Point2(116.0, 15.0), "start");
    PatternText unit;
    unit.height = 4.0;
    unit.text = std::string("scale 1:1; unit of the surface: ") + unitName(this->Drawn.unit);
    this->Text += textElement(unit, Point2(116.0, 24.0), "start") + "</g>\n";
  }

  void addPiece(std::size_t p)
  {
    const PatternPiece& piece = this->Drawn.pieces[p];
    this->Text += "<g id=\"piece-" + std::to_string(piece.number) + "\"" +
      attribute("data-name", piece.name) + attribute("data-size", piece.size) +
      attribute("data-quantity", std::to_string(piece.quantity)) + ">\n";
    std::string open; // name of the open group
    for (const Stroke& stroke : strokesOf(piece))
    {
      if (open != stroke.style.name)
      {
        this->Text += open.empty() ? "" : "</g>\n";
        open = stroke.style.name;
        this->Text += "<g" + attribute("class", open) + styleAttributes(stroke.style) + ">\n";
      }
      this->addStroke(p, stroke);
    }
    this->Text += open.empty() ? "" : "</g>\n";
    this->Text += "<g class=\"text\">\n";
    for (const PatternText& text : piece.texts)
    {
      this->Text += textElement(text, this->at(p, text.position), "middle");
    }
    this->Text += "</g>\n</g>\n";
  }

  void addStroke(std::size_t p, const Stroke& stroke)
  {
    this->Text += "<path";
    if (!stroke.curve.empty())
    {
      this->Text += attribute("data-curve", stroke.curve);
    }
    if (stroke.isWire)
    {
      this->Text += attribute("data-length", number(stroke.measure));
    }
    if (stroke.isNotch)
    {
      this->Text += attribute("data-arc-length", number(stroke.measure));
    }
    this->Text += " d=\"";
    for (std::size_t k = 0; k < stroke.points.size(); ++k)
    {
      const Point2 q = this->at(p, stroke.points[k]);
      this->Text += (k == 0 ? "M" : " L") + number(q.x()) + "," + number(q.y());
    }
    this->Text += stroke.closed ? " Z\"/>\n" : "\"/>\n";
  }

  const Pattern& Drawn;
  SheetLayout Layout;
  std::string Text;
};
}

std::string makeSvg(const Pattern& pattern)
{
  return SvgDrawing(pattern).make();
}
}
}
