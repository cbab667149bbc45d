// SPDX-License-Identifier: BSD-3-Clause
#include "Listings.h"

#include "Flattening.h"
#include "Report/FlatteningTables.h"

#include <cmath>
#include <cstdio>
#include <ostream>
#include <string>

namespace wirewarp
{
void printFormats(std::ostream& out)
{
  out << R"(Surfaces
  .vtp .vtk .obj .ply .stl .off .gltf .glb, of polygons or triangles. Coordinates are read in double
  precision where the file holds them (STL holds single precision).

Curves
  .vtp or .vtk with polylines on the surface (cell arrays CurveType: 0 accessory, 1 key, 2 dart,
  3 seam; CurveName; for more see vtkFeatureCurveAlgorithm); .obj with line elements, .dxf with LINE,
  LWPOLYLINE, POLYLINE, ARC, CIRCLE, ELLIPSE or SPLINE, whose group or layer is called TYPE NAME;
  .csv with the columns name, x, y, z and, unless names begin with it, type, an empty row between two
  of one name; or text, one curve a line, '#' starts a comment, a NAME with blanks stands in double
  quotes:
    TYPE NAME v0 v1 ...
    edge NAME v0 v1 ...
  TYPE is accessory (length kept), key (length and shape kept), straight (a key that is straight in
  the plane: center line, grainline, fold), dart (cut open) or seam (cut through); edge is an
  accessory curve along the boundary, the shorter way from each vertex to the next: by its name a hem
  or neckline has its own allowance and notches, and it stays a sew line of the pattern; v0 v1 ... are
  vertex ids of SURFACE, counted from 0, or points as x,y,z (of an edge the vertices next to them, if
  no farther from the boundary than 0.5 % of the size of SURFACE). Instead of them may stand
    plane x=0              where a plane across x, y or z cuts SURFACE, all lines of it, or those on
                           one side of others: plane x=0 y>10 z<50
    opening 2              all around an opening, as wirewarp check numbers them; its name is then
                           NAME, as in edge waist opening 2
    boundary left          all around the opening farthest to the left (right, top, bottom, front,
                           back), or along the curve above of that name
    between waist and hem  the straight way from an opening (opening N) or curve above to another
  In a .csv they stand in the column x.
  Polylines in SURFACE itself are curves too. Points of curves need not be vertices: they are laid on
  SURFACE if no farther from it than --curve-distance.
  Curves without a name are called "curve N", N counted from 0 over all curves. Where several share a
  name, options that take a NAME mean all of them.

Results
  A folder holds flat.vtp (pieces in the plane), wires.vtp (their wires), cut.vtp (the cut surface in
  space, point for point like flat.vtp) and report.json (all measures); of cut and reshape also
  curves.vtp (all curves), of reshape flattenable.vtp (the moved surface), of sew sewn.vtp (the cloth
  at rest, point for point like flat.vtp). Earlier files are replaced. pattern, nest, sew and picture
  read such a folder.
  Texts number pieces from 1; PieceId and "piece" of report.json count from 0.

Units
  Lengths are in the unit of SURFACE, angles in radians, times in seconds; sizes are printed in mm and
  cm, by --unit, or by what SURFACE or CURVES state (the field data LengthUnit of .vtp and .vtk, a
  comment of OBJ such as "# units: mm"). Without one of these the command takes mm, cm or m, whichever
  makes SURFACE most nearly as large as clothes and furniture, and says so. Files that are written
  keep a unit that is stated. A length of an option may have its unit: 12mm, 1.2cm, 0.5in, 1.5m. Without one it
  is in mm where the help has MM, in the unit of SURFACE where it has LENGTH.

Exit codes
  0 done; 2 bad usage; 3 input rejected, no result, or files or the table cannot be written;
  4 flattened, but with a warning (not converged, a length error above --max-length-error, a flipped
  triangle, an overlap), or a given --max-strain is missed by more than half of it: files are written.
  Of a batch the worst.
)";
}

namespace
{
std::string range(double least, double greatest)
{
  if (!std::isfinite(least) && !std::isfinite(greatest))
  {
    return "-";
  }
  char text[64];
  std::snprintf(text, sizeof text, "%g..%+g", least, greatest);
  return text;
}
}

void printMaterials(std::ostream& out)
{
  const Table table = flattening::materialTable();
  const auto number = [&](std::size_t row, const char* column) {
    return numberIn(table, row, column);
  };
  const auto text = [&](std::size_t row, const char* column) { return textIn(table, row, column); };
  char line[256];
  std::snprintf(line, sizeof line, "%-14s %9s %9s %9s %7s %12s %12s %6s  %s\n", "material",
    "warp N/m", "weft N/m", "shear N/m", "compr.", "warp %", "weft %", "shear", "what it is");
  out << line;
  for (std::size_t row = 0; row < rowsOf(table); ++row)
  {
    const std::string name = text(row, "Name");
    const bool threads = number(row, "Warp") > 0.0;
    if (!threads)
    {
      std::snprintf(line, sizeof line, "%-14s %9s %9s %9s %7s %12s %12s %6s  ", name.c_str(), "-",
        "-", "-", "-", "-", "-", "-");
    }
    else
    {
      std::snprintf(line, sizeof line, "%-14s %9g %9g %9g %7g %12s %12s %5g°  ", name.c_str(),
        number(row, "Warp"), number(row, "Weft"), number(row, "Shear"), number(row, "Compression"),
        range(number(row, "WarpLeast"), number(row, "WarpGreatest")).c_str(),
        range(number(row, "WeftLeast"), number(row, "WeftGreatest")).c_str(),
        number(row, "ShearLimit"));
    }
    out << line << text(row, "Description") << (number(row, "Sheet") != 0.0 ? " (sheet)" : "")
        << '\n';
  }
  out << "\nStiffness of warp, weft and shear; compr.: in compression over that in tension; then "
         "the limits.\nSheets have no seam allowance by default.\nSources:\n";
  for (std::size_t row = 0; row < rowsOf(table); ++row)
  {
    out << "  " << text(row, "Name") << ": " << text(row, "Source") << '\n';
  }
}
}
