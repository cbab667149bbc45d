// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace figures
{
/// Throws std::runtime_error where VTK could not open a window, not even one off screen: it would
/// end the program there.
void requireDisplay();
}
