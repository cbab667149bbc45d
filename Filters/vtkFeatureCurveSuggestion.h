// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFeatureCurveSuggestion
 * @brief propose darts and seams for a surface, and flatten it with them
 *
 * Looks for straight cuts that let the surface lie flat with little strain: thousands are ranked by
 * what Yamabe's equation foretells of them, the best of each round are flattened with the scheme
 * and all options that are set here, moved about while that helps, and the best one is kept, until
 * the largest `StrainP95` of a piece is within Bound, MaximumCuts or MaximumCutLength are used up,
 * or no cut is worth its price. What turns out not to be needed is taken back. A surface that is
 * closed, a tube or has handles is first cut open. Curves that the surface has already stay as they
 * are; key curves are not cut. Where the surface is its own mirror image so are the cuts. The same
 * for any number of threads.
 *
 * Inputs and options: see vtkFeatureCurveAlgorithm and vtkWireWarpingFilter. **Outputs 0 to 2** are
 * those of vtkWireWarpingFilter, for the surface with all curves.
 *
 * **Output 3, the curves**: those of the input in their order, then the proposed ones in the order
 * of choice, ready to be given to vtkWireWarpingFilter. Cell arrays: `CurveType` (int), `CurveName`
 * (string; "dart 1", "seam 2", ...), `KeyShape` (int), `LengthTolerance` (double), `Rank` (int;
 * from 1, -1: a curve of the input), `Length` (double, unit of length), `PredictedGain` and `Gain`
 * (double; by how much the cut lowers the mean of u^2 by forecast and the mean rigid energy in
 * truth, after those of lower rank), `Opening` (double, unit of length; of a dart's mouth, by
 * forecast), `StrainBefore` and `StrainAfter` (double; the largest `StrainP95`), `MirrorOf` (int;
 * the rank of the cut that it is the mirror image of, or -1). Point array, where a curve has one:
 * `PlanarShape`. Field data: `BoundMet` (int), `Strain` (double; without and with all cuts),
 * `MirrorPlane` (double; normal and offset, where there is one), `Trials` (int; how many
 * flattenings were made).
 *
 * A bound that cannot be met is no refusal: `BoundMet` says so, with a warning that names what is
 * left. INVALID_OPTION: a preference for a curve that there is not.
 *
 * @sa vtkWireWarpingFilter vtkFeatureCurveImprinter
 */
#ifndef vtkFeatureCurveSuggestion_h
#define vtkFeatureCurveSuggestion_h

#include "vtkFiltersFlatteningModule.h" // for the export macro
#include "vtkWireWarpingFilter.h"

class VTKFILTERSFLATTENING_EXPORT vtkFeatureCurveSuggestion : public vtkWireWarpingFilter
{
public:
  static vtkFeatureCurveSuggestion* New();
  vtkTypeMacro(vtkFeatureCurveSuggestion, vtkWireWarpingFilter)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Which cuts are proposed.
   */
  enum SuggestedCutsModes
  {
    DARTS = 0,
    SEAMS = 1,
    DARTS_AND_SEAMS = 2
  };

  ///@{
  /**
   * Which cuts are proposed: DARTS, SEAMS, or DARTS_AND_SEAMS. What opens a closed surface, a tube
   * or a handle is proposed always. Default: DARTS_AND_SEAMS.
   */
  vtkSetClampMacro(SuggestedCuts, int, DARTS, DARTS_AND_SEAMS);
  vtkGetMacro(SuggestedCuts, int);
  void SetSuggestedCutsToDarts() { this->SetSuggestedCuts(DARTS); }
  void SetSuggestedCutsToSeams() { this->SetSuggestedCuts(SEAMS); }
  void SetSuggestedCutsToDartsAndSeams() { this->SetSuggestedCuts(DARTS_AND_SEAMS); }
  const char* GetSuggestedCutsAsString() const;
  ///@}

  ///@{
  /**
   * The strain, on 95 % of each piece's area, that is good enough; 0: cut until MaximumCuts or
   * MaximumCutLength are used up. Default: 0.02. Range: [0, 0.99].
   */
  vtkSetClampMacro(Bound, double, 0.0, 0.99);
  vtkGetMacro(Bound, double);
  ///@}

  ///@{
  /**
   * The most cuts that are proposed; a mirror image counts. Default: 8.
   */
  vtkSetClampMacro(MaximumCuts, int, 1, VTK_INT_MAX);
  vtkGetMacro(MaximumCuts, int);
  ///@}

  ///@{
  /**
   * The greatest length of all proposed cuts together, in the unit of the surface; 0: no limit.
   * Default: 0.
   */
  vtkSetClampMacro(MaximumCutLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumCutLength, double);
  ///@}

  ///@{
  /**
   * Look for a plane that mirrors the surface onto itself, and propose cuts that it mirrors as
   * well. Default: on.
   */
  vtkSetMacro(Symmetric, bool);
  vtkGetMacro(Symmetric, bool);
  vtkBooleanMacro(Symmetric, bool);
  ///@}

  ///@{
  /**
   * How gladly a cut may begin or end on a curve: its price is divided by the weight, and 0 forbids
   * it. Default: none.
   */
  void AddPreference(const std::string& curve, double weight);
  void RemoveAllPreferences();
  ///@}

protected:
  vtkFeatureCurveSuggestion();
  ~vtkFeatureCurveSuggestion() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int SuggestedCuts;
  double Bound;
  int MaximumCuts;
  double MaximumCutLength = 0.0;
  bool Symmetric;
  std::map<std::string, double> Preferences;

private:
  vtkFeatureCurveSuggestion(const vtkFeatureCurveSuggestion&) = delete;
  void operator=(const vtkFeatureCurveSuggestion&) = delete;
};

#endif
