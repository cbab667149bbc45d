// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceCurve
 * @brief draw a feature curve on a surface through control points
 *
 * Control points are picked, and lie a little off the surface as a rule: each means the point of
 * the surface that is closest to it, however far it is. Between them the curve runs over the
 * surface, as SegmentKind says. The output goes into port 1 of vtkWireWarpingFilter as it is.
 *
 * **Port 0**, the surface: vtkPolyData of polygons and triangle strips, as in
 * vtkFeatureCurveAlgorithm. Its line cells are no control points.
 *
 * **Port 1**, optional: vtkPolyData with control points; each polyline is a curve of its own, and
 * without polylines all points, in their order, are one. Without port 1 the points of this object
 * are taken, see SetControlPoint().
 *
 * **Output**: the curves as polylines on the surface, with the cell arrays `CurveType`,
 * `CurveName`, `KeyShape` and `LengthTolerance` of vtkFeatureCurveAlgorithm, and what
 * vtkFeatureCurveEditor needs to go on editing them: `CurveImageOf` and the field data
 * `ControlPoints`, `ControlPointCurve`, `ControlPointKind` and `MirrorPlane`. Several curves of one
 * name get numbers behind it. After a refusal the output is without points and cells. Codes beside
 * those of the surface: NON_FINITE_POINT, CURVE_TOO_SHORT (fewer than two different control points,
 * three of a closed curve that is no section), CURVE_LEAVES_SURFACE (control points on parts of the
 * surface that are not connected, or that no section joins; no point at the Offset),
 * INVALID_OPTION.
 *
 * @code
 * vtkNew<vtkSurfaceCurve> drawn;
 * drawn->SetInputData(surface);
 * drawn->SetNumberOfControlPoints(2);
 * drawn->SetControlPoint(0, 0.0, 0.0, 0.0);
 * drawn->SetControlPoint(1, 10.0, 20.0, 0.0);
 * drawn->SetCurveType(vtkFeatureCurveAlgorithm::DART);
 * vtkNew<vtkWireWarpingFilter> flattening;
 * flattening->SetInputData(surface);
 * flattening->AddCurvesConnection(drawn->GetOutputPort());
 * flattening->Update();
 * @endcode
 *
 * @warning A control point far from the surface still means its closest point, which may not be the
 * one that was meant.
 *
 * @sa vtkFeatureCurveEditor vtkFeatureCurveImprinter vtkWireWarpingFilter
 */
#ifndef vtkSurfaceCurve_h
#define vtkSurfaceCurve_h

#include "vtkFiltersFlatteningModule.h" // for the export macro
#include "vtkFlatteningAlgorithm.h"

#include <array>  // for control points
#include <memory> // for what is kept
#include <string> // for the name
#include <vector> // for control points

class vtkAlgorithmOutput;

class VTKFILTERSFLATTENING_EXPORT vtkSurfaceCurve : public vtkFlatteningAlgorithm
{
public:
  static vtkSurfaceCurve* New();
  vtkTypeMacro(vtkSurfaceCurve, vtkFlatteningAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The control points, port 1.
   */
  void SetControlPointsConnection(vtkAlgorithmOutput* points)
  {
    this->SetInputConnection(1, points);
  }
  void SetControlPointsData(vtkPolyData* points) { this->SetInputData(1, points); }
  ///@}

  ///@{
  /**
   * The control points where nothing is connected to port 1. New ones are at the origin.
   */
  void SetNumberOfControlPoints(int number);
  int GetNumberOfControlPoints() const { return static_cast<int>(this->ControlPoints.size()); }
  void SetControlPoint(int id, double x, double y, double z);
  void GetControlPoint(int id, double point[3]) const;
  ///@}

  /// How the curve gets from one control point to the next.
  enum SegmentKinds
  {
    GEODESIC = 0,
    SECTION = 1,
    EDGES = 2,
    SPLINE = 3
  };

  ///@{
  /**
   * GEODESIC, by the straight path over the surface, the shortest there is nearby; SECTION, in the
   * plane through both and the surface's normal, and round the surface as a measuring tape where a
   * closed curve has two or three control points; EDGES, by the shortest way along edges of the
   * mesh; SPLINE, smoothly through all of them. Default: GEODESIC.
   */
  vtkSetClampMacro(SegmentKind, int, GEODESIC, SPLINE);
  vtkGetMacro(SegmentKind, int);
  const char* GetSegmentKindAsString() const;
  ///@}

  ///@{
  /**
   * Go on from the last control point to the first. Default: off.
   */
  vtkSetMacro(Closed, bool);
  vtkGetMacro(Closed, bool);
  vtkBooleanMacro(Closed, bool);
  ///@}

  ///@{
  /**
   * Pull a closed curve tight, as a rubber band that cannot leave the surface comes to rest: the
   * shortest curve that it can be moved to, such as the waist of a body between two girths. Control
   * points say only round what it runs. Default: off. Refused where the curve is open
   * (INVALID_OPTION) or shrinks to a point (CURVE_TOO_SHORT).
   */
  vtkSetMacro(Tight, bool);
  vtkGetMacro(Tight, bool);
  vtkBooleanMacro(Tight, bool);
  ///@}

  ///@{
  /**
   * Draw the curve at this distance from the one through the control points in its place, measured
   * over the surface, in the unit of its coordinates: above 0 on the left of who walks along the
   * control points on the outside, below 0 on the right; 0: the curve itself. As
   * vtkFeatureCurveEditor::AddOffset(), as several curves where the boundary interrupts it.
   * Default: 0. Refused where no point is that far (CURVE_LEAVES_SURFACE), and where it is not
   * finite (INVALID_OPTION).
   */
  vtkSetMacro(Offset, double);
  vtkGetMacro(Offset, double);
  ///@}

  ///@{
  /**
   * The array `CurveType` of the output: 0 accessory, 1 key, 2 dart, 3 seam. Default: 0.
   */
  vtkSetClampMacro(CurveType, int, 0, 3);
  vtkGetMacro(CurveType, int);
  const char* GetCurveTypeAsString() const;
  ///@}

  ///@{
  /**
   * The array `CurveName` of the output. Default: empty.
   */
  void SetCurveName(const std::string& name);
  std::string GetCurveName() const { return this->CurveName; }
  ///@}

  ///@{
  /**
   * The array `KeyShape` of the output: 0 what the angles on the surface give, 1 a straight line.
   * Default: 0.
   */
  vtkSetClampMacro(KeyShape, int, 0, 1);
  vtkGetMacro(KeyShape, int);
  const char* GetKeyShapeAsString() const;
  ///@}

  ///@{
  /**
   * The array `LengthTolerance` of the output. Default: 0. Range: [0, 0.99].
   */
  vtkSetClampMacro(LengthTolerance, double, 0.0, 0.99);
  vtkGetMacro(LengthTolerance, double);
  ///@}

  ///@{
  /**
   * Draw the image of each curve in the mirror plane as well, as a curve of its own. Default: off.
   */
  vtkSetMacro(Mirror, bool);
  vtkGetMacro(Mirror, bool);
  vtkBooleanMacro(Mirror, bool);
  ///@}

  ///@{
  /**
   * A point of the mirror plane, and its normal, which need not have length 1; one of no length is
   * refused (INVALID_OPTION). Default: 0.0, 0.0, 0.0 and 1.0, 0.0, 0.0.
   */
  vtkSetVector3Macro(MirrorOrigin, double);
  vtkGetVector3Macro(MirrorOrigin, double);
  vtkSetVector3Macro(MirrorNormal, double);
  vtkGetVector3Macro(MirrorNormal, double);
  ///@}

protected:
  vtkSurfaceCurve();
  ~vtkSurfaceCurve() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSurfaceCurve(const vtkSurfaceCurve&) = delete;
  void operator=(const vtkSurfaceCurve&) = delete;

  std::vector<std::array<double, 3>> ControlPoints;
  int SegmentKind = GEODESIC;
  bool Closed = false;
  bool Tight = false;
  double Offset = 0.0;
  int CurveType = 0;
  std::string CurveName;
  int KeyShape = 0;
  double LengthTolerance = 0.0;
  bool Mirror = false;
  double MirrorOrigin[3] = { 0.0, 0.0, 0.0 };
  double MirrorNormal[3] = { 1.0, 0.0, 0.0 };

  class Kept;
  std::unique_ptr<Kept> Drawn; ///< the surface of the last run, ready to draw on
};

#endif
