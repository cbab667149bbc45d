// SPDX-License-Identifier: BSD-3-Clause
// The filters' defaults are those of the algorithms, option by option.
#include "FlatteningTesting.h"

#include "Flattening/FlatteningOptions.h"
#include "Imprint/ImprintedSurface.h"
#include "Quality/BoundaryOverlap.h"

#include "vtkFlatteningQuality.h"
#include "vtkLeastSquaresConformalFilter.h"
#include "vtkWireWarpingFilter.h"

using namespace flatteningTesting;
using namespace flattening;

namespace
{
template <typename Enumeration>
int number(Enumeration value)
{
  return static_cast<int>(value);
}

// Each structure is taken apart, so that an option that is added to it does not compile here before
// it is compared.
void optionsOfWireWarping(Checks& check)
{
  vtkNew<vtkWireWarpingFilter> filter;
  const auto [scheme, start, angles, interior, isometric, conformal, cloth, closeCuts, dartLegs,
    eases, skipClosed, releaseKeys, tryReleases, trialWork, arrange, spacing, lengthTolerance] =
    FlatteningOptions();
  check.equal(filter->GetScheme(), number(scheme), "Scheme");
  check.equal(std::string(filter->GetMaterial()).empty(), !cloth, "Material");
  check.equal(filter->GetScheme(), number(vtkWireWarpingFilter::ISOMETRIC), "the product's scheme");
  check.equal(filter->GetCloseCuts(), closeCuts, "CloseCuts");
  check.equal(eases.empty() && start.empty(), true, "eases and start");
  check.equal(filter->GetDartLegs(), number(dartLegs), "DartLegs");
  check.equal(filter->GetSkipClosed(), skipClosed, "SkipClosed");
  check.equal(filter->GetReleaseKeys(), releaseKeys, "ReleaseKeys");
  check.equal(filter->GetReleaseTrials(), tryReleases, "ReleaseTrials");
  check.equal(trialWork > 0.0, true, "what ReleaseTrials may take has no property");
  check.equal(filter->GetArrange(), arrange, "Arrange");
  check.equal(filter->GetSpacing(), spacing, "Spacing");
  check.equal(filter->GetMaximumLengthError(), lengthTolerance, "MaximumLengthError");

  const auto [solver, mostIterations, closure, optimality] = angles;
  check.equal(filter->GetSolver(), number(solver), "Solver");
  check.equal(filter->GetMaximumIterations(), mostIterations, "MaximumIterations");
  check.equal(filter->GetClosureTolerance(), closure, "ClosureTolerance");
  check.equal(filter->GetOptimalityTolerance(), optimality, "OptimalityTolerance");

  const auto [method, relaxation, movement, fewest, most, energyTolerance, mostRigid] = interior;
  check.equal(filter->GetInterior(), number(method), "Interior");
  check.equal(filter->GetRelaxationFactor(), relaxation, "RelaxationFactor");
  check.equal(filter->GetRelaxationMovement(), movement, "RelaxationMovement");
  check.equal(filter->GetRelaxationMinimumIterations(), fewest, "RelaxationMinimumIterations");
  check.equal(filter->GetRelaxationMaximumIterations(), most, "RelaxationMaximumIterations");
  check.equal(filter->GetRigidEnergyTolerance(), energyTolerance, "RigidEnergyTolerance");
  check.equal(filter->GetRigidMaximumIterations(), mostRigid, "RigidMaximumIterations");

  const auto [energy, sheet, rough, angleWeight, mostIsometric, tolerance, length] = isometric;
  const auto [kind, bias] = energy;
  check.that(!sheet && !rough, "no cloth of its own");
  check.that(length <= lengthTolerance, "lengths are solved for as finely as they are promised");
  check.equal(filter->GetDistortionEnergy(), number(kind), "DistortionEnergy");
  check.equal(filter->GetAreaBias(), bias, "AreaBias");
  check.equal(filter->GetAngleWeight(), angleWeight, "AngleWeight");
  check.equal(filter->GetIsometricMaximumIterations(), mostIsometric, "IsometricMaximumIterations");
  check.equal(filter->GetIsometricTolerance(), tolerance, "IsometricTolerance");
  check.equal(filter->GetConformalPins()[0], vtkIdType{ conformal.pins[0] }, "first pin");
  check.equal(filter->GetConformalPins()[1], vtkIdType{ conformal.pins[1] }, "second pin");
}

void optionsOfImprinting(Checks& check)
{
  vtkNew<vtkWireWarpingFilter> filter;
  const auto [split, tolerance, snap] = ImprintOptions();
  check.equal(filter->GetSplitTriangles(), split, "SplitTriangles");
  check.equal(filter->GetImprintTolerance(), tolerance, "ImprintTolerance");
  check.equal(filter->GetSnapTolerance(), snap, "SnapTolerance");
}

void optionsOfTheOthers(Checks& check)
{
  vtkNew<vtkLeastSquaresConformalFilter> conformal;
  const FlatteningOptions defaults;
  check.equal(conformal->GetAreaNormalized(), defaults.conformal.areaNormalized, "AreaNormalized");
  check.equal(conformal->GetPins()[0], vtkIdType{ defaults.conformal.pins[0] }, "Pins");
  check.equal(conformal->GetSkipClosed(), defaults.skipClosed, "SkipClosed");
  check.equal(conformal->GetArrange(), defaults.arrange, "Arrange");
  check.equal(conformal->GetSpacing(), defaults.spacing, "Spacing");
  vtkNew<vtkFlatteningQuality> quality;
  check.equal(quality->GetMaximumOverlaps(), static_cast<int>(mostListedOverlaps), "overlaps");
}

void thePapersMethodIsOneCall(Checks& check)
{
  vtkNew<vtkWireWarpingFilter> filter;
  filter->SetSolverToSequential();
  filter->UsePaperMethod();
  check.equal(filter->GetScheme(), number(vtkWireWarpingFilter::GLOBAL), "the paper's scheme");
  check.equal(filter->GetInterior(), number(vtkWireWarpingFilter::LAPLACIAN), "its interior");
  check.equal(filter->GetSolver(), number(vtkWireWarpingFilter::SEQUENTIAL), "the solver stays");
}
}

int TestDefaults(int, char*[])
{
  Checks check;
  optionsOfWireWarping(check);
  optionsOfImprinting(check);
  optionsOfTheOthers(check);
  thePapersMethodIsOneCall(check);
  return check.result();
}
