// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input/DataSet.h"

#include <string>
#include <string_view>

namespace wirewarp
{
/// Points, cells and arrays as bytes of this machine, to go from one process to another.
std::string packDataSet(flattening::DataSet data);

/// The data of such bytes. Whatever the bytes are, the result is sound: cells name points that
/// exist, and names are such as XML can hold. Arrays may be shorter than their points or cells: the
/// flattening leaves such out and says so. Throws std::runtime_error that names the defect
/// otherwise.
flattening::DataSet unpackDataSet(std::string_view bytes);
}
