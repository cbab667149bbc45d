// SPDX-License-Identifier: BSD-3-Clause
#include "ScaleBar.h"

#include <vtkTextProperty.h>

namespace figures
{
vtkSmartPointer<vtkScalarBarActor> makeScaleBar(vtkLookupTable* colors, int labels, int textSize)
{
  auto bar = vtkSmartPointer<vtkScalarBarActor>::New();
  bar->SetLookupTable(colors);
  bar->SetOrientationToHorizontal();
  bar->SetNumberOfLabels(labels);
  bar->SetLabelFormat("%.3g");
  bar->UnconstrainedFontSizeOn();
  vtkTextProperty* const property = bar->GetLabelTextProperty();
  property->SetColor(0.0, 0.0, 0.0);
  property->SetFontSize(textSize);
  property->BoldOff();
  property->ItalicOff();
  property->ShadowOff();
  return bar;
}
}
