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
 * Inputs and options: see vtkFeatureCurveAlgorithm and vtkWireWarpingFilter. **Outputs 0 to 2** are
 * those of vtkWireWarpingFilter, with all key curves.
 *
 * **Output 3, the prices**: a vtkPolyData without points; vtkFlatteningTable makes a table of it.
 * Field data, a row a trial: `KeyTrial` (string; "all keys", then "without NAME" and "NAME alone"
 * for each key, the dearest first, and "no key"), `KeyCurve` (int; id of the curve in the order of
 * reading, -1: all or none), `KeyPrice` (double; by how much `AreaError` falls where the shape of
 * this key alone is given up; not a number but in the rows "without NAME"), `AreaError` and
 * `StrainP95` (double; of the piece where they are largest; not a number where the surface was
 * refused), `Status` (string; of the first piece that breaks a promise), `Released` (string; names
 * of keys that lost their shape, since they clash with others, with commas between them). Keys come
 * by the number of others that are given up without them, then by price: what is to blame for a
 * clash comes first.
 *
 * INVALID_CURVE: there is no key curve. Otherwise the errors of vtkWireWarpingFilter; a trial that
 * is refused is none.
 *
 * @code
 * vtkNew<vtkKeyCurvePrices> prices;
 * prices->SetInputData(surface);
 * prices->SetCurvesData(curves);
 * vtkNew<vtkFlatteningTable> table;
 * table->SetInputConnection(prices->GetOutputPort(3));
 * table->Update();
 * vtkTable* rows = table->GetOutput();
 * rows->Dump();
 * @endcode
 *
 * @warning Each trial is a flattening: up to two for each key curve, and three more.
 *
 * @sa vtkWireWarpingFilter vtkFlatteningTable
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
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkKeyCurvePrices();
  ~vtkKeyCurvePrices() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkKeyCurvePrices(const vtkKeyCurvePrices&) = delete;
  void operator=(const vtkKeyCurvePrices&) = delete;
};

#endif
