// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMakeFlattenable
 * @brief move a surface as little as it takes to lie flat with little strain, and flatten it
 *
 * For a surface in which no cuts are wanted: it is changed until the strain on 95 % of
 * each flat piece is within Bound. The surface is flattened and sewn together again in turn, the
 * cloth being drawn back to the design by springs that are weakened until the bound holds; then it
 * goes back towards the design while it holds. The aim is that of C. C. L. Wang, "Towards
 * flattenable mesh surfaces", Computer-Aided Design 40(1), 2008, with a bound on the strain, which
 * cloth can bear, in place of angles that sum to 2 pi. The boundary and curves that are named do
 * not move at all, so that their lengths stay and neighbours still fit. The same for any number of
 * threads.
 *
 * Inputs and options: see vtkFeatureCurveAlgorithm and vtkWireWarpingFilter; **port 2**, optional,
 * a body that is not entered; the surface is
 * flattened by the scheme and all options that are set here. **Outputs 0 to 4** are those of
 * vtkWireWarpingFilter, for the moved surface.
 *
 * **Output 5, the moved surface**: that of vtkFeatureCurveImprinter with other points. Point
 * arrays: `Shift` (double, 3 components, unit of length; from the design to the moved surface),
 * `ShiftDistance` (double; its length), `ShiftOutwards` (double; its part along the normal of the
 * design, below 0 inwards), `Kept` (unsigned char; 1: not to be moved). **Output 6, the curves** on
 * it, as vtkFeatureCurveImprinter gives them: outputs 5 and 6 can be given to vtkWireWarpingFilter.
 *
 * **Outputs 7 and 8, the design before**: outputs 0 and 3 of vtkWireWarpingFilter without this
 * filter.
 *
 * **Output 9, the measures**: a vtkTable of one row. Columns: `BoundMet` (int), `StrainBefore`,
 * `StrainAfter` (the largest `StrainP95` of a piece), `Size` (root of the area of the design),
 * `ShiftMean`, `ShiftP95`, `ShiftMax` (by area; P95 is not exceeded on 95 % of it),
 * `ShiftOutwardsMean` (by area), `ShiftInwardsMax` (0: no point moved inwards; unit of length),
 * `RelativeShiftMean`, `RelativeShiftP95`, `RelativeShiftMax` (over Size) (double).
 *
 * A bound that cannot be met is no refusal: the surface is then the one with the least strain that
 * was found, `BoundMet` is 0, and a warning says so. INVALID_OPTION: a curve to keep that there is
 * not.
 *
 * @code
 * vtkNew<vtkMakeFlattenable> flattenable;
 * flattenable->SetInputData(surface);
 * flattenable->SetCurvesData(curves);
 * flattenable->SetBound(0.02);
 * flattenable->AddKeptCurve("centre front");
 * flattenable->Update();
 * vtkPolyData* moved = flattenable->GetOutput(5);
 * vtkTable* measures = vtkTable::SafeDownCast(flattenable->GetOutputDataObject(9));
 * std::cout << measures->GetValueByName(0, "ShiftMax").ToDouble() << "\n";
 * @endcode
 *
 * @warning Each step is a flattening of the whole surface and a sewing: seconds for a garment piece
 * of two thousand triangles. Progress is told, and an abort is heard.
 *
 * @sa vtkWireWarpingFilter vtkSewnShape vtkFeatureCurveSuggestion
 */
#ifndef vtkMakeFlattenable_h
#define vtkMakeFlattenable_h

#include "vtkFiltersFlatteningModule.h" // for the export macro
#include "vtkSmartPointer.h"            // for the trials
#include "vtkWireWarpingFilter.h"

#include <set>    // for the kept curves
#include <string> // for their names

class vtkTable;

class VTKFILTERSFLATTENING_EXPORT vtkMakeFlattenable : public vtkWireWarpingFilter
{
public:
  static vtkMakeFlattenable* New();
  vtkTypeMacro(vtkMakeFlattenable, vtkWireWarpingFilter)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The strain, on 95 % of each piece's area, that is good enough. Default: 0.02. Range: [1e-6,
   * 0.99].
   */
  vtkFlatteningNumberMacro(Bound, double);
  ///@}

  ///@{
  /**
   * Leave the boundary of the surface where it is. Default: on.
   */
  vtkFlatteningFlagMacro(KeepBoundary);
  ///@}

  ///@{
  /**
   * Leave all curves of a name where they are. The name may also be the "curve N" that a curve
   * without a name is given. Default: none.
   */
  void AddKeptCurve(const std::string& curve);
  void RemoveAllKeptCurves();
  ///@}

  ///@{
  /**
   * How much the surface moves outwards rather than inwards, along the normals of the design, which
   * point to where its triangles turn counter-clockwise: a step inwards costs 1 / (1 - OutsideBias)
   * times one outwards; at 1 no point moves inwards. A dome over a boundary that stays can only
   * sink: with a bias it may need KeepBoundary off; at 0 both are alike. Default: 0. Range: 0 to 1.
   */
  vtkFlatteningNumberMacro(OutsideBias, double);
  ///@}

  ///@{
  /**
   * Thickness of a plate that bends as the cloth does that the surface is made of while it moves,
   * over the root of the area: see vtkSewnShape. Default: 0.001. Range: 0 to 1.
   */
  vtkFlatteningNumberMacro(Thickness, double);
  ///@}

  ///@{
  /**
   * A surface that the surface does not enter while it moves, port 2, optional: a body, a last, a
   * core. Its normals point outwards; one that is closed is turned so. What of the design lies
   * inside goes no deeper; triangles between points may cut its bulges.
   */
  void SetBodyConnection(vtkAlgorithmOutput* body) { this->SetInputConnection(2, body); }
  void SetBodyData(vtkPolyData* body) { this->SetInputData(2, body); }
  ///@}

  /**
   * One row per flattening of the search: `Anchor` (stiffness of the springs, over that of the
   * cloth), `Share` (of the way from the design), `Strain`, `Shift` (mean, over Size) (double).
   */
  vtkTable* GetTrials() const;

protected:
  vtkMakeFlattenable();
  ~vtkMakeFlattenable() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  // Options have the defaults of the algorithms.
  std::set<std::string> KeptCurves;

private:
  vtkMakeFlattenable(const vtkMakeFlattenable&) = delete;
  void operator=(const vtkMakeFlattenable&) = delete;

  vtkSmartPointer<vtkTable> Trials; // of the last run
};

#endif
