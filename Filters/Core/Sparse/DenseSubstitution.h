// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Sparse/FactorBlocks.h"

#include <Eigen/Core>

namespace flattening
{
/// Right-hand sides that are solved together, so that L is read once; each as long as the front.
using FrontVectors = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

/// Solves L x = w in the columns of a front and takes them out of the rows below.
void substituteForward(const FactorColumns<const double>& factor, FrontVectors w);
void substituteForward(const FactorColumns<const float>& factor, FrontVectors w);
/// Solves L^T x = w in the columns of a front, the rows below being known. What is kept above the
/// diagonal must be finite.
void substituteBackward(const FactorColumns<const double>& factor, FrontVectors w);
void substituteBackward(const FactorColumns<const float>& factor, FrontVectors w);
}
