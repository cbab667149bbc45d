// SPDX-License-Identifier: BSD-3-Clause
#include "Coloring.h"

#include "Panels.h"

#include <vtkCellData.h>
#include <vtkColorTransferFunction.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace figures
{
namespace
{
/// In the order of the enumeration.
constexpr std::array<const char*, 11> names{ "developability", "homogeneity", "aspect-ratio",
  "area", "strain", "stretch", "warp", "weft", "shear", "distance", "piece" };

/// Nine colors of viridis, from its dark end to its light one (N. Smith, S. van der Walt,
/// matplotlib 1.5, CC0); between them CIELAB interpolation is at most 3.7 off the map's 256 colors
/// (CIE 1976).
constexpr std::array<Vector, 9> viridis{ { { 0.267, 0.005, 0.329 }, { 0.279, 0.175, 0.483 },
  { 0.230, 0.322, 0.546 }, { 0.173, 0.449, 0.558 }, { 0.128, 0.567, 0.551 },
  { 0.154, 0.680, 0.504 }, { 0.361, 0.786, 0.388 }, { 0.668, 0.862, 0.196 },
  { 0.993, 0.906, 0.144 } } };

vtkSmartPointer<vtkLookupTable> tabulate(
  vtkColorTransferFunction* function, double low, double high, int count = 256)
{
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

/// Light at the low end of the range, which is what is good, and dark at the high one.
vtkSmartPointer<vtkLookupTable> makeSequentialColors(ColorRange range, int count = 256)
{
  vtkNew<vtkColorTransferFunction> function;
  function->SetColorSpaceToLab();
  const double step = (range.high - range.low) / (viridis.size() - 1.0);
  for (std::size_t k = 0; k < viridis.size(); ++k)
  {
    const Vector& color = viridis[viridis.size() - 1 - k];
    function->AddRGBPoint(range.low + static_cast<double>(k) * step, color[0], color[1], color[2]);
  }
  return tabulate(
    function, std::min(range.low, range.high), std::max(range.low, range.high), count);
}

/// Blue below, white at and red above the middle (K. Moreland, Diverging Color Maps for Scientific
/// Visualization, ISVC 2009).
vtkSmartPointer<vtkLookupTable> makeDivergingColors(double low, double middle, double high)
{
  vtkNew<vtkColorTransferFunction> function;
  function->SetColorSpaceToDiverging();
  function->AddRGBPoint(low, 0.230, 0.299, 0.754);
  function->AddRGBPoint(middle, 0.9, 0.9, 0.9);
  function->AddRGBPoint(high, 0.706, 0.016, 0.150);
  return tabulate(function, low, high);
}

/// Eight colors that differ to the color-blind as well (M. Okabe, K. Ito, Color Universal Design,
/// 2008), black in a gray.
const std::vector<Vector> distinct{ { 0.902, 0.624, 0.0 }, { 0.337, 0.706, 0.914 },
  { 0.0, 0.620, 0.451 }, { 0.941, 0.894, 0.259 }, { 0.0, 0.447, 0.698 }, { 0.835, 0.369, 0.0 },
  { 0.800, 0.475, 0.655 }, { 0.6, 0.6, 0.6 } };

/// 0 where there is no array.
double largestOf(vtkDataArray* values)
{
  return values ? values->GetRange()[1] : 0.0;
}

constexpr double rightAngle = 90.0;
constexpr double leastEnd = 1e-3;    ///< of a diverging scale, from its middle
constexpr double turnedOver = 100.0; ///< strain of such a triangle, and the largest, in percent

/// By how many degrees the threads' angle may change, of the pieces' material.
double lockingAngle(const FlatPiece& piece)
{
  const double limit = piece.number("ShearLimit");
  return std::isnan(limit) ? rightAngle : limit;
}

/// The values of an array that shares of all do not exceed.
std::array<double, 2> quantiles(vtkDataArray* values, const std::array<double, 2>& shares)
{
  std::vector<double> sorted;
  for (vtkIdType k = 0; values && k < values->GetNumberOfTuples(); ++k)
  {
    sorted.push_back(values->GetComponent(k, 0));
  }
  std::sort(sorted.begin(), sorted.end());
  std::array<double, 2> found{};
  for (std::size_t k = 0; k < shares.size() && !sorted.empty(); ++k)
  {
    found[k] = sorted[static_cast<std::size_t>(shares[k] * (sorted.size() - 1.0))];
  }
  return found;
}

/// 1, 2, 5, 10, ... and what lies between by tens: at least the value, and an end of a scale.
double roundedUp(double value)
{
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : { 1.0, 2.0, 5.0 })
  {
    if (value <= step * power * (1.0 + 1e-9))
    {
      return step * power;
    }
  }
  return 10.0 * power;
}

/// A cell array that is good in the middle, in colors that end at its 5th or 95th percentile.
ColorMap divergingMap(
  const FlatPiece& piece, const char* name, const std::string& title, double middle)
{
  const auto ends = quantiles(piece.flat->GetCellData()->GetArray(name), { 0.05, 0.95 });
  const double farthest = std::max(std::abs(ends[0] - middle), std::abs(ends[1] - middle));
  const double end = roundedUp(std::max(farthest, leastEnd));
  return { name, false, title, makeDivergingColors(middle - end, middle, middle + end), 5 };
}

ColorMap colorMapOf(Coloring coloring, const FlatPiece& piece)
{
  switch (coloring)
  {
    case Coloring::Developability:
    {
      const char* const name = "Developability";
      const double largest = largestOf(piece.flat->GetPointData()->GetArray(name));
      return { name, true, "developability: angle defect (rad)",
        makeSequentialColors({ 0.0, std::max(largest, developable) }), 3 };
    }
    case Coloring::AspectRatio:
      return { "AspectRatio", false, "aspect ratio (1 is ideal)", makeSequentialColors(indexRange),
        6 };
    case Coloring::Area:
      return divergingMap(piece, "AreaRatio", "area in the plane / on the surface", 1.0);
    case Coloring::Strain:
    {
      const char* const name = "Strain";
      const double largest = quantiles(piece.flat->GetCellData()->GetArray(name), { 0.0, 0.99 })[1];
      return { name, false, "strain (%)",
        makeSequentialColors({ 0.0, roundedUp(std::max(largest, 0.1)) }), 6 };
    }
    case Coloring::Stretch:
      // In steps, as pattern makers know it.
      return { "DominantStretch", false, "largest stretch of warp, weft or bias (%)",
        makeSequentialColors({ 100.0, 120.0 }, 8), 5 };
    case Coloring::Distance:
    {
      const char* const name = "Distance";
      const double largest = largestOf(piece.flat->GetPointData()->GetArray(name));
      return { name, true, "sewn surface: distance from the design (unit of length)",
        makeSequentialColors({ 0.0, largest > 0.0 ? largest : 1.0 }), 3 };
    }
    case Coloring::Piece:
    {
      const char* const name = "PieceId";
      const double largest = largestOf(piece.flat->GetCellData()->GetArray(name));
      return { name, false, "", makeCategories(distinct, static_cast<int>(largest) + 1), 0 };
    }
    case Coloring::Warp:
      return divergingMap(piece, "StrainWarp", "strain of the warp (drawn above 0)", 0.0);
    case Coloring::Weft:
      return divergingMap(piece, "StrainWeft", "strain of the weft (drawn above 0)", 0.0);
    case Coloring::Shear:
    {
      const double limit = lockingAngle(piece);
      const bool locks = limit < rightAngle;
      const double end = locks ? limit : 15.0;
      return { "ShearAngle", false,
        std::string("shear: trellis angle off the right one (degrees") +
          (locks ? "; the material's limit at the ends)" : ")"),
        makeDivergingColors(-end, 0.0, end), 5 };
    }
    default:
      return { "HomogeneityOfDistortion", false, "homogeneity (1 is ideal)",
        makeSequentialColors(indexRange), 6 };
  }
}
}

const char* nameOf(Coloring coloring)
{
  return names[static_cast<std::size_t>(coloring)];
}

std::optional<Coloring> coloringOf(const std::string& name)
{
  const auto* const found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? std::nullopt
                              : std::make_optional(static_cast<Coloring>(found - names.begin()));
}

ColorMap makeColorMap(Coloring coloring, const FlatPiece& piece, ColorRange range)
{
  ColorMap map = colorMapOf(coloring, piece);
  if (range.low != range.high && map.labels > 0)
  {
    const bool diverges = map.colors->GetTableRange()[0] < 0.0 || coloring == Coloring::Area;
    map.colors = diverges
      ? makeDivergingColors(range.low, 0.5 * (range.low + range.high), range.high)
      : makeSequentialColors(coloring == Coloring::Homogeneity || coloring == Coloring::AspectRatio
            ? ColorRange{ range.high, range.low } // large is good
            : range,
          map.colors->GetNumberOfTableValues());
  }
  return map;
}

FlatPiece withStrain(const FlatPiece& piece)
{
  vtkCellData* const cells = piece.flat->GetCellData();
  vtkDataArray* const areas = cells->GetArray("AreaRatio");
  vtkDataArray* const aspects = cells->GetArray("AspectRatio");
  FlatPiece strained = piece;
  if (!areas || !aspects)
  {
    return strained;
  }
  const vtkNew<vtkDoubleArray> strains;
  strains->SetName("Strain");
  for (vtkIdType cell = 0; cell < areas->GetNumberOfTuples(); ++cell)
  {
    const double area = areas->GetComponent(cell, 0);
    const double aspect = aspects->GetComponent(cell, 0);
    // a = S s, the aspect ratio is s / S.
    const double strain = area > 0.0 && aspect > 0.0
      ? 50.0 * (std::abs(std::log(area)) - std::log(aspect))
      : turnedOver;
    strains->InsertNextValue(std::min(strain, turnedOver));
  }
  for (PolyData* const data : { &strained.flat, &strained.cut })
  {
    auto copy = vtkSmartPointer<vtkPolyData>::New();
    copy->ShallowCopy(*data);
    copy->GetCellData()->AddArray(strains);
    *data = copy;
  }
  return strained;
}
}
