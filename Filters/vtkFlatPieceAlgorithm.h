// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFlatPieceAlgorithm
 * @brief common base of the filters that flatten a surface with feature curves
 *
 * Inputs: see vtkFeatureCurveAlgorithm.
 *
 * **Output 0, the flat pieces**: z = 0; the triangles of the input in the order of its cells (those
 * of one polygon consecutive), counter-clockwise, with the input's point data, cell data and field
 * data. **Output 1, the wires** in the plane: polylines over the points of output 0. **Output 2,
 * the cut surface** in space: point for point and cell for cell like output 0, with the same arrays
 * and the flat positions as active texture coordinates (`FlatPositions`, in the unit of length).
 * **Output 3, the pieces**, and **output 4, the curves**: a vtkTable with one row per piece
 * (`Piece`, `Status`, `Name`, ...) and one with one row per feature curve (`Curve`, `Name`,
 * `Type`, ...).
 *
 * The main arrays and columns; Documentation/outputs.md has all of them:
 *
 * | array | in | type | meaning |
 * |---|---|---|---|
 * | `HomogeneityOfDistortion` | 0, 2 cells | double | min(a, 1/a) with a = flat area / area on the surface; 1 is ideal, 0 where flipped |
 * | `PieceId` | 0, 2 cells | id | row of output 3 |
 * | `vtkOriginalCellIds` | 0, 2 cells | id | cell of the input |
 * | `vtkOriginalPointIds` | 0, 2 points | id | point of the input; -1 for a point made by imprinting |
 * | `SeamPairs` | 0 field | id, 5 components | one row per pair of cut edges: the edge between points 0 and 1 is sewn to that between points 2 and 3; component 4 is the row of output 4 |
 * | `CurveId` | 1 cells | id | row of output 4; -1 for boundary and connectors |
 * | `EdgeLengthError`, `MaxEdgeLengthError` | 3 | double | mean and largest relative error of wire edges (E_len, Eq. 26) |
 * | `EdgeLengthErrorAll` | 3 | double | mean relative error of all edges of the mesh |
 * | `AreaError` | 3 | double | sum of abs(flat area - area) / sum of area |
 * | `StrainP95` | 3 | double | strain that is not exceeded on 95 % of the area |
 * | `RestLength`, `FlatLength` | 4 | double | length on the surface and in the plane |
 *
 * Field data of the outputs holds only what other filters read: `LengthUnit`, `SeamPairs`,
 * `SeamClosed`, `OverlapEdges`, `GrainAngle` and `SheetMaterial` (with a material), `RunStatus` and
 * `RunStatusMessage` of output 0. A list without rows is no array.
 *
 * Without a result the outputs have no points and cells, and output 3 has one row, with `Piece` -1,
 * `Status` and `StatusMessage`.
 *
 * @code
 * vtkNew<vtkWireWarpingFilter> flattening;
 * flattening->SetInputData(surface);
 * flattening->Update();
 * vtkNew<vtkDelimitedTextWriter> writer;
 * writer->SetInputConnection(flattening->GetOutputPort(3));
 * writer->SetFileName("pieces.csv");
 * writer->Write();
 * @endcode
 *
 * @warning With composite input the tables are those of each block, so that `Piece` counts from 0
 * in each, and tables from methods are those of the block that ran last.
 *
 * @sa vtkWireWarpingFilter vtkLeastSquaresConformalFilter
 */
#ifndef vtkFlatPieceAlgorithm_h
#define vtkFlatPieceAlgorithm_h

#include "vtkFeatureCurveAlgorithm.h"
#include "vtkFiltersFlatteningModule.h" // for the export macro
#include "vtkSmartPointer.h"            // for the reports
#include "vtkTable.h"                   // for the reports

#include <string> // for the texts
#include <vector> // for the grain

namespace flattening
{
struct FlatteningOptions;
struct FlatteningResult;
struct FlatteningRun;
struct ReportTables;
}

class VTKFILTERSFLATTENING_EXPORT vtkFlatPieceAlgorithm : public vtkFeatureCurveAlgorithm
{
public:
  vtkTypeMacro(vtkFlatPieceAlgorithm, vtkFeatureCurveAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Outputs 3 and 4, the tables of pieces and of feature curves.
   */
  vtkTable* GetPieces();
  vtkTable* GetCurves();
  ///@}

  ///@{
  /**
   * The iterations of the last run: of the wires' angles, with the columns `Piece`, `Phase`,
   * `Objective` (rad^2), `Closure` (fraction of the perimeter), `Optimality` (largest entry of the
   * gradient of the Lagrangian) and `Step` (radians, root mean square); and of the whole piece by
   * scheme ISOMETRIC, with `Piece`, `Exact` (1 where the Hessian was exact, 0 its convex part),
   * `Energy` (in mean triangle areas), `LengthError` (largest, in roots of the mean triangle area),
   * `Optimality` and `Move` (of the vertex that moved farthest, in the same unit).
   */
  vtkTable* GetAngleIterations() const { return this->AngleIterations; }
  vtkTable* GetIsometricIterations() const { return this->IsometricIterations; }
  ///@}

  /**
   * What to release where a piece lies poorly, for each piece the best first: `Piece`, `Name` and
   * `Curve` (row of output 4), `Shape` (1: of a key curve its shape alone, 0: the curve as a
   * whole), `Tried`, and `Objective`, `AreaError` and `Homogeneity` of the piece flattened without
   * that by the same options; -1 where it was not tried or has no solution.
   */
  vtkTable* GetReleases() const { return this->Releases; }

  /**
   * The remedies of the pieces' statuses, the best first: `Piece`, `Remedy` (see
   * GetRemedySentence()) and `Subject`.
   */
  vtkTable* GetPieceRemedies() const { return this->PieceRemedies; }

  /**
   * The pieces that SkipClosed left out: `Reason` ("ClosedSurface" or "Handle"), `Cell` (the first
   * of its cells in the input) and `Triangles`.
   */
  vtkTable* GetLeftOutPieces() const { return this->LeftOutPieces; }

  /**
   * A sentence on pieces that are unusually small or large for the unit of length; empty for none.
   * Where the unit is stated it is a warning as well.
   */
  vtkGetCharFromStdStringMacro(SizeWarning);

  /**
   * The seconds that the last run took: for wires, interior and quality, and in total.
   */
  vtkGetVector4Macro(Seconds, double);

  ///@{
  /**
   * Leave out pieces that cannot be laid flat, since they have no boundary or have handles, and
   * flatten the others; a warning and GetLeftOutPieces() name them. Off: the surface is an error
   * for them (CLOSED_SURFACE, HANDLE), as it is where nothing would remain. Default: off.
   */
  vtkFlatteningFlagMacro(SkipClosed);
  ///@}

  ///@{
  /**
   * Close darts and other cuts where their banks would lie over each other, which they do where
   * the surface is saddle-like: the closed parts of the two banks then lie on each other, at the
   * price of more distortion, and do not count as `Boundary`; patterns are whole there. Off: they
   * overlap, and the status is OVERLAP. Default: off.
   */
  vtkFlatteningFlagMacro(CloseCuts);
  ///@}

  ///@{
  /**
   * What the pieces are cut from: the name of a material that ListMaterials() knows, or a JSON file
   * with its numbers (see Documentation/materials.md). ISOMETRIC then minimizes the energy of its
   * threads instead of DistortionEnergy, and keeps their strains within its limits where lengths
   * allow; other schemes, the conformal map, and the material "isotropic" only measure what the
   * threads would have to do. A material that is unknown or without meaning is refused
   * (INVALID_OPTION); strains that stay beyond the limits on more than 5 % of a piece's area mark
   * it BEYOND_LIMITS. Default: empty, no material.
   */
  vtkFlatteningTextMacro(Material);
  ///@}

  ///@{
  /**
   * A JSON file of a material, which then counts instead of Material: for panels that list the
   * materials known by name. Default: empty.
   */
  void SetMaterialFile(const char* path);
  vtkGetCharFromStdStringMacro(MaterialFile);
  ///@}

  ///@{
  /**
   * How pieces lie on the material: an angle in degrees from the upright of the piece to the warp,
   * counter-clockwise in the plane (upright is its first key curve from start to end, else the long
   * side of the smallest rectangle around the piece as it lies without the material); the name of a
   * curve, along which the warp runs from its start to its end, or NAME:DEGREES at an angle from
   * it; several of these, of which each piece takes the first that lies in it; or "free", the angle
   * at which the material is strained least. A piece without any of the curves is laid by its
   * upright and marked MISSING_GRAIN. Default: none, upright.
   */
  void AddGrain(const std::string& grain);
  void RemoveAllGrains();
  ///@}

  /**
   * The materials that are known by name, a row each: `Name`, `Description` (string), `Warp`,
   * `Weft`, `Shear` (stiffness in N/m), `Compression` (over that in tension), `WarpLeast`,
   * `WarpGreatest`, `WeftLeast`, `WeftGreatest` (limits of strains, in percent), `ShearLimit`
   * (degrees) (double; -1 or infinite where there is none), `OneWay`, `Sheet` (int; its edges
   * do not fray), `Source` (string; of the numbers).
   */
  static void ListMaterials(vtkTable* materials);

  ///@{
  /**
   * Turn the pieces upright (the grainline, which is the first key curve from its start to its end,
   * along y, else the long side of the smallest rectangle around the piece) and lay them in rows
   * beside each other without overlap of their bounding boxes. Off: each stays where its first wire
   * edge put it. Default: on.
   */
  vtkFlatteningFlagMacro(Arrange);
  ///@}

  ///@{
  /**
   * Space between the bounding boxes of arranged pieces, as a fraction of the largest side of one.
   * Default: 0.05. Range: 0 to 1e6.
   */
  vtkFlatteningNumberMacro(Spacing, double);
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

protected:
  vtkFlatPieceAlgorithm();
  ~vtkFlatPieceAlgorithm() override = default;

  void FinishData(vtkInformationVector* outputVector) override;
  void EndRun(vtkDataObject* input, vtkDataObject* output) override;

  /**
   * What the properties say, for Core.
   */
  virtual flattening::FlatteningOptions Settings();

  /**
   * Name of input array 0, and whether it holds weights that the run can use.
   */
  const char* WeightName();
  bool Weigh(flattening::FlatteningRun& run, const flattening::bridge::CurvedPolyData& source);

  /**
   * Flattens surface and curves into the five outputs.
   */
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /**
   * Tells how a run ended, and writes its result, null for none, to the five outputs. Returns
   * whether there is one.
   */
  bool TakeResult(const flattening::FlatteningRun& run,
    const flattening::bridge::CurvedPolyData& source, const flattening::FlatteningResult* result,
    const flattening::FlatteningOptions& options, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector);

  vtkIdType Pins[2] = { -1, -1 }; ///< of the conformal map

private:
  vtkFlatPieceAlgorithm(const vtkFlatPieceAlgorithm&) = delete;
  void operator=(const vtkFlatPieceAlgorithm&) = delete;

  void KeepTables(const flattening::ReportTables& tables);

  // Of the last run.
  vtkSmartPointer<vtkTable> AngleIterations;
  vtkSmartPointer<vtkTable> IsometricIterations;
  vtkSmartPointer<vtkTable> Releases;
  vtkSmartPointer<vtkTable> PieceRemedies;
  vtkSmartPointer<vtkTable> LeftOutPieces;
  std::string SizeWarning;
  double Seconds[4] = { 0.0, 0.0, 0.0, 0.0 };
  // Options have the defaults of the algorithms.
  std::string MaterialFile;
  std::vector<std::string> Grain;
  bool BesideSurface = false;
};

#endif
