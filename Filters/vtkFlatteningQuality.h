// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFlatteningQuality
 * @brief measure any flattening or parameterization of a surface
 *
 * **Port 0**, the surface in space. **Port 1**, optional, the flat surface: vtkPolyData with the
 * same points and cells, x and y its flat positions. Without it the active texture coordinates of
 * the surface are the flat positions; bring them to the unit of length first, since nothing is
 * scaled. **Port 2**, optional, the edges that E_len is taken over: line cells whose points have
 * exactly the coordinates of points of the surface (or all of them those of the flat surface); both
 * sides of a cut count. Without it those are the boundary edges.
 *
 * Ghost cells, triangles without size that touch no other and arrays that are too short are left
 * out, as vtkFeatureCurveAlgorithm does. Points
 * are taken as they are: a surface that is cut open is measured cut open. A map that turns
 * the whole surface over (the sum of signed areas is negative) is measured as if seen from behind.
 *
 * **Output 0**: the triangles of the surface over its points, in the order of its cells, with its
 * data and the cell arrays `HomogeneityOfDistortion`, `AspectRatio`, `AreaRatio`, `AngleError`
 * (double), `Flipped` (unsigned char), `vtkOriginalCellIds` (id). Field data: `OverlapEdges` (id, 4
 * components: the points of two boundary edges that cross, one row per pair; at most
 * MaximumOverlaps of all).
 *
 * **Output 1, the measures**: a vtkTable of one row, with the columns `EdgeLengthError`,
 * `MaxEdgeLengthError`, `EdgeLengthErrorAll`, `AngleErrorMean`, `GlobalHomogeneity`,
 * `GlobalAspectRatio`, `AreaError`, `StrainP95`, `RigidEnergy` (double), `FlippedTriangles`,
 * `Overlaps` (id), `OverlapsComplete` (int), `CutLength` (double; cuts are boundary edges whose
 * ends have exactly the coordinates in space of those of another one, each place counts once),
 * `Triangles`, `Vertices` (id), `Mirrored` (int, 1 where the map turned the surface over).
 * Meanings: see vtkFlatPieceAlgorithm. Flips and overlaps are a result here, not a warning.
 *
 * @code
 * vtkNew<vtkFlatteningQuality> quality;
 * quality->SetInputData(surface); // in space, with its flat positions as texture coordinates
 * quality->Update();
 * std::cout << quality->GetMeasures()->GetValueByName(0, "AreaError").ToDouble() << "\n";
 * @endcode
 *
 * @warning Texture coordinates between 0 and 1 are no lengths: scale them, or all areas are wrong.
 *
 * @sa vtkWireWarpingFilter vtkLeastSquaresConformalFilter
 */
#ifndef vtkFlatteningQuality_h
#define vtkFlatteningQuality_h

#include "vtkFiltersFlatteningModule.h" // for the export macro
#include "vtkFlatteningAlgorithm.h"

class vtkTable;

class VTKFILTERSFLATTENING_EXPORT vtkFlatteningQuality : public vtkFlatteningAlgorithm
{
public:
  static vtkFlatteningQuality* New();
  vtkTypeMacro(vtkFlatteningQuality, vtkFlatteningAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The flat surface, port 1.
   */
  void SetFlatConnection(vtkAlgorithmOutput* flat) { this->SetInputConnection(1, flat); }
  void SetFlatData(vtkPolyData* flat) { this->SetInputData(1, flat); }
  ///@}

  ///@{
  /**
   * The edges whose length counts, port 2.
   */
  void SetEdgesConnection(vtkAlgorithmOutput* edges) { this->SetInputConnection(2, edges); }
  void SetEdgesData(vtkPolyData* edges) { this->SetInputData(2, edges); }
  ///@}

  ///@{
  /**
   * Most pairs of crossing boundary edges that `OverlapEdges` lists; `Overlaps` counts all.
   * Default: 1000. Range: from 0.
   */
  vtkSetClampMacro(MaximumOverlaps, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumOverlaps, int);
  ///@}

  /**
   * Output 1, the measures.
   */
  vtkTable* GetMeasures();

protected:
  vtkFlatteningQuality();
  ~vtkFlatteningQuality() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkFlatteningQuality(const vtkFlatteningQuality&) = delete;
  void operator=(const vtkFlatteningQuality&) = delete;

  int MaximumOverlaps;
};

#endif
