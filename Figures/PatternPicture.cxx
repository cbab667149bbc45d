// SPDX-License-Identifier: BSD-3-Clause
#include "PatternPicture.h"

#include "Files.h"

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTriangle.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace figures
{
namespace
{
// Pixels.
constexpr int strip = 150;
constexpr int margin = 16;
constexpr int line = 18;
constexpr int legendSize = 14;
constexpr int barHeight = 60;
constexpr int samples = 8;               // of a pixel
constexpr std::size_t messageWidth = 72; // characters
constexpr int tableWidth = 1000;         // of a picture that has room for numbers beside its scale

constexpr Vector black{ 0.0, 0.0, 0.0 };
constexpr Vector grey{ 0.35, 0.35, 0.35 };

bool hasType(const PolyData& wires, int type)
{
  vtkDataArray* const types = wires->GetCellData()->GetArray("CurveType");
  for (vtkIdType cell = 0; types && cell < types->GetNumberOfTuples(); ++cell)
  {
    if (static_cast<int>(types->GetComponent(cell, 0)) == type)
    {
      return true;
    }
  }
  return false;
}

/// Lines of at most so many characters, broken between words.
std::vector<std::string> wrapped(const std::string& text, std::size_t width)
{
  std::vector<std::string> lines;
  std::istringstream paragraphs(text);
  for (std::string paragraph; std::getline(paragraphs, paragraph);)
  {
    lines.emplace_back();
    std::istringstream words(paragraph);
    for (std::string word; words >> word;)
    {
      std::string& last = lines.back();
      if (last.empty())
      {
        last = word;
      }
      else if (last.size() + 1 + word.size() <= width)
      {
        last += " " + word;
      }
      else
      {
        lines.push_back(word);
      }
    }
  }
  return lines;
}

template <typename... Values>
std::string formatted(const char* pattern, Values... values)
{
  char text[160];
  std::snprintf(text, sizeof(text), pattern, values...);
  return text;
}
}

std::vector<std::string> errorTable(const FlatPiece& piece, std::size_t maximumRows)
{
  std::vector<std::string> rows{
    "piece  E_len %   E_ang     E_h     E_r  E_area  flips  overlaps"
  };
  const vtkIdType count = piece.pieces ? piece.pieces->GetNumberOfRows() : 0;
  for (vtkIdType row = 0; row < count; ++row)
  {
    if (rows.size() == maximumRows && row + 1 < count)
    {
      rows.push_back("... and " + std::to_string(count - row) + " more");
      break;
    }
    rows.push_back(formatted("%5d  %7.4f  %6.4f  %6.3f  %6.3f  %6.4f  %5.0f  %8.0f",
      static_cast<int>(row + 1), 100.0 * piece.number("EdgeLengthError", row),
      piece.number("AngleErrorMean", row), piece.number("GlobalHomogeneity", row),
      piece.number("GlobalAspectRatio", row), piece.number("AreaError", row),
      piece.number("FlippedTriangles", row), piece.number("Overlaps", row)));
  }
  return rows;
}

std::string extremesOf(const FlatPiece& piece, const ColorMap& map)
{
  vtkDataSetAttributes* const arrays = map.onPoints
    ? static_cast<vtkDataSetAttributes*>(piece.flat->GetPointData())
    : static_cast<vtkDataSetAttributes*>(piece.flat->GetCellData());
  vtkDataArray* const values = arrays->GetArray(map.array);
  vtkDataArray* const ids = piece.flat->GetCellData()->GetArray("PieceId");
  if (!values || values->GetNumberOfTuples() == 0 || map.labels == 0)
  {
    return "";
  }
  vtkIdType least = 0;
  vtkIdType largest = 0;
  double sum = 0.0;
  double weights = 0.0;
  for (vtkIdType k = 0; k < values->GetNumberOfTuples(); ++k)
  {
    const double value = values->GetComponent(k, 0);
    least = value < values->GetComponent(least, 0) ? k : least;
    largest = value > values->GetComponent(largest, 0) ? k : largest;
    auto* const cell = vtkTriangle::SafeDownCast(map.onPoints ? nullptr : piece.cut->GetCell(k));
    const double weight = cell ? cell->ComputeArea() : 1.0;
    sum += weight * value;
    weights += weight;
  }
  constexpr double rounding = 1e-6; // of ratios and per cent
  const auto number = [](const char* pattern, double value) {
    return formatted(pattern, std::abs(value) < rounding ? 0.0 : value);
  };
  const auto words = [&](vtkIdType k) {
    const std::string text = number("%.3g", values->GetComponent(k, 0));
    return map.onPoints || !ids || ids->GetRange()[1] < 1.0
      ? text
      : text + formatted(" on piece %d", static_cast<int>(ids->GetComponent(k, 0)) + 1);
  };
  double place[3];
  piece.cut->GetPoint(map.onPoints ? largest : piece.cut->GetCell(largest)->GetPointId(0), place);
  for (double& coordinate : place)
  {
    coordinate = std::abs(coordinate) < rounding * piece.cut->GetLength() ? 0.0 : coordinate;
  }
  return "largest " + words(largest) +
    formatted(" at %.4g, %.4g, %.4g; least ", place[0], place[1], place[2]) + words(least) +
    (weights > 0.0 ? number("; mean %.3g", sum / weights) : "");
}

namespace
{
/// A window with two panels and, below them, an overlay of texts.
class PatternPicture
{
public:
  PatternPicture(const PatternScene& given, int width, int height);
  void write(const std::string& path) { writePng(this->Window, path); }

private:
  enum class TextStyle
  {
    Plain,
    Bold,
    FixedPitch
  };

  void drawPanels(const PatternScene& scene, const ColorMap& map);
  void drawTexts(const PatternScene& scene);
  void drawLegend(const PatternScene& scene);
  void drawScale(const ColorMap& map);
  /// In as many lines as the scale leaves room for.
  void drawExtremes(const std::string& text);
  bool isNarrow() const { return this->Window->GetSize()[0] < tableWidth; }
  /// \return its width in pixels
  int addText(const std::string& text, int x, int y, int size, const Vector& color,
    TextStyle style = TextStyle::Plain, bool fromTop = false);

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Overlay;
};

PatternPicture::PatternPicture(const PatternScene& given, int width, int height)
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetSize(width, height);
  this->Window->SetMultiSamples(samples);
  this->Window->SetNumberOfLayers(2);
  const vtkNew<vtkRenderer> ground; // behind the words below
  ground->SetBackground(1.0, 1.0, 1.0);
  this->Window->AddRenderer(ground);
  PatternScene scene = given;
  if (scene.coloring == Coloring::Strain)
  {
    scene.piece = withStrain(scene.piece);
  }
  const ColorMap map = makeColorMap(scene.coloring, scene.piece, scene.range);
  this->drawPanels(scene, map);
  this->Overlay->SetLayer(1);
  this->Window->AddRenderer(this->Overlay);
  this->drawTexts(scene);
  this->drawLegend(scene);
  if (map.labels > 0)
  {
    this->drawScale(map);
    this->drawExtremes(extremesOf(scene.piece, map));
  }
  this->Window->Render();
}

void PatternPicture::drawPanels(const PatternScene& scene, const ColorMap& map)
{
  Drawing space;
  const Vector up = upOf(scene.piece.cut);
  space.lookFrom(facing(scene.piece.cut, up), up);
  Drawing plane;
  this->Window->AddRenderer(space.renderer());
  this->Window->AddRenderer(plane.renderer());
  if (scene.sewn)
  {
    space.addGhost(scene.piece.cut);
    space.addMap(scene.sewn, map.array, map.onPoints, map.colors);
    space.addWires(scene.piece.wiresOn(scene.sewn), DartSides::Blue);
  }
  else
  {
    space.addMap(scene.piece.cut, map.array, map.onPoints, map.colors);
    space.addWires(scene.piece.wiresOn(scene.piece.cut), DartSides::Blue);
  }
  plane.addMap(scene.piece.flat, map.array, map.onPoints, map.colors);
  plane.addWires(scene.piece.wires, DartSides::Blue);

  // One scale for both, so that sizes compare; the width is shared as they need it.
  const int width = this->Window->GetSize()[0];
  const int height = std::max(this->Window->GetSize()[1] - strip, 1);
  const int gaps = 6 * margin;
  const std::array<double, 2> left = space.size();
  const std::array<double, 2> right = plane.size();
  const double pixel = std::max((left[0] + right[0]) / std::max(width - gaps, 1),
    std::max(left[1], right[1]) / std::max(height - 2 * margin - 2 * line, 1));
  const double spare = width - (left[0] + right[0]) / pixel;
  const int middle = static_cast<int>(left[0] / pixel + 0.5 * spare);
  const FigureStyle style;
  space.finish({ 0, strip, middle, height }, pixel, style);
  plane.finish({ middle, strip, width - middle, height }, pixel, style);
}

int PatternPicture::addText(const std::string& text, int x, int y, int size, const Vector& color,
  TextStyle style, bool fromTop)
{
  vtkNew<vtkTextActor> actor;
  actor->SetInput(text.c_str());
  vtkTextProperty* const property = actor->GetTextProperty();
  property->SetColor(color.data());
  property->SetFontSize(size);
  if (style == TextStyle::FixedPitch)
  {
    property->SetFontFamilyToCourier();
  }
  if (fromTop)
  {
    property->SetVerticalJustificationToTop();
  }
  actor->SetPosition(x, fromTop ? this->Window->GetSize()[1] - y : y);
  this->Overlay->AddViewProp(actor);
  property->SetBold(style == TextStyle::Bold);
  double extent[2];
  actor->GetSize(this->Overlay, extent);
  return static_cast<int>(extent[0]);
}

void PatternPicture::drawTexts(const PatternScene& scene)
{
  this->addText(scene.title, margin, margin, legendSize + 4, black, TextStyle::Bold, true);
  constexpr std::size_t rows = (strip - 2 * margin) / line - 3;
  const int top = strip - margin - line;
  int right = 0;
  int y = top;
  for (const std::string& row :
    this->isNarrow() ? std::vector<std::string>() : errorTable(scene.piece, rows))
  {
    right =
      std::max(right, this->addText(row, margin, y, legendSize, black, TextStyle::FixedPitch));
    y -= line;
  }
  const int left = this->isNarrow() ? margin : right + 3 * margin;
  y = this->isNarrow() ? this->Window->GetSize()[1] - 2 * margin - 2 * line : top;
  for (const std::string& words : wrapped(scene.message, messageWidth))
  {
    this->addText(words, left, y, legendSize, scene.warning ? keyColor : grey);
    y -= line;
  }
}

void PatternPicture::drawLegend(const PatternScene& scene)
{
  struct Entry
  {
    const char* name;
    const Vector& color;
    bool shown;
  };
  const PolyData& wires = scene.piece.wires;
  const bool seams = hasType(wires, 3);
  const Entry entries[] = { { seams ? "boundary and seams" : "boundary", boundaryColor,
                              seams || hasType(wires, -1) },
    { "accessory", accessoryColor, hasType(wires, 0) }, { "key", keyColor, hasType(wires, 1) },
    { "dart", dartColor, hasType(wires, 2) } };
  int x = margin;
  for (const Entry& entry : entries)
  {
    if (entry.shown)
    {
      x += this->addText(
             "\xE2\x80\x94 ", x, margin / 2, legendSize + 4, entry.color, TextStyle::Bold) +
        4;
      x +=
        this->addText(entry.name, x, margin / 2, legendSize, entry.color, TextStyle::Bold) + margin;
    }
  }
}

void PatternPicture::drawExtremes(const std::string& text)
{
  constexpr std::size_t narrowWidth = 26; // characters
  const std::vector<std::string> lines =
    wrapped(text, this->isNarrow() ? narrowWidth : text.size());
  int y = 2 * margin + line / 2 + line * static_cast<int>(lines.size() - 1);
  for (const std::string& words : lines)
  {
    this->addText(words, margin, y, legendSize, black);
    y -= line;
  }
}

void PatternPicture::drawScale(const ColorMap& map)
{
  const double width = this->Window->GetSize()[0];
  const double height = this->Window->GetSize()[1];
  const double length = std::min(420.0, 0.35 * width);
  const auto bar = makeScaleBar(map.colors, map.labels, legendSize);
  const double left = width - length - 3 * margin;
  bar->SetPosition(left / width, margin / height);
  bar->SetPosition2(length / width, barHeight / height);
  this->Overlay->AddViewProp(bar);
  constexpr int letter = 7;
  const int fitting =
    static_cast<int>(width) - margin - letter * static_cast<int>(map.title.size());
  this->addText(map.title, std::max(margin, std::min(static_cast<int>(left), fitting)),
    this->isNarrow() ? strip - margin - line : margin + barHeight - line / 3, legendSize, black);
}

}

void writePatternPicture(const PatternScene& scene, int width, int height, const std::string& path)
{
  PatternPicture(scene, width, height).write(path);
}
}
