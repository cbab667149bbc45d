// SPDX-License-Identifier: BSD-3-Clause
// A part of a cone without VTK: flattened by Core, where it must keep its area, and drawn by
// Pattern.
#include "Flattening/SurfaceFlattening.h"
#include "Formats/PatternFile.h"

#include <cmath>
#include <cstdio>

int main()
{
  using namespace flattening;
  constexpr Index around = 24;
  constexpr Index along = 10;
  Points3 points;
  Triangles triangles;
  for (Index j = 0; j <= along; ++j)
  {
    for (Index i = 0; i <= around; ++i)
    {
      const double angle = 2.0 * i / around;
      const double radius = 10.0 + j;
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 2.0 * j);
    }
  }
  for (Index j = 0; j < along; ++j)
  {
    for (Index i = 0; i < around; ++i)
    {
      const Index corner = j * (around + 1) + i;
      triangles.push_back({ corner, corner + 1, corner + around + 2 });
      triangles.push_back({ corner, corner + around + 2, corner + around + 1 });
    }
  }
  const TriangleMesh mesh(points, triangles);
  const FlatteningResult result = flattenSurface(mesh, {}, FlatteningOptions(), Execution());
  if (!result.status.ok())
  {
    std::printf("not flattened: %s\n", result.status.message.c_str());
    return 1;
  }
  double area = 0.0;
  for (const Triangle& triangle : triangles)
  {
    const Point2 first = result.positions[triangle[1]] - result.positions[triangle[0]];
    const Point2 second = result.positions[triangle[2]] - result.positions[triangle[0]];
    area += 0.5 * (first.x() * second.y() - first.y() * second.x());
  }
  const double lost = std::abs(area / mesh.area() - 1.0);

  pattern::PatternSource source;
  source.positions = result.positions;
  source.inSpace = points;
  source.triangles = triangles;
  source.pieceOfTriangle.assign(triangles.size(), 0);
  for (const Wire& wire : result.wires)
  {
    pattern::SourceWire line;
    line.points = wire.vertices;
    line.piece = wire.piece;
    source.wires.push_back(line);
  }
  pattern::FileOptions options;
  options.pattern.allowance = 0.0;
  pattern::Pattern drawing;
  std::string svg;
  const Status written = pattern::makePatternFile(source, options, drawing, svg);
  std::printf("area lost %.1e, %zu bytes of SVG %s\n", lost, svg.size(), written.message.c_str());
  return lost < 1e-9 && written.ok() && svg.find("cut-line") != std::string::npos ? 0 : 1;
}
