// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLeastSquaresConformalFilter
 * @brief flatten a surface so that its angles change least
 *
 * The least squares conformal map of each piece, scaled so that its perimeter is that of the
 * surface. It keeps no length: it is the comparison of the WireWarping paper, and the usual
 * parameterization for textures. Feature curves are optional; darts and seams among them are opened
 * first, the others only say over which edges E_len is taken.
 *
 * Inputs: see vtkFeatureCurveAlgorithm. Outputs: see vtkFlatPieceAlgorithm.
 *
 * The method is that of B. Levy, S. Petitjean, N. Ray, J. Maillot, "Least squares conformal maps
 * for automatic texture atlas generation", ACM Transactions on Graphics 21(3), 2002,
 * https://doi.org/10.1145/566654.566590.
 *
 * @code
 * vtkNew<vtkLeastSquaresConformalFilter> conformal;
 * conformal->SetInputData(surface);
 * conformal->Update();
 * std::cout << "mean error of an edge: "
 *           << conformal->GetPieces()->GetValueByName(0, "EdgeLengthError").ToDouble() << "\n";
 * @endcode
 *
 * @warning Sewn edges come out with different lengths: not for patterns to cut.
 *
 * @sa vtkWireWarpingFilter vtkFlatteningQuality
 */
#ifndef vtkLeastSquaresConformalFilter_h
#define vtkLeastSquaresConformalFilter_h

#include "vtkFiltersFlatteningModule.h" // for the export macro
#include "vtkFlatPieceAlgorithm.h"

class VTKFILTERSFLATTENING_EXPORT vtkLeastSquaresConformalFilter : public vtkFlatPieceAlgorithm
{
public:
  static vtkLeastSquaresConformalFilter* New();
  vtkTypeMacro(vtkLeastSquaresConformalFilter, vtkFlatPieceAlgorithm)

  ///@{
  /**
   * The two points of the surface that are pinned; -1: the two boundary points that are farthest
   * apart (always so in a piece that has not both). Default: -1, -1.
   */
  vtkSetVector2Macro(Pins, vtkIdType);
  vtkGetVector2Macro(Pins, vtkIdType);
  ///@}

  ///@{
  /**
   * Divide the two equations of each triangle by the root of its area, as Levy et al. do, so that
   * every triangle counts by its area. Off, large triangles count more. Default: on.
   */
  vtkFlatteningFlagMacro(AreaNormalized);
  ///@}

protected:
  vtkLeastSquaresConformalFilter();
  ~vtkLeastSquaresConformalFilter() override = default;

  void AddOtherOptions(flattening::OptionValues& values) override;

  flattening::FlatteningOptions Settings() override;

private:
  vtkLeastSquaresConformalFilter(const vtkLeastSquaresConformalFilter&) = delete;
  void operator=(const vtkLeastSquaresConformalFilter&) = delete;
};

#endif
