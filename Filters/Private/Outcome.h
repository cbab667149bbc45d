// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"

#include "vtkType.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace flattening
{
namespace bridge
{
/// A Status whose ids are those of the input's data set.
struct Outcome
{
  StatusCode code = StatusCode::Ok;
  std::string message;
  std::vector<vtkIdType> ids;
  vtkPolyData* curves = nullptr; ///< the data set of the curve that is to blame

  bool ok() const { return this->code == StatusCode::Ok; }
};

/// An outcome without ids to translate.
Outcome outcomeOf(const Status& status);

/// An outcome in the input's ids, each once, in order of first mention. Where they differ from
/// those that the message tells, they are added to it.
/// \param noun what the ids are, "cells" or "points"
/// \param inputId per id of the status its id in the input; negative: it has none
Outcome outcomeOf(const Status& status, const char* noun, const std::vector<vtkIdType>& inputId);
}
}
