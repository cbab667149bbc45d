// SPDX-License-Identifier: BSD-3-Clause
#include "Figure.h"

#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace figures
{
namespace
{
/// So that the last digits of a result do not change the size of a picture.
constexpr double rounding = 1e-6;
}

//------------------------------------------------------------------------------
Figure::Figure(int width, int maximumHeight, int samples)
  : Window(vtkSmartPointer<vtkRenderWindow>::New())
  , Rows(1)
  , Width(width)
  , MaximumHeight(maximumHeight)
{
  this->Window->SetMultiSamples(samples);
}

//------------------------------------------------------------------------------
Drawing& Figure::add()
{
  return this->Rows.back().emplace_back();
}

//------------------------------------------------------------------------------
void Figure::nextRow()
{
  this->Rows.emplace_back();
}

//------------------------------------------------------------------------------
double Figure::neededPixel() const
{
  double pixel = 0.0;
  double height = 0.0;
  int available = this->MaximumHeight;
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

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
vtkRenderWindow* Figure::render()
{
  this->Rows.remove_if([](const Row& row) { return row.empty(); });
  const double pixel = this->neededPixel();
  int height = 0;
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
  this->Window->Render();
  return this->Window;
}

//------------------------------------------------------------------------------
void Figure::write(const std::string& path)
{
  this->Window->SetOffScreenRendering(1);
  this->render();
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(this->Window);
  image->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(image->GetOutputPort());
  writer->SetFileName(path.c_str());
  writer->Write();
  if (writer->GetErrorCode() != 0)
  {
    throw std::runtime_error("cannot write " + path);
  }
}
}
