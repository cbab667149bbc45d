// SPDX-License-Identifier: BSD-3-Clause
// Replaces PdfWriter.cxx in a build without cairo or FriBidi.
#include "Formats/PdfWriter.h"

namespace flattening::pattern
{
Status makePdf(const Pattern&, const PageOptions&, std::string&)
{
  return { StatusCode::InvalidOption,
    "this build cannot write PDF, because it was made without cairo or FriBidi", {},
    { Remedy::WriteOtherFormat } };
}
}
