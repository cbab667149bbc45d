// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// In ParaView's window, where flat pieces appear for the first time, resets the camera of their
/// view, so that surface and pieces are seen whole, and draws their wires 3 pixels wide. ParaView
/// calls it when it loads the plugin; without a window it does nothing.
void arrangeFirstPictures();
