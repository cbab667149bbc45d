// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/Garment.h"
#include "Input/DataSet.h"

namespace flattening::pattern
{
/// Pieces as vtkGarmentCodeReader documents them, so that readPattern() reads them.
struct GarmentData
{
  DataSet flat;
  DataSet wires; ///< over the points of `flat`
  DataSet cut;
};

/// Reads a file of GarmentCode: numbers in the unit that it states, brought to centimetres; edges
/// straight, quadratic, cubic or arcs of circles, also in the older form with one control point;
/// control points in the frame of their chord, or in that of the panel where the file says so. What
/// it does not know (parameters of a design) is passed over.
/// \return InvalidPattern with what is wrong where; NothingToDraw without a panel; OutOfMemory
Status readGarmentCode(const std::string& path, GarmentData& data);
/// The panels of the text of such a file.
Status parseGarmentCode(const std::string& text, Garment& garment);
}
