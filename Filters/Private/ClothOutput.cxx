// SPDX-License-Identifier: BSD-3-Clause
#include "ClothOutput.h"

#include "Base/Types.h"
#include "FieldArrays.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace flattening
{
namespace bridge
{
namespace
{
/// The largest strain of a triangle and its direction: warp, weft, or the bias between them, in
/// which a shear of g draws by about g / 2.
struct Dominant
{
  unsigned char thread = 0;
  double strain = 0.0;
};

Dominant dominantOf(const ThreadStrain& strain)
{
  const double bias = 0.5 * (strain.warp + strain.weft) + std::sin(0.5 * std::abs(strain.shear));
  Dominant dominant{ 0, strain.warp };
  const auto consider = [&dominant](unsigned char thread, double value) {
    if (std::abs(value) > std::abs(dominant.strain))
    {
      dominant = { thread, value };
    }
  };
  consider(1, strain.weft);
  consider(2, bias);
  return dominant;
}
}

void writeThreads(const FlatteningResult& result, vtkCellData* cells)
{
  const std::vector<ThreadStrain>& threads = result.threads;
  if (threads.empty())
  {
    return;
  }
  const std::size_t count = threads.size();
  addRows<vtkDoubleArray>(
    cells, "StrainWarp", count, [&](std::size_t t) { return threads[t].warp; });
  addRows<vtkDoubleArray>(
    cells, "StrainWeft", count, [&](std::size_t t) { return threads[t].weft; });
  addRows<vtkDoubleArray>(
    cells, "ShearAngle", count, [&](std::size_t t) { return threads[t].shear / degree; });
  std::vector<unsigned char> out(count, 0);
  for (const PieceReport& piece : result.pieces)
  {
    for (Index t : piece.cloth ? piece.cloth->outOfLimit : Indices())
    {
      out[t] = 1;
    }
  }
  addRows<vtkUnsignedCharArray>(cells, "OutOfLimit", count, [&](std::size_t t) { return out[t]; });
  addRows<vtkUnsignedCharArray>(
    cells, "DominantThread", count, [&](std::size_t t) { return dominantOf(threads[t]).thread; });
  addRows<vtkDoubleArray>(cells, "DominantStretch", count,
    [&](std::size_t t) { return 100.0 * (1.0 + dominantOf(threads[t]).strain); });
}

void writeGrain(const FlatteningResult& result, vtkFieldData* field)
{
  // Without a material what the field data of the input had is removed: patterns of it would lie on
  // a cloth.
  const std::size_t rows = result.threads.empty() ? 0 : result.pieces.size();
  addRows<vtkDoubleArray>(field, "GrainAngle", rows, [&](std::size_t row) {
    const auto& cloth = result.pieces[row].cloth;
    return cloth ? cloth->grain.angle / degree : 0.0;
  });
}
}
}
