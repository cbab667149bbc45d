// SPDX-License-Identifier: BSD-3-Clause
// Replaces PdfWriter.cxx in a build without cairo, FriBidi or qpdf.
#include "Formats/PatternWriters.h"

namespace flattening::pattern
{
Status makePdf(const Pattern&, const PageOptions&, std::string&)
{
  return { StatusCode::InvalidOption,
    "this build cannot write PDF, because it was made without cairo, FriBidi or qpdf", {},
    { Remedy::WriteOtherFormat } };
}
}
