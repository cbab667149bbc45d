// SPDX-License-Identifier: BSD-3-Clause
#include "Formats/PatternWriters.h"

#include "Formats/ArcPolyline.h"
#include "Formats/SheetLayout.h"
#include "Outlines/Grainlines.h"
#include "Outlines/PatternText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace flattening::pattern
{
namespace
{
struct DxfLayer
{
  const char* name;
  int color; ///< AutoCAD's color index
  bool dashed = false;
};

namespace dxf
{
// The layers of ASTM D6673 that patterns are drawn on, in colors that can be read on black and on
// white alike.
constexpr DxfLayer boundary{ "1", 7 };
constexpr DxfLayer turnPoints{ "2", 8 };
constexpr DxfLayer curvePoints{ "3", 8 };
constexpr DxfLayer notches{ "4", 1 };
constexpr DxfLayer mirrorLine{ "6", 190 };
constexpr DxfLayer grainLine{ "7", 6 };
constexpr DxfLayer internalLines{ "8", 94 };
constexpr DxfLayer cutOuts{ "11", 7 };
constexpr DxfLayer drillHoles{ "13", 1 };
constexpr DxfLayer sewLines{ "14", 150, true };
constexpr DxfLayer annotation{ "15", 32 };
// Of drawings for cutting machines.
constexpr DxfLayer cut{ "CUT", 7 };
constexpr DxfLayer mark{ "MARK", 150 };
constexpr DxfLayer text{ "TEXT", 94 };
}

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

constexpr std::size_t longestText = 250;

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

  void add(int code, const std::string& value)
  {
    const std::string digits = std::to_string(code);
    this->Text += std::string(3 - digits.size(), ' ') + digits + "\r\n" + value + "\r\n";
  }
  void add(int code, int value) { this->add(code, std::to_string(value)); }
  void add(const std::vector<std::pair<int, std::string>>& pairs)
  {
    for (const auto& [code, value] : pairs)
    {
      this->add(code, value);
    }
  }
  /// A number as it is.
  void addNumber(int code, double value)
  {
    const std::string text = formatNumber(value, 8);
    this->add(code, text.find('.') == std::string::npos ? text + ".0" : text);
  }
  void addLength(int code, double millimetres)
  {
    this->addNumber(code, this->PerMillimetre * millimetres);
  }
  /// \param which of the points of an entity, from 0
  void addPoint(const Point2& p, int which = 0)
  {
    this->addLength(10 + which, p.x());
    this->addLength(20 + which, p.y());
    this->addNumber(30 + which, 0.0);
  }
  void beginSection(const char* name) { this->add({ { 0, "SECTION" }, { 2, name } }); }
  void beginTable(const char* name, int entries)
  {
    this->add({ { 0, "TABLE" }, { 2, name }, { 70, std::to_string(entries) } });
  }
  /// An entry of a table, with its handle and its name.
  void beginEntry(const char* table, const std::string& name)
  {
    this->add(0, table);
    this->addHandle();
    this->add(2, name);
  }
  void begin(const char* entity, const DxfLayer& layer)
  {
    this->add(0, entity);
    this->addHandle();
    this->add(8, layer.name);
  }
  /// \param flags of group 70
  void beginPolyline(const DxfLayer& layer, int flags)
  {
    this->begin("POLYLINE", layer);
    this->add(66, 1);
    this->addPoint(Point2::Zero());
    this->add(70, flags);
  }
  void addLine(const DxfLayer& layer, const Point2& from, const Point2& to)
  {
    this->begin("LINE", layer);
    this->addPoint(from);
    this->addPoint(to, 1);
  }
  void addCircle(const DxfLayer& layer, const Point2& center, double radius)
  {
    this->begin("CIRCLE", layer);
    this->addPoint(center);
    this->addLength(40, radius);
  }
  /// \param at where the text begins on its base line
  void addText(
    const DxfLayer& layer, const Point2& at, double height, double angle, const std::string& text)
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
    this->begin("TEXT", layer);
    this->addPoint(at);
    this->addLength(40, height);
    this->add(1, escaped);
    if (angle != 0.0)
    {
      this->addNumber(50, angle * 180.0 / pi);
    }
  }
  /// A text around a point.
  void addTextAround(const DxfLayer& layer, const Point2& center, double height, double angle,
    const std::string& text)
  {
    const Point2 along(std::cos(angle), std::sin(angle));
    const Point2 up(-along.y(), along.x());
    this->addText(layer, center - textWidth(text, height) / 2.0 * along - 0.5 * height * up, height,
      angle, text);
  }
  /// Header and tables of a drawing with these corners.
  void addHead(const Point2& low, const Point2& high, const std::vector<DxfLayer>& layers)
  {
    // R12 knows no units, and what reads it takes inches where both of them are missing.
    this->add({ { 0, "SECTION" }, { 2, "HEADER" }, { 9, "$ACADVER" }, { 1, "AC1009" },
      { 9, "$INSUNITS" }, { 70, this->Inches ? "1" : "4" }, { 9, "$MEASUREMENT" },
      { 70, this->Inches ? "0" : "1" }, { 9, "$EXTMIN" } });
    this->addPoint(low);
    this->add(9, "$EXTMAX");
    this->addPoint(high);
    this->add({ { 9, "$HANDLING" }, { 70, "1" }, { 9, "$HANDSEED" } });
    this->Seed = this->Text.size();
    this->add({ { 5, hexadecimal(0) }, { 0, "ENDSEC" } });

    this->beginSection("TABLES");
    this->beginTable("LTYPE", 2);
    this->addLineType(solid, "Solid line", {});
    this->addLineType(dashed, "Dashed __ __ __ __", { dashLength, -gapLength });
    this->add(0, "ENDTAB");
    this->beginTable("LAYER", static_cast<int>(layers.size()));
    for (const DxfLayer& layer : layers)
    {
      this->beginEntry("LAYER", layer.name);
      this->add(
        { { 70, "0" }, { 62, std::to_string(layer.color) }, { 6, layer.dashed ? dashed : solid } });
    }
    this->add(0, "ENDTAB");
    this->beginTable("STYLE", 1);
    this->beginEntry("STYLE", "STANDARD");
    this->add({ { 70, "0" }, { 40, "0.0" }, { 41, "1.0" }, { 50, "0.0" }, { 71, "0" },
      { 42, "2.5" }, { 3, "txt" }, { 4, "" }, { 0, "ENDTAB" }, { 0, "ENDSEC" } });
  }
  /// The whole text.
  std::string finish()
  {
    this->add(0, "EOF");
    const std::string first = "  5\r\n";
    this->Text.replace(this->Seed + first.size(), 8, hexadecimal(this->NextHandle));
    return std::move(this->Text);
  }

private:
  void addHandle() { this->add(5, hexadecimal(this->NextHandle++)); }
  /// \param dashes lengths in millimetres, those of gaps less than 0; none: a solid line
  void addLineType(
    const std::string& name, const std::string& words, const std::vector<double>& dashes)
  {
    this->beginEntry("LTYPE", name);
    this->add({ { 70, "0" }, { 3, words }, { 72, "65" }, { 73, std::to_string(dashes.size()) } });
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

  bool Inches;
  double PerMillimetre;
  unsigned NextHandle = 1;
  std::size_t Seed = 0; ///< where in the text the next free handle is to be told
  std::string Text;
};

/// A corner turns by more than this, in radians; a lesser turn belongs to a curve.
constexpr double turnAngle = 0.3;
constexpr std::size_t longestSymbol = 31; // R12's limit
constexpr double drillRadius = 1.5;
// Of a polyline.
constexpr int closedLine = 1;
constexpr int dashesRunOn = 128;
constexpr double gradeTextHeight = 3.0;

const DxfLayer& layerOf(LineKind kind)
{
  switch (kind)
  {
    case LineKind::CutLine:
      return dxf::boundary;
    case LineKind::CutOut:
      return dxf::cutOuts;
    case LineKind::SewLine:
    case LineKind::DartLeg:
      return dxf::sewLines;
    case LineKind::Fold:
      return dxf::mirrorLine;
    default:
      return dxf::internalLines;
  }
}

/// Those of the pieces; a number tells apart what would be the same in DXF.
std::vector<std::string> blockNames(const Pattern& pattern)
{
  std::vector<std::string> names;
  for (const PatternPiece& piece : pattern.pieces)
  {
    std::string name = dxfSymbol(piece.name, longestSymbol);
    if (name.find_first_not_of('_') == std::string::npos ||
      std::find(names.begin(), names.end(), name) != names.end())
    {
      const std::string number = "_" + std::to_string(piece.number);
      name = name.substr(0, longestSymbol - number.size());
      name += number;
    }
    names.push_back(name);
  }
  return names;
}

struct DxfDrawing
{
  std::string make()
  {
    this->Records.addHead({ 0.0, -this->Layout.extent.y() }, { this->Layout.extent.x(), 0.0 },
      { dxf::boundary, dxf::turnPoints, dxf::curvePoints, dxf::notches, dxf::mirrorLine,
        dxf::grainLine, dxf::internalLines, dxf::cutOuts, dxf::drillHoles, dxf::sewLines,
        dxf::annotation });
    this->Records.beginSection("BLOCKS");
    for (std::size_t p = 0; p < this->Drawn.pieces.size(); ++p)
    {
      this->addBlock(p);
    }
    this->Records.add(0, "ENDSEC");
    this->Records.beginSection("ENTITIES");
    this->addStyleTexts();
    for (std::size_t p = 0; p < this->Drawn.pieces.size(); ++p)
    {
      this->Records.begin("INSERT", dxf::boundary);
      this->Records.add(2, this->BlockNames[p]);
      this->Records.addPoint(this->cornerOf(p));
    }
    this->Records.add(0, "ENDSEC");
    return this->Records.finish();
  }

  /// For laser, knife and router: what is cut, what is marked, and texts.
  std::string makeForCutter()
  {
    this->Records.addHead({ 0.0, -this->Layout.extent.y() }, { this->Layout.extent.x(), 0.0 },
      { dxf::cut, dxf::mark, dxf::text });
    this->Records.beginSection("ENTITIES");
    for (std::size_t p = 0; p < this->Drawn.pieces.size(); ++p)
    {
      const PatternPiece& piece = this->Drawn.pieces[p];
      this->Corner = this->cornerOf(p);
      this->addCutterMarks(piece);
      this->addCutterTexts(piece);
      this->addCuts(piece); // last, as a part that is cut out may move
    }
    this->Records.add(0, "ENDSEC");
    return this->Records.finish();
  }

  void addMark(const DxfLayer& layer, const Point2& at)
  {
    this->Records.begin("POINT", layer);
    this->Records.addPoint(at);
  }

  void addPolyline(const PatternLine& line)
  {
    const DxfLayer& layer = layerOf(line.kind);
    // Dashes run on over the points, which are nearer to each other than dashes are long.
    this->Records.beginPolyline(
      layer, (line.closed ? closedLine : 0) | (layer.dashed ? dashesRunOn : 0));
    for (const Point2& p : line.points)
    {
      this->Records.begin("VERTEX", layer);
      this->Records.addPoint(p);
    }
    this->Records.begin("SEQEND", layer);
    this->addPointMarks(line);
  }

  /// \param in, out the ways to the point and from it
  void addPointMark(const Point2& at, const Point2& in, const Point2& out, bool isEnd)
  {
    const bool turns = isEnd || std::abs(std::atan2(cross(in, out), in.dot(out))) > turnAngle;
    this->addMark(turns ? dxf::turnPoints : dxf::curvePoints, at);
  }

  /// Turn points and curve points, the two kinds of vertices that pattern systems tell apart.
  /// Of a smooth line only what its curves hang on.
  void addPointMarks(const PatternLine& line)
  {
    if (!line.curve.empty())
    {
      this->addCurveMarks(line);
      return;
    }
    const std::size_t count = line.points.size();
    for (std::size_t k = 0; k < count; ++k)
    {
      const bool isEnd = !line.closed && (k == 0 || k + 1 == count);
      this->addPointMark(line.points[k], line.points[k] - line.points[(k + count - 1) % count],
        line.points[(k + 1) % count] - line.points[k], isEnd);
    }
  }

  void addCurveMarks(const PatternLine& line)
  {
    for (std::size_t k = 0; k < line.curve.size(); ++k)
    {
      const bool isEnd = k == 0 && !line.closed;
      const FairSpan& after = line.curve[k];
      const FairSpan& before = line.curve[(k + line.curve.size() - 1) % line.curve.size()];
      this->addPointMark(after.control[0], before.control[3] - before.control[2],
        after.control[1] - after.control[0], isEnd);
    }
    if (!line.closed)
    {
      this->addMark(dxf::turnPoints, line.curve.back().control[3]);
    }
  }

  void addBlock(std::size_t p)
  {
    const PatternPiece& piece = this->Drawn.pieces[p];
    this->Records.begin("BLOCK", dxf::boundary);
    this->Records.add({ { 2, this->BlockNames[p] }, { 70, "0" } });
    this->Records.addPoint(Point2::Zero());
    this->Records.add(3, this->BlockNames[p]);
    for (const PatternLine& line : piece.lines)
    {
      if (line.kind == LineKind::DartFold || line.kind == LineKind::Fold)
      {
        this->Records.addLine(layerOf(line.kind), line.points.front(), line.points.back());
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
        this->addMark(dxf::notches, notch.from);
        const Point2 way = notch.to - notch.from;
        this->Records.addNumber(50, std::atan2(way.y(), way.x()) * 180.0 / pi);
        // A point is all that pattern systems want, and too little to be seen in others.
        this->Records.addLine(dxf::notches, notch.from, notch.to);
      }
      else
      {
        this->Records.addLine(dxf::internalLines, notch.from, notch.to);
      }
    }
    for (const Point2& hole : piece.drillHoles)
    {
      this->addMark(dxf::drillHoles, hole);
      this->Records.addCircle(dxf::drillHoles, hole, drillRadius);
    }
    for (const GradePoint& point : piece.gradePoints)
    {
      this->Records.addText(
        dxf::turnPoints, point.place, gradeTextHeight, 0.0, "# " + std::to_string(point.rule));
    }
    this->addGrain(piece.grain);
    this->addPieceTexts(piece);
    this->Records.begin("ENDBLK", dxf::boundary);
  }

  /// Pattern systems want one line; its heads, which plain CAD shows, are none.
  void addGrain(const Grainline& grain)
  {
    this->Records.addLine(dxf::grainLine, grain.from, grain.to);
    for (const std::array<Point2, 3>& head : arrowHeads(grain))
    {
      this->Records.begin("SOLID", dxf::grainLine);
      for (int corner = 0; corner < 4; ++corner) // a triangle has its last one twice
      {
        this->Records.addPoint(head[static_cast<std::size_t>(std::min(corner, 2))], corner);
      }
    }
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
      const bool isOfPiece = text.role == TextRole::Title || text.role == TextRole::Label;
      const bool isSystem = isOfPiece && next < system.size();
      const std::string& content = isSystem ? system[next++] : text.text;
      const double height = text.role == TextRole::Title ? 0.7 * text.height : text.height;
      this->Records.addTextAround(
        isSystem ? dxf::boundary : dxf::annotation, text.position, height, text.angle, content);
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
      this->Records.addText(dxf::boundary, Point2(0.0, y), 5.0, 0.0, text);
      y -= 10.0;
    }
  }

  void addCuts(const PatternPiece& piece)
  {
    for (const LineKind kind : { LineKind::CutOut, LineKind::CutLine })
    {
      for (const PatternLine& line : piece.lines)
      {
        if (line.kind == kind)
        {
          this->addArcs(dxf::cut, line);
        }
      }
    }
  }

  void addCutterMarks(const PatternPiece& piece)
  {
    for (const PatternLine& line : piece.lines)
    {
      if (!isCut(line.kind))
      {
        this->addArcs(dxf::mark, line);
      }
    }
    for (const Notch& notch : piece.notches)
    {
      this->Records.addLine(dxf::mark, this->at(notch.from), this->at(notch.to));
    }
    for (const Point2& hole : piece.drillHoles)
    {
      this->Records.addCircle(dxf::mark, this->at(hole), drillRadius);
    }
    if (!this->Drawn.isSheet && piece.grain.from != piece.grain.to)
    {
      this->Records.addLine(dxf::mark, this->at(piece.grain.from), this->at(piece.grain.to));
    }
  }

  void addCutterTexts(const PatternPiece& piece)
  {
    for (const PatternText& text : piece.texts)
    {
      if (!this->Drawn.isSheet || text.role != TextRole::Grain)
      {
        this->Records.addTextAround(
          dxf::text, this->at(text.position), text.height, text.angle, text.text);
      }
    }
  }

  void addArcs(const DxfLayer& layer, const PatternLine& line)
  {
    const std::vector<ArcVertex> vertices = arcPolyline(line.points, line.closed, arcTolerance);
    if (vertices.size() < 2)
    {
      return;
    }
    this->Records.beginPolyline(layer, line.closed ? closedLine : 0);
    for (const ArcVertex& vertex : vertices)
    {
      this->Records.begin("VERTEX", layer);
      this->Records.addPoint(this->at(vertex.at));
      if (vertex.bulge != 0.0)
      {
        this->Records.addNumber(42, vertex.bulge);
      }
    }
    this->Records.begin("SEQEND", layer);
  }

  /// The lower left corner of a piece, in rows from the top of the drawing, y up.
  Point2 cornerOf(std::size_t p) const
  {
    return { this->Layout.corners[p].x(),
      -this->Layout.corners[p].y() - this->Drawn.pieces[p].extent.y() };
  }

  Point2 at(const Point2& p) const { return this->Corner + p; }

  const Pattern& Drawn;
  SheetLayout Layout = layOut(Drawn, squareWidth(Drawn), 0.0);
  std::vector<std::string> BlockNames = blockNames(Drawn);
  DxfRecords Records = DxfRecords(Drawn.unit == Unit::Inch);
  Point2 Corner = Point2::Zero(); ///< of the piece, for cutters
};
}

std::string makeDxf(const Pattern& pattern)
{
  return DxfDrawing{ pattern }.make();
}

std::string makeCutterDxf(const Pattern& pattern)
{
  return DxfDrawing{ pattern }.makeForCutter();
}
}
