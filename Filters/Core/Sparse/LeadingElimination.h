// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Types.h"

#include <Eigen/SparseCore>

namespace flattening
{
/// An order of elimination for a symmetric matrix whose first columns stay first, in their order,
/// and whose others follow in the order of minimum degree of the graph that is left when the first
/// ones are eliminated.
///
/// \param lower only its lower triangle is read
/// \param leading how many columns stay
/// \return the column at each place
Indices leadingColumnsFirst(const Eigen::SparseMatrix<double>& lower, Index leading);
}
