// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFeatureCurveEditor
 * @brief draw and change feature curves on a surface, without a window
 *
 * The model behind a program in which feature curves are drawn: a list of curves, each with *nodes*
 * on the surface and *segments* between them, commands that change it, and undo and redo without
 * limit. vtkFeatureCurveWidget works on it by mouse; a script may do so by these commands alone.
 *
 * Every place is given as a point in space, and means the point of the surface that is closest to
 * it. Curves, nodes and segments are counted from 0; segment k starts at node k. A command that
 * cannot be carried out changes nothing, returns false, and GetMessage() says why; asking for a
 * curve, node or segment that is not there gives 0, and an empty name.
 *
 * GetCurves() gives the curves as polylines on the surface, with the cell arrays that
 * vtkFeatureCurveAlgorithm documents, so that they go into port 1 of the filters as they are.
 * Beside them are what SetCurves() needs to make them editable again, in a file as well:
 *
 * | array | on | type | meaning |
 * |---|---|---|---|
 * | `CurveImageOf` | cells | id | the cell that this one is the mirror image of; -1: drawn itself |
 * | `ControlPoints` | field, 3 components | double | nodes of all curves, curve by curve |
 * | `ControlPointCurve` | field | id | cell that the node belongs to |
 * | `ControlPointKind` | field | int | SegmentKinds of the segment that starts there |
 * | `MirrorPlane` | field, 6 components | double | origin and normal; no array: there is none |
 *
 * A polyline without control points gets a node at each of its points.
 *
 * ModifiedEvent is invoked after each change.
 *
 * @code
 * vtkNew<vtkFeatureCurveEditor> editor;
 * if (!editor->SetSurface(surface) || !editor->SetCurves(curves))
 * {
 *   std::cerr << editor->GetMessage() << "\n";
 * }
 * vtkNew<vtkPolyData> edited;
 * editor->GetCurves(edited);
 * std::cout << edited->GetNumberOfLines() << " curves\n";
 * @endcode
 *
 * @warning Not a filter: it does not follow later changes of the surface that it was given.
 *
 * @sa vtkFeatureCurveAlgorithm vtkWireWarpingFilter
 */
#ifndef vtkFeatureCurveEditor_h
#define vtkFeatureCurveEditor_h

#include "vtkFiltersFlatteningModule.h" // for the export macro
#include "vtkObject.h"

#include <memory> // for the model
#include <string> // for names

class vtkPoints;
class vtkPolyData;
namespace flattening
{
namespace bridge
{
class CurveEditorModel;
}
}

class VTKFILTERSFLATTENING_EXPORT vtkFeatureCurveEditor : public vtkObject
{
public:
  static vtkFeatureCurveEditor* New();
  vtkTypeMacro(vtkFeatureCurveEditor, vtkObject)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How a curve gets from one node to the next: GEODESIC, by the straight path over the surface;
   * SECTION, in the plane through both nodes and the surface's normal, as the filters lay a
   * polyline onto a surface, and round the surface through all nodes where a closed curve has two
   * or three; EDGES, by the shortest way along edges; SPLINE, smoothly through all nodes.
   */
  enum SegmentKinds
  {
    GEODESIC = 0,
    SECTION = 1,
    EDGES = 2,
    SPLINE = 3
  };

  /**
   * What a point may snap to.
   */
  enum SnapTargets
  {
    NOTHING = 0,
    BOUNDARY = 1,
    CORNER = 2,
    VERTEX = 3,
    CURVE = 4,
    DART_TIP = 5,
    MIRROR_PLANE = 6
  };

  /**
   * The surface to draw on; a copy is kept, with defects healed as filters heal them, which
   * GetMessage() tells. Forgets all curves, and the past. False, and nothing changes, where it is
   * no surface that can be drawn on.
   */
  bool SetSurface(vtkPolyData* surface);

  /**
   * What the last command has to say: why it was refused, or what is odd about what it did.
   */
  const char* GetMessage() const { return this->Message.c_str(); }

  ///@{
  /**
   * The curves as they are.
   */
  int GetNumberOfCurves() const;
  std::string GetCurveName(int curve) const;
  int GetCurveType(int curve) const;         ///< vtkFeatureCurveAlgorithm::CurveTypes
  int GetCurveKeyShape(int curve) const;     ///< the values of the array `KeyShape`
  double GetCurveTolerance(int curve) const; ///< the values of the array `LengthTolerance`
  double GetCurveEase(int curve) const;      ///< the values of the array `LengthEase`
  int GetCurveEasedPiece(int curve) const;   ///< the values of the array `EasedPiece`
  bool GetCurveClosed(int curve) const;
  bool GetCurveMirrored(int curve) const;
  double GetCurveLength(int curve) const;
  int GetNumberOfNodes(int curve) const;
  void GetNode(int curve, int node, double point[3]) const;
  int GetNumberOfSegments(int curve) const;
  int GetSegmentKind(int curve, int segment) const;
  double GetSegmentLength(int curve, int segment) const;
  ///@}

  ///@{
  /**
   * Curves of two nodes or more as polylines on the surface, with control points; one curve alone
   * as it is drawn, with a cell for its image in the mirror.
   */
  void GetCurves(vtkPolyData* curves) const;
  void GetCurve(int curve, vtkPolyData* line) const;
  ///@}

  /**
   * Starts with other curves, those that GetCurves() gave or any polylines on the surface, and
   * forgets the past. Curves that are not on the surface are laid onto it; GetMessage() then names
   * the one that was farthest, where that is beyond the filters' default ImprintTolerance.
   */
  bool SetCurves(vtkPolyData* curves);

  ///@{
  /**
   * Add a curve through nodes, as the last one, and remove one. The name of a new curve is "curve"
   * with a number.
   */
  bool AddCurve(vtkPoints* nodes, int kind = GEODESIC, bool closed = false);
  bool RemoveCurve(int curve);
  ///@}

  /**
   * Add the curve at a distance from one, measured over the surface, with its type, tolerance and
   * key shape, and smooth where that one is: as one curve, or several where the boundary interrupts
   * it. Where the surface can be unrolled it is exact but for the rounding of corners, elsewhere
   * within 3 thousandths of the distance of points that straight lines reach which leave the curve
   * at right angles.
   * @param curve its number
   * @param distance in the unit of length; positive: on the left of who walks along the curve on
   * the outside, negative: on the right. Refused: 0, and where no point is that far
   */
  bool AddOffset(int curve, double distance);

  /**
   * Pull a closed curve tight, as a rubber band that cannot leave the surface comes to rest: the
   * shortest curve that it can be moved to over the surface. It gets other nodes, three as a rule.
   * @param curve its number. Refused: an open curve, and one that shrinks to a point
   */
  bool TightenCurve(int curve);

  /**
   * The distance of a point from a curve in the sense of AddOffset(); NaN where no way leads there.
   * @param curve its number
   * @param point near the surface
   */
  double GetDistance(int curve, const double point[3]) const;

  /**
   * Add a curve of few nodes along a stroke by hand, or along any polyline, as the last one; one
   * that ends within three times the tolerance of its start is closed.
   * @param stroke points near the surface, in their order
   * @param tolerance how far the curve may be from the stroke, in the unit of length; above 0
   * @param kind SPLINE, or GEODESIC, straight from node to node; others count as GEODESIC
   */
  bool AddStroke(vtkPoints* stroke, double tolerance, int kind = SPLINE);

  ///@{
  /**
   * Insert a node, which gets the number `node`; behind the last one the curve goes on. Move and
   * remove one; with its last node a curve goes.
   */
  bool InsertNode(int curve, int node, const double point[3], int kind = GEODESIC);
  bool MoveNode(int curve, int node, const double point[3]);
  bool RemoveNode(int curve, int node);
  ///@}

  ///@{
  /**
   * Close a curve from its last node to its first, or open it there; split it in two at an inner
   * node, a closed one open it at a node; append a curve to another where they are nearest to each
   * other; add a curve's mirror image as a curve of its own.
   */
  bool SetCurveClosed(int curve, bool closed);
  bool SplitCurve(int curve, int node);
  bool JoinCurves(int first, int second);
  bool AddMirrorImage(int curve);
  ///@}

  ///@{
  /**
   * What a curve is. A name is given once; a tolerance is in [0, 1). An ease is a fraction in
   * (-1, 1), 0 for none, in a piece from 0, or -1 for the only one that the curve is in; an image
   * in the mirror plane is eased alike where the piece is -1, and else not at all. Whether the
   * curve lies there, and may change by as much, is asked when it is flattened.
   */
  bool SetCurveName(int curve, const std::string& name);
  bool SetCurveType(int curve, int type);
  bool SetCurveKeyShape(int curve, int shape);
  bool SetCurveTolerance(int curve, double tolerance);
  bool SetCurveEase(int curve, double fraction, int piece);
  bool SetSegmentKind(int curve, int segment, int kind);
  ///@}

  ///@{
  /**
   * The mirror plane, and whether a curve has an image in it that follows all changes.
   */
  bool SetMirrorPlane(const double origin[3], const double normal[3]);
  bool RemoveMirrorPlane();
  bool HasMirrorPlane() const;
  bool SetCurveMirrored(int curve, bool mirrored);
  ///@}

  ///@{
  /**
   * Undo and redo commands; those of a group are undone as one, such as the moves of a drag.
   */
  bool CanUndo() const;
  bool CanRedo() const;
  void Undo();
  void Redo();
  void BeginGroup();
  void EndGroup();
  ///@}

  ///@{
  /**
   * How many commands Undo() can take back, and make those since there were `count` one, or none
   * where they came to nothing: so the nodes of a curve are undone one by one while it is drawn,
   * and the curve as a whole once it is there.
   */
  int GetNumberOfCommands() const;
  void JoinCommandsSince(int count);
  ///@}

  ///@{
  /**
   * What SnapPoint() heeds. Default: all on.
   */
  vtkSetMacro(SnapToBoundary, bool);
  vtkGetMacro(SnapToBoundary, bool);
  vtkBooleanMacro(SnapToBoundary, bool);
  vtkSetMacro(SnapToCorners, bool);
  vtkGetMacro(SnapToCorners, bool);
  vtkBooleanMacro(SnapToCorners, bool);
  vtkSetMacro(SnapToVertices, bool);
  vtkGetMacro(SnapToVertices, bool);
  vtkBooleanMacro(SnapToVertices, bool);
  vtkSetMacro(SnapToCurves, bool);
  vtkGetMacro(SnapToCurves, bool);
  vtkBooleanMacro(SnapToCurves, bool);
  vtkSetMacro(SnapToDartTips, bool);
  vtkGetMacro(SnapToDartTips, bool);
  vtkBooleanMacro(SnapToDartTips, bool);
  vtkSetMacro(SnapToMirrorPlane, bool);
  vtkGetMacro(SnapToMirrorPlane, bool);
  vtkBooleanMacro(SnapToMirrorPlane, bool);
  ///@}

  ///@{
  /**
   * The direction in which the user looks at the surface, for SnapPoint(), FindNode() and
   * FindSegment(): along it distances count a tenth, since who aims at the side of a surface misses
   * by much in depth. (0, 0, 0): all directions are alike. It is no change of the curves, and
   * invokes no event. Default: (0, 0, 0).
   */
  void SetViewDirection(const double direction[3]);
  vtkGetVector3Macro(ViewDirection, double);
  ///@}

  /**
   * The point of the surface that is meant by a point near it: what lies within reach, in the unit
   * of length, draws it onto itself. First come single points (dart tips, nodes, corners), then
   * lines (boundary, curves, mirror plane), last the vertices of the mesh.
   * @param point near the surface
   * @param reach how far things draw, in the unit of length
   * @param exceptCurve the curve whose node is moved, or -1
   * @param snapped the point on the surface that is meant
   * @return one of SnapTargets
   */
  int SnapPoint(const double point[3], double reach, int exceptCurve, double snapped[3]) const;

  /**
   * The segment that would join two points, as a line, and its length; -1 where there is none.
   */
  double PreviewSegment(
    const double from[3], const double to[3], int kind, vtkPolyData* line) const;

  ///@{
  /**
   * The nearest node or segment within reach of a point, in the unit of length, as curve and number
   * of the node or segment. False where there is none.
   */
  bool FindNode(const double point[3], double reach, int found[2]) const;
  bool FindSegment(const double point[3], double reach, int found[2]) const;
  ///@}

protected:
  vtkFeatureCurveEditor();
  ~vtkFeatureCurveEditor() override;

private:
  vtkFeatureCurveEditor(const vtkFeatureCurveEditor&) = delete;
  void operator=(const vtkFeatureCurveEditor&) = delete;

  template <typename Command>
  bool Carry(const Command& command);
  template <typename Change>
  bool Describe(int curve, const Change& change);
  bool Refuse(const std::string& message);

  std::unique_ptr<flattening::bridge::CurveEditorModel> Drawn;
  std::string Message;
  double ViewDirection[3] = { 0.0, 0.0, 0.0 };
  bool SnapToBoundary = true;
  bool SnapToCorners = true;
  bool SnapToVertices = true;
  bool SnapToCurves = true;
  bool SnapToDartTips = true;
  bool SnapToMirrorPlane = true;
};

#endif
