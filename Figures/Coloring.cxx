// SPDX-License-Identifier: BSD-3-Clause
#include "Coloring.h"

#include "Panels.h"

#include <vtkColorTransferFunction.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>

namespace figures
{
namespace
{
/// Light, so that wires stand out.
vtkSmartPointer<vtkLookupTable> makeLightColors(ColorRange range)
{
  constexpr double saturation = 0.6;
  vtkSmartPointer<vtkLookupTable> table = makeColors(range);
  table->SetSaturationRange(saturation, saturation);
  table->ForceBuild();
  return table;
}

/// Blue below, white at and red above 1.
vtkSmartPointer<vtkLookupTable> makeAreaColors(double low, double high)
{
  vtkNew<vtkColorTransferFunction> function;
  function->SetColorSpaceToDiverging();
  function->AddRGBPoint(low, 0.230, 0.299, 0.754);
  function->AddRGBPoint(1.0, 0.9, 0.9, 0.9);
  function->AddRGBPoint(high, 0.706, 0.016, 0.150);
  constexpr int count = 256;
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(count);
  table->SetTableRange(low, high);
  for (int k = 0; k < count; ++k)
  {
    const double* const color = function->GetColor(low + (high - low) * (k + 0.5) / count);
    table->SetTableValue(k, color[0], color[1], color[2]);
  }
  return table;
}
}

//------------------------------------------------------------------------------
const char* nameOf(Coloring coloring)
{
  switch (coloring)
  {
    case Coloring::Developability:
      return "developability";
    case Coloring::AspectRatio:
      return "aspect-ratio";
    case Coloring::Area:
      return "area";
    default:
      return "homogeneity";
  }
}

//------------------------------------------------------------------------------
std::optional<Coloring> coloringOf(const std::string& name)
{
  const auto* const found = std::find_if(colorings.begin(), colorings.end(),
    [&name](Coloring coloring) { return name == nameOf(coloring); });
  return found == colorings.end() ? std::nullopt : std::optional<Coloring>(*found);
}

//------------------------------------------------------------------------------
ColorMap makeColorMap(Coloring coloring, const PolyData& flat)
{
  switch (coloring)
  {
    case Coloring::Developability:
    {
      const char* const name = "Developability";
      vtkDataArray* const values = flat->GetPointData()->GetArray(name);
      const double largest = values ? values->GetRange()[1] : 0.0;
      return { name, true, "developability: angle defect (rad)",
        makeLightColors({ 0.0, std::max(largest, developable) }), 3 };
    }
    case Coloring::AspectRatio:
      return { "AspectRatio", false, "aspect ratio (1 is ideal)", makeLightColors(indexRange), 6 };
    case Coloring::Area:
      return { "AreaRatio", false, "area in the plane / on the surface", makeAreaColors(0.8, 1.2),
        5 };
    default:
      return { "HomogeneityOfDistortion", false, "homogeneity (1 is ideal)",
        makeLightColors(indexRange), 6 };
  }
}
}
