// SPDX-License-Identifier: BSD-3-Clause
#include "DxfWriter.h"

#include "PatternText.h"
#include "SheetLayout.h"

#include <cmath>

namespace flattening
{
namespace pattern
{
namespace
{
enum Layer
{
  Boundary = 1,
  TurnPoints = 2,
  CurvePoints = 3,
  Notches = 4,
  GrainLine = 7,
  InternalLines = 8,
  CutOuts = 11,
  DrillHoles = 13,
  SewLines = 14,
  Annotation = 15,
};

struct LayerColour
{
  Layer layer;
  int colour; ///< AutoCAD's colour index
};
constexpr LayerColour layerColours[] = { { Boundary, 7 }, { TurnPoints, 8 }, { CurvePoints, 8 },
  { Notches, 1 }, { GrainLine, 6 }, { InternalLines, 3 }, { CutOuts, 7 }, { DrillHoles, 1 },
  { SewLines, 5 }, { Annotation, 2 } };

/// A corner turns by more than this, in radians; a lesser turn belongs to a curve.
constexpr double turnAngle = 0.3;
constexpr std::size_t longestText = 250;

Layer layerOf(LineKind kind)
{
  switch (kind)
  {
    case LineKind::CutLine:
      return Boundary;
    case LineKind::CutOut:
      return CutOuts;
    case LineKind::SewLine:
    case LineKind::DartLeg:
      return SewLines;
    default:
      return InternalLines;
  }
}

class DxfDrawing
{
public:
  explicit DxfDrawing(const Pattern& pattern)
    : Drawn(pattern)
    , PerMillimetre(pattern.unit == Unit::Inch ? 1.0 / 25.4 : 1.0)
    , Layout(layOut(pattern, squareWidth(pattern), 0.0))
  {
  }

  std::string make()
  {
    this->addHeader();
    this->addTables();
    this->add(0, "SECTION");
    this->add(2, "BLOCKS");
    for (const PatternPiece& piece : this->Drawn.pieces)
    {
      this->addBlock(piece);
    }
    this->add(0, "ENDSEC");
    this->add(0, "SECTION");
    this->add(2, "ENTITIES");
    this->addStyleTexts();
    for (std::size_t p = 0; p < this->Drawn.pieces.size(); ++p)
    {
      const PatternPiece& piece = this->Drawn.pieces[p];
      this->add(0, "INSERT");
      this->addLayer(Boundary);
      this->add(2, blockName(piece));
      // Rows from the top of the drawing, y up.
      this->addPoint(
        { this->Layout.corners[p].x(), -this->Layout.corners[p].y() - piece.extent.y() });
    }
    this->add(0, "ENDSEC");
    this->add(0, "EOF");
    return std::move(this->Text);
  }

private:
  void add(int code, const std::string& value)
  {
    const std::string digits = std::to_string(code);
    this->Text += std::string(3 - digits.size(), ' ') + digits + "\r\n" + value + "\r\n";
  }
  void add(int code, int value) { this->add(code, std::to_string(value)); }
  void addNumber(int code, double value)
  {
    std::string text = formatNumber(value, 8);
    this->add(code, text.find('.') == std::string::npos ? text + ".0" : text);
  }
  /// \param which 0 for the first point of an entity, 1 for the second
  void addPoint(const Point2& p, int which = 0)
  {
    this->addNumber(10 + which, this->PerMillimetre * p.x());
    this->addNumber(20 + which, this->PerMillimetre * p.y());
    this->addNumber(30 + which, 0.0);
  }
  void addLayer(Layer layer) { this->add(8, static_cast<int>(layer)); }

  static std::string blockName(const PatternPiece& piece)
  {
    // 31 characters are R12's limit; the number makes the name unique.
    return dxfSymbol("P" + std::to_string(piece.number) + "_" + piece.name, 31);
  }

  void addHeader()
  {
    this->add(0, "SECTION");
    this->add(2, "HEADER");
    this->add(9, "$ACADVER");
    this->add(1, "AC1009");
    this->add(9, "$EXTMIN");
    this->addPoint({ 0.0, -this->Layout.extent.y() });
    this->add(9, "$EXTMAX");
    this->addPoint({ this->Layout.extent.x(), 0.0 });
    this->add(0, "ENDSEC");
  }

  void addTables()
  {
    this->add(0, "SECTION");
    this->add(2, "TABLES");
    this->add(0, "TABLE");
    this->add(2, "LTYPE");
    this->add(70, 1);
    this->add(0, "LTYPE");
    this->add(2, "CONTINUOUS");
    this->add(70, 0);
    this->add(3, "Solid line");
    this->add(72, 65);
    this->add(73, 0);
    this->addNumber(40, 0.0);
    this->add(0, "ENDTAB");
    this->add(0, "TABLE");
    this->add(2, "LAYER");
    this->add(70, static_cast<int>(std::size(layerColours)));
    for (const LayerColour& layer : layerColours)
    {
      this->add(0, "LAYER");
      this->add(2, static_cast<int>(layer.layer));
      this->add(70, 0);
      this->add(62, layer.colour);
      this->add(6, "CONTINUOUS");
    }
    this->add(0, "ENDTAB");
    this->add(0, "TABLE");
    this->add(2, "STYLE");
    this->add(70, 1);
    this->add(0, "STYLE");
    this->add(2, "STANDARD");
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

  void addText(Layer layer, const Point2& at, double height, double angle, const std::string& text)
  {
    // Cutting an escape in two would leave a broken one.
    std::string escaped = escapeDxf(text);
    if (escaped.size() > longestText)
    {
      escaped = escaped.substr(0, longestText);
      const std::size_t escape = escaped.rfind("\\U+");
      if (escape != std::string::npos && escape + 7 > escaped.size())
      {
        escaped.erase(escape);
      }
    }
    this->add(0, "TEXT");
    this->addLayer(layer);
    this->addPoint(at);
    this->addNumber(40, this->PerMillimetre * height);
    this->add(1, escaped);
    if (angle != 0.0)
    {
      this->addNumber(50, angle * 180.0 / pi);
    }
  }

  void addMark(Layer layer, const Point2& at)
  {
    this->add(0, "POINT");
    this->addLayer(layer);
    this->addPoint(at);
  }

  void addLine(Layer layer, const Point2& from, const Point2& to)
  {
    this->add(0, "LINE");
    this->addLayer(layer);
    this->addPoint(from);
    this->addPoint(to, 1);
  }

  void addPolyline(const PatternLine& line)
  {
    const Layer layer = layerOf(line.kind);
    this->add(0, "POLYLINE");
    this->addLayer(layer);
    this->add(66, 1);
    this->addPoint(Point2::Zero());
    this->add(70, line.closed ? 1 : 0);
    for (const Point2& p : line.points)
    {
      this->add(0, "VERTEX");
      this->addLayer(layer);
      this->addPoint(p);
    }
    this->add(0, "SEQEND");
    this->addLayer(layer);
    this->addPointMarks(line);
  }

  /// Turn points and curve points, the two kinds of vertices that pattern systems tell apart.
  void addPointMarks(const PatternLine& line)
  {
    const std::size_t count = line.points.size();
    for (std::size_t k = 0; k < count; ++k)
    {
      bool turn = !line.closed && (k == 0 || k + 1 == count);
      if (!turn)
      {
        const Point2 before = line.points[k] - line.points[(k + count - 1) % count];
        const Point2 after = line.points[(k + 1) % count] - line.points[k];
        const double sine = before.x() * after.y() - before.y() * after.x();
        turn = std::abs(std::atan2(sine, before.dot(after))) > turnAngle;
      }
      this->addMark(turn ? TurnPoints : CurvePoints, line.points[k]);
    }
  }

  void addBlock(const PatternPiece& piece)
  {
    this->add(0, "BLOCK");
    this->addLayer(Boundary);
    this->add(2, blockName(piece));
    this->add(70, 0);
    this->addPoint(Point2::Zero());
    this->add(3, blockName(piece));
    for (const PatternLine& line : piece.lines)
    {
      if (line.kind == LineKind::DartFold)
      {
        this->addLine(InternalLines, line.points.front(), line.points.back());
      }
      else
      {
        this->addPolyline(line);
      }
    }
    for (const Notch& notch : piece.notches)
    {
      if (notch.onCutLine)
      {
        this->addMark(Notches, notch.from);
        const Point2 way = notch.to - notch.from;
        this->addNumber(50, std::atan2(way.y(), way.x()) * 180.0 / pi);
      }
      else
      {
        this->addLine(InternalLines, notch.from, notch.to);
      }
    }
    for (const Point2& hole : piece.drillHoles)
    {
      this->addMark(DrillHoles, hole);
    }
    this->addLine(GrainLine, piece.grain.from, piece.grain.to);
    this->addPieceTexts(piece);
    this->add(0, "ENDBLK");
    this->addLayer(Boundary);
  }

  void addPieceTexts(const PatternPiece& piece)
  {
    std::vector<std::string> system{ "Piece Name: " + piece.name };
    if (!piece.size.empty())
    {
      system.push_back("Size: " + piece.size);
    }
    system.push_back("Quantity: " + std::to_string(piece.quantity));
    std::size_t next = 0;
    for (const PatternText& text : piece.texts)
    {
      // The system texts stand where the drawing has name, size and quantity; the rest is
      // annotation.
      const bool isSystem = text.role != TextRole::Curve && next < system.size();
      const std::string& content = isSystem ? system[next++] : text.text;
      const double height = text.role == TextRole::Title ? 0.7 * text.height : text.height;
      const double half = textWidth(content, height) / 2.0;
      const Point2 along(std::cos(text.angle), std::sin(text.angle));
      const Point2 up(-along.y(), along.x());
      this->addText(isSystem ? Boundary : Annotation,
        text.position - half * along - 0.5 * height * up, height, text.angle, content);
    }
  }

  void addStyleTexts()
  {
    std::vector<std::string> texts{ "Style Name: " + this->Drawn.name };
    if (!this->Drawn.date.empty())
    {
      texts.push_back("Creation Date: " + this->Drawn.date);
      texts.push_back("Creation Time: " + this->Drawn.time);
    }
    texts.emplace_back("Author: SurfaceFlattening");
    const std::string& size = this->Drawn.pieces.front().size;
    if (!size.empty())
    {
      texts.push_back("Sample Size: " + size);
    }
    texts.push_back(
      std::string("Units: ") + (this->Drawn.unit == Unit::Inch ? "ENGLISH" : "METRIC"));
    double y = 10.0 * static_cast<double>(texts.size());
    for (const std::string& text : texts)
    {
      this->addText(Boundary, { 0.0, y }, 5.0, 0.0, text);
      y -= 10.0;
    }
  }

  const Pattern& Drawn;
  double PerMillimetre;
  SheetLayout Layout;
  std::string Text;
};
}

std::string makeDxf(const Pattern& pattern)
{
  return DxfDrawing(pattern).make();
}
}
}
