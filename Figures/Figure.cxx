// SPDX-License-Identifier: BSD-3-Clause
#include "Figure.h"

#include "Files.h"

#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>

namespace figures
{
namespace
{
/// So that the last digits of a result do not change the size of a picture.
constexpr double rounding = 1e-6;
constexpr int textSize = 18;
constexpr int scaleLabels = 6;
}

Figure::Figure(int width, int maximumHeight, int samples)
  : Window(vtkSmartPointer<vtkRenderWindow>::New())
  , Rows(1)
  , Width(width)
  , MaximumHeight(maximumHeight)
{
  this->Window->SetMultiSamples(samples);
}

Drawing& Figure::add()
{
  return this->Rows.back().emplace_back();
}

void Figure::nextRow()
{
  this->Rows.emplace_back();
}

void Figure::addScale(const std::string& title, ColorRange range)
{
  this->Scales.push_back({ title, range });
}

double Figure::neededPixel() const
{
  double pixel = 0.0;
  double height = 0.0;
  int available = this->MaximumHeight - (this->Scales.empty() ? 0 : this->style.scaleHeight);
  for (const Row& row : this->Rows)
  {
    double rowWidth = 0.0;
    double tallest = 0.0;
    for (const Drawing& drawing : row)
    {
      rowWidth += drawing.size()[0];
      tallest = std::max(tallest, drawing.size()[1]);
    }
    const int gaps = 2 * this->style.gap * static_cast<int>(row.size());
    pixel = std::max(pixel, rowWidth / (this->Width - gaps));
    height += tallest;
    available -= this->rowHeight(row, 0.0);
  }
  return std::max(pixel, height / available);
}

int Figure::rowHeight(const Row& row, double pixel) const
{
  double tallest = 0.0;
  bool titled = false;
  for (const Drawing& drawing : row)
  {
    tallest = std::max(tallest, drawing.size()[1]);
    titled = titled || drawing.hasTitle();
  }
  const int needed = pixel > 0.0 ? static_cast<int>(std::ceil(tallest / pixel - rounding)) : 0;
  return needed + 2 * this->style.gap + (titled ? this->style.titleHeight : 0);
}

void Figure::finishRow(Row& row, int bottom, int height, double pixel) const
{
  double needed = 0.0;
  for (const Drawing& drawing : row)
  {
    needed += drawing.size()[0] / pixel;
  }
  // What is left over goes to all drawings alike.
  const double spare = (this->Width - needed) / static_cast<double>(row.size());
  double right = 0.0;
  for (Drawing& drawing : row)
  {
    const int left = static_cast<int>(std::lround(right));
    right += drawing.size()[0] / pixel + spare;
    drawing.finish(
      { left, bottom, static_cast<int>(std::lround(right)) - left, height }, pixel, this->style);
  }
}

void Figure::drawScales(int windowHeight) const
{
  const double height = this->style.scaleHeight;
  vtkNew<vtkRenderer> strip;
  strip->SetViewport(0.0, 0.0, 1.0, height / windowHeight);
  strip->SetBackground(1.0, 1.0, 1.0);
  this->Window->AddRenderer(strip);
  const double share = 1.0 / static_cast<double>(this->Scales.size());
  for (std::size_t k = 0; k < this->Scales.size(); ++k)
  {
    const auto bar = makeScaleBar(makeColors(this->Scales[k].range), scaleLabels, textSize);
    const double middle = (static_cast<double>(k) + 0.5) * share;
    const double width = std::min(0.8 * share, 500.0 / this->Width);
    bar->SetPosition(middle - 0.5 * width, 0.1);
    bar->SetPosition2(width, 0.5);
    strip->AddViewProp(bar);
    vtkNew<vtkTextActor> title;
    title->SetInput(this->Scales[k].title.c_str());
    title->SetPosition(middle * this->Width, 0.72 * height);
    title->GetTextProperty()->SetColor(0.0, 0.0, 0.0);
    title->GetTextProperty()->SetFontSize(textSize);
    title->GetTextProperty()->SetJustificationToCentered();
    strip->AddViewProp(title);
  }
}

vtkRenderWindow* Figure::render()
{
  this->Rows.remove_if([](const Row& row) { return row.empty(); });
  const double pixel = this->neededPixel();
  const int scales = this->Scales.empty() ? 0 : this->style.scaleHeight;
  int height = scales;
  for (const Row& row : this->Rows)
  {
    height += this->rowHeight(row, pixel);
  }
  this->Window->SetSize(this->Width, height);
  int top = height;
  for (Row& row : this->Rows)
  {
    for (Drawing& drawing : row)
    {
      this->Window->AddRenderer(drawing.renderer());
    }
    const int rowHeight = this->rowHeight(row, pixel);
    top -= rowHeight;
    this->finishRow(row, top, rowHeight, pixel);
  }
  if (scales > 0)
  {
    this->drawScales(height);
  }
  this->Window->Render();
  return this->Window;
}

void Figure::write(const std::string& path)
{
  this->Window->SetOffScreenRendering(1);
  this->render();
  writePng(this->Window, path);
}
}
