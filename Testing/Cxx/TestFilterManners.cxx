// SPDX-License-Identifier: BSD-3-Clause
// What whoever knows VTK's filters expects of these as well: status before a run, error codes,
// modification times, runs after an abort, and attributes that still mean something in the plane.
#include "FlatteningTesting.h"

#include "vtkErrorCode.h"
#include "vtkLeastSquaresConformalFilter.h"
#include "vtkPolyDataNormals.h"
#include "vtkSurfaceDevelopability.h"
#include "vtkWireWarpingFilter.h"

#include <new>
#include <stdexcept>

using namespace flatteningTesting;

namespace
{
void statusBeforeARunIsNotRun(Checks& check)
{
  vtkNew<vtkWireWarpingFilter> fresh;
  check.equal(std::string(fresh->GetStatusName()), "NotRun", "status of a new filter");
  check.that(fresh->IsRefused(), "a new filter has no result");

  vtkObject::GlobalWarningDisplayOff(); // the executives tell of the reader, to nobody in
                                        // particular
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName("/nonexistent/surface.vtp");
  vtkNew<vtkSurfaceDevelopability> developability;
  vtkNew<vtkWireWarpingFilter> filter;
  for (vtkFlatteningAlgorithm* algorithm : { static_cast<vtkFlatteningAlgorithm*>(developability),
         static_cast<vtkFlatteningAlgorithm*>(filter) })
  {
    // The status of a run before is not that of an input that cannot be read.
    algorithm->SetInputData(makeQuarterSphere());
    algorithm->Update();
    check.that(!algorithm->IsRefused(), "the run before");
    algorithm->SetInputConnection(reader->GetOutputPort());
    algorithm->Update();
    check.equal(algorithm->GetStatusCode(), static_cast<int>(vtkFlatteningAlgorithm::NOT_RUN),
      "status where the input cannot be read");
    check.that(algorithm->IsRefused(), "no result where the input cannot be read");
    const std::string defect = algorithm->GetStatusDefect();
    check.equal(defect, std::string("the filter has not run"), "the defect alone");
    check.equal(std::string(algorithm->GetStatusMessage()).rfind(defect + "; ", 0),
      std::size_t{ 0 }, "a message of the defect and the way out where the input cannot be read");
  }
  vtkObject::GlobalWarningDisplayOn();
}

void refusalsSetTheErrorCode(Checks& check)
{
  vtkNew<vtkWireWarpingFilter> filter;
  const Messages messages(filter);
  filter->SetInputData(vtkNew<vtkPolyData>());
  vtkNew<vtkSurfaceDevelopability> behind;
  behind->SetInputConnection(filter->GetOutputPort());
  vtkObject::GlobalWarningDisplayOff(); // the executive tells of the request
  check.equal(filter->GetExecutive()->Update(), 0, "the request fails");
  filter->Modified();
  behind->Update();
  vtkObject::GlobalWarningDisplayOn();
  check.equal(behind->GetStatusCode(), static_cast<int>(vtkFlatteningAlgorithm::NOT_RUN),
    "status of a filter behind a refusal");
  check.equal(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError),
    "error code of a refusal");
  filter->SetInputData(makeGrid(3, 2));
  filter->Update();
  check.equal(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError),
    "error code of the good run after it");
  behind->Update();
  check.equal(behind->GetStatusCode(), static_cast<int>(vtkFlatteningAlgorithm::OK),
    "status of the filter behind it then");
}

/// An exception that is not bad_alloc, such as a thread that cannot be started, is in the message.
void aLimitOfTheSystemIsNamed(Checks& check)
{
  const std::string limit = "no thread: Resource temporarily unavailable";
  for (std::string what : { limit, std::string() })
  {
    vtkNew<vtkWireWarpingFilter> filter;
    const Messages messages(filter);
    filter->SetInputData(makeGrid(3, 2));
    vtkNew<vtkCallbackCommand> thrower;
    thrower->SetClientData(&what);
    thrower->SetCallback([](vtkObject*, unsigned long, void* client, void* progress) {
      const double fraction = *static_cast<double*>(progress);
      if (fraction <= 0.0 || fraction >= 1.0)
      {
        return; // of the executive, outside of the filter's work
      }
      const std::string& text = *static_cast<std::string*>(client);
      if (text.empty())
      {
        throw std::bad_alloc();
      }
      throw std::runtime_error(text);
    });
    filter->AddObserver(vtkCommand::ProgressEvent, thrower);
    filter->Update();
    check.equal(filter->GetStatusCode(), static_cast<int>(vtkFlatteningAlgorithm::OUT_OF_MEMORY),
      "status of a run that a limit ended");
    check.equal(std::string(filter->GetStatusMessage()).find(limit) != std::string::npos,
      what == limit, "the limit in the message");
  }
}

template <class Filter>
void anAbortedRunIsDoneAgain(Checks& check)
{
  vtkNew<Filter> filter;
  const Messages messages(filter);
  filter->SetInputData(makeQuarterSphere());
  int runs = 0;
  bool abort = true;
  struct Observer
  {
    vtkAlgorithm* algorithm;
    bool* abort;
    int* runs;
    void start() { ++*this->runs; }
    void progress() { this->algorithm->SetAbortExecute(*this->abort ? 1 : 0); }
  } observer{ filter, &abort, &runs };
  filter->AddObserver(vtkCommand::StartEvent, &observer, &Observer::start);
  filter->AddObserver(vtkCommand::ProgressEvent, &observer, &Observer::progress);
  filter->Update();
  check.equal(std::string(filter->GetStatusName()), "Cancelled", "status of the aborted run");
  for (const int port : { 0, 1, 2 })
  {
    check.that(isEmpty(filter->GetOutput(port)), "outputs of the aborted run are empty");
  }
  check.equal(messages.errors.size() + messages.warnings.size(), std::size_t{ 0 }, "messages");
  abort = false;
  filter->Update();
  check.equal(std::string(filter->GetStatusName()), "Ok", "status of the next update");
  check.equal(runs, 2, "runs so far");
  filter->Update();
  check.equal(runs, 2, "runs after an update that has nothing to do");
}

void normalsDoNotFollowIntoThePlane(Checks& check)
{
  const vtkSmartPointer<vtkPolyData> surface = makeQuarterSphere();
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface);
  normals->ComputeCellNormalsOn();
  normals->SplittingOff();
  vtkNew<vtkWireWarpingFilter> filter;
  filter->SetInputConnection(normals->GetOutputPort());
  filter->Update();
  check.that(!isEmpty(filter->GetOutput()), "the piece is flattened");
  check.that(
    !filter->GetOutput()->GetPointData()->GetNormals(), "no normals at points of the plane");
  check.that(!filter->GetOutput()->GetCellData()->GetNormals(), "no normals of cells in the plane");
  check.that(filter->GetOutput(2)->GetPointData()->GetNormals(), "normals stay on the surface");
}
}

int TestFilterManners(int, char*[])
{
  Checks check;
  statusBeforeARunIsNotRun(check);
  refusalsSetTheErrorCode(check);
  aLimitOfTheSystemIsNamed(check);
  anAbortedRunIsDoneAgain<vtkWireWarpingFilter>(check);
  anAbortedRunIsDoneAgain<vtkLeastSquaresConformalFilter>(check);
  normalsDoNotFollowIntoThePlane(check);
  return check.result();
}
