// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkLookupTable.h>
#include <vtkScalarBarActor.h>
#include <vtkSmartPointer.h>

namespace figures
{
/// A horizontal bar of colors with numbers below it.
/// @param labels how many numbers; textSize in pixels
vtkSmartPointer<vtkScalarBarActor> makeScaleBar(vtkLookupTable* colors, int labels, int textSize);
}
