// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkKeyCurvePrices
 * @brief what the planar shape of each key curve costs
 *
 * Which curves should keep their shape, and which of them contradict each other, is answered by
 * trials: the surface is flattened with all key curves, without each of them, with each alone and
 * with none, by the scheme and all options that are set here. A key that is left out keeps its
 * lengths and is free in its shape, as an accessory curve.
 *
 * Inputs and options: see vtkFeatureCurveAlgorithm and vtkWireWarpingFilter. **Outputs 0 to 4** are
 * those of vtkWireWarpingFilter, with all key curves.
 *
 * **Output 5, the prices**: a vtkTable with one row per trial. Columns: `Trial` (string; "all
 * keys", then "without NAME" and "NAME alone" for each key by decreasing price, and "no key"),
 * `Status` (string; of the first piece with a warning), `Curve` (id; row of output 4, -1: all or
 * none), `Price` (double; by how much `AreaError` falls where the shape of this key alone is given
 * up; not a number except in the rows "without NAME"), `AreaError` and `StrainP95` (double; of the
 * piece where they are largest; not a number where the surface was rejected), `Released` (string;
 * names of keys that lost their shape, since they clash with others, separated by commas). Keys
 * come by the number of others that are given up without them, then by price: what is to blame for
 * a clash comes first.
 *
 * INVALID_CURVE: there is no key curve. Otherwise the errors of vtkWireWarpingFilter; a trial that
 * is refused is none.
 *
 * @code
 * vtkNew<vtkKeyCurvePrices> prices;
 * prices->SetInputData(surface);
 * prices->SetCurvesData(curves);
 * prices->Update();
 * vtkTable::SafeDownCast(prices->GetOutputDataObject(5))->Dump();
 * @endcode
 *
 * @warning Each trial is a flattening: up to two for each key curve, and three more.
 *
 * @sa vtkWireWarpingFilter
 */
#ifndef vtkKeyCurvePrices_h
#define vtkKeyCurvePrices_h

#include "vtkFiltersFlatteningModule.h" // for the export macro
#include "vtkWireWarpingFilter.h"

class VTKFILTERSFLATTENING_EXPORT vtkKeyCurvePrices : public vtkWireWarpingFilter
{
public:
  static vtkKeyCurvePrices* New();
  vtkTypeMacro(vtkKeyCurvePrices, vtkWireWarpingFilter)

protected:
  vtkKeyCurvePrices();
  ~vtkKeyCurvePrices() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkKeyCurvePrices(const vtkKeyCurvePrices&) = delete;
  void operator=(const vtkKeyCurvePrices&) = delete;
};

#endif
