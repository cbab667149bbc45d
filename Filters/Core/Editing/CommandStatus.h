// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Memory.h"
#include "Base/Status.h"

#include <string>

namespace flattening
{
/// Of a command that asks for what there is not.
inline Status refusal(const std::string& defect)
{
  return { StatusCode::InvalidOption, defect };
}

/// A command's status, with memory that runs out among them.
template <typename Command>
Status guarded(const Command& command)
{
  struct Outcome
  {
    Status status;
  };
  return withinMemory([&command] { return Outcome{ command() }; }).status;
}
}
