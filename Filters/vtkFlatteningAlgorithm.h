// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFlatteningAlgorithm
 * @brief common base of the flattening filters: what became of the last run
 *
 * A filter of this family either gives a result or refuses its input; it never gives a result that
 * is silently wrong.
 *
 * - **Refused** (codes up to NumericalFailure): one vtkErrorMacro names the defect, the first
 *   offending ids and the remedy. The outputs have neither points nor cells, ErrorCode is
 *   vtkErrorCode::UserError, and the request fails, so that filters behind this one do not run; of
 *   a composite data set, and among several processes, only the output is empty. A run that was
 *   aborted (CANCELLED) has empty outputs as well, but no error.
 * - **Warning** (codes from NOT_CONVERGED on): the outputs are complete, and a
 *   vtkWarningMacro says what is not as it should be.
 *
 * A vtkWarningMacro also says what the filter left out of an input that it can use, such as an
 * array that is too short; the status is OK then, and GetStatusWarnings() has all of them.
 *
 * The status of the last run can be read from the filter after Update(). With composite input the
 * filter runs once per block, and the status is that of the block that ran last; the field data
 * `RunStatus` and `RunStatusMessage` (string) of output 0 are those of each block.
 *
 * Lists in the field data that have no row are left out.
 *
 * What a program does with it:
 * @code
 * vtkNew<vtkWireWarpingFilter> flattening;
 * flattening->SetInputData(surface);
 * flattening->Update();
 * if (flattening->IsRefused())
 * {
 *   std::cerr << flattening->GetStatusName() << ": " << flattening->GetStatusMessage() << "\n";
 *   vtkIdTypeArray* ids = flattening->GetStatusIds(); // of flattening->GetStatusIdKind()
 *   std::cerr << ids->GetNumberOfValues() << " " << flattening->GetStatusIdKind() << "\n";
 * }
 * @endcode
 *
 * @warning A status is that of the last run: before the first Update(), and where the input could
 * not be read, it is NOT_RUN.
 *
 * @sa vtkFeatureCurveAlgorithm vtkWireWarpingFilter
 */
#ifndef vtkFlatteningAlgorithm_h
#define vtkFlatteningAlgorithm_h

#include "vtkFiltersFlatteningModule.h" // for the export macro
#include "vtkIdTypeArray.h"             // for the ids
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for the ids
#include "vtkStringArray.h"  // for the remedies

#include <map>    // for the processes
#include <memory> // for the processes
#include <set>    // for the ports
#include <string> // for the message
#include <vector> // for the warnings

class vtkDataObject;

namespace flattening
{
struct OptionStructures;
class OptionValues;
struct Status;
namespace bridge
{
struct SurfaceOwners;
}
}

/// Properties that are options of the table, which has their defaults and ranges.
#define vtkFlatteningNumberMacro(name, type)                                                       \
  virtual void Set##name(type value)                                                               \
  {                                                                                                \
    this->SetNumberOption(#name, value);                                                           \
  }                                                                                                \
  virtual type Get##name() const                                                                   \
  {                                                                                                \
    return static_cast<type>(this->GetNumberOption(#name));                                        \
  }
#define vtkFlatteningWordMacro(name)                                                               \
  virtual const char* Get##name##AsString() const                                                  \
  {                                                                                                \
    return this->GetOptionWord(#name);                                                             \
  }                                                                                                \
  vtkFlatteningNumberMacro(name, int)
#define vtkFlatteningFlagMacro(name)                                                               \
  virtual void name##On()                                                                          \
  {                                                                                                \
    this->Set##name(true);                                                                         \
  }                                                                                                \
  virtual void name##Off()                                                                         \
  {                                                                                                \
    this->Set##name(false);                                                                        \
  }                                                                                                \
  vtkFlatteningNumberMacro(name, bool)
#define vtkFlatteningTextMacro(name)                                                               \
  virtual void Set##name(const char* text)                                                         \
  {                                                                                                \
    this->SetTextOption(#name, text);                                                              \
  }                                                                                                \
  virtual const char* Get##name() const                                                            \
  {                                                                                                \
    return this->GetTextOption(#name);                                                             \
  }

class VTKFILTERSFLATTENING_EXPORT vtkFlatteningAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkFlatteningAlgorithm, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Runs the filter; memory that runs out becomes the status OUT_OF_MEMORY.
   */
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  ///@{
  /**
   * The unit of length of a data set, "mm", "cm", "m" or "inch", that its field data state as
   * `LengthUnit` (string); empty where they state none of these. Filters pass on the unit of their
   * surface, or where that states none, of the first curves that do. Another word takes it out.
   */
  static std::string GetLengthUnitOf(vtkDataObject* data);
  static void SetLengthUnitOf(vtkDataObject* data, const std::string& unit);
  ///@}

  /**
   * What a run can end with. Up to NUMERICAL_FAILURE, but for OK, there is no result; later codes
   * mark a result with a warning.
   */
  enum StatusCodes
  {
    NOT_RUN = -1, ///< no run yet, for example because the input could not be read
    OK = 0,
    CANCELLED,
    EMPTY_SURFACE,
    NON_FINITE_POINT,
    INVALID_POINT_ID,
    DEGENERATE_TRIANGLE,
    NON_MANIFOLD_EDGE,
    NON_MANIFOLD_VERTEX,
    NOT_ORIENTABLE,
    CLOSED_SURFACE,
    HANDLE,
    CURVE_TOO_SHORT,
    CURVE_POINT_OFF_SURFACE,
    CURVE_LEAVES_SURFACE,
    CURVE_NOT_ON_EDGES,
    INVALID_CURVE,
    INVALID_OPTION,
    OUT_OF_MEMORY,
    NUMERICAL_FAILURE,
    NOT_CONVERGED,
    INCOMPATIBLE_KEYS,
    LENGTH_ERROR,
    FLIPPED_TRIANGLES,
    OVERLAP,
    MISSING_GRAIN,
    BEYOND_LIMITS
  };

  ///@{
  /**
   * How the last run ended: one of StatusCodes, its fixed name ("NonManifoldEdge"), and the message
   * that was given, empty where the status is OK. A run that is refused sets
   * vtkErrorCode::UserError as the ErrorCode of vtkAlgorithm, any other run that ends
   * vtkErrorCode::NoError.
   */
  int GetStatusCode() const { return this->StatusCode; }
  const char* GetStatusName() const;
  const char* GetStatusMessage() const { return this->StatusMessage.c_str(); }
  ///@}

  ///@{
  /**
   * Ids of the offending elements of the last run, in the numbering of the input, and what they are
   * ids of: "points" or "cells" of the surface (port 0), "edges" as pairs of its points, "curves"
   * as cells and "curve points" as points of the data set that holds the curve. Both are empty
   * where the status is OK or concerns no element. The array is never null.
   */
  vtkIdTypeArray* GetStatusIds() const { return this->StatusIds; }
  const char* GetStatusIdKind() const { return this->StatusIdKind.c_str(); }
  ///@}

  ///@{
  /**
   * The message of the last run in its parts, for programs with option names of their own: the
   * defect; the names of the remedies, the best first; and what each is to be applied to, empty
   * where it needs no name. Never null.
   */
  const char* GetStatusDefect() const { return this->StatusDefect.c_str(); }
  vtkStringArray* GetStatusRemedies() const { return this->StatusRemedies; }
  vtkStringArray* GetStatusRemedySubjects() const { return this->StatusRemedySubjects; }
  ///@}

  /**
   * The warnings of the last run that the status does not say, each once. Never null.
   */
  vtkStringArray* GetStatusWarnings() const { return this->StatusWarnings; }

  ///@{
  /**
   * All remedies: their number, the name of each ("CloseCuts"), and what the one with a name says.
   * In this sentence % stands for what it is to be applied to, `{Property}` or `{Property=VALUE}`
   * for an option of the filters, `{Sewing.Property}` for one of vtkSewnShape, the name of a class
   * for another filter, and a part within [] is left out by a program without the option. Null
   * where there is none.
   */
  static int GetNumberOfRemedies();
  static const char* GetRemedyName(int remedy);
  static const char* GetRemedySentence(const char* name);
  ///@}

  /**
   * True where the last run gave no result, or there was none.
   */
  bool IsRefused() const;

  ///@{
  /**
   * All processes of vtkMultiProcessController's global controller run this filter, each with its
   * part of the input, as in ParaView. A surface is flattened by the process that has it, and the
   * others give empty outputs without a word (NOT_RUN); one of which several have a part is refused
   * (INVALID_OPTION), since each would take its part for the whole; curves on port 1 are curves for
   * the blocks of every process. Off: the filter knows nothing of other processes. Default: off.
   */
  vtkSetMacro(Distributed, bool);
  vtkGetMacro(Distributed, bool);
  vtkBooleanMacro(Distributed, bool);
  ///@}

  /**
   * What is wrong with the first of these properties (names with blanks between them) that has no
   * effect with the values of the others; empty: nothing. A run ignores such properties.
   */
  std::string DescribeIdleOption(const std::string& given);

  /**
   * A run that was aborted is done again by the next Update(), although nothing was changed.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkFlatteningAlgorithm();
  ~vtkFlatteningAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;

  ///@{
  /**
   * Makes an input one that need not be there, and an output a vtkTable; the filter has at least
   * the ports up to it.
   */
  void SetOptionalPort(int port);
  void SetTablePort(int port);
  ///@}

  /**
   * Gives all options their defaults; the constructor of each class that has some calls it.
   */
  void SetDefaultOptions();

  ///@{
  /**
   * The options by the names of their properties: numbers, within their ranges, and flags; texts,
   * null for an empty one; the name of the value of an enumeration.
   */
  void SetNumberOption(const char* property, double value);
  double GetNumberOption(const char* property) const;
  void SetTextOption(const char* property, const char* text);
  const char* GetTextOption(const char* property) const;
  const char* GetOptionWord(const char* property) const;
  ///@}

  /**
   * Sets options that are kept elsewhere.
   */
  virtual void AddOtherOptions(flattening::OptionValues& vtkNotUsed(values)) {}

  /**
   * The values of all options, for Core.
   */
  flattening::OptionStructures OptionsForCore();
  flattening::OptionValues AllOptions();

  /**
   * Called before and after a run, once also where the input is a composite data set, for whose
   * blocks RequestData() is called one by one. The second gets the whole input and output.
   */
  virtual void BeginRun(vtkInformationVector** vtkNotUsed(inputVector)) {}
  virtual void EndRun(vtkDataObject* vtkNotUsed(input), vtkDataObject* vtkNotUsed(output)) {}

  /**
   * Whether a process can do its part of a surface that is spread over several, with the ghost
   * cells that it has.
   */
  virtual bool TakesParts() const { return false; }

  /**
   * The unit of the surface, or where that states none, of the first curves that do; empty for
   * none.
   */
  std::string LengthUnitOf(vtkInformationVector** inputVector);

  /**
   * Called after each run on one data set, whether it gave a result or not.
   */
  virtual void FinishData(vtkInformationVector* vtkNotUsed(outputVector)) {}

  /**
   * Empties the outputs and forgets the status of the last run.
   */
  void Begin(vtkInformationVector* outputVector);

  /**
   * Keeps the status and gives the error or the warning that belongs to it. Returns whether there
   * is a result.
   */
  bool Conclude(const flattening::Status& outcome);

  /**
   * Gives warnings of what the status does not say, each sentence once, and keeps them for
   * GetStatusWarnings().
   */
  void Warn(const std::vector<std::string>& messages);

  /**
   * Adds the field data `RunStatus` and `RunStatusMessage`.
   */
  void WriteRunStatus(vtkPolyData* output) const;

private:
  void EnterRun(vtkInformationVector** inputVector);
  void LeaveRun();
  bool HasSurface(vtkInformationVector* outputVector);
  bool HasFailed() const;
  void Keep(const flattening::Status& outcome);
  void Forget();

  vtkFlatteningAlgorithm(const vtkFlatteningAlgorithm&) = delete;
  void operator=(const vtkFlatteningAlgorithm&) = delete;

  int StatusCode = NOT_RUN;
  bool Running = false;
  bool Distributed = false;
  bool AmongBlocks = false;
  /// Of the surface, or of each block, and of that which is at hand.
  std::unique_ptr<flattening::OptionValues> Options; ///< of the table
  std::unique_ptr<std::map<const vtkDataObject*, flattening::bridge::SurfaceOwners>> AllOwners;
  std::unique_ptr<flattening::bridge::SurfaceOwners> Owners;
  std::string StatusMessage;
  std::string StatusDefect;
  std::string StatusIdKind;
  vtkSmartPointer<vtkIdTypeArray> StatusIds;
  vtkSmartPointer<vtkStringArray> StatusRemedies;
  vtkSmartPointer<vtkStringArray> StatusRemedySubjects;
  vtkSmartPointer<vtkStringArray> StatusWarnings;
  std::set<int> OptionalPorts;
  std::set<int> TablePorts;
};

#endif
