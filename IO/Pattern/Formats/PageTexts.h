// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Formats/PdfPages.h"

namespace flattening::pattern
{
/// Moves each text that lies on the border of a page, or on a page that is left out, onto a page
/// nearby, within its piece and as far from its lines and other texts as that allows. Title and
/// labels of a piece move together.
void keepTextsOnPages(const PagePlan& plan, Pattern& pattern);
}
