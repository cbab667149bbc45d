// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSewnShape
 * @brief sew flat pieces together again and compare the result with the design
 *
 * The proof of a flattening: cloth that is flat at rest in the shape of the pieces is put where the
 * design has it and let go. It stretches and bends as little as it can, and comes to rest at some
 * distance from the surface that was designed: under Pressure, by its weight (Gravity) and on a
 * body, where these are given, without friction.
 *
 * **Port 0**, the flat pieces, and **port 1**, the cut surface in space, point for point and cell
 * for cell like them: outputs 0 and 2 of vtkWireWarpingFilter. The field data `SeamPairs` of port 0
 * says what is sewn together; without it nothing is.
 *
 * **Port 2**, optional, a body that the cloth does not go through: a penalty pushes it out, then a
 * barrier keeps it out (M. Li et al., "Incremental potential contact", ACM Transactions on Graphics
 * 39(4), 2020).
 *
 * The cloth is an isotropic sheet that costs (S - 1)^2 + (s - 1)^2 an area, S >= s the stretches of
 * a triangle, as the flattening counts it (RigidEnergy; AreaBias as there), or has the threads of a
 * Material, warp along y of the flat pieces, whose limits are no stiffness and do not count; and
 * bends like a plate
 * of Thickness (quadratic bending: M. Bergou, M. Wardetzky, D. Harmon, D. Zorin, E. Grinspun, "A
 * quadratic bending model for inextensible surfaces", 2006); across a seam as in a piece. The rest
 * is found by Newton's method from the design on. It is a minimum of the energy next to the design;
 * a sheet that buckles may have others.
 *
 * **Output 0, the sewn surface at rest** over the points and cells of port 1, with its point and
 * cell data but for normals, and **output 1, the design** with the same:
 *
 * | array | on | type | meaning |
 * |---|---|---|---|
 * | `Distance` | points | double | to the closest point of the other surface, unit of length |
 * | `NormalDeviation` | cells | double | angle between the normals on both surfaces, radians |
 * | `PrincipalStrains` | cells | double, 2 components | S - 1 and s - 1 |
 * | `Compressed` | cells | unsigned char | 1 where s is below 0.999: cloth wrinkles there |
 * | `ShapeId` | cells | id | row of output 2 |
 * | `SewnStrainWarp`, `SewnStrainWeft` | cells | double | with a Material: length of a thread at rest over that in the piece, less 1 |
 * | `SewnShearAngle` | cells | double | with a Material: by how many degrees its threads leave the right angle |
 *
 * Field data of output 0: `SeamPairs` (as in port 0) and `SeamStrains` (double, 2 components: how
 * much longer each of the two edges is at rest than in its piece, as a fraction).
 *
 * **Output 2, the shapes**: see GetShapes().
 *
 * Errors: pieces without area (DEGENERATE_TRIANGLE); inputs that do not belong together, with
 * PRODUCT a piece that is sewn to nothing, pressure in an open product, weight of one without a
 * body, an unknown material (INVALID_OPTION). Warning: NOT_CONVERGED.
 *
 * @code
 * vtkNew<vtkWireWarpingFilter> flattening;
 * flattening->SetInputData(surface);
 * flattening->SetCurvesData(curves);
 * vtkNew<vtkSewnShape> sewn;
 * sewn->SetInputConnection(flattening->GetOutputPort(0));
 * sewn->SetDesignConnection(flattening->GetOutputPort(2));
 * sewn->Update();
 * std::cout << sewn->GetShapes()->GetValueByName(0, "RelativeDistanceMean").ToDouble() << "\n";
 * @endcode
 *
 * @warning The thinner the cloth, the closer a developable comes to its design: by the square of
 * Thickness, since the rest of the cloth is flat and bending it has to be held by stretching.
 * @warning Only where cloth bends like a cylinder does it bend like that plate; bent in both
 * directions it is stiffer, by the mesh: a flat square sags by 0.56 to 0.75 of what the plate does.
 *
 * @sa vtkWireWarpingFilter vtkFlatteningQuality
 */
#ifndef vtkSewnShape_h
#define vtkSewnShape_h

#include "vtkFiltersFlatteningModule.h" // for the export macro
#include "vtkFlatteningAlgorithm.h"
#include "vtkSmartPointer.h" // for the iterations

#include <string>

class vtkTable;

class VTKFILTERSFLATTENING_EXPORT vtkSewnShape : public vtkFlatteningAlgorithm
{
public:
  static vtkSewnShape* New();
  vtkTypeMacro(vtkSewnShape, vtkFlatteningAlgorithm)

  ///@{
  /**
   * The cut surface in space, port 1.
   */
  void SetDesignConnection(vtkAlgorithmOutput* design) { this->SetInputConnection(1, design); }
  void SetDesignData(vtkPolyData* design) { this->SetInputData(1, design); }
  ///@}

  ///@{
  /**
   * A surface that the cloth does not go through, port 2, optional: a body, a last, a core. Its
   * normals point outwards; one that is closed is turned so. Points of the cloth keep a thousandth
   * of its size from it, triangles between them may cut its bulges.
   */
  void SetBodyConnection(vtkAlgorithmOutput* body) { this->SetInputConnection(2, body); }
  void SetBodyData(vtkPolyData* body) { this->SetInputData(2, body); }
  ///@}

  /**
   * Output 1, the design with the arrays.
   */
  vtkPolyData* GetDesignOutput();

  /**
   * Output 2, one row for each shape (Test PANEL: a piece; PRODUCT: all that is sewn together), in
   * the unit of length:
   *
   * | column | type | meaning |
   * |---|---|---|
   * | `Shape`, `Status`, `Pieces` | id, string, id | the shape, how its run ended, how many pieces it has |
   * | `Size` | double | root of the area of the design |
   * | `DistanceMean`, `DistanceRms`, `DistanceP95` | double | of the points of output 0, by area in the pieces; P95 is not exceeded on 95 % of it |
   * | `DistanceMax` | double | Hausdorff distance of the two surfaces, by their points |
   * | `RelativeDistanceMean`, `...Rms`, `...P95`, `...Max` | double | the same over Size |
   * | `NormalDeviationMean` | double | radians |
   * | `StrainMean`, `StrainP95`, `StrainMax` | double | of max abs(ln sigma), by area |
   * | `CompressedArea` | double | share of the area |
   * | `StrainWarpRms`, `StrainWeftRms`, `ShearRms` | double | with a Material: root mean squares by area in the pieces; the shear in degrees |
   * | `BodyDepth` | double | how deep a point that is not held lies in the body; 0: none does |
   * | `SecondDistanceMean`, `SeveralShapes` | double, int | of the shape that a second start finds (SecondStart), and 1 where the two differ by more than a tenth |
   * | `MembraneEnergy`, `BendingEnergy` | double | over half of Young's modulus; unit of length squared |
   * | `Triangles`, `Iterations`, `Converged`, `StatusMessage` | id, id, int, string | of the run |
   */
  vtkTable* GetShapes();

  /**
   * The iterations of the last run: `Shape`, `Energy` (mean triangle areas times half the modulus),
   * `Force` (largest on a vertex, over modulus times the root of the mean triangle area), `Move`
   * (of the point that moved farthest, in roots of the mean triangle area).
   */
  vtkTable* GetIterations() const;

  /// What is held while the cloth comes to rest.
  enum Tests
  {
    PANEL = 0,
    PRODUCT = 1
  };

  ///@{
  /**
   * What is held while the cloth comes to rest: PANEL, of each piece its boundary where the design
   * has it; PRODUCT, nothing: seams are shared, hems are free, and the whole is laid over the
   * design by the rigid motion that brings their points nearest to each other. Default: PANEL.
   */
  vtkFlatteningWordMacro(Test);
  void SetTestToPanel() { this->SetTest(PANEL); }
  void SetTestToProduct() { this->SetTest(PRODUCT); }
  ///@}

  ///@{
  /**
   * Thickness of a plate that bends as the cloth does, over the root of the mean area of a piece:
   * the root of 12 times bending stiffness over stiffness against stretch. A shirting of 15 uN m
   * and 2 kN/m is such a plate of 0.3 mm, which is 0.00075 of a piece of 40 cm. Default: 0.001.
   * Range: 0 to 1.
   */
  vtkFlatteningNumberMacro(Thickness, double);
  ///@}

  ///@{
  /**
   * Above 0 a change of area costs the cloth more than one of angle, below 0 less, as AreaBias of
   * vtkWireWarpingFilter does. Default: 0. Range: -0.99 to 0.99.
   */
  vtkFlatteningNumberMacro(AreaBias, double);
  ///@}

  ///@{
  /**
   * Most iterations of a shape. Default: 300. Range: from 1.
   */
  vtkFlatteningNumberMacro(MaximumIterations, int);
  ///@}

  ///@{
  /**
   * Pressure behind the cloth, along the normals of the design, times its size over the stiffness
   * of the cloth against stretch: 0.01 strains a ball by a few parts in a thousand. PRODUCT: what
   * is sewn together must be closed, as a cushion or a plush toy is. Default: 0. Range: -1 to 1.
   */
  vtkFlatteningNumberMacro(Pressure, double);
  ///@}

  ///@{
  /**
   * Weight of the cloth per area and where it pulls, times the size of the design over the
   * stiffness of the cloth against stretch: a shirting of 1.2 N/m^2 and 2 kN/m in a piece of 40 cm
   * has 0.00024. PRODUCT: there must be a body that holds it. Default: (0, 0, 0). Range: a length
   * of at most 1.
   */
  vtkSetVector3Macro(Gravity, double);
  vtkGetVector3Macro(Gravity, double);
  ///@}

  ///@{
  /**
   * What the cloth is made of, as Material of vtkWireWarpingFilter: a name, or a JSON file. The
   * modulus is that of its stiffer thread. Default: empty, the isotropic sheet.
   */
  vtkFlatteningTextMacro(Material);
  ///@}

  ///@{
  /**
   * Come to rest once more, from as far on the other side of the design as the cloth lies on one,
   * shaken by a thousandth of the size (with a body from the design, shaken), and say where that is
   * another shape: the figures are then those of one shape of several. It takes twice the time.
   * Default: on.
   */
  vtkFlatteningFlagMacro(SecondStart);
  ///@}

protected:
  vtkSewnShape();
  ~vtkSewnShape() override = default;

  void AddOtherOptions(flattening::OptionValues& values) override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSewnShape(const vtkSewnShape&) = delete;
  void operator=(const vtkSewnShape&) = delete;

  // Options have the defaults of the algorithms.
  double Gravity[3] = { 0.0, 0.0, 0.0 };
  vtkSmartPointer<vtkTable> Iterations; // of the last run
};

#endif
