// SPDX-License-Identifier: BSD-3-Clause
#include "FilterOptions.h"

#include "MethodNames.h"

#include <vtkFeatureCurveSuggestion.h>
#include <vtkKeyCurvePrices.h>
#include <vtkNew.h>
#include <vtkWireWarpingFilter.h>

namespace wirewarp
{
//------------------------------------------------------------------------------
Options defaultOptions()
{
  const vtkNew<vtkWireWarpingFilter> filter;
  Options options;
  options.scheme = schemeNames[static_cast<std::size_t>(filter->GetScheme())];
  options.solver = solverNames[static_cast<std::size_t>(filter->GetSolver())];
  options.interior = interiorNames[static_cast<std::size_t>(filter->GetInterior())];
  options.releaseKeys = filter->GetReleaseKeys();
  options.releaseTrials = filter->GetReleaseTrials();
  options.closeCuts = filter->GetCloseCuts();
  options.dartLegs = dartLegNames[static_cast<std::size_t>(filter->GetDartLegs())];
  options.skipClosed = filter->GetSkipClosed();
  options.energy = energyNames[static_cast<std::size_t>(filter->GetDistortionEnergy())];
  options.areaBias = filter->GetAreaBias();
  options.angleWeight = filter->GetAngleWeight();
  options.isometricMaximumIterations = filter->GetIsometricMaximumIterations();
  options.isometricTolerance = filter->GetIsometricTolerance();
  options.material = filter->GetMaterial();
  options.grain = filter->GetGrain();
  options.maximumIterations = filter->GetMaximumIterations();
  options.closureTolerance = filter->GetClosureTolerance();
  options.optimalityTolerance = filter->GetOptimalityTolerance();
  options.relaxationFactor = filter->GetRelaxationFactor();
  options.relaxationMovement = filter->GetRelaxationMovement();
  options.relaxationMinimumIterations = filter->GetRelaxationMinimumIterations();
  options.relaxationMaximumIterations = filter->GetRelaxationMaximumIterations();
  options.rigidTolerance = filter->GetRigidEnergyTolerance();
  options.rigidMaximumIterations = filter->GetRigidMaximumIterations();
  options.split = filter->GetSplitTriangles();
  options.imprintTolerance = filter->GetImprintTolerance();
  options.snapTolerance = filter->GetSnapTolerance();
  options.arrange = filter->GetArrange();
  options.spacing = filter->GetSpacing();
  options.maximumLengthError = filter->GetMaximumLengthError();
  for (std::size_t k = 0; k < 2; ++k)
  {
    options.pins[k] = static_cast<int>(filter->GetConformalPins()[k]);
  }
  const vtkNew<vtkFeatureCurveSuggestion> suggestion;
  options.bound = suggestion->GetBound();
  options.maximumCuts = suggestion->GetMaximumCuts();
  options.maximumCutLength = suggestion->GetMaximumCutLength();
  options.maximumWork = suggestion->GetMaximumWork();
  options.symmetric = suggestion->GetSymmetric() ? "auto" : "off";
  return options;
}

//------------------------------------------------------------------------------
void setOptions(const Options& options, vtkWireWarpingFilter* filter)
{
  filter->SetScheme(valueOf(schemeNames, options.scheme));
  filter->SetSolver(valueOf(solverNames, options.solver));
  filter->SetInterior(valueOf(interiorNames, options.interior));
  filter->SetReleaseKeys(options.releaseKeys);
  filter->SetReleaseTrials(options.releaseTrials);
  filter->SetCloseCuts(options.closeCuts);
  filter->SetDartLegs(valueOf(dartLegNames, options.dartLegs));
  filter->SetSkipClosed(options.skipClosed);
  filter->SetDistortionEnergy(valueOf(energyNames, options.energy));
  filter->SetAreaBias(options.areaBias);
  filter->SetAngleWeight(options.angleWeight);
  filter->SetIsometricMaximumIterations(options.isometricMaximumIterations);
  filter->SetIsometricTolerance(options.isometricTolerance);
  filter->SetMaterial(options.material.c_str());
  filter->SetGrain(options.grain.c_str());
  filter->SetMaximumIterations(options.maximumIterations);
  filter->SetClosureTolerance(options.closureTolerance);
  filter->SetOptimalityTolerance(options.optimalityTolerance);
  filter->SetRelaxationFactor(options.relaxationFactor);
  filter->SetRelaxationMovement(options.relaxationMovement);
  filter->SetRelaxationMinimumIterations(options.relaxationMinimumIterations);
  filter->SetRelaxationMaximumIterations(options.relaxationMaximumIterations);
  filter->SetRigidEnergyTolerance(options.rigidTolerance);
  filter->SetRigidMaximumIterations(options.rigidMaximumIterations);
  filter->SetConformalPins(options.pins[0], options.pins[1]);
  filter->SetSplitTriangles(options.split);
  filter->SetImprintTolerance(options.imprintTolerance);
  filter->SetSnapTolerance(options.snapTolerance);
  filter->SetArrange(options.arrange);
  filter->SetSpacing(options.spacing);
  filter->SetMaximumLengthError(options.maximumLengthError);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkWireWarpingFilter> makeFilter(const Options& options)
{
  if (options.reshaping.any())
  {
    return makeReshapingFilter(options.reshaping);
  }
  if (options.priceKeys)
  {
    return vtkSmartPointer<vtkKeyCurvePrices>::New();
  }
  if (options.suggest.empty())
  {
    return vtkSmartPointer<vtkWireWarpingFilter>::New();
  }
  const auto filter = vtkSmartPointer<vtkFeatureCurveSuggestion>::New();
  filter->SetSuggestedCuts(valueOf(suggestNames, options.suggest));
  filter->SetBound(options.bound);
  filter->SetMaximumCuts(options.maximumCuts);
  filter->SetMaximumCutLength(options.maximumCutLength);
  filter->SetMaximumWork(options.maximumWork);
  filter->SetSymmetric(options.symmetric == "auto");
  for (const auto& [curve, weight] : options.preferences)
  {
    filter->AddPreference(curve, weight);
  }
  filter->SetWeightArray(options.weights.c_str());
  return filter;
}
}
