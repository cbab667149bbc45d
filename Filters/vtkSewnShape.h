// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSewnShape
 * @brief sew flat pieces together again and compare the result with the design
 *
 * The proof of a flattening: cloth that is flat at rest in the shape of the pieces is put where the
 * design has it and let go. Newton's method finds where it comes to rest, a minimum of its energy
 * next to the design: under Pressure, by its weight (Gravity), and on a body that it does not
 * enter. It stretches as RigidEnergy or its Material says and bends like a plate of Thickness; the
 * page on the sewing simulation has the model and its sources.
 *
 * **Ports 0 and 1** are outputs 0 and 2 of vtkWireWarpingFilter: the flat pieces, whose `SeamPairs`
 * say what is sewn together, and the cut surface. **Port 2**, optional, is the body. **Output 0**
 * is the surface at rest, **output 1** the design, both with `Distance`, `NormalDeviation` and
 * `PrincipalStrains`; **output 2** has one row a shape, GetShapes() (Documentation/outputs.md).
 *
 * @code
 * vtkNew<vtkWireWarpingFilter> flattening;
 * flattening->SetInputData(surface);
 * vtkNew<vtkSewnShape> sewn;
 * sewn->SetInputConnection(flattening->GetOutputPort(0));
 * sewn->SetDesignConnection(flattening->GetOutputPort(2));
 * sewn->Update();
 * std::cout << sewn->GetShapes()->GetValueByName(0, "RelativeDistanceMean").ToDouble() << "\n";
 * @endcode
 *
 * @warning Cloth that bends in both directions is stiffer than its plate, by the mesh: a flat square
 * sags by 0.56 to 0.75 of what the plate does. A sheet that buckles may have other minima.
 *
 * @sa vtkWireWarpingFilter vtkFlatteningQuality
 */
#ifndef vtkSewnShape_h
#define vtkSewnShape_h

#include "vtkFiltersFlatteningModule.h" // for the export macro
#include "vtkFlatteningAlgorithm.h"
#include "vtkSmartPointer.h" // for the iterations
#include "vtkTable.h"        // for the iterations

#include <string>

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
  vtkPolyData* GetDesignOutput() { return this->GetOutput(1); }

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
  vtkTable* GetIterations() const { return this->Iterations; }

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

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSewnShape(const vtkSewnShape&) = delete;
  void operator=(const vtkSewnShape&) = delete;

  // Options have the defaults of the algorithms.
  double Gravity[3] = { 0.0, 0.0, 0.0 };
  vtkSmartPointer<vtkTable> Iterations; // of the last run
};

#endif
