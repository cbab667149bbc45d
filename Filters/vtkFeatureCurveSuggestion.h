// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFeatureCurveSuggestion
 * @brief propose darts and seams, or lines to draw, for a surface, and flatten it with them
 *
 * Looks for straight cuts with which each flat piece is strained by at most Bound on 95 % of its
 * area. Thousands are ranked by a forecast; the best of each round are flattened and moved while
 * that helps. Cuts that are not needed are taken back, and those of a symmetric surface come in
 * pairs. Curves of the input stay; keys are not cut. LINES proposes center, grain and style lines
 * and girths, and no cut.
 *
 * Inputs, options and outputs 0 to 4 are those of vtkWireWarpingFilter, for the surface with all
 * curves. **Output 5** holds the curves of the input and behind them the proposed ones, with
 * `Rank`, `Length`, `Gain` and `MirrorOf`; **output 6** is a vtkTable of one row about the search
 * (Documentation/outputs.md). A bound that is not met is a warning with place and remedy.
 *
 * @code
 * vtkNew<vtkFeatureCurveSuggestion> suggestion;
 * suggestion->SetInputData(surface);
 * suggestion->SetBound(0.02);
 * vtkNew<vtkWireWarpingFilter> again; // the curves are ordinary ones
 * again->SetInputData(surface);
 * again->AddCurvesConnection(suggestion->GetOutputPort(5));
 * again->Update();
 * @endcode
 *
 * @warning Each trial flattens the whole surface: seconds for a thousand triangles, minutes for
 * large ones. An abort ends the search with the best cuts found so far, and a warning.
 *
 * @sa vtkWireWarpingFilter vtkFeatureCurveImprinter
 */
#ifndef vtkFeatureCurveSuggestion_h
#define vtkFeatureCurveSuggestion_h

#include "vtkCommand.h"                 // for UserEvent
#include "vtkFiltersFlatteningModule.h" // for the export macro
#include "vtkSmartPointer.h"            // for the lines left out
#include "vtkTable.h"                   // for the lines left out
#include "vtkWireWarpingFilter.h"

#include <string> // for names

class VTKFILTERSFLATTENING_EXPORT vtkFeatureCurveSuggestion : public vtkWireWarpingFilter
{
public:
  static vtkFeatureCurveSuggestion* New();
  vtkTypeMacro(vtkFeatureCurveSuggestion, vtkWireWarpingFilter)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Invoked during the search whenever it has other cuts. Call data: a vtkPolyData of lines on the
   * surface, in space, the cuts found so far; they may change until the search ends.
   */
  enum Events
  {
    PreviewEvent = vtkCommand::UserEvent + 1
  };

  /// Which cuts are proposed.
  enum SuggestedCutsModes
  {
    DARTS = 0,
    SEAMS = 1,
    DARTS_AND_SEAMS = 2,
    LINES = 3,
    GORES = 4
  };

  ///@{
  /**
   * Which cuts are proposed: DARTS, SEAMS, or DARTS_AND_SEAMS. What opens a closed surface, a tube
   * or a handle is proposed with each of these. LINES: no cuts, but centre and grain lines, girths
   * and style lines; Bound and the limits of cuts do not matter then. GORES: seams through the axis
   * of a round surface, the fewest within the bound. Default: DARTS_AND_SEAMS.
   */
  vtkFlatteningWordMacro(SuggestedCuts);
  void SetSuggestedCutsToDarts() { this->SetSuggestedCuts(DARTS); }
  void SetSuggestedCutsToSeams() { this->SetSuggestedCuts(SEAMS); }
  void SetSuggestedCutsToDartsAndSeams() { this->SetSuggestedCuts(DARTS_AND_SEAMS); }
  void SetSuggestedCutsToLines() { this->SetSuggestedCuts(LINES); }
  void SetSuggestedCutsToGores() { this->SetSuggestedCuts(GORES); }
  ///@}

  ///@{
  /**
   * The strain, on 95 % of each piece's area, that is good enough; 0: cut until MaximumCuts or
   * MaximumCutLength are used up. Default: 0.05. Range: [0, 0.99].
   */
  vtkFlatteningNumberMacro(Bound, double);
  ///@}

  ///@{
  /**
   * The most cuts that are proposed; a mirror image counts. 0: as many as the bound takes. Default:
   * 0.
   */
  vtkFlatteningNumberMacro(MaximumCuts, int);
  ///@}

  ///@{
  /**
   * Into about how many pieces seams part the surface, with as little strain as that allows; of
   * several connected parts each gets its share by area. They are fewer where mirrored pieces are
   * sewn in pairs, or seams cannot be drawn apart, and more where a piece would lie over itself. 0:
   * as few as the bound takes. Default: 0.
   */
  vtkFlatteningNumberMacro(PieceCount, int);
  ///@}

  ///@{
  /**
   * The greatest length of all proposed cuts together, in the unit of the surface; 0: no limit.
   * Default: 0.
   */
  vtkFlatteningNumberMacro(MaximumCutLength, double);
  ///@}

  ///@{
  /**
   * The greatest width of a flat piece where it is narrowest, in the unit of the surface, as that
   * of a roll of cloth. Wider pieces are parted into strips of equal widths by seams that are
   * straight in the plane; where that fails, as by MaximumCuts, a warning says how wide they are.
   * 0: any. Default: 0.
   */
  vtkFlatteningNumberMacro(MaximumWidth, double);
  ///@}

  ///@{
  /**
   * The most work that the search may take, in millions of steps of an iteration on one triangle;
   * 0: no limit. A million takes about half a second of one processor. The best cuts that
   * are found by then are proposed, and a warning names it. Work is counted, not timed: cuts are
   * the same on every machine. Default: 90.
   */
  vtkFlatteningNumberMacro(MaximumWork, double);
  ///@}

  ///@{
  /**
   * Whether proposed cuts are mirrored. "on": across a plane that mirrors the surface onto itself
   * to within 3 % of sqrt(area / pi), or, where bending has hidden it, by lengths and angles on the
   * surface. "off": without regard to a mirror. "force": across the best plane, within 25 %; cuts
   * of the half that needs fewer are mapped to the other. The name of a curve: across the plane in
   * which it lies, a straight one with the normal of the surface. A plane: "x", "y" or "z",
   * "x=0.2", or normal and offset as "1,0,0,0.2". With LINES all but "off" are the same. Default:
   * "on".
   */
  vtkFlatteningTextMacro(Symmetric);
  ///@}

  ///@{
  /**
   * How gladly a cut may begin or end on a curve: its price is divided by the weight, and 0 forbids
   * it. Default: none.
   */
  void AddPreference(const std::string& curve, double weight);
  void RemoveAllPreferences();
  ///@}

  /**
   * Lines that the last run tried and does not propose, with the columns `Name`, `Type`, `Sound`
   * (1: the line only costs too much, 0: it brings a warning, such as that triangles are turned
   * over), `Length`, `Gain`, `AreaErrorBefore`, `AreaErrorAfter`, `StrainBefore`, `StrainAfter`.
   */
  vtkTable* GetLeftOutLines() const { return this->LeftOutLines; }

protected:
  vtkFeatureCurveSuggestion();
  ~vtkFeatureCurveSuggestion() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  // Options have the defaults of the algorithms.
  std::map<std::string, double> Preferences;

private:
  vtkFeatureCurveSuggestion(const vtkFeatureCurveSuggestion&) = delete;
  void operator=(const vtkFeatureCurveSuggestion&) = delete;

  vtkSmartPointer<vtkTable> LeftOutLines; // of the last run
};

#endif
