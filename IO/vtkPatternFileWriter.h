// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPatternFileWriter
 * @brief what the files of patterns have in common: format, paper, colours, and how writing ended
 *
 * The base of vtkPatternWriter, which says what is drawn.
 *
 * @code
 * vtkNew<vtkPatternWriter> writer;
 * vtkPatternFileWriter* file = writer;
 * file->SetFileName("pattern.pdf");
 * file->SetPaperToA0();
 * file->WalkTableOn();
 * @endcode
 *
 * @warning Options of one format mean nothing to the others: pages are those of a PDF, colours for
 * laser cutters those of an SVG.
 *
 * @sa vtkPatternWriter
 */
#ifndef vtkPatternFileWriter_h
#define vtkPatternFileWriter_h

#include "vtkIOPatternModule.h" // for the export macro
#include "vtkSmartPointer.h"    // for the ways out
#include "vtkWriter.h"

#include <string> // for messages

class vtkStringArray;

namespace flattening
{
struct Status;
}

class VTKIOPATTERN_EXPORT vtkPatternFileWriter : public vtkWriter
{
public:
  vtkTypeMacro(vtkPatternFileWriter, vtkWriter)
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
   * Draw an SVG in a colour of its own for each role, with thin whole lines, as programs of laser
   * cutters want it that choose power and order by colour (red, green and blue in hexadecimal): cut
   * lines ff0000, the fold of a half piece 808080, holes ff8000, sew lines 0000ff, legs of darts
   * 0080ff, their fold lines 8000ff, key curves ff00ff, other curves 808000, notches 00ff00, marks
   * on darts 008000, drill holes 00ffff, the grain 000000. Default: off.
   */
  vtkSetMacro(LaserColors, bool);
  vtkGetMacro(LaserColors, bool);
  vtkBooleanMacro(LaserColors, bool);
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

  ///@{
  /**
   * Add the walk of the seams to a PDF, a table on A4 pages after the pattern, which do not count
   * as its pages. Default: off.
   */
  vtkSetMacro(WalkTable, bool);
  vtkGetMacro(WalkTable, bool);
  vtkBooleanMacro(WalkTable, bool);
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
   * The message in its parts, for programs that say it in words of their own: the defect; the names
   * of the ways out, those of vtkFlatteningAlgorithm::GetRemedyName(), the best first; and what
   * each is to be applied to, empty where it needs no name. Never null.
   */
  const char* GetStatusDefect() const { return this->StatusDefect.c_str(); }
  vtkStringArray* GetStatusRemedies() const;
  vtkStringArray* GetStatusRemedySubjects() const;
  ///@}

protected:
  vtkPatternFileWriter();
  ~vtkPatternFileWriter() override;

  /// AUTOMATIC where the extension says nothing.
  int ChosenFormat() const;
  void Keep(const flattening::Status& status);
  void Refuse(unsigned long code, const flattening::Status& status);

  char* FileName = nullptr;
  int FileFormat = AUTOMATIC;
  bool LaserColors = false;
  int Paper = A4;
  double PageOverlap = 10.0;
  int MaximumPages = 200;
  bool WalkTable = false;

private:
  vtkPatternFileWriter(const vtkPatternFileWriter&) = delete;
  void operator=(const vtkPatternFileWriter&) = delete;

  const char* StatusName = "NotRun";
  std::string StatusDefect;
  std::string ErrorMessage;
  vtkSmartPointer<vtkStringArray> StatusRemedies;
  vtkSmartPointer<vtkStringArray> StatusRemedySubjects;
};

#endif
