// SPDX-License-Identifier: BSD-3-Clause
// A run on 200,000 triangles that is aborted, once it has started or within a phase, goes on to no
// other phase and leaves empty outputs.
#include "FlatteningTesting.h"

#include "vtkLeastSquaresConformalFilter.h"
#include "vtkWireWarpingFilter.h"

using namespace flatteningTesting;

namespace
{
constexpr int gridSize = 320;

double bulge(double x, double y)
{
  return 0.1 * std::sin(3.0 * x) * std::sin(3.0 * y);
}

/// A curved sheet with wires along two rows and two columns.
vtkSmartPointer<vtkPolyData> makeLargePiece()
{
  vtkSmartPointer<vtkPolyData> piece = makeGrid(gridSize, gridSize, bulge);
  for (const int at : { gridSize / 3, 2 * gridSize / 3 })
  {
    Cell row;
    Cell column;
    for (int k = 0; k <= gridSize; ++k)
    {
      row.push_back(at * (gridSize + 1) + k);
      column.push_back(k * (gridSize + 1) + at);
    }
    addLine(piece, row);
    addLine(piece, column);
  }
  return piece;
}

/// Aborts a run at a progress event, and counts the events that the run still sends.
class Aborter
{
public:
  enum When
  {
    OnceStarted,
    WithinAPhase, ///< at an event that tells no progress, so that observers can make up their mind
  };

  Aborter(vtkAlgorithm* algorithm, When when)
    : Algorithm(algorithm)
    , Moment(when)
  {
    this->Tag = algorithm->AddObserver(vtkCommand::ProgressEvent, this, &Aborter::onProgress);
  }
  ~Aborter() { this->Algorithm->RemoveObserver(this->Tag); }
  Aborter(const Aborter&) = delete;
  Aborter& operator=(const Aborter&) = delete;

  bool aborted() const { return this->Aborted; }
  int eventsAfter() const { return this->EventsAfter; }

private:
  void onProgress()
  {
    if (this->Aborted)
    {
      ++this->EventsAfter;
      return;
    }
    const double progress = this->Algorithm->GetProgress();
    if (progress > 0.0 && (this->Moment == OnceStarted || progress == this->Last))
    {
      this->Aborted = true;
      this->Algorithm->SetAbortExecute(1);
    }
    this->Last = progress;
  }

  vtkAlgorithm* Algorithm;
  When Moment;
  unsigned long Tag = 0;
  bool Aborted = false;
  int EventsAfter = 0;
  double Last = 0.0;
};

void abortedRunEnds(
  Checks& check, vtkFlatPieceAlgorithm* filter, Aborter::When when, const std::string& what)
{
  filter->Modified();
  const Aborter aborter(filter, when);
  filter->Update();
  check.that(aborter.aborted(), what + " has been aborted");
  // The phase that is about to begin when the run asks next may be told.
  check.that(aborter.eventsAfter() <= 1,
    what + " goes on for " + std::to_string(aborter.eventsAfter()) + " events");
  check.equal(std::string(filter->GetStatusName()), "Cancelled", "status of " + what);
  for (const int port : { 0, 1, 2 })
  {
    check.that(isEmpty(filter->GetOutput(port)), "outputs of " + what + " are empty");
  }
}
}

int TestWireWarpingFilterAbort(int, char*[])
{
  Checks check;
  const vtkSmartPointer<vtkPolyData> piece = makeLargePiece();
  vtkNew<vtkWireWarpingFilter> filter;
  const Messages messages(filter);
  filter->SetInputData(piece);
  for (const int scheme : { vtkWireWarpingFilter::PROGRESSIVE, vtkWireWarpingFilter::GLOBAL,
         vtkWireWarpingFilter::ISOMETRIC })
  {
    filter->SetScheme(scheme);
    const std::string run = std::string("a run of scheme ") + filter->GetSchemeAsString();
    abortedRunEnds(check, filter, Aborter::OnceStarted, run);
  }
  filter->SetSchemeToIsometric();
  abortedRunEnds(check, filter, Aborter::WithinAPhase, "a run within a phase");
  vtkNew<vtkLeastSquaresConformalFilter> conformal;
  conformal->SetInputData(piece);
  abortedRunEnds(check, conformal, Aborter::OnceStarted, "a run of the conformal map");
  check.equal(messages.errors.size() + messages.warnings.size(), std::size_t{ 0 },
    "messages of aborted runs");
  return check.result();
}
