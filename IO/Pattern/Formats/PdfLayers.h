// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"

#include <string>
#include <vector>

namespace flattening::pattern
{
/// What a layer of a PDF shows, as a PDF of its own.
struct PdfLayer
{
  std::string name; ///< UTF-8
  std::string pdf;
};

/// Whether this build was made with qpdf, which writes layers.
bool hasPdfLayers();

/// Lays drawings of the same pages on each other, each as a layer that can be hidden.
/// \param layers the lowest one first; it may have more pages, which stay as they are
/// \param pages how many are laid on each other
/// \return InvalidPattern where a drawing cannot be read
Status joinPdfLayers(const std::vector<PdfLayer>& layers, std::size_t pages, std::string& pdf);
}
