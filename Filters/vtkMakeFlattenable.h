// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMakeFlattenable
 * @brief move a surface as little as it takes to lie flat with little strain, and flatten it
 *
 * For a surface in which no cuts are wanted. It is flattened and sewn together again in turn, held
 * to the design by springs that are weakened until the strain on 95 % of each piece is within
 * Bound; then it goes back toward the design while the bound holds. The aim is that of C. C. L.
 * Wang, "Towards flattenable mesh surfaces", Computer-Aided Design 40(1), 2008. The boundary and
 * curves that are named keep their place, so that neighbors still fit.
 *
 * Inputs, options and outputs 0 to 4 are those of vtkWireWarpingFilter, for the moved surface; port
 * 2, optional, is a body that is not entered. **Output 5** is the moved surface with `Shift` and
 * `ShiftDistance`, **output 6** its curves, **7 and 8** are the flat pieces and their table without
 * this filter, **9** has the measures in one row (Documentation/outputs.md). A bound that cannot be
 * met is a warning: the surface is the one with the least strain that was found.
 *
 * @code
 * vtkNew<vtkMakeFlattenable> flattenable;
 * flattenable->SetInputData(surface);
 * flattenable->SetBound(0.02);
 * flattenable->Update();
 * vtkTable* measures = vtkTable::SafeDownCast(flattenable->GetOutputDataObject(9));
 * std::cout << measures->GetValueByName(0, "ShiftMax").ToDouble() << "\n";
 * @endcode
 *
 * @warning Each step is a flattening and a sewing of the whole surface: seconds for two thousand
 * triangles. Reports progress; can be aborted.
 *
 * @sa vtkWireWarpingFilter vtkSewnShape vtkFeatureCurveSuggestion
 */
#ifndef vtkMakeFlattenable_h
#define vtkMakeFlattenable_h

#include "vtkFiltersFlatteningModule.h" // for the export macro
#include "vtkSmartPointer.h"            // for the trials
#include "vtkTable.h"                   // for the trials
#include "vtkWireWarpingFilter.h"

#include <set>    // for the kept curves
#include <string> // for their names

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
  vtkTable* GetTrials() const { return this->Trials; }

protected:
  vtkMakeFlattenable();
  ~vtkMakeFlattenable() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  // Options have the defaults of the algorithms.
  std::set<std::string> KeptCurves;

private:
  vtkMakeFlattenable(const vtkMakeFlattenable&) = delete;
  void operator=(const vtkMakeFlattenable&) = delete;

  vtkSmartPointer<vtkTable> Trials; // of the last run
};

#endif
