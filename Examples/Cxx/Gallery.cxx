// SPDX-License-Identifier: BSD-3-Clause
// One picture a piece: the surface with its curves and its developability, the flat pieces of the
// isometric scheme, which is the default, of the global scheme and of LSCM, and maps of what they
// change: 1 - index of homogeneity and of aspect ratio, with scales. overview.png is the picture of
// the README.
#include "Figure.h"
#include "Panels.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <utility>

using namespace figures;

namespace
{
constexpr int width = 1600;
constexpr int maximumHeight = 2000;
constexpr int samples = 8;

std::string withNumber(const char* pattern, double value)
{
  char text[80];
  std::snprintf(text, sizeof(text), pattern, value);
  return text;
}

void addFlat(Figure& figure, const std::vector<FlatPiece>& flat, const std::string& method)
{
  Drawing& drawing = figure.add();
  drawing.setTitle(method + withNumber(", E_len %.4f", flat[0].number("EdgeLengthError")));
  drawFlat(drawing, flat);
}

void addIndex(
  Figure& figure, const std::vector<FlatPiece>& flat, const std::string& title, const char* array)
{
  Drawing& drawing = figure.add();
  drawing.setTitle(title);
  drawIndex(drawing, flat, array);
}

void drawPiece(const std::string& folder, const std::string& name, const std::string& path)
{
  const std::vector<Piece> pieces{ readPiece(folder, name) };
  const Vector view = facing(pieces[0].surface);
  const auto isometric = flattenAll(pieces, Method::Isometric);
  const auto global = flattenAll(pieces, Method::Global);
  const auto conformal = flattenAll(pieces, Method::LeastSquaresConformal);

  Figure figure(width, maximumHeight, samples);
  Drawing& surface = figure.add();
  surface.setTitle("surface");
  drawSpace(surface, pieces, view);
  addFlat(figure, isometric, "isometric");
  addFlat(figure, global, "global");
  addFlat(figure, conformal, "LSCM");
  figure.nextRow();

  Drawing& map = figure.add();
  const double largest = drawDevelopability(map, pieces, view);
  map.setTitle(withNumber("E_dev up to %.2g rad", largest));
  figure.addScale("E_dev, rad: 0 is developable", { 0.0, std::max(largest, developable) });
  figure.addScale("1 - index of homogeneity, of aspect ratio: 0 is undistorted", { 0.0, 0.5 });
  for (const auto& [index, array] : { std::pair("homogeneity", "HomogeneityOfDistortion"),
         std::pair("aspect ratio", "AspectRatio") })
  {
    addIndex(figure, isometric, std::string("isometric, ") + index, array);
    addIndex(figure, conformal, std::string("LSCM, ") + index, array);
  }
  figure.write(path);
}

/// Front and back of the shirt in space, and its three flat pieces.
void drawOverview(const std::string& folder, const std::string& path)
{
  const std::vector<Piece> pieces{ readPiece(folder, "shirt_front"),
    readPiece(folder, "shirt_back"), readPiece(folder, "shirt_shoulder") };
  Figure figure(width, maximumHeight, samples);
  drawSpace(figure.add(), pieces, { 0.0, 0.0, 1.0 });
  drawSpace(figure.add(), pieces, { 0.0, 0.0, -1.0 });
  drawFlat(figure.add(), flattenAll(pieces, Method::Isometric));
  figure.write(path);
}
}

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    std::cerr << "usage: Gallery DATA_FOLDER PICTURE_FOLDER\n";
    return EXIT_FAILURE;
  }
  try
  {
    const std::string data = argv[1];
    const std::string pictures = argv[2];
    if (!vtksys::SystemTools::MakeDirectory(pictures))
    {
      throw std::runtime_error("cannot make " + pictures);
    }
    const std::vector<std::string> names = listPieces(data);
    if (names.empty())
    {
      throw std::runtime_error("no .vtp files in " + data);
    }
    const auto path = [&](const std::string& name) { return pictures + "/" + name + ".png"; };
    for (const std::string& name : names)
    {
      drawPiece(data, name, path(name));
    }
    drawOverview(data, path("overview"));
  }
  catch (const std::exception& error)
  {
    std::cerr << "Gallery: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
