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
 * Inputs: see vtkFeatureCurveAlgorithm. Outputs, arrays and field data: those of
 * vtkWireWarpingFilter.
 *
 * The method is that of B. Levy, S. Petitjean, N. Ray, J. Maillot, "Least squares conformal maps
 * for automatic texture atlas generation", ACM Transactions on Graphics 21(3), 2002,
 * https://doi.org/10.1145/566654.566590.
 *
 * @code
 * vtkNew<vtkLeastSquaresConformalFilter> conformal;
 * conformal->SetInputData(surface);
 * conformal->Update();
 * vtkFieldData* measures = conformal->GetOutput()->GetFieldData();
 * std::cout << "mean error of an edge: " << measures->GetArray("EdgeLengthError")->GetRange()[1]
 *           << "\n";
 * @endcode
 *
 * @warning Sewn edges come out with different lengths: not for patterns to cut.
 *
 * @sa vtkWireWarpingFilter vtkFlatteningQuality
 */
#ifndef vtkLeastSquaresConformalFilter_h
#define vtkLeastSquaresConformalFilter_h

#include "vtkFeatureCurveAlgorithm.h"
#include "vtkFiltersFlatteningModule.h" // for the export macro

class VTKFILTERSFLATTENING_EXPORT vtkLeastSquaresConformalFilter : public vtkFeatureCurveAlgorithm
{
public:
  static vtkLeastSquaresConformalFilter* New();
  vtkTypeMacro(vtkLeastSquaresConformalFilter, vtkFeatureCurveAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

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
  vtkSetMacro(AreaNormalized, bool);
  vtkGetMacro(AreaNormalized, bool);
  vtkBooleanMacro(AreaNormalized, bool);
  ///@}

  ///@{
  /**
   * Leave out pieces that cannot be laid flat, since they have no boundary or have handles, and
   * flatten the others; a warning and the field data `LeftOutCells` name them. Off: the surface is
   * refused for them (CLOSED_SURFACE, HANDLE), as it is where nothing would remain. Default: off.
   */
  vtkSetMacro(SkipClosed, bool);
  vtkGetMacro(SkipClosed, bool);
  vtkBooleanMacro(SkipClosed, bool);
  ///@}

  ///@{
  /**
   * Lay the pieces beside each other, see vtkWireWarpingFilter::SetArrange(). Default: on.
   */
  vtkSetMacro(Arrange, bool);
  vtkGetMacro(Arrange, bool);
  vtkBooleanMacro(Arrange, bool);
  ///@}

  ///@{
  /**
   * Lay the flat pieces to the right of the surface, at half its height, so that a viewer shows
   * both, and those of the blocks of a composite data set in rows beside each other; z stays 0, and
   * measures, lengths and `FlatPositions` are those of the pieces before they were moved. Off: each
   * surface's pieces start from the origin, over those of other blocks. Default: off.
   */
  vtkSetMacro(BesideSurface, bool);
  vtkGetMacro(BesideSurface, bool);
  vtkBooleanMacro(BesideSurface, bool);
  ///@}

  ///@{
  /**
   * Space between the bounding boxes of arranged pieces, as a fraction of the largest side of one.
   * Default: 0.05. Range: 0 to 1e6.
   */
  vtkSetClampMacro(Spacing, double, 0.0, 1e6);
  vtkGetMacro(Spacing, double);
  ///@}

protected:
  vtkLeastSquaresConformalFilter();
  ~vtkLeastSquaresConformalFilter() override;

  void EndRun(vtkDataObject* input, vtkDataObject* output) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkLeastSquaresConformalFilter(const vtkLeastSquaresConformalFilter&) = delete;
  void operator=(const vtkLeastSquaresConformalFilter&) = delete;

  vtkIdType Pins[2] = { -1, -1 };
  bool AreaNormalized;
  bool SkipClosed;
  bool BesideSurface = false;
  bool Arrange;
  double Spacing;
};

#endif
