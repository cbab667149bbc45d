// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPatternWriter
 * @brief write flat pieces as a pattern to cut: SVG, PDF or DXF at true scale
 *
 * Inputs are the outputs of vtkWireWarpingFilter, or data with the same arrays:
 *
 * | port | what | used of it |
 * |---|---|---|
 * | 0 | the flat pieces, triangles counter-clockwise, z ignored | cell array `PieceId` (absent: one piece); field data `SeamPairs` (absent: no notches, no darts to fold), `SeamClosed` (absent: no cut was closed) |
 * | 1, optional | the flat wires over the points of port 0 | cell arrays `CurveType`, `CurveId`, `CurveName`, `PieceId`, `Connector`; absent: outlines only |
 * | 2, optional | the cut surface in space, point for point like port 0 | lengths on the surface, for notches and for `data-length`; absent: the flat lengths |
 *
 * Each piece is drawn with its cut line, its sew lines, its feature curves, darts with legs and
 * fold line and a drill hole near the tip, notches, a grainline along its first key curve, its
 * name, size, quantity, number and the names of its curves. Pieces are moved beside each other, not
 * turned or scaled: **every wire has in the file the length that it has on the surface**, to
 * 1e-9 mm in SVG, 1e-8 mm in DXF and 0.001 mm in PDF for each coordinate. Lines made here (cut
 * line) keep to a 10,000th of a millimetre.
 *
 * - **SVG**: user unit millimetre; a group a piece, a class a kind of line (`cut-line`,
 *   `cut-out`, `sew-line`, `dart-leg`, `dart-fold`, `key-curve`, `internal`, `notch`, `dart-mark`,
 *   `drill-hole`, `grain`); paths of wires have `data-curve` and `data-length`, notches
 *   `data-arc-length` (mm on the surface).
 * - **PDF**: 1:1 on pages of the chosen Paper with a margin of 10 mm, overlapping, with crosses to join
 *   them at, row and column on each page, a map, and a test rectangle of 100 mm x 50 mm. Blank
 * pages are left out; of the two ways to hold the paper the one with fewer pages is taken.
 * - **DXF**: R12 ASCII after ASTM D6673 / AAMA: one BLOCK and INSERT a piece; layers 1 boundary and
 *   system texts, 2 turn points, 3 curve points, 4 notches, 7 grainline, 8 internal lines, 11
 *   cutouts, 13 drill holes, 14 sew lines and dart legs, 15 annotation. Millimetres with "Units:
 * METRIC", or, for a surface in inches, inches with "Units: ENGLISH". Texts are 7-bit (\\U+XXXX).
 *
 * The cut line is the union of the piece with the strips of its seam allowance (Clipper), with
 * mitred corners of limited length. A folded dart's mouth gets a roof, so that the folded cloth
 * reaches the cut line. Where the flattening has closed a cut, the cloth is whole: nothing is drawn
 * there.
 *
 * **Errors**: nothing to draw, broken input, an invalid option, a pattern too large for the pages,
 * a file that cannot be written. One vtkErrorMacro says what and the way out, Write() returns 0,
 * GetErrorCode() and GetErrorMessage() tell it again, and an earlier file of that name stays as it
 * was: the new one is written aside and then renamed.
 *
 * All lengths of this class are **millimetres**, whatever the unit of the surface.
 *
 * @sa vtkWireWarpingFilter
 */
#ifndef vtkPatternWriter_h
#define vtkPatternWriter_h

#include "vtkFiltersFlatteningModule.h" // for the export macro
#include "vtkWriter.h"

#include <map>    // for the allowances
#include <string> // for names
#include <vector> // for the names of pieces

namespace flattening
{
namespace pattern
{
struct PatternOptions;
}
}

class VTKFILTERSFLATTENING_EXPORT vtkPatternWriter : public vtkWriter
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
   * What to write.
   */
  enum FileFormats
  {
    AUTOMATIC = 0,
    SVG = 1,
    PDF = 2,
    DXF = 3
  };

  ///@{
  /**
   * What to write; AUTOMATIC: what the extension of FileName says (.svg, .pdf, .dxf, in either
   * case); any other extension is an error. Default: AUTOMATIC.
   */
  vtkSetClampMacro(FileFormat, int, AUTOMATIC, DXF);
  vtkGetMacro(FileFormat, int);
  void SetFileFormatToAutomatic() { this->SetFileFormat(AUTOMATIC); }
  void SetFileFormatToSVG() { this->SetFileFormat(SVG); }
  void SetFileFormatToPDF() { this->SetFileFormat(PDF); }
  void SetFileFormatToDXF() { this->SetFileFormat(DXF); }
  const char* GetFileFormatAsString() const;
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
   * Unit of length of the input. UNSPECIFIED is taken as CENTIMETRE, with a warning. Default:
   * UNSPECIFIED.
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
  vtkSetMacro(PatternName, std::string);
  vtkGetMacro(PatternName, std::string);
  ///@}

  ///@{
  /**
   * Size that the pattern is for, any UTF-8 text. Default: empty, no size is written.
   */
  vtkSetMacro(PatternSize, std::string);
  vtkGetMacro(PatternSize, std::string);
  ///@}

  ///@{
  /**
   * How many of each piece are cut. Default: 1. Range: from 1.
   */
  vtkSetClampMacro(Quantity, int, 1, VTK_INT_MAX);
  vtkGetMacro(Quantity, int);
  ///@}

  ///@{
  /**
   * Name of one piece, by its id from 0. Where there is none: PatternName, with the piece's number
   * where there are several.
   */
  void SetPieceName(int piece, const std::string& name);
  void RemoveAllPieceNames();
  ///@}

  ///@{
  /**
   * Seam allowance, in millimetres, where no curve has its own. Default: 10. Range: from 0.
   */
  vtkSetClampMacro(Allowance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Allowance, double);
  ///@}

  ///@{
  /**
   * Seam allowance, in millimetres, along one curve: a seam, a dart that is cut out, a feature
   * curve that runs along the boundary, or "boundary" for what is left of the surface's own. A name
   * that is not there is an error when writing.
   */
  void SetCurveAllowance(const std::string& curve, double allowance);
  void RemoveAllCurveAllowances();
  ///@}

  ///@{
  /**
   * A corner of the cut line is no farther from its sew line's corner than this many allowances.
   * Default: 2. Range: from 1.
   */
  vtkSetClampMacro(MitreLimit, double, 1.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MitreLimit, double);
  ///@}

  ///@{
  /**
   * Notches lie at multiples of this length on the surface from the start of each stretch of a seam
   * or dart, on both sides, but not within a quarter of it before the end; in the middle of a
   * stretch where there is none of these. In millimetres; 0: only the mouths of darts are notched.
   * Default: 100. Range: from 0; so small that a stretch would get 10000 notches is refused.
   */
  vtkSetClampMacro(NotchSpacing, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(NotchSpacing, double);
  ///@}

  ///@{
  /**
   * Length of a notch, in millimetres; it never reaches the sew line. Default: 5. Range: from 0.
   */
  vtkSetClampMacro(NotchLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(NotchLength, double);
  ///@}

  ///@{
  /**
   * Cut darts out, with seam allowance along their legs, instead of folding them. Darts that cannot
   * be folded (with branches, or with legs that are not each other's partners) are always cut out.
   * Default: off.
   */
  vtkSetMacro(CutDartsOut, bool);
  vtkGetMacro(CutDartsOut, bool);
  vtkBooleanMacro(CutDartsOut, bool);
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
   * Paper of a PDF. SHEET: one page as large as the pattern, up to 5080 mm. Default: A4.
   */
  vtkSetClampMacro(Paper, int, A4, SHEET);
  vtkGetMacro(Paper, int);
  void SetPaperToA4() { this->SetPaper(A4); }
  void SetPaperToLetter() { this->SetPaper(LETTER); }
  void SetPaperToA3() { this->SetPaper(A3); }
  void SetPaperToA0() { this->SetPaper(A0); }
  void SetPaperToSheet() { this->SetPaper(SHEET); }
  const char* GetPaperAsString() const;
  ///@}

  ///@{
  /**
   * How far pages of a PDF overlap, in millimetres. Default: 10. Range: 0 to 50.
   */
  vtkSetClampMacro(PageOverlap, double, 0.0, 50.0);
  vtkGetMacro(PageOverlap, double);
  ///@}

  ///@{
  /**
   * A pattern that needs more pages is refused, since its unit is likely wrong. Default: 200.
   * Range: from 1.
   */
  vtkSetClampMacro(MaximumPages, int, 1, VTK_INT_MAX);
  vtkGetMacro(MaximumPages, int);
  ///@}

  /**
   * What the last Write() said; empty after success.
   */
  const char* GetErrorMessage() const { return this->ErrorMessage.c_str(); }

protected:
  vtkPatternWriter();
  ~vtkPatternWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

private:
  vtkPatternWriter(const vtkPatternWriter&) = delete;
  void operator=(const vtkPatternWriter&) = delete;

  /// AUTOMATIC where the extension says nothing.
  int ChosenFormat() const;
  flattening::pattern::PatternOptions MakeOptions() const;
  void Refuse(unsigned long code, const std::string& message);

  char* FileName = nullptr;
  int FileFormat = AUTOMATIC;
  int Unit = UNSPECIFIED;
  std::string PatternName = "pattern";
  std::string PatternSize;
  int Quantity = 1;
  std::vector<std::string> PieceNames;
  double Allowance = 10.0;
  std::map<std::string, double> CurveAllowances;
  double MitreLimit = 2.0;
  double NotchSpacing = 100.0;
  double NotchLength = 5.0;
  bool CutDartsOut = false;
  int Paper = A4;
  double PageOverlap = 10.0;
  int MaximumPages = 200;
  std::string ErrorMessage;
};

#endif
