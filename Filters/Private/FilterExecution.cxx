// SPDX-License-Identifier: BSD-3-Clause
#include "FilterExecution.h"

#include "vtkAlgorithm.h"
#include "vtkSMPTools.h"
#include "vtkVersion.h"

namespace flattening
{
namespace bridge
{
Execution executionOf(vtkAlgorithm* algorithm)
{
  Execution execution;
  execution.progress = [algorithm](double fraction, const char* phase) {
    algorithm->SetProgressText(phase);
    algorithm->UpdateProgress(fraction);
  };
  execution.cancel = [algorithm]() {
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
    return algorithm->CheckAbort();
#else
    return algorithm->GetAbortExecute() != 0;
#endif
  };
  execution.parallel = [](Index count, const std::function<void(Index, Index)>& body) {
    vtkSMPTools::For(0, count, [&body](vtkIdType begin, vtkIdType end) {
      body(static_cast<Index>(begin), static_cast<Index>(end));
    });
  };
  return execution;
}
}
}
