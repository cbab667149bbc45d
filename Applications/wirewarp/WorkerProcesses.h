// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace wirewarp
{
/// Runs jobs 0 to count - 1 in processes of their own, `workers` at a time, so that neither VTK's
/// global state nor a crash of one job reaches another. Call it before there is a thread.
/// \param job runs in a worker and gives a text.
/// \param done runs here, in the order in which jobs end, with the job's text; without one where
/// its process died.
/// Throws std::runtime_error where no process can be made.
void runInProcesses(std::size_t count, std::size_t workers,
  const std::function<std::string(std::size_t)>& job,
  const std::function<void(std::size_t, const std::optional<std::string>&)>& done);
}
