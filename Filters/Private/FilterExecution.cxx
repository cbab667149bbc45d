// SPDX-License-Identifier: BSD-3-Clause
#include "FilterExecution.h"

#include "Base/Memory.h"

#include "vtkAlgorithm.h"
#include "vtkSMPTools.h"
#include "vtkVersion.h"

#include <chrono>
#include <memory>
#include <stdexcept>

namespace flattening::bridge
{
namespace
{
/// What the observers of an algorithm's progress know, and since when.
struct Told
{
  using Clock = std::chrono::steady_clock;

  double fraction = 0.0;
  Clock::time_point when = Clock::now();

  bool isLongAgo() const { return Clock::now() - this->when > std::chrono::milliseconds(50); }
  void tell(vtkAlgorithm* algorithm, double newFraction)
  {
    this->fraction = newFraction;
    algorithm->UpdateProgress(newFraction);
    this->when = Clock::now();
  }
};
}

Execution executionOf(vtkAlgorithm* algorithm)
{
  const auto told = std::make_shared<Told>();
  Execution execution;
  execution.progress = [algorithm, told](double fraction, const char* phase) {
    algorithm->SetProgressText(phase);
    told->tell(algorithm, fraction);
  };
  execution.cancel = [algorithm, told]() {
    // Who watches progress may want to end the run, however long a phase takes.
    if (told->isLongAgo())
    {
      told->tell(algorithm, told->fraction);
    }
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
    return algorithm->CheckAbort();
#else
    return algorithm->GetAbortExecute() != 0;
#endif
  };
  execution.parallel = [](Index count, const std::function<void(Index, Index)>& body) {
    try
    {
      vtkSMPTools::For(0, count, [&body](vtkIdType begin, vtkIdType end) {
        body(static_cast<Index>(begin), static_cast<Index>(end));
      });
    }
    catch (const std::runtime_error& error)
    {
      // Bodies keep what they throw; TBB reports so that it cannot start a thread.
      throw SystemLimit(error.what());
    }
  };
  return execution;
}
}
