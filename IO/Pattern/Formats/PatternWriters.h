// SPDX-License-Identifier: BSD-3-Clause
// A pattern in each of its file formats, as the bytes of the file.
#pragma once

#include "Formats/PdfPages.h"
#include "Outlines/DrawingSource.h"

#include <string>

namespace flattening::pattern
{
/// A pattern as SVG 1.1 whose user unit is the millimetre, with a test rectangle of 100 mm x 50 mm.
/// One group a piece, in it one group a role, both layers to Inkscape; a wire's path has
/// `data-length`, its length on the surface, and `data-curve`. Written here and not with cairo,
/// whose paths are held in steps of a 256th of a point: lengths to 1e-6 need more digits than that.
/// \param laserColors a color a role, all lines thin and whole; otherwise as on paper
std::string makeSvg(const Pattern& pattern, bool laserColors);

/// A pattern as PDF at 1:1, on the pages that drawPages() draws, by cairo.
Status makePdf(const Pattern& drawing, const PageOptions& options, std::string& pdf);

/// The characters of a line in the order in which they stand on paper from the left, for libraries
/// that draw one after the other, by the Unicode bidirectional algorithm (Unicode Standard Annex
/// 9): words of letters that are written from the right are turned round, numbers among them are
/// not, brackets are mirrored, and letters of Arabic take the forms in which they join. A line runs
/// from the left as soon as it has a letter that does, as the patterns' own words; its marks of
/// direction and embedding are taken out. A line without letters from the right is returned as it
/// is.
/// \param text valid UTF-8
/// \throws std::bad_alloc
std::string visualOrder(const std::string& text);

/// A pattern as DXF R12 ASCII after ASTM D6673 / AAMA, with the layers and units that
/// vtkPatternWriter documents, and the numbers of grade rules on layer 2. Beside the points that
/// pattern systems look for, notches are short lines and drill holes circles, for who else opens
/// the file. Layers and entities have handles.
std::string makeDxf(const Pattern& pattern);

/// The same for laser, knife and router: model space alone, with the layers CUT, MARK and TEXT,
/// each line once as a polyline with arcs, nothing that a machine would cut twice, no points, and
/// no grainline on sheets.
std::string makeCutterDxf(const Pattern& pattern);

/// A pattern as HPGL for plotters and cutters, in their unit of a 40th of a millimetre, from the
/// lower left: pen 1 draws everything but the cut lines, with texts in 7 bits, then pen 2 cuts the
/// cut lines, holes first.
std::string makeHpgl(const Pattern& pattern);

/// A flattening as the JSON of GarmentCode (M. Korosteleva, O. Sorkine-Hornung, GarmentCode:
/// programming parametric sewing patterns, ACM Transactions on Graphics 42(6), 2023): panels
/// without allowance, in centimetres, with straight and cubic edges; stitches between edges of the
/// same length; each panel placed in space where its piece fits the surface best. Numbers are
/// written such that reading them gives the same bits. Pieces that were panels are
/// written as these again.
/// \param source as it was read, for its panels
/// \param all what prepareDrawing() made of it
/// \param drawing for the names of the pieces
/// \return InvalidPattern for a piece with a hole, which the format cannot hold
Status makeGarmentCode(
  const PatternSource& source, const DrawingSource& all, const Pattern& drawing, std::string& json);
}
