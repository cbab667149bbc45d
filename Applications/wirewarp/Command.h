// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace wirewarp
{
/// The command `wirewarp`; ends the process.
[[noreturn]] void runCommand(int argc, char** argv);
}
