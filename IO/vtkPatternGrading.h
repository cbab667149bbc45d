// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPatternGrading
 * @brief lay the sizes of one pattern on each other, and find how its points go from size to size
 *
 * Takes the flattenings of several surfaces of one connectivity with the same curves, such as one
 * garment fitted to several bodies. Each port takes a connection for each size, in one order:
 *
 * | port | what | used of it |
 * |---|---|---|
 * | 0 | the flat pieces | points, triangles, cell array `PieceId` |
 * | 1 | the flat wires over the same points | cell arrays `CurveType`, `CurveName`, `PieceId`, `Connector` |
 *
 * **Output**: the wires of all sizes as polylines, in **millimetres**, each piece with the point at
 * which its sizes are laid on each other as its origin and its grain along y. The points are those
 * of port 0, size after size. Cell arrays: `SizeId` (int), `PieceId` (id), `CurveName` (string).
 * Field data: `SizeName` (string, one row for each size), `BaseSize` (int, 1 row), `GrainDirection`
 * (double, 1 row, 2 components a piece: the grain of the base as it lies on port 0), and one row
 * for each rule: `RulePiece` (id), `RulePoint` (id of a point of port 0), `RuleName` (string: the
 * curves that meet there), `RuleDelta` (double, mm, 2 components a size: from the base size across
 * the grain to the right and along it), and those of vtkFlatteningAlgorithm. Points with rules are
 * the ends of curves on the border, and corners of the boundary that turn by more than 30 degrees.
 *
 * vtkPatternWriter takes the output on port 3 and writes the nest, the list of rules and the rule
 * table.
 *
 * **Errors** (INVALID_OPTION): fewer than two sizes, one without a name or with that of another, a
 * base or a curve that is not there, or sizes that differ in more than where their points are. The
 * output is without points then.
 *
 * @code
 * vtkNew<vtkWireWarpingFilter> medium; // each size has a filter of its own
 * medium->SetInputData(surface);
 * medium->SetCurvesData(curves);
 * medium->Update();
 * vtkNew<vtkPatternGrading> grading;
 * grading->AddSize("M", medium->GetOutput(0), medium->GetOutput(1));
 * // ... and the others
 * grading->SetBaseSize("M");
 * grading->Update();
 * std::cout << grading->GetOutput()->GetNumberOfLines() << " lines\n";
 * @endcode
 *
 * @warning Rules are those of the flat pieces; borders that vtkPatternWriter draws smooth differ
 * from them by up to its FairTolerance.
 *
 * @sa vtkPatternWriter, vtkWireWarpingFilter
 */
#ifndef vtkPatternGrading_h
#define vtkPatternGrading_h

#include "vtkFlatteningAlgorithm.h"
#include "vtkIOPatternModule.h" // for the export macro

#include <string> // for names
#include <vector> // for the names of sizes

class VTKIOPATTERN_EXPORT vtkPatternGrading : public vtkFlatteningAlgorithm
{
public:
  static vtkPatternGrading* New();
  vtkTypeMacro(vtkPatternGrading, vtkFlatteningAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Adds a size: its name, its flat pieces and its flat wires, which are not copied, as connections
   * of ports 0 and 1.
   */
  void AddSize(const std::string& name, vtkPolyData* flat, vtkPolyData* wires);

  /**
   * Takes all connections of port 1 away, as RemoveAllInputs() does those of port 0.
   */
  void RemoveAllWires();

  ///@{
  /**
   * The names of the sizes, in the order of the connections. Those that have none are named by
   * their number, from 1.
   */
  void SetSizeName(int size, const std::string& name);
  const char* GetSizeName(int size) const;
  int GetNumberOfSizeNames() const { return static_cast<int>(this->SizeNames.size()); }
  void RemoveAllSizeNames();
  ///@}

  ///@{
  /**
   * Name of the size that rules count from. Empty: the one in the middle. Default: empty.
   */
  vtkSetMacro(BaseSize, std::string);
  vtkGetMacro(BaseSize, std::string);
  ///@}

  ///@{
  /**
   * Name of the curve at whose first point and along whose chord sizes are laid on each other.
   * Empty, and on pieces without it: the first key curve within the piece; where there is none, the
   * middle of its wires, turned as they fit those of the base best. Default: empty.
   */
  vtkSetMacro(AlignmentCurve, std::string);
  vtkGetMacro(AlignmentCurve, std::string);
  ///@}

  /**
   * Unit of length of the surfaces, numbered as those of vtkPatternWriter.
   */
  enum Units
  {
    MILLIMETRE = 1,
    CENTIMETRE = 2,
    METRE = 3,
    INCH = 4
  };

  ///@{
  /**
   * Unit of length of the surfaces. Default: CENTIMETRE.
   */
  vtkSetClampMacro(Unit, int, MILLIMETRE, INCH);
  vtkGetMacro(Unit, int);
  void SetUnitToMillimetre() { this->SetUnit(MILLIMETRE); }
  void SetUnitToCentimetre() { this->SetUnit(CENTIMETRE); }
  void SetUnitToMetre() { this->SetUnit(METRE); }
  void SetUnitToInch() { this->SetUnit(INCH); }
  const char* GetUnitAsString() const;
  ///@}

protected:
  vtkPatternGrading();
  ~vtkPatternGrading() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPatternGrading(const vtkPatternGrading&) = delete;
  void operator=(const vtkPatternGrading&) = delete;

  std::vector<std::string> SizeNames;
  std::string BaseSize;
  std::string AlignmentCurve;
  int Unit = CENTIMETRE;
};

#endif
