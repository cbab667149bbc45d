// SPDX-License-Identifier: BSD-3-Clause
// What holds for each scheme and interior, and what a broken promise looks like: complete outputs,
// one warning, the status in the field data.
#include "FlatteningTesting.h"

#include "vtkIdTypeArray.h"
#include "vtkWireWarpingFilter.h"

using namespace flatteningTesting;

namespace
{
// The interior as rigid as possible halves the angle error of Table 1's global row.
void thePinnedInteriorHalvesTheAngleError(Checks& check)
{
  const auto surface = makeQuarterSphere();
  vtkNew<vtkWireWarpingFilter> filter;
  filter->SetInputData(surface);
  filter->SetCurvesData(makeQuarterSphereArc(surface));
  filter->SetSchemeToGlobal();
  filter->Update();
  check.equal(std::string(filter->GetStatusName()), "Ok", "status");
  check.near(number(filter, "AngleErrorMean"), 0.0779, 5e-5, "E_ang");
  check.near(number(filter, "GlobalHomogeneity"), 0.786, 5e-4, "E_h");
  check.near(number(filter, "Objective"), 0.197157, 1e-6, "objective");
}

// Eq. 12 runs towards Eq. 11.
void theRelaxationAgreesWithTheDirectInterior(Checks& check)
{
  const auto surface = makeQuarterSphere();
  vtkSmartPointer<vtkPolyData> flat[2];
  for (const int run : { 0, 1 })
  {
    vtkNew<vtkWireWarpingFilter> filter;
    filter->SetInputData(surface);
    filter->SetCurvesData(makeQuarterSphereArc(surface));
    filter->SetInterior(
      run == 0 ? vtkWireWarpingFilter::LAPLACIAN : vtkWireWarpingFilter::RELAXATION);
    filter->SetRelaxationMovement(1e-13);
    filter->SetRelaxationMaximumIterations(10000);
    filter->Update();
    flat[run] = filter->GetOutput();
  }
  for (vtkIdType p = 0; p < 37; ++p)
  {
    for (int k = 0; k < 2; ++k)
    {
      check.near(flat[1]->GetPoint(p)[k], flat[0]->GetPoint(p)[k], 1e-10, "coordinate");
    }
  }
}

// The isometric scheme keeps lengths and flips nothing: with both energies, and for
// weights far apart.
void theIsometricSchemeKeepsLengths(Checks& check)
{
  const auto surface = makeQuarterSphere();
  double angleChange[2] = { 0.0, 0.0 };
  for (const double weight : { 1.0, 10.0 })
  {
    for (const int energy :
      { vtkWireWarpingFilter::RIGID, vtkWireWarpingFilter::SYMMETRIC_DIRICHLET })
    {
      vtkNew<vtkWireWarpingFilter> filter;
      filter->SetInputData(surface);
      filter->SetCurvesData(makeQuarterSphereArc(surface));
      filter->SetSchemeToIsometric();
      filter->SetDistortionEnergy(energy);
      filter->SetAngleWeight(weight);
      filter->Update();
      check.equal(std::string(filter->GetStatusName()), "Ok", "status");
      check.near(number(filter, "MaxEdgeLengthError"), 0.0, 1e-12, "E_len_max");
      check.equal(number(filter, "FlippedTriangles"), 0.0, "FlippedTriangles");
      check.that(number(filter, "DistortionEnergy") > 0.0, "DistortionEnergy is given");
      check.that(number(filter, "AngleEnergy") > 0.0, "AngleEnergy is given");
      angleChange[weight > 5.0] = number(filter, "AngleEnergy") / weight;
    }
  }
  check.that(angleChange[1] < angleChange[0], "more weight keeps the wires' angles nearer");
}

void aRunThatDoesNotConvergeIsMarked(Checks& check)
{
  const auto surface = makeQuarterSphere();
  vtkNew<vtkWireWarpingFilter> filter;
  const Messages messages(filter);
  filter->SetInputData(surface);
  filter->SetCurvesData(makeQuarterSphereArc(surface));
  filter->SetSolverToSequential();
  filter->SetMaximumIterations(2);
  filter->Update();
  check.equal(filter->GetStatusCode(), static_cast<int>(vtkWireWarpingFilter::NOT_CONVERGED),
    "status after two iterations");
  check.that(!filter->IsRefused(), "it is no refusal");
  check.equal(messages.errors.size(), std::size_t{ 0 }, "errors");
  check.equal(messages.warnings.size(), std::size_t{ 1 }, "warnings");
  check.equal(filter->GetOutput(0)->GetNumberOfPolys(), 56, "flat triangles");
  check.equal(filter->GetOutput(2)->GetNumberOfPolys(), 56, "triangles in space");
  check.that(filter->GetOutput(1)->GetNumberOfLines() > 0, "there are wires");
  check.equal(text(filter->GetPieces(), "Status"), "NotConverged", "Status of the piece");
  check.equal(text(filter->GetOutput(), "RunStatus"), "NotConverged", "RunStatus");
  check.contains(text(filter->GetPieces(), "StatusMessage"), "2 iterations", "StatusMessage");
}

// A tube, which no plane can hold, is a warning with the points to cut it open between, although
// all lengths are kept; a half of it is none.
void whatAPlaneCannotHoldIsAWarning(Checks& check)
{
  for (const int around : { 12, 30 })
  {
    for (const bool half : { false, true })
    {
      const auto points = vtkSmartPointer<vtkPoints>::New();
      const auto cells = vtkSmartPointer<vtkCellArray>::New();
      for (int ring = 0; ring < 3; ++ring)
      {
        for (int k = 0; k < around; ++k)
        {
          const double turn = 2.0 * vtkMath::Pi() * k / around;
          points->InsertNextPoint(4.0 * std::cos(turn), 4.0 * std::sin(turn), 0.7 * ring);
          if (ring > 0 && (!half || 2 * k < around))
          {
            const vtkIdType a = around * (ring - 1) + k;
            const vtkIdType b = around * (ring - 1) + (k + 1) % around;
            cells->InsertNextCell({ a, b, b + around, a + around });
          }
        }
      }
      vtkNew<vtkPolyData> tube;
      tube->SetPoints(points);
      tube->SetPolys(cells);
      vtkNew<vtkWireWarpingFilter> filter;
      const Messages messages(filter);
      filter->SetInputData(tube);
      filter->Update();
      check.that(!filter->IsRefused(), "a tube is flattened");
      check.near(number(filter, "MaxEdgeLengthError"), 0.0, 1e-9, "E_len_max");
      const std::string verdict = half ? "" : text(filter->GetPieces(), "Verdict");
      const std::size_t broken = filter->GetStatusCode() == vtkWireWarpingFilter::OK ? 0 : 1;
      check.equal(messages.warnings.size(), broken + (half ? 0 : 1), "warnings");
      if (!half && !messages.warnings.empty())
      {
        check.contains(verdict, "this is a tube with 2 openings", "Verdict");
        check.contains(verdict, " to point ", "Verdict");
        check.contains(messages.warnings.back() + messages.warnings.front(), verdict, "warning");
        check.equal(std::string(filter->GetStatusWarnings()->GetValue(0)), "piece 1: " + verdict,
          "the warning");
      }
    }
  }
}

// Fig. 13: key curves that cannot keep their shapes together are named, and one set free.
void incompatibleKeysAreNamed(Checks& check, const std::string& data)
{
  const auto curves = read(data + "/pants_front_curves_set3.vtp");
  vtkNew<vtkWireWarpingFilter> filter;
  const Messages messages(filter);
  filter->SetInputData(read(data + "/pants_front.vtp"));
  filter->SetCurvesData(curves);
  filter->Update();
  check.equal(filter->GetStatusCode(), static_cast<int>(vtkWireWarpingFilter::INCOMPATIBLE_KEYS),
    "status of Fig. 13's keys");
  check.equal(messages.warnings.size(), std::size_t{ 1 }, "warnings");
  check.contains(filter->GetStatusMessage(), "accessory curves", "message");
  check.near(number(filter, "MaxEdgeLengthError"), 0.0, 1e-10, "E_len_max");
  vtkIdTypeArray* ids = filter->GetStatusIds();
  check.that(ids->GetNumberOfValues() > 0, "curves to release are told");
  auto* names = vtkStringArray::SafeDownCast(curves->GetCellData()->GetAbstractArray("CurveName"));
  vtkDataArray* types = curves->GetCellData()->GetArray("CurveType");
  for (vtkIdType k = 0; k < ids->GetNumberOfValues(); ++k)
  {
    const vtkIdType cell = ids->GetValue(k);
    check.equal(types->GetComponent(cell, 0), 1.0, "type of a curve to release");
    check.contains(filter->GetStatusMessage(), names->GetValue(cell), "message");
  }

  filter->ReleaseKeysOn();
  filter->Update();
  check.that(filter->GetStatusCode() != vtkWireWarpingFilter::INCOMPATIBLE_KEYS,
    "released keys are compatible");
}

// The front of the wetsuit's legs is a saddle at the waist: its darts want more cloth, not less.
void crossingCutsAreNamedOrClosed(Checks& check, const std::string& data)
{
  vtkNew<vtkWireWarpingFilter> filter;
  const Messages messages(filter);
  filter->SetInputData(read(data + "/wetsuit_pants_front.vtp"));
  filter->SetCurvesData(read(data + "/wetsuit_pants_front_curves.vtp"));
  filter->Update();
  check.equal(filter->GetStatusCode(), static_cast<int>(vtkWireWarpingFilter::OVERLAP),
    "status of darts that cross");
  check.contains(filter->GetStatusMessage(), "waist_dart_left", "message");

  filter->CloseCutsOn();
  filter->Update();
  check.equal(filter->GetStatusCode(), static_cast<int>(vtkWireWarpingFilter::OK),
    "status with the darts closed");
  check.equal(number(filter, "Overlaps"), 0.0, "overlaps");
  check.near(number(filter, "MaxEdgeLengthError"), 0.0, 1e-10, "E_len_max");
  vtkTable* curves = filter->GetCurves();
  for (vtkIdType row = 0; row < curves->GetNumberOfRows(); ++row)
  {
    const std::string name = text(curves, "Name", row);
    const double closed = number(curves, "ClosedLength", row);
    check.equal(closed > 0.0, name.find("waist_dart") == 0, "closed " + name);
    check.that(closed <= number(curves, "RestLength", row) * (1.0 + 1e-12), "no longer than it");
  }
}
}

int TestWireWarpingFilterPromises(int argc, char* argv[])
{
  Checks check;
  thePinnedInteriorHalvesTheAngleError(check);
  theRelaxationAgreesWithTheDirectInterior(check);
  theIsometricSchemeKeepsLengths(check);
  aRunThatDoesNotConvergeIsMarked(check);
  whatAPlaneCannotHoldIsAWarning(check);
  incompatibleKeysAreNamed(check, dataDirectory(argc, argv));
  crossingCutsAreNamedOrClosed(check, dataDirectory(argc, argv));
  return check.result();
}
