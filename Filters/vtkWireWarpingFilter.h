// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkWireWarpingFilter
 * @brief flatten a surface with feature curves of exact length
 *
 * The surface's boundary and its feature curves are *wires*: in the plane each of their edges has
 * the length that it has in space. Darts are opened and seams are cut through first; every piece
 * is flattened on its own, and the pieces are laid beside each other.
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

#include <string> // for the names
#include <vector> // for the eases

class vtkTable;

namespace flattening
{
namespace bridge
{
struct CurveFraction;
}
}

class VTKFILTERSFLATTENING_EXPORT vtkWireWarpingFilter : public vtkFlatPieceAlgorithm
{
public:
  static vtkWireWarpingFilter* New();
  vtkTypeMacro(vtkWireWarpingFilter, vtkFlatPieceAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How the wires get their shape.
   */
  enum Schemes
  {
    PROGRESSIVE = 0,
    GLOBAL = 1,
    ISOMETRIC = 2,
    LEAST_SQUARES_CONFORMAL = 3
  };

  ///@{
  /**
   * How the wires get their shape: PROGRESSIVE, wire-patch by wire-patch (Algorithm 2); GLOBAL, all
   * angles together (Eq. 13); ISOMETRIC, wires and interior together, which distorts least;
   * LEAST_SQUARES_CONFORMAL, for comparison: keeps no length. Default: ISOMETRIC.
   */
  vtkSetClampMacro(Scheme, int, PROGRESSIVE, LEAST_SQUARES_CONFORMAL);
  vtkGetMacro(Scheme, int);
  void SetSchemeToProgressive() { this->SetScheme(PROGRESSIVE); }
  void SetSchemeToGlobal() { this->SetScheme(GLOBAL); }
  void SetSchemeToIsometric() { this->SetScheme(ISOMETRIC); }
  void SetSchemeToLeastSquaresConformal() { this->SetScheme(LEAST_SQUARES_CONFORMAL); }
  const char* GetSchemeAsString() const;
  ///@}

  /**
   * The paper's method: Scheme GLOBAL and Interior LAPLACIAN. The Solver stays: NEWTON finds the
   * minimum that the paper asks for, SEQUENTIAL by the paper's steps, where they converge.
   */
  void UsePaperMethod();

  /**
   * How the angles' constrained optimization is solved.
   */
  enum Solvers
  {
    NEWTON = 0,
    SEQUENTIAL = 1
  };

  ///@{
  /**
   * How the angles' constrained optimization is solved: NEWTON, exact Newton steps in the
   * directions of the wire edges; SEQUENTIAL, the paper's sequential linearly constrained
   * programming (Eq. 15). The ISOMETRIC scheme starts from its solution; LEAST_SQUARES_CONFORMAL
   * solves for no angles. Default: NEWTON.
   */
  vtkSetClampMacro(Solver, int, NEWTON, SEQUENTIAL);
  vtkGetMacro(Solver, int);
  void SetSolverToNewton() { this->SetSolver(NEWTON); }
  void SetSolverToSequential() { this->SetSolver(SEQUENTIAL); }
  const char* GetSolverAsString() const;
  ///@}

  /**
   * How the points between the wires are placed.
   */
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
   * starts there, LEAST_SQUARES_CONFORMAL has no use for it. Default: AS_RIGID_AS_POSSIBLE.
   */
  vtkSetClampMacro(Interior, int, LAPLACIAN, AS_RIGID_AS_POSSIBLE);
  vtkGetMacro(Interior, int);
  void SetInteriorToLaplacian() { this->SetInterior(LAPLACIAN); }
  void SetInteriorToRelaxation() { this->SetInterior(RELAXATION); }
  void SetInteriorToAsRigidAsPossible() { this->SetInterior(AS_RIGID_AS_POSSIBLE); }
  const char* GetInteriorAsString() const;
  ///@}

  ///@{
  /**
   * Treat key curves as accessory curves: their length is kept, their shape is free. Default: off.
   */
  vtkSetMacro(ReleaseKeys, bool);
  vtkGetMacro(ReleaseKeys, bool);
  vtkBooleanMacro(ReleaseKeys, bool);
  ///@}

  ///@{
  /**
   * GLOBAL and ISOMETRIC: try what a release would bring where a piece lies poorly, which takes the
   * time of up to six flattenings of the piece, by ISOMETRIC for not much more than two
   * seconds (counted by the work, not by the clock; see `ReleaseTried`). Off: the curves are ranked
   * by their sensitivity alone. Default: on.
   */
  vtkSetMacro(ReleaseTrials, bool);
  vtkGetMacro(ReleaseTrials, bool);
  vtkBooleanMacro(ReleaseTrials, bool);
  ///@}

  ///@{
  /**
   * Close darts and other cuts as far as their banks would lie over each other, which they do where
   * the surface is saddle-like: the closed parts of the two banks then lie on each other, at the
   * price of more distortion, and do not count as `Boundary`; patterns are whole there. Off: they
   * overlap, and the status is OVERLAP. Default: off.
   */
  vtkSetMacro(CloseCuts, bool);
  vtkGetMacro(CloseCuts, bool);
  vtkBooleanMacro(CloseCuts, bool);
  ///@}

  /**
   * How the legs of a dart lie.
   */
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
   * other, at the price of more distortion; a dart with two tips is MIRRORED, since straight legs
   * would close it. Darts whose legs cannot be so keep free ones, which `Fallbacks` says.
   * LEAST_SQUARES_CONFORMAL has no use for it. Default: FREE.
   */
  vtkSetClampMacro(DartLegs, int, FREE, MIRRORED);
  vtkGetMacro(DartLegs, int);
  void SetDartLegsToFree() { this->SetDartLegs(FREE); }
  void SetDartLegsToStraight() { this->SetDartLegs(STRAIGHT); }
  void SetDartLegsToMirrored() { this->SetDartLegs(MIRRORED); }
  const char* GetDartLegsAsString() const;
  ///@}

  ///@{
  /**
   * Ease: makes all curves of a name, a seam or a named edge of the boundary, by a fraction longer
   * in one piece (from 0; -1: the only one that they are in) than on the surface, 0.03 for 3 %;
   * less than 0 makes them shorter. What they are sewn to keeps the length of the surface, and the
   * ease is spread evenly. The curve needs a length tolerance as large (AddCurveTolerance()). A
   * curve that is not there, lies in other pieces, has both sides in the piece or is to change by
   * more than its tolerance is refused when the filter runs (INVALID_OPTION). Takes the place of
   * the eases that curves of the name have of their own (`LengthEase`); 0 takes them away. Default:
   * no ease.
   */
  void AddCurveEase(const std::string& curve, int piece, double fraction);
  void RemoveAllCurveEases();
  ///@}

  ///@{
  /**
   * The same as a line of text, for programs whose panels hold texts: NAME:PIECE=PERCENT%, or
   * NAME=PERCENT% where a curve lies in one piece alone, several separated by semicolons, as
   * "side:1=+3%; cap:2=5%". Pieces are numbered from 1 here, as in patterns. It takes the place of
   * all eases; text of another form is an error and changes nothing. Get gives all eases in this
   * form, however they were set. Default: empty.
   */
  void SetCurveEases(const char* text);
  const char* GetCurveEases() const;
  ///@}

  ///@{
  /**
   * All length tolerances of curves (AddCurveTolerance()) as a line of text: NAME=PERCENT%, several
   * separated by semicolons, each from 0 and below 100 %. Text of another form is an error and
   * changes nothing. Get gives all tolerances in this form by name, however they were set. Default:
   * empty.
   */
  void SetCurveTolerances(const char* text);
  const char* GetCurveTolerances() const;
  ///@}

  ///@{
  /**
   * Most iterations of the solver of the angles, a piece. Default: 300. Range: from 1.
   */
  vtkSetClampMacro(MaximumIterations, int, 1, VTK_INT_MAX);
  vtkGetMacro(MaximumIterations, int);
  ///@}

  ///@{
  /**
   * The solver stops when no loop of wires misses its start by more than this fraction of the
   * perimeter. Default: 1e-12. Range: from 0.
   */
  vtkSetClampMacro(ClosureTolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ClosureTolerance, double);
  ///@}

  ///@{
  /**
   * The solver stops when no entry of the gradient of the Lagrangian is larger. Default: 1e-10.
   * Range: from 0.
   */
  vtkSetClampMacro(OptimalityTolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(OptimalityTolerance, double);
  ///@}

  ///@{
  /**
   * RELAXATION: factor tau of Eq. 12. Default: 1.5. Range: (0, 2); a value outside is refused
   * (INVALID_OPTION).
   */
  vtkSetMacro(RelaxationFactor, double);
  vtkGetMacro(RelaxationFactor, double);
  ///@}

  ///@{
  /**
   * RELAXATION: stop when no point moves farther than this fraction of the mean wire edge. Default:
   * 1e-5. Range: from 0.
   */
  vtkSetClampMacro(RelaxationMovement, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(RelaxationMovement, double);
  ///@}

  ///@{
  /**
   * RELAXATION: fewest and most iterations. Default: 10 and 100. Range: from 0, and from 1; a
   * minimum above the maximum is refused (INVALID_OPTION).
   */
  vtkSetClampMacro(RelaxationMinimumIterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(RelaxationMinimumIterations, int);
  vtkSetClampMacro(RelaxationMaximumIterations, int, 1, VTK_INT_MAX);
  vtkGetMacro(RelaxationMaximumIterations, int);
  ///@}

  ///@{
  /**
   * AS_RIGID_AS_POSSIBLE: stop when the energy falls by less than this fraction of itself. Default:
   * 1e-9. Range: from 0.
   */
  vtkSetClampMacro(RigidEnergyTolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(RigidEnergyTolerance, double);
  ///@}

  ///@{
  /**
   * AS_RIGID_AS_POSSIBLE: most iterations. Default: 200. Range: from 1.
   */
  vtkSetClampMacro(RigidMaximumIterations, int, 1, VTK_INT_MAX);
  vtkGetMacro(RigidMaximumIterations, int);
  ///@}

  /**
   * What deforming the sheet costs in the ISOMETRIC scheme.
   */
  enum SheetEnergies
  {
    RIGID = 0,
    SYMMETRIC_DIRICHLET = 1
  };

  ///@{
  /**
   * ISOMETRIC: what deforming the sheet costs. RIGID, as rigid as possible: the squared distance of
   * the map of each triangle from the nearest rotation; SYMMETRIC_DIRICHLET: grows without bound
   * where a triangle collapses, so that none is flipped. Default: RIGID.
   */
  vtkSetClampMacro(DistortionEnergy, int, RIGID, SYMMETRIC_DIRICHLET);
  vtkGetMacro(DistortionEnergy, int);
  void SetDistortionEnergyToRigid() { this->SetDistortionEnergy(RIGID); }
  void SetDistortionEnergyToSymmetricDirichlet() { this->SetDistortionEnergy(SYMMETRIC_DIRICHLET); }
  const char* GetDistortionEnergyAsString() const;
  ///@}

  ///@{
  /**
   * ISOMETRIC with RIGID: above 0 a change of area costs more than a change of angle, as in a stiff
   * sheet; below 0 less, as in a stretchy one. Default: 0. Range: [-0.99, 0.99].
   */
  vtkSetClampMacro(AreaBias, double, -0.99, 0.99);
  vtkGetMacro(AreaBias, double);
  ///@}

  ///@{
  /**
   * ISOMETRIC: weight of the wires' bending against the sheet. The larger, the nearer are the
   * angles along the wires to those on the surface; 0 lets wires buckle. A wire that the sheet
   * presses is stiffer than one that it draws, so that none wrinkles; what a bend costs depends on
   * the surface, not on how finely it is divided. Default: 5. Range: [0, 100].
   */
  vtkSetClampMacro(AngleWeight, double, 0.0, 100.0);
  vtkGetMacro(AngleWeight, double);
  ///@}

  ///@{
  /**
   * ISOMETRIC: most iterations, and the tolerance at which it stops: one that the gradient of the
   * Lagrangian, relative to the root of the energy, is below, or whose square is above the share of
   * the energy that another step promises. It stops as well where a whole step moves no point by
   * more than 1e-10 of the root of the mean triangle area. Default: 100 and 1e-9. Range: from 1,
   * and from 0.
   */
  vtkSetClampMacro(IsometricMaximumIterations, int, 1, VTK_INT_MAX);
  vtkGetMacro(IsometricMaximumIterations, int);
  vtkSetClampMacro(IsometricTolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(IsometricTolerance, double);
  ///@}

  ///@{
  /**
   * What the pieces are cut from: the name of a material that ListMaterials() knows, or a JSON file
   * with its numbers (see Documentation/materials.md). ISOMETRIC then minimizes the energy of its
   * threads, in the place of DistortionEnergy, and keeps their strains within its limits as far as
   * lengths allow; other schemes, and the material "isotropic", only measure what the threads would
   * have to do. A material that is unknown or without meaning is refused (INVALID_OPTION); strains
   * that stay beyond the limits on more than 5 % of a piece's area mark it BEYOND_LIMITS. Default:
   * empty, no material.
   */
  void SetMaterial(const char* text);
  vtkGetCharFromStdStringMacro(Material);
  ///@}

  ///@{
  /**
   * How pieces lie on the material: an angle in degrees from the upright of the piece to the warp,
   * counter-clockwise in the plane (upright is its first key curve from start to end, else the long
   * side of the smallest rectangle around the piece as it lies without the material); the name of a
   * curve, along which the warp runs from its start to its end, or NAME:DEGREES at an angle from
   * it; several of these separated by semicolons, of which each piece takes the first that lies in
   * it; or "free", the angle at which the material is strained least. A piece without any of the
   * curves is laid by its upright and marked MISSING_GRAIN. Default: empty, upright.
   */
  void SetGrain(const char* text);
  vtkGetCharFromStdStringMacro(Grain);
  ///@}

  /**
   * The materials that are known by name, a row each: `Name`, `Description` (string), `Warp`,
   * `Weft`, `Shear` (stiffness in N/m), `Compression` (over that in tension), `WarpLeast`,
   * `WarpGreatest`, `WeftLeast`, `WeftGreatest` (limits of strains, in percent), `ShearLimit`
   * (degrees) (double; -1 or infinite where there is none), `OneWay` (int), `Source` (string; of
   * the numbers).
   */
  static void ListMaterials(vtkTable* materials);

  ///@{
  /**
   * LEAST_SQUARES_CONFORMAL: the two points of the surface that are pinned; -1: the two boundary
   * points that are farthest apart. Default: -1, -1.
   */
  vtkSetVector2Macro(ConformalPins, vtkIdType);
  vtkGetVector2Macro(ConformalPins, vtkIdType);
  ///@}

  ///@{
  /**
   * A wire edge whose relative length error is larger breaks the promise (LENGTH_ERROR). Default:
   * 1e-9. Range: from 0.
   */
  vtkSetClampMacro(MaximumLengthError, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumLengthError, double);
  ///@}

protected:
  vtkWireWarpingFilter();
  ~vtkWireWarpingFilter() override;

  /**
   * What the properties say, for Core.
   */
  flattening::FlatteningOptions Settings();

  void VisitOptions(flattening::bridge::OptionVisitor& visit) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkWireWarpingFilter(const vtkWireWarpingFilter&) = delete;
  void operator=(const vtkWireWarpingFilter&) = delete;

  template <class Visitor>
  void VisitOwnOptions(Visitor& visit)
  {
    visit("Scheme", this->Scheme);
    visit("Interior", this->Interior);
    visit("ReleaseKeys", this->ReleaseKeys);
    visit("CloseCuts", this->CloseCuts);
    visit("DartLegs", this->DartLegs);
    visit("Solver", this->Solver);
    visit("ReleaseTrials", this->ReleaseTrials);
    visit("DistortionEnergy", this->DistortionEnergy);
    visit("AreaBias", this->AreaBias);
    visit("AngleWeight", this->AngleWeight);
    visit("Material", this->Material);
    visit("Grain", this->Grain);
    visit("MaximumIterations", this->MaximumIterations);
    visit("ClosureTolerance", this->ClosureTolerance);
    visit("OptimalityTolerance", this->OptimalityTolerance);
    visit("IsometricMaximumIterations", this->IsometricMaximumIterations);
    visit("IsometricTolerance", this->IsometricTolerance);
    visit("RigidEnergyTolerance", this->RigidEnergyTolerance);
    visit("RigidMaximumIterations", this->RigidMaximumIterations);
    visit("RelaxationFactor", this->RelaxationFactor);
    visit("RelaxationMovement", this->RelaxationMovement);
    visit("RelaxationMinimumIterations", this->RelaxationMinimumIterations);
    visit("RelaxationMaximumIterations", this->RelaxationMaximumIterations);
    visit("MaximumLengthError", this->MaximumLengthError);
    visit("ConformalPins", this->ConformalPins);
  }

  // Options have the defaults of the algorithms.
  int Scheme = 0;
  int Solver = 0;
  int Interior = 0;
  bool ReleaseKeys = false;
  bool ReleaseTrials = false;
  bool CloseCuts = false;
  int DartLegs = 0;
  int MaximumIterations = 0;
  double ClosureTolerance = 0.0;
  double OptimalityTolerance = 0.0;
  double RelaxationFactor = 0.0;
  double RelaxationMovement = 0.0;
  int RelaxationMinimumIterations = 0;
  int RelaxationMaximumIterations = 0;
  double RigidEnergyTolerance = 0.0;
  int RigidMaximumIterations = 0;
  int DistortionEnergy = 0;
  double AreaBias = 0.0;
  double AngleWeight = 0.0;
  int IsometricMaximumIterations = 0;
  double IsometricTolerance = 0.0;
  std::vector<flattening::bridge::CurveFraction> Eases;
  mutable std::string CurveEasesText;      ///< that Get gave last
  mutable std::string CurveTolerancesText; ///< that Get gave last
  std::string Material;
  std::string Grain;
  vtkIdType ConformalPins[2] = { -1, -1 };
  double MaximumLengthError = 0.0;
};

#endif
