// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPatternWriter
 * @brief write flat pieces as a pattern to cut: SVG, PDF, DXF or HPGL at true scale, or the walk of its seams
 *
 * Inputs are the outputs of vtkWireWarpingFilter, or data with the same arrays:
 *
 * | port | what | used of it |
 * |---|---|---|
 * | 0 | the flat pieces, triangles counter-clockwise, z ignored | cell array `PieceId` (absent: one piece); field data `SeamPairs` (absent: no notches, no darts to fold), `SeamClosed` (absent: no cut was closed) |
 * | 1, optional | the flat wires over the points of port 0 | cell arrays `CurveType`, `CurveId`, `CurveName`, `PieceId`, `Connector`; absent: outlines only |
 * | 2, optional | the cut surface in space, point for point like port 0 | lengths on the surface, for notches and for `data-length`; absent: the flat lengths |
 * | 3, optional | sizes of the pattern, the output of vtkPatternGrading with port 0 as the base | the nest, the list of rules and the rule table; the numbers of rules in DXF |
 *
 * Each piece is drawn with its cut line, its sew lines, its feature curves, darts with legs and
 * fold line and a drill hole near the tip, notches, a grainline along its first straight key curve,
 * its name, size, quantity, number and the names of its curves. Pieces are moved beside each other,
 * turned (UpAxis) and not scaled: **every wire has in the file the length that it has on the
 * surface**, to 1e-9 mm in SVG, 1e-8 mm in DXF, 0.001 mm in PDF and 0.0125 mm in HPGL for each
 * coordinate. Lines made here (cut line) keep to a 10,000th of a millimetre. FileFormats says what
 * each file has.
 *
 * The cut line is the union of the piece with the strips of its seam allowance (Clipper), with
 * mitred corners of limited length, and a roof over a folded dart's mouth. Where the flattening has
 * closed a cut, nothing is drawn.
 *
 * **Errors**: nothing to draw, broken input, an invalid option, a pattern too large for the pages,
 * memory that ran out, a file that cannot be written. One vtkErrorMacro says what and the remedy,
 * Write() returns 0, GetStatusName(), GetErrorCode() and GetErrorMessage() tell it again, and an
 * earlier file of that name stays as it was: the new one is written aside and then renamed.
 *
 * All lengths of this class are **millimetres**, whatever the unit of the surface.
 *
 * @code
 * vtkNew<vtkWireWarpingFilter> flattening;
 * flattening->SetInputData(surface);
 * flattening->SetCurvesData(curves);
 * vtkNew<vtkPatternWriter> writer;
 * for (int port = 0; port < 3; ++port)
 * {
 *   writer->SetInputConnection(port, flattening->GetOutputPort(port));
 * }
 * writer->SetUnitToCentimetre();
 * writer->SetFileName("pattern.pdf");
 * const bool done = writer->Write() == 1; // else GetErrorMessage() says why
 * @endcode
 *
 * @warning With points of single precision lengths are those of the rounded points.
 *
 * @sa vtkPatternGrading, vtkWireWarpingFilter
 */
#ifndef vtkPatternWriter_h
#define vtkPatternWriter_h

#include "vtkFlatteningAlgorithm.h" // for the macros of options
#include "vtkIOPatternModule.h"     // for the export macro
#include "vtkSmartPointer.h"        // for the remedies
#include "vtkWriter.h"

#include <memory> // for what is kept from file to file
#include <string> // for names
#include <vector> // for the names of pieces

namespace flattening
{
struct Status;
class OptionValues;
namespace pattern
{
class FairCache;
struct PatternOptions;
}
}

class vtkPolyData;
class vtkStringArray;

class VTKIOPATTERN_EXPORT vtkPatternWriter : public vtkWriter
{
public:
  static vtkPatternWriter* New();
  vtkTypeMacro(vtkPatternWriter, vtkWriter)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to write. Required.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * What to write. Options of one format mean nothing to the others.
   *
   * - **SVG**: user unit millimetre; a group a piece, in it a group a role, both layers in
   *   Inkscape, the role's name as class (`cut-line`, `cut-out`, `sew-line`, `dart-leg`,
   *   `dart-fold`, `fold`, `key-curve`, `internal`, `notch`, `dart-mark`, `drill-hole`, `grain`);
   *   paths of wires have `data-curve` and `data-length`, notches `data-arc-length` (mm on the
   *   surface).
   * - **PDF**: 1:1 on pages of the chosen Paper with a margin of 10 mm, overlapping, with crosses
   *   to join them at, row and column on each page, a map, and a test rectangle of 100 mm x 50
   *   mm; as few pages as the two ways to hold the paper allow. Roles, texts, and what is of the
   *   pages are layers.
   * - **DXF**: R12 ASCII after ASTM D6673 / AAMA: one BLOCK and INSERT a piece, which bears its
   *   name; layers 1 boundary and system texts, 2 turn points, 3 curve points, 4 notches, 6 the
   *   fold of half pieces, 7 grainline, 8 internal lines, 11 cutouts, 13 drill holes, 14 sew
   *   lines and dart legs, 15 annotation. Notches are points with an angle and short lines, drill
   *   holes points and circles. Millimetres with "Units: METRIC", or, for a surface in inches,
   *   inches with "Units: ENGLISH". Texts are 7-bit (\\U+XXXX).
   * - **HPGL**: for plotters and cutters; a 40th of a millimetre, pen 1 draws, pen 2 cuts the cut
   *   lines last. Texts are 7-bit, other characters question marks.
   * - **GarmentCode**: JSON of panels and stitches (M. Korosteleva, O. Sorkine-Hornung, ACM
   *   Transactions on Graphics 42(6), 2023): sew lines in centimetres without allowance, straight
   *   and cubic edges labelled by their curves, stitches between edges of one length, and each
   *   panel placed in space where its piece fits the surface best. A piece with a hole is
   *   an error.
   * - **Walk**: a table of comma-separated values, a row for each interval of a seam or dart
   *   between two notches: `curve`, `type` (seam, dart), `piece_a`, `piece_b`, `interval` (from
   *   1), `from_mm`, `to_mm` (along the curve, on the surface), `length_a_mm`, `length_b_mm` (of
   *   the two sides, measured on what is drawn), `difference_mm`, `ease_percent` (of side a over
   *   side b), `angle_sum_start_deg`, `angle_sum_end_deg` (of the cloth of both sides there: 180
   *   where it runs on smoothly over the seam; 360 within an edge; at a dart's tip that of one
   *   point), `join` (its mark; empty for folded darts), `bend_deg` (the angle between the
   *   surfaces of both sides along the whole join, in the mean; above 0 where it is convex); with
   *   a Thickness `bevel_deg`, half of it, and `bevel_mm`, how far the bevel goes back.
   * - **Nest**, **GradeList**, **RuleTable**: of the sizes on port 3, an SVG with the sew lines
   *   of all sizes on each other, a layer a size; comma-separated values with a row for each
   *   point that has a rule (`piece` from 1, `point`, `name`, and `dx`, `dy` of each size in mm
   *   across the grain and along it); and the rule table of ASTM D6673 (.rul), whose rules 1, 2,
   *   ... go along the axes of the DXF, where the texts "# 1", "# 2", ... stand at their points
   *   on the sew lines (layer 2). Cut lines of other sizes are to be drawn anew, by their
   *   allowance.
   */
  enum FileFormats
  {
    AUTOMATIC = 0,
    SVG = 1,
    PDF = 2,
    DXF = 3,
    WALK = 4,
    HPGL = 5,
    GARMENT_CODE = 6,
    NEST = 7,
    GRADE_LIST = 8,
    RULE_TABLE = 9
  };

  ///@{
  /**
   * What to write; AUTOMATIC: what the extension of FileName says (.svg, .pdf, .dxf, .plt for
   * HPGL, .json for GarmentCode, .csv for the walk, .rul for the rule table, in either case); any
   * other extension is an error. Default: AUTOMATIC.
   */
  vtkSetClampMacro(FileFormat, int, AUTOMATIC, RULE_TABLE);
  vtkGetMacro(FileFormat, int);
  void SetFileFormatToAutomatic() { this->SetFileFormat(AUTOMATIC); }
  void SetFileFormatToSVG() { this->SetFileFormat(SVG); }
  void SetFileFormatToPDF() { this->SetFileFormat(PDF); }
  void SetFileFormatToDXF() { this->SetFileFormat(DXF); }
  void SetFileFormatToWalk() { this->SetFileFormat(WALK); }
  void SetFileFormatToHPGL() { this->SetFileFormat(HPGL); }
  void SetFileFormatToGarmentCode() { this->SetFileFormat(GARMENT_CODE); }
  void SetFileFormatToNest() { this->SetFileFormat(NEST); }
  void SetFileFormatToGradeList() { this->SetFileFormat(GRADE_LIST); }
  void SetFileFormatToRuleTable() { this->SetFileFormat(RULE_TABLE); }
  const char* GetFileFormatAsString() const;
  ///@}

  ///@{
  /**
   * Draw an SVG with a color for each role and thin whole lines, of few arcs that are within
   * 0.03 mm of the drawing, for programs of laser cutters that choose power and order by
   * color (red, green and blue in hexadecimal): cut lines ff0000, the fold of a half piece
   * 808080, holes ff8000, sew lines 0000ff, legs of darts 0080ff, their fold lines 8000ff,
   * key curves ff00ff, other curves 808000, notches 00ff00, marks on darts 008000, drill
   * holes 00ffff, the grain 000000. Default: off.
   */
  vtkFlatteningFlagMacro(LaserColors);
  ///@}

  ///@{
  /**
   * Draw a DXF for laser, knife and router, not for pattern systems: model space
   * alone, the layers CUT (outlines and holes, once each), MARK (sew lines off the outline, darts,
   * curves, notches, drill holes, grain) and TEXT, polylines with arcs that are within 0.03 mm of
   * the drawing, no points; sheet materials have no grainline. Default: off.
   */
  vtkFlatteningFlagMacro(CutterStyle);
  ///@}

  /**
   * Paper of a PDF.
   */
  enum Papers
  {
    A4 = 0,
    LETTER = 1,
    A3 = 2,
    A0 = 3,
    SHEET = 4
  };

  ///@{
  /**
   * Paper of a PDF. SHEET: one page as large as the pattern, or where that is
   * larger than 5080 mm, which PDF allows, pages of that size to be joined. Default: A4.
   */
  vtkFlatteningWordMacro(Paper);
  void SetPaperToA4() { this->SetPaper(A4); }
  void SetPaperToLetter() { this->SetPaper(LETTER); }
  void SetPaperToA3() { this->SetPaper(A3); }
  void SetPaperToA0() { this->SetPaper(A0); }
  void SetPaperToSheet() { this->SetPaper(SHEET); }
  ///@}

  ///@{
  /**
   * How far pages of a PDF overlap, in millimetres. Default: 10. Range: 0 to 50.
   */
  vtkFlatteningNumberMacro(PageOverlap, double);
  ///@}

  ///@{
  /**
   * A pattern that needs more pages is refused, since its unit is likely wrong. Default: 200.
   * Range: 1 to 100000.
   */
  vtkFlatteningNumberMacro(MaximumPages, int);
  ///@}

  ///@{
  /**
   * Add the walk of the seams to a PDF, a table on A4 pages after the pattern, which do not count
   * as its pages. Default: off.
   */
  vtkFlatteningFlagMacro(WalkTable);
  ///@}

  ///@{
  /**
   * How the last Write() ended: the fixed name of a refusal ("PatternTooLarge"), "Ok", or "NotRun"
   * where there was none yet; and what it said, empty after success.
   */
  const char* GetStatusName() const { return this->StatusName; }
  const char* GetErrorMessage() const { return this->ErrorMessage.c_str(); }
  ///@}

  ///@{
  /**
   * The message in its parts, for programs that say it in words of their own: the defect; the
   * names of the remedies, those of vtkFlatteningAlgorithm::GetRemedyName(), the best first;
   * and what each is to be applied to, empty where it needs no name. Never null.
   */
  const char* GetStatusDefect() const { return this->StatusDefect.c_str(); }
  vtkStringArray* GetStatusRemedies() const;
  vtkStringArray* GetStatusRemedySubjects() const;
  ///@}

  /**
   * Unit of length of the input.
   */
  enum Units
  {
    UNSPECIFIED = 0,
    MILLIMETRE = 1,
    CENTIMETRE = 2,
    METRE = 3,
    INCH = 4
  };

  ///@{
  /**
   * Unit of length of the input. UNSPECIFIED: the one that the flat pieces state
   * (vtkFlatteningAlgorithm::GetLengthUnitOf()); where they state none, CENTIMETRE, with a warning.
   * Default: UNSPECIFIED.
   */
  vtkSetClampMacro(Unit, int, UNSPECIFIED, INCH);
  vtkGetMacro(Unit, int);
  void SetUnitToMillimetre() { this->SetUnit(MILLIMETRE); }
  void SetUnitToCentimetre() { this->SetUnit(CENTIMETRE); }
  void SetUnitToMetre() { this->SetUnit(METRE); }
  void SetUnitToInch() { this->SetUnit(INCH); }
  const char* GetUnitAsString() const;
  ///@}

  /**
   * Sets the unit by "mm", "cm", "m" or "inch". Another name is an error (false) and changes
   * nothing.
   */
  bool SetUnitByName(const std::string& name);

  ///@{
  /**
   * Name of the pattern, any UTF-8 text. Default: "pattern".
   */
  vtkFlatteningTextMacro(PatternName);
  ///@}

  ///@{
  /**
   * Size that the pattern is for, any UTF-8 text. Without one none is written. Default: empty.
   */
  vtkFlatteningTextMacro(PatternSize);
  ///@}

  ///@{
  /**
   * How many of each piece are cut. Default: 1. Range: 1 to 1000000.
   */
  vtkFlatteningNumberMacro(Quantity, int);
  ///@}

  ///@{
  /**
   * How many of one piece are cut, by its id from 0, in place of Quantity; 0: that many. A piece
   * that is not there is an error when writing. Of pieces in pairs (CutPairs) so many pairs.
   * Default: 0. Range: from 0.
   */
  void SetPieceQuantity(int piece, int quantity);
  void RemoveAllPieceQuantities();
  ///@}

  ///@{
  /**
   * Name of one piece, by its id from 0. Where there is none: that in the cell array
   * `PieceName` (string), as of objects of an OBJ file, numbered where several pieces have
   * it; else PatternName, with the piece's number where there are several.
   */
  void SetPieceName(int piece, const std::string& name);
  void RemoveAllPieceNames();
  ///@}

  ///@{
  /**
   * Seam allowance, in millimetres, where no curve has its own; -1: 10, and 0 of a material whose
   * edges do not fray. Default: -1. Range: 0 to 1e6, or -1.
   */
  vtkFlatteningNumberMacro(Allowance, double);
  ///@}

  ///@{
  /**
   * Seam allowance, in millimetres, along one curve: a seam, a dart that is cut out, a feature
   * curve that runs along the boundary, or "boundary" for what is left of the surface's own. With
   * "NAME:2" that of piece 2, counted from 1, alone, as for an overlap. A name or side that is not
   * there is an error when writing. Get gives Allowance where a curve has none of its
   * own.
   */
  void SetCurveAllowance(const std::string& curve, double length);
  double GetCurveAllowance(const std::string& curve) const;
  bool HasCurveAllowance(const std::string& curve) const;
  void RemoveAllCurveAllowances();
  ///@}

  ///@{
  /**
   * A corner of the cut line is no farther from its sew line's corner than this many allowances.
   * Default: 2. Range: 1 to 100.
   */
  vtkFlatteningNumberMacro(MitreLimit, double);
  ///@}

  ///@{
  /**
   * Distance of notches along each stretch of a seam or dart, on the surface and on both
   * sides, in millimetres; the last is a quarter of it before the end at least, and a shorter
   * stretch has one in its middle. Where the notches would be the same from either end, the
   * first one moves towards the start. 0: at the mouths of darts alone; -1: about a sixth of
   * the largest piece. A stretch with 10000 notches is an error. Default: -1. Range: 0 to
   * 1e6, or -1.
   */
  vtkFlatteningNumberMacro(NotchSpacing, double);
  ///@}

  ///@{
  /**
   * A notch on all curves of a name, this far from their start on the surface, in
   * millimetres: on both sides of a seam or dart, or on a feature curve along the boundary.
   * Curves with notches of their own have none by NotchSpacing. A name that is not there and
   * a distance beyond the end of the longest curve are errors when writing. Get gives them in
   * the order of adding.
   */
  void AddCurveNotch(const std::string& curve, double distance);
  int GetNumberOfCurveNotches(const std::string& curve) const;
  double GetCurveNotch(const std::string& curve, int notch) const;
  void RemoveAllCurveNotches();
  ///@}

  ///@{
  /**
   * Draw all notches of the curves of a name double, as two marks 6.35 mm apart along the
   * border, on both sides of a seam or dart, which distinguishes the back of an armhole from its
   * front. A name that is not there is an error when writing.
   */
  void AddDoubleNotches(const std::string& curve);
  bool HasDoubleNotches(const std::string& curve) const;
  void RemoveAllDoubleNotches();
  ///@}

  ///@{
  /**
   * Notch the cut line at the corners of the sew line, where both sew lines, drawn on, meet it (one
   * notch where a corner points into the cloth); and the border where feature curves and edges with
   * names end on it, and opposite on what is sewn to it, but at corners. Default: all off.
   */
  vtkFlatteningFlagMacro(NotchCorners);
  vtkFlatteningFlagMacro(NotchCurveEnds);
  ///@}

  ///@{
  /**
   * Length of a notch, in millimetres; it never reaches the sew line. Default: 5. Range: 0 to
   * 1e6.
   */
  vtkFlatteningNumberMacro(NotchLength, double);
  ///@}

  /**
   * The axis of the surface that points up.
   */
  enum UpAxes
  {
    UP_AUTOMATIC = 0,
    UP_X = 1,
    UP_Y = 2,
    UP_Z = 3,
    UP_NONE = 4
  };

  ///@{
  /**
   * Turn each piece so that the up of the surface is up in it, with its grain along that,
   * unless it has a straight key curve, lies on its cloth (Grain) or rather level in space,
   * or sizes are connected. UP_AUTOMATIC: of y and z the axis along which the surface is
   * larger; UP_NONE: no piece is turned. Default: UP_AUTOMATIC.
   */
  vtkFlatteningWordMacro(UpAxis);
  void SetUpAxisToAutomatic() { this->SetUpAxis(UP_AUTOMATIC); }
  void SetUpAxisToX() { this->SetUpAxis(UP_X); }
  void SetUpAxisToY() { this->SetUpAxis(UP_Y); }
  void SetUpAxisToZ() { this->SetUpAxis(UP_Z); }
  void SetUpAxisToNone() { this->SetUpAxis(UP_NONE); }
  ///@}

  ///@{
  /**
   * Mark both sides of each stretch that is sewn to another with the same letters, A, B, ...,
   * AA, in the middle and, where there is room, near both ends; a PDF on A4, letter or A3
   * lists them. Folded darts have none. Default: on.
   */
  vtkFlatteningFlagMacro(JoinMarks);
  ///@}

  ///@{
  /**
   * Draw pieces longer along their grain (warp) and across it (weft), in per cent; below 0 shorter.
   * Default: all 0. Range: -20 to 20.
   */
  vtkFlatteningNumberMacro(WarpCompensation, double);
  vtkFlatteningNumberMacro(WeftCompensation, double);
  ///@}

  ///@{
  /**
   * Thickness of the material, with which tables of joins have their bevels, and width of tabs to
   * glue on the first side of each join, in millimetres. Default: all 0. Range: 0 to 1e6.
   */
  vtkFlatteningNumberMacro(Thickness, double);
  vtkFlatteningNumberMacro(GlueTab, double);
  ///@}

  ///@{
  /**
   * Cut darts out, with seam allowance along their legs, instead of folding them. Darts that
   * cannot be folded (with branches, or with legs that are not each other's partners) are
   * always cut out. Default: off.
   */
  vtkFlatteningFlagMacro(CutDartsOut);
  ///@}

  ///@{
  /**
   * Of pieces that are symmetric, all their wires included and within 0.5 mm, draw one half,
   * to be cut on the fold of the cloth. A note says so, and by how much the halves differed.
   * Other pieces are drawn whole. Default: off.
   */
  vtkFlatteningFlagMacro(CutOnFold);
  ///@}

  ///@{
  /**
   * Cut pieces on the fold of the cloth along all curves of a name. Of a piece that has it
   * inside one half is drawn, as with CutOnFold; a piece that has it on its border is a half,
   * without allowance there. A name that is not there, a curve that is sewn, that bends by
   * more than 0.5 mm or about which its piece is not symmetric to 0.5 mm, and a half that is
   * laid on one layer of cloth (FabricWidth) are errors when writing.
   */
  void AddFold(const std::string& curve);
  void RemoveAllFolds();
  ///@}

  ///@{
  /**
   * How far the tips of folded darts are drawn back, in millimetres, so that the sewn dart
   * ends before the fullest place. The legs go with the tip by an affine map that leaves the
   * mouth where it is; their lengths are those that `data-length` and a walk of the seams
   * say. More than half of a dart's depth is an error when writing. Default: 0. Range: 0 to
   * 1e6.
   */
  vtkFlatteningNumberMacro(DartTip, double);
  ///@}

  ///@{
  /// DartTip of the darts of a name. A name that is not there is an error when writing.
  void SetCurveDartTip(const std::string& curve, double length);
  double GetCurveDartTip(const std::string& curve) const;
  bool HasCurveDartTip(const std::string& curve) const;
  void RemoveAllCurveDartTips();
  ///@}

  ///@{
  /**
   * Of two pieces that are mirror images of each other within 0.5 mm, all their wires
   * included, draw the first alone, to be cut in pairs of which one is turned over. Off, both
   * are drawn and named each other's mirror image. Default: off.
   */
  vtkFlatteningFlagMacro(CutPairs);
  ///@}

  ///@{
  /**
   * Draw borders and feature curves between corners (turns of more than 30 degrees that are
   * no part of a round) as cubic splines of least bending, straight where they are nearly so,
   * no point of the flat piece farther from them than this many millimetres. Each stretch
   * from notch to notch keeps its length to 1e-10 of it, both sides of a seam alike; what
   * cannot keep to the tolerance stays as the mesh has it, with a note. A piece of which 95 %
   * of the area would be strained by over 0.3 % more keeps nearer to its flat points, or
   * stays. Panels of vtkGarmentCodeReader keep their edges but along curves with a
   * CurveFairTolerance. 0: as the mesh has them. Default: 0.2. Range: 0 to 100.
   */
  vtkFlatteningNumberMacro(FairTolerance, double);
  ///@}

  ///@{
  /**
   * FairTolerance along all curves of a name, or "boundary" for what is left of the surface's own,
   * in millimetres from 0; smooth lines meet those that stay as the mesh has them (0) in a corner.
   * A name that is not there is an error when writing.
   */
  void SetCurveFairTolerance(const std::string& curve, double length);
  double GetCurveFairTolerance(const std::string& curve) const;
  bool HasCurveFairTolerance(const std::string& curve) const;
  void RemoveAllCurveFairTolerances();
  ///@}

  ///@{
  /**
   * Draw the outline of each piece that is symmetric within 0.5 mm as its own mirror image,
   * within the FairTolerance. Sides whose lengths differ by up to 0.1 mm get their mean, as
   * does what is sewn to them. Notes (MIRRORED, NOT_MIRRORED) say how far sides are from each
   * other, and why a piece is not drawn so. It is an error when writing where no line is
   * smooth. Default: off.
   */
  vtkFlatteningFlagMacro(Symmetrize);
  ///@}

  /**
   * The names of all curves that have an option of their own, each once, in alphabetical
   * order.
   */
  vtkSmartPointer<vtkStringArray> GetCurvesWithOptions() const;

  ///@{
  /**
   * Of SVG, PDF and HPGL: lay all copies of all pieces on cloth of this width across the
   * grain, in millimetres, whole also where CutOnFold, one of each pair (CutPairs) turned
   * over, with the grain along the cloth and at least FabricGap from the next. A note says
   * how long the cloth must be and which share of it is used; the search is one of bounded
   * work, with the same result on every machine. A piece that is wider is an error when
   * writing (PatternTooLarge). Needs Clipper. 0: in rows. Default: 0. Range: 0 to 1e5.
   */
  vtkFlatteningNumberMacro(FabricWidth, double);
  ///@}

  ///@{
  /**
   * The cloth of FabricWidth has an up and a down, as velvet and prints have, and all pieces lie
   * the same way; off, they may be turned by half a turn. Default: off.
   */
  vtkFlatteningFlagMacro(FabricNap);
  ///@}

  ///@{
  /**
   * Least distance of pieces on the cloth of FabricWidth, in millimetres. Default: 5. Range: 0 to
   * 1000.
   */
  vtkFlatteningNumberMacro(FabricGap, double);
  ///@}

  ///@{
  /**
   * What the last Write() with a FabricWidth found: the length of the cloth in millimetres, and the
   * share of it that is pieces, above 0 and at most 1. Both are 0 where there was none.
   */
  vtkGetMacro(FabricLength, double);
  vtkGetMacro(FabricEfficiency, double);
  ///@}

  ///@{
  /**
   * Where ports 1 and 2 have no connection, take what the flattening filter that made the
   * flat pieces gives there, also through filters in between that hand the pieces on, for
   * programs that know one input of a writer alone, such as ParaView. Default: off.
   */
  vtkSetMacro(FollowPipeline, bool);
  vtkGetMacro(FollowPipeline, bool);
  vtkBooleanMacro(FollowPipeline, bool);
  ///@}

  ///@{
  /// What the last Write() drew otherwise than may be expected, a sentence each: a grainline that
  /// is upright because all key curves of its piece bend. VTK's warnings say it as well.
  int GetNumberOfWarnings() const { return static_cast<int>(this->Warnings.size()); }
  const char* GetWarning(int warning) const;
  ///@}

  ///@{
  /**
   * What the last Write() did, a sentence each, and of which kind it is: what options asked
   * for (DRAWN), lines made smooth (SMOOTHED), those and pieces that could not be
   * (LEFT_ROUGH, NOT_SMOOTHED), an outline made its own mirror image (MIRRORED), and one that
   * could not be (NOT_MIRRORED).
   */
  enum NoteKinds
  {
    DRAWN,
    SMOOTHED,
    LEFT_ROUGH,
    NOT_SMOOTHED,
    MIRRORED,
    NOT_MIRRORED
  };
  int GetNumberOfNotes() const { return static_cast<int>(this->Notes.size()); }
  const char* GetNote(int note) const;
  int GetNoteKind(int note) const;
  ///@}

  ///@{
  /**
   * All properties that are options, but those of single curves and pieces, for programs that are
   * built with this project.
   */
  void SetOptions(const flattening::OptionValues& values);
  void GetOptions(flattening::OptionValues& values);
  ///@}

protected:
  vtkPatternWriter();
  ~vtkPatternWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

private:
  vtkPatternWriter(const vtkPatternWriter&) = delete;
  void operator=(const vtkPatternWriter&) = delete;

  // Options of the table by their names.
  void SetNumberOption(const char* property, double value);
  double GetNumberOption(const char* property) const;
  void SetTextOption(const char* property, const char* text);
  const char* GetTextOption(const char* property) const;
  const char* GetOptionWord(const char* property) const;
  /// The data set of a port; null where there is none.
  vtkPolyData* DataOf(int port);
  /// Unit, or the one that the flat pieces state.
  int KnownUnit();
  /// Writes the file, from what is connected.
  flattening::Status WritePattern(int format);

  /// AUTOMATIC where the extension says nothing.
  int ChosenFormat() const;
  void Keep(const flattening::Status& status);
  void Refuse(unsigned long code, const flattening::Status& status);

  char* FileName = nullptr;
  int FileFormat = AUTOMATIC;
  std::unique_ptr<flattening::OptionValues> Options;          ///< of the table, but lists
  std::unique_ptr<flattening::pattern::PatternOptions> Lists; ///< of single curves and pieces
  int Unit = UNSPECIFIED;
  double FabricLength = 0.0;
  double FabricEfficiency = 0.0;
  bool FollowPipeline = false;
  std::vector<std::string> Warnings;
  std::vector<std::pair<std::string, int>> Notes; ///< with their kinds
  std::unique_ptr<flattening::pattern::FairCache> Fair;
  const char* StatusName = "NotRun";
  std::string StatusDefect;
  std::string ErrorMessage;
  vtkSmartPointer<vtkStringArray> StatusRemedies;
  vtkSmartPointer<vtkStringArray> StatusRemedySubjects;
};

#endif
