// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkWireWarpingFilter
 * @brief flatten a surface with feature curves of exact length
 *
 * The surface's boundary and its feature curves are *wires*: in the plane each of their edges has
 * the length that it has in space (of the boundary on request only those that curves name). Darts
 * are opened and seams are cut through first; every piece is flattened on its own, and the pieces
 * are laid beside each other.
 *
 * Inputs: see vtkFeatureCurveAlgorithm. Outputs: see vtkFlatPieceAlgorithm.
 *
 * A result has a warning, and its name in `Status`, where the solver did not converge, key curves
 * contradict each other, a wire edge is off by more than MaximumLengthError, a triangle is flipped,
 * a piece overlaps itself, strains are beyond the limits of the Material.
 *
 * @code
 * vtkNew<vtkXMLPolyDataReader> surface;
 * surface->SetFileName("shirt_front.vtp");
 * vtkNew<vtkXMLPolyDataReader> curves;
 * curves->SetFileName("shirt_front_curves.vtp");
 * vtkNew<vtkWireWarpingFilter> flattening;
 * flattening->SetInputConnection(surface->GetOutputPort());
 * flattening->AddCurvesConnection(curves->GetOutputPort());
 * flattening->Update();
 * if (!flattening->IsRefused())
 * {
 *   vtkTable* pieces = flattening->GetPieces();
 *   std::cout << pieces->GetNumberOfRows() << " pieces, strain of the first "
 *             << pieces->GetValueByName(0, "StrainP95").ToDouble() << "\n";
 * }
 * @endcode
 *
 * The method is that of C. C. L. Wang, "WireWarping: A fast surface flattening approach with
 * length-preserved feature curves", Computer-Aided Design 40(3), 2008,
 * https://doi.org/10.1016/j.cad.2007.11.005; equation numbers are the paper's.
 *
 * @warning A rejected input gives empty outputs, not an exception: check IsRefused() before reading
 * arrays. A piece that overlaps itself is an output, with a warning: check the status before
 * cutting cloth.
 *
 * @sa vtkFeatureCurveCutter vtkLeastSquaresConformalFilter vtkFlatteningQuality
 */
#ifndef vtkWireWarpingFilter_h
#define vtkWireWarpingFilter_h

#include "vtkFiltersFlatteningModule.h" // for the export macro
#include "vtkFlatPieceAlgorithm.h"

#include <map>     // for the eases
#include <string>  // for the names
#include <utility> // for the eases

class VTKFILTERSFLATTENING_EXPORT vtkWireWarpingFilter : public vtkFlatPieceAlgorithm
{
public:
  static vtkWireWarpingFilter* New();
  vtkTypeMacro(vtkWireWarpingFilter, vtkFlatPieceAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How the wires get their shape.
  enum Schemes
  {
    PROGRESSIVE = 0,
    GLOBAL = 1,
    ISOMETRIC = 2
  };

  ///@{
  /**
   * How the wires get their shape: PROGRESSIVE, wire-patch by wire-patch (Algorithm 2); GLOBAL, all
   * angles together (Eq. 13); ISOMETRIC, wires and interior together, which distorts least. The
   * conformal map is vtkLeastSquaresConformalFilter. Default: ISOMETRIC.
   */
  vtkFlatteningWordMacro(Scheme);
  void SetSchemeToProgressive() { this->SetScheme(PROGRESSIVE); }
  void SetSchemeToGlobal() { this->SetScheme(GLOBAL); }
  void SetSchemeToIsometric() { this->SetScheme(ISOMETRIC); }
  ///@}

  /// Which lengths of the boundary are kept.
  enum BoundaryModes
  {
    EXACT_BOUNDARY = 0,
    FREE_BOUNDARY = 1
  };

  ///@{
  /**
   * Which lengths are kept: EXACT_BOUNDARY, those of the boundary, of the sides of darts and seams
   * and of all curves; FREE_BOUNDARY, with ISOMETRIC alone, those of accessory and key curves,
   * whether they lie inside or name a stretch of the boundary. A piece may be without any. Default:
   * EXACT_BOUNDARY.
   */
  vtkFlatteningWordMacro(BoundaryMode);
  void SetBoundaryModeToExact() { this->SetBoundaryMode(EXACT_BOUNDARY); }
  void SetBoundaryModeToFree() { this->SetBoundaryMode(FREE_BOUNDARY); }
  ///@}

  ///@{
  /**
   * With FREE_BOUNDARY: keep the boundary from crossing itself where the piece would overlap. Parts
   * that press on each other end up beside each other, which costs distortion (Jiang, Schaefer and
   * Panozzo, "Simplicial Complex Augmentation Framework for Bijective Maps", 2017). Where the
   * lengths of curves leave no such map, the piece says NOT_CONVERGED. Default: off.
   */
  vtkFlatteningFlagMacro(PreventOverlap);
  ///@}

  /**
   * The paper's method: Scheme GLOBAL and Interior LAPLACIAN. The Solver stays: NEWTON finds the
   * minimum that the paper asks for, SEQUENTIAL by the paper's steps, where they converge.
   */
  void UsePaperMethod();

  /// How the angles' constrained optimization is solved.
  enum Solvers
  {
    NEWTON = 0,
    SEQUENTIAL = 1
  };

  ///@{
  /**
   * How the angles' constrained optimization is solved: NEWTON, exact Newton steps in the
   * directions of the wire edges; SEQUENTIAL, the paper's sequential linearly constrained
   * programming (Eq. 15). The ISOMETRIC scheme starts from its solution. Default: NEWTON.
   */
  vtkFlatteningWordMacro(Solver);
  void SetSolverToNewton() { this->SetSolver(NEWTON); }
  void SetSolverToSequential() { this->SetSolver(SEQUENTIAL); }
  ///@}

  /// How the points between the wires are placed.
  enum Interiors
  {
    LAPLACIAN = 0,
    RELAXATION = 1,
    AS_RIGID_AS_POSSIBLE = 2
  };

  ///@{
  /**
   * How the points between the wires are placed: LAPLACIAN, Eq. 11 solved directly; RELAXATION, the
   * paper's iteration for it (Eq. 12), NOT_CONVERGED where its iterations run out;
   * AS_RIGID_AS_POSSIBLE, from a harmonic map on, with the wires pinned. Scheme ISOMETRIC only
   * starts there. Default: AS_RIGID_AS_POSSIBLE.
   */
  vtkFlatteningWordMacro(Interior);
  void SetInteriorToLaplacian() { this->SetInterior(LAPLACIAN); }
  void SetInteriorToRelaxation() { this->SetInterior(RELAXATION); }
  void SetInteriorToAsRigidAsPossible() { this->SetInterior(AS_RIGID_AS_POSSIBLE); }
  ///@}

  ///@{
  /**
   * Treat key curves as accessory curves: their length is kept, their shape is free. Default: off.
   */
  vtkFlatteningFlagMacro(ReleaseKeys);
  ///@}

  ///@{
  /**
   * GLOBAL and ISOMETRIC: try what a release improves where a piece lies poorly: up to six more
   * flattenings of the piece, by ISOMETRIC of about two seconds (counted by the work, not by the
   * clock). Off: the curves are ranked by their sensitivity alone. Default: on.
   */
  vtkFlatteningFlagMacro(ReleaseTrials);
  ///@}

  /// How the legs of a dart lie.
  enum DartLegsForms
  {
    FREE = 0,
    STRAIGHT = 1,
    MIRRORED = 2
  };

  ///@{
  /**
   * How the legs of a dart lie: FREE, each as the piece distorts least, so that they fit when sewn
   * but may miss each other when folded; STRAIGHT, both straight; MIRRORED, both the mean of the
   * curves that free legs are. Legs that are not free are exact mirror images and fold on each
   * other, which costs distortion; a dart with two tips is MIRRORED, since straight legs would
   * close it. Darts whose legs cannot be so keep free ones (`Fallbacks`). Default: MIRRORED.
   */
  vtkFlatteningWordMacro(DartLegs);
  void SetDartLegsToFree() { this->SetDartLegs(FREE); }
  void SetDartLegsToStraight() { this->SetDartLegs(STRAIGHT); }
  void SetDartLegsToMirrored() { this->SetDartLegs(MIRRORED); }
  ///@}

  ///@{
  /**
   * Ease: makes all curves of a name, a seam or a named edge of the boundary, by a fraction longer
   * in one piece (from 0; -1: the only one that they are in) than on the surface, 0.03 for 3 %;
   * less than 0 makes them shorter. What they are sewn to keeps the length of the surface, and the
   * ease is spread evenly. The curve needs a length tolerance as large (AddCurveTolerance()). A
   * curve that is not there, lies in other pieces, has both sides in the piece or is to change by
   * more than its tolerance is an error of the run (INVALID_OPTION). Replaces the eases that curves
   * have of their own (`LengthEase`); 0 removes them. Default: none.
   */
  void AddCurveEase(const std::string& curve, int piece, double fraction);
  void RemoveAllCurveEases();
  ///@}

  ///@{
  /**
   * Most iterations of the solver of the angles, a piece. Default: 300. Range: from 1.
   */
  vtkFlatteningNumberMacro(MaximumIterations, int);
  ///@}

  ///@{
  /**
   * The solver stops when no loop of wires misses its start by more than a fraction of the
   * perimeter, and no entry of the gradient of the Lagrangian is larger. Default: 1e-12 and 1e-10.
   * Range: from 0.
   */
  vtkFlatteningNumberMacro(ClosureTolerance, double);
  vtkFlatteningNumberMacro(OptimalityTolerance, double);
  ///@}

  ///@{
  /**
   * RELAXATION: factor tau of Eq. 12; a value outside its range is an error (INVALID_OPTION). Stop
   * when no point moves farther than a fraction of the mean wire edge. Default: 1.5 and 1e-5.
   * Range: (0, 2), and from 0.
   */
  vtkFlatteningNumberMacro(RelaxationFactor, double);
  vtkFlatteningNumberMacro(RelaxationMovement, double);
  ///@}

  ///@{
  /**
   * RELAXATION: fewest and most iterations. Default: 10 and 100. Range: from 0, and from 1; a
   * minimum above the maximum is refused (INVALID_OPTION).
   */
  vtkFlatteningNumberMacro(RelaxationMinimumIterations, int);
  vtkFlatteningNumberMacro(RelaxationMaximumIterations, int);
  ///@}

  ///@{
  /**
   * AS_RIGID_AS_POSSIBLE: stop when the energy falls by less than a fraction of itself, and most
   * iterations. Default: 1e-9 and 200. Range: from 0, and from 1.
   */
  vtkFlatteningNumberMacro(RigidEnergyTolerance, double);
  vtkFlatteningNumberMacro(RigidMaximumIterations, int);
  ///@}

  /// What deforming the sheet costs in the ISOMETRIC scheme.
  enum SheetEnergies
  {
    RIGID = 0,
    SYMMETRIC_DIRICHLET = 1,
    AUTOMATIC_ENERGY = 2
  };

  ///@{
  /**
   * ISOMETRIC: what deforming the sheet costs. RIGID, as rigid as possible: the squared distance of
   * the map of each triangle from the nearest rotation; SYMMETRIC_DIRICHLET: grows without bound
   * where a triangle collapses, so that none is flipped; AUTOMATIC_ENERGY: SYMMETRIC_DIRICHLET
   * where the boundary is free, else RIGID. Default: AUTOMATIC_ENERGY.
   */
  vtkFlatteningWordMacro(DistortionEnergy);
  void SetDistortionEnergyToRigid() { this->SetDistortionEnergy(RIGID); }
  void SetDistortionEnergyToSymmetricDirichlet() { this->SetDistortionEnergy(SYMMETRIC_DIRICHLET); }
  void SetDistortionEnergyToAutomatic() { this->SetDistortionEnergy(AUTOMATIC_ENERGY); }
  ///@}

  ///@{
  /**
   * ISOMETRIC with RIGID: above 0 a change of area costs more than a change of angle, as in a stiff
   * sheet; below 0 less, as in a stretchy one. Default: 0. Range: [-0.99, 0.99].
   */
  vtkFlatteningNumberMacro(AreaBias, double);
  ///@}

  ///@{
  /**
   * ISOMETRIC: weight of the wires' bending against the sheet. The larger, the nearer are the
   * angles along the wires to those on the surface; 0 lets wires buckle. A wire that the sheet
   * presses is stiffer than one that it draws, so that none wrinkles; what a bend costs depends on
   * the surface, not on how finely it is divided. Default: 5. Range: [0, 100].
   */
  vtkFlatteningNumberMacro(AngleWeight, double);
  ///@}

  ///@{
  /**
   * ISOMETRIC: most iterations, and the tolerance at which it stops: one that the gradient of the
   * Lagrangian, relative to the root of the energy, is below, or whose square is above the share of
   * the energy that another step promises. It stops as well where a whole step moves no point by
   * more than 1e-10 of the root of the mean triangle area. Default: 100 and 1e-9. Range: from 1,
   * and from 0.
   */
  vtkFlatteningNumberMacro(IsometricMaximumIterations, int);
  vtkFlatteningNumberMacro(IsometricTolerance, double);
  ///@}

  ///@{
  /**
   * ISOMETRIC: name of a cell array of the surface, one number a cell, that says how much
   * distortion matters there: each triangle counts as if its area were multiplied by it. Only
   * ratios within a piece count; below a thousandth of the mean they count as that. Lengths are
   * kept as without. Proposed cuts weigh strains by it as well; where the weights are not mirrored
   * neither are the cuts. It is input array 0: SetInputArrayToProcess(0, 0, 0,
   * vtkDataObject::FIELD_ASSOCIATION_CELLS, NAME) is the same. Default: empty, everywhere alike.
   */
  void SetWeightArray(const char* name);
  const char* GetWeightArray() { return this->WeightName(); }
  ///@}

  ///@{
  /**
   * A wire edge whose relative length error is larger is a warning (LENGTH_ERROR). Default:
   * 1e-9. Range: from 0.
   */
  vtkFlatteningNumberMacro(MaximumLengthError, double);
  ///@}

protected:
  vtkWireWarpingFilter();
  ~vtkWireWarpingFilter() override = default;

  flattening::FlatteningOptions Settings() override;
  void AddOtherOptions(flattening::OptionValues& values) override;

private:
  vtkWireWarpingFilter(const vtkWireWarpingFilter&) = delete;
  void operator=(const vtkWireWarpingFilter&) = delete;
  // as all options at first by SetDefaultOptions()
  std::map<std::pair<std::string, int>, double> Eases; ///< by curve and piece
};

#endif
