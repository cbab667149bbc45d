// SPDX-License-Identifier: BSD-3-Clause
// Replaces PdfLayers.cxx in a build without qpdf.
#include "Formats/PdfLayers.h"

namespace flattening::pattern
{
bool hasPdfLayers()
{
  return false;
}

Status joinPdfLayers(const std::vector<PdfLayer>&, std::size_t, std::string&)
{
  return { StatusCode::InvalidOption,
    "this build cannot write layers in PDF, because it was made without qpdf", {},
    { Remedy::WriteOtherFormat } };
}
}
