// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFeatureCurveAlgorithm
 * @brief common base of the filters that take a surface with feature curves
 *
 * **Port 0**, the surface: vtkPolyData of polygons and triangle strips. Polygons and strips are
 * triangulated, triangles that run the wrong way are turned over, and points with equal coordinates
 * are joined where CoincidentPoints says so. Vertex cells are ignored, and so are ghost cells:
 * those that the cell array `vtkGhostType` marks as hidden or as copies of another process's
 * (DUPLICATECELL). Ids are those of the input all the same.
 *
 * Arrays of points and cells that are shorter than these are left out of the outputs, with a
 * warning that names them.
 *
 * **Port 1**, optional and repeatable, the feature curves: the line cells of each vtkPolyData, with
 * points on the surface. **Line cells of the surface's own vtkPolyData are feature curves as
 * well**, so that a file, or a block of a composite data set, carries a piece with its curves.
 * Composite data sets are iterated over port 0; a curve on port 1 belongs to every block then, so
 * let blocks carry their own. A composite data set on port 1 is all of its leaves.
 *
 * Every polyline of three or more points is one curve. Two-point lines of one data set that agree
 * in all of the cell arrays below are joined end to end first, up to points where other than two of
 * them meet, so that the output of vtkFeatureEdges gives long curves and not one an edge.
 *
 * | array | on | meaning |
 * |---|---|---|
 * | `CurveType` | cells | integer 0 accessory, 1 key, 2 dart, 3 seam, or a string array of these names. No array: accessory |
 * | `CurveName` | cells, string | name in messages and reports. No array, or an empty name: "curve N", N counting all curves from 0, those of the surface's own data set first |
 * | `KeyShape` | cells, integer | shape of a key curve in the plane: 0 what its angles on the surface give, 1 a straight line. No array: 0 |
 * | `LengthTolerance` | cells | how far lengths may go from those on the surface, as a fraction, in [0, 1); a seam between pieces gets the mean of what they would choose, on both sides. No array: 0, the curve is rigid |
 * | `LengthEase` | cells | ease: by how much the curve is longer in one piece than on the surface, as a fraction, in (-1, 1), not beyond `LengthTolerance`; what it is sewn to keeps the length of the surface. No array: 0 |
 * | `EasedPiece` | cells, integer | that piece, from 0; -1, or no array: the only one that the curve is in |
 * | `PlanarShape` | points, 2 components | planar polyline whose turning angles a key curve takes; NaN: none at this point. A curve with the shape at each of its points takes it |
 *
 * A value that is not in this table is refused with the id of its cell or point (INVALID_CURVE).
 *
 * What they have in common:
 * @code
 * vtkNew<vtkWireWarpingFilter> flattening;
 * flattening->SetInputData(surface);
 * flattening->SetCurvesData(curves);
 * flattening->AddCurveTolerance("side seam", 0.02); // may be eased by 2 %
 * flattening->SetImprintTolerance(5e-3);            // picked a little off the surface
 * flattening->Update();
 * @endcode
 *
 * @warning Curves on port 1 are those of every block; a surface in several partitions is refused.
 *
 * @sa vtkFlatteningAlgorithm vtkWireWarpingFilter vtkFeatureCurveCutter
 * vtkFeatureCurveImprinter vtkLeastSquaresConformalFilter
 */
#ifndef vtkFeatureCurveAlgorithm_h
#define vtkFeatureCurveAlgorithm_h

#include "vtkFiltersFlatteningModule.h" // for the export macro
#include "vtkFlatteningAlgorithm.h"

#include <map>    // for the tolerances
#include <memory> // for the loaded input
#include <string> // for their names

namespace flattening
{
namespace bridge
{
struct ConnectedCurves;
struct CurvedPolyData;
struct KeptRun;
}
struct FlatteningCache;
struct FlatteningOptions;
}

class VTKFILTERSFLATTENING_EXPORT vtkFeatureCurveAlgorithm : public vtkFlatteningAlgorithm
{
public:
  vtkTypeMacro(vtkFeatureCurveAlgorithm, vtkFlatteningAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Types of feature curves, the values of the array `CurveType`.
   */
  enum CurveTypes
  {
    ACCESSORY = 0,
    KEY = 1,
    DART = 2,
    SEAM = 3
  };

  ///@{
  /**
   * The feature curves, port 1. Each connection may hold several curves.
   */
  void SetCurvesConnection(vtkAlgorithmOutput* curves) { this->SetInputConnection(1, curves); }
  void AddCurvesConnection(vtkAlgorithmOutput* curves) { this->AddInputConnection(1, curves); }
  void SetCurvesData(vtkPolyData* curves) { this->SetInputData(1, curves); }
  void RemoveAllCurves() { this->RemoveAllInputConnections(1); }
  ///@}

  /// Whether points of the surface with equal coordinates are one.
  enum CoincidentPointsModes
  {
    AUTOMATIC = 0,
    JOIN = 1,
    KEEP = 2
  };

  ///@{
  /**
   * Whether points of the surface with equal coordinates are one: JOIN, as wanted where a file has
   * a point twice along a texture seam; KEEP, where edges meet in space without being sewn;
   * AUTOMATIC, joined only where hardly any two triangles share a point, as in files of separate
   * triangles. Default: AUTOMATIC.
   */
  vtkFlatteningWordMacro(CoincidentPoints);
  void SetCoincidentPointsToAutomatic() { this->SetCoincidentPoints(AUTOMATIC); }
  void SetCoincidentPointsToJoin() { this->SetCoincidentPoints(JOIN); }
  void SetCoincidentPointsToKeep() { this->SetCoincidentPoints(KEEP); }
  ///@}

  ///@{
  /**
   * Heal defects of the surface where it is clear how, and warn of what was done: points that are
   * collapsed onto neighbors, triangles without area or doubled, fins and edges of more than two
   * triangles, points in which parts touch, specks. Off: all of them are refused. Default: on.
   */
  vtkFlatteningFlagMacro(HealSurface);
  ///@}

  ///@{
  /**
   * Split triangles where a curve does not run along mesh edges; off: such a curve is refused
   * (CURVE_NOT_ON_EDGES). Default: on.
   */
  vtkFlatteningFlagMacro(SplitTriangles);
  ///@}

  ///@{
  /**
   * Greatest distance of a curve's point from the surface, as a fraction of the diagonal of the
   * surface's bounding box. A point farther away is refused (CURVE_POINT_OFF_SURFACE), and the
   * message gives the fraction that takes it. The default takes points as pickers and splines give
   * them. Default: 2e-3. Range: [0, 1].
   */
  vtkFlatteningNumberMacro(ImprintTolerance, double);
  ///@}

  ///@{
  /**
   * A curve's point or crossing that is nearer to a vertex or an edge than this fraction of the
   * mean edge length, or of the longest edge of the triangles there where that is shorter, moves
   * onto it, so that no sliver arises; in triangles too thin to be split the distance is raised. A
   * point within ImprintTolerance of a vertex moves onto it from up to 1 % of that length, however
   * small the fraction. Default: 1e-3. Range: [0, 0.5].
   */
  vtkFlatteningNumberMacro(SnapTolerance, double);
  ///@}

  ///@{
  /**
   * Length tolerance of all curves of a name, in place of `LengthTolerance`. The name may also be
   * the "curve N" that a curve without a name is given, or "boundary" for what is left of the
   * surface's own, of which each stretch between ends of other wires gets a length of its own.
   * Default: none. Range: [0, 1); a value outside and a name that no curve has are refused
   * (INVALID_OPTION).
   */
  void AddCurveTolerance(const std::string& curve, double tolerance);
  void RemoveAllCurveTolerances();
  ///@}

  /**
   * The connection of port 1 whose data set holds the curve for which the last run was refused,
   * from 0; -1 where that was no curve, or one of the surface's own data set.
   */
  int GetStatusConnection() const { return this->StatusConnection; }

  ///@{
  /**
   * Keep between updates what depends on the surface and the place of its curves alone: the
   * surface as it was read, the curves imprinted on it, and, until other curves are cut, the
   * pieces, their wires, measures and the factors of the systems that place their inside. An update
   * after a change of a curve's type, shape or tolerance, or of the scheme, is then faster; the
   * result is the same to the last bit. Off gives the memory back at the next update. Default: on.
   */
  vtkSetMacro(Caching, bool);
  vtkGetMacro(Caching, bool);
  vtkBooleanMacro(Caching, bool);
  ///@}

  ///@{
  /**
   * Precision of the points of the outputs, one of vtkAlgorithm::DesiredOutputPrecision:
   * DOUBLE_PRECISION; SINGLE_PRECISION, for viewers and files that want no more: the points are
   * rounded last of all, by up to 6e-8 of a coordinate, and every array, measure and status is that
   * of the result before; DEFAULT_PRECISION, the same as DOUBLE_PRECISION whatever the input has,
   * since exact lengths need it. Patterns to cut are to be written from points in double precision.
   * Default: DEFAULT_PRECISION.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  const char* GetOutputPointsPrecisionAsString() const;
  ///@}

protected:
  vtkFeatureCurveAlgorithm();
  ~vtkFeatureCurveAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void BeginRun(vtkInformationVector** inputVector) override;
  void FinishData(vtkInformationVector* outputVector) override;

  /**
   * Reads surface and curves. Null after a refusal, which has been told then.
   */
  std::shared_ptr<flattening::bridge::CurvedPolyData> LoadInput(vtkInformationVector** inputVector);

  /**
   * What the run before this one kept of the pieces; null without Caching.
   */
  flattening::FlatteningCache* KeptPieces() const;

  // Options have the defaults of the algorithms.
  bool Caching = true;
  int OutputPointsPrecision = DEFAULT_PRECISION;
  std::map<std::string, double> CurveTolerances;

private:
  vtkFeatureCurveAlgorithm(const vtkFeatureCurveAlgorithm&) = delete;
  void operator=(const vtkFeatureCurveAlgorithm&) = delete;

  std::unique_ptr<flattening::bridge::KeptRun> Kept;
  std::unique_ptr<flattening::bridge::ConnectedCurves> Gathered; // in a run
  int StatusConnection = -1;
};

#endif
