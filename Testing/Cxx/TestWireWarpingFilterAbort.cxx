// SPDX-License-Identifier: BSD-3-Clause
// A run on 200,000 triangles that is aborted once it has started ends within 0.2 s with empty
// outputs.
#include "FlatteningTesting.h"

#include "vtkWireWarpingFilter.h"

#include <algorithm>
#include <chrono>

using namespace flatteningTesting;

namespace
{
using Clock = std::chrono::steady_clock;

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

/// Aborts the filter at its first progress past the start, or, where it is to wait, at the first
/// one after so many seconds; and tells since when the abort was wanted.
class Aborter
{
public:
  explicit Aborter(vtkAlgorithm* algorithm, double wait)
    : Algorithm(algorithm)
    , Wanted(Clock::now() +
        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(wait)))
    , Waits(wait > 0.0)
  {
    this->Tag = algorithm->AddObserver(vtkCommand::ProgressEvent, this, &Aborter::onProgress);
  }
  ~Aborter() { this->Algorithm->RemoveObserver(this->Tag); }
  bool aborted() const { return this->Aborted; }
  double secondsSince() const
  {
    return std::chrono::duration<double>(Clock::now() - this->Wanted).count();
  }

private:
  void onProgress()
  {
    const bool due =
      this->Waits ? Clock::now() >= this->Wanted : this->Algorithm->GetProgress() > 0.0;
    if (!this->Aborted && due)
    {
      this->Aborted = true;
      this->Wanted = this->Waits ? this->Wanted : Clock::now();
      this->Algorithm->SetAbortExecute(1);
    }
  }
  vtkAlgorithm* Algorithm;
  unsigned long Tag = 0;
  bool Aborted = false;
  Clock::time_point Wanted;
  bool Waits;
};

double abortedRun(Checks& check, vtkWireWarpingFilter* filter, double wait)
{
  filter->Modified();
  const Aborter aborter(filter, wait);
  filter->Update();
  const double seconds = aborter.secondsSince();
  check.that(aborter.aborted(), "the run has been aborted");
  check.equal(std::string(filter->GetStatusName()), "Cancelled", "status of an aborted run");
  for (const int port : { 0, 1, 2 })
  {
    check.that(isEmpty(filter->GetOutput(port)), "outputs of an aborted run are empty");
  }
  return seconds;
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
         vtkWireWarpingFilter::ISOMETRIC, vtkWireWarpingFilter::LEAST_SQUARES_CONFORMAL })
  {
    filter->SetScheme(scheme);
    // The best of three, because the machine may be busy with other tests.
    double seconds = abortedRun(check, filter, 0.0);
    for (int again = 0; again < 2 && seconds >= 0.2; ++again)
    {
      seconds = std::min(seconds, abortedRun(check, filter, 0.0));
    }
    std::cout << "scheme " << scheme << ": " << seconds << " s from the abort to the end\n";
    check.that(seconds < 0.2, "scheme " + std::to_string(scheme) + " ends soon after the abort");
  }
  // An observer of progress that makes up its mind within a long phase is asked in time.
  filter->SetSchemeToIsometric();
  double seconds = abortedRun(check, filter, 0.5);
  for (int again = 0; again < 2 && seconds >= 0.3; ++again)
  {
    seconds = std::min(seconds, abortedRun(check, filter, 0.5));
  }
  std::cout << seconds << " s from the wish to abort to the end\n";
  check.that(seconds < 0.3, "the run ends soon after an observer wishes it");
  check.equal(messages.errors.size() + messages.warnings.size(), std::size_t{ 0 },
    "messages of aborted runs");
  return check.result();
}
