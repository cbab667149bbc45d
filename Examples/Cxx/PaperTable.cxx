// SPDX-License-Identifier: BSD-3-Clause
// Table 1 of the WireWarping paper for the pieces of Data/: how far each method changes lengths,
// angles and areas, and how long it takes. The paper's own pieces are not public, so theirs are
// other numbers; only the quarter-sphere can be made again from its description, and its rows stand
// beside the paper's. The isometric scheme, which the paper does not have, stands among them. With
// --check the program fails unless the paper's rows agree in every digit that it prints.
#include "Pieces.h"

#include <vtkLeastSquaresConformalFilter.h>
#include <vtkNew.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

using namespace figures;

namespace
{
struct Example
{
  const char* title;
  const char* name; ///< of the files in Data/
  const char* set;  ///< of curves
  bool conformal;   ///< Table 1 compares with the conformal map
};

const std::vector<Example> examples{
  { "Shirt, front", "shirt_front", "", true },
  { "Shirt, back", "shirt_back", "", true },
  { "Shirt, shoulder", "shirt_shoulder", "", true },
  { "Pants (set 1), front", "pants_front", "", true },
  { "Pants (set 1), back", "pants_back", "", true },
  { "Pants (set 2), front", "pants_front", "_set2", false },
  { "Pants (set 2), back", "pants_back", "_set2", false },
  { "Wetsuit upper body, front", "wetsuit_upper_front", "", true },
  { "Wetsuit upper body, back", "wetsuit_upper_back", "", true },
  { "Wetsuit pants, front", "wetsuit_pants_front", "", true },
  { "Wetsuit pants, back", "wetsuit_pants_back", "", true },
  { "Quarter-sphere", "quarter_sphere", "", true },
};

/// A row that the paper prints for the quarter-sphere. Its E_r is defined elsewhere, in a way that
/// gives other numbers than min s / max S for the first two.
struct PrintedRow
{
  const char* lengthError;
  const char* angleError;
  const char* homogeneity;
  const char* aspectRatio;
};

PrintedRow printedRow(Method method)
{
  switch (method)
  {
    case Method::Progressive:
      return { "0.00", "159.1", "0.394", "0.511" };
    case Method::Global:
      return { "0.00", "148.8", "0.404", "0.518" };
    default:
      return { "64.3", "42.1", "0.582", "0.672" };
  }
}

const char* nameOf(Method method)
{
  return method == Method::Progressive ? "Progressive"
    : method == Method::Global         ? "Global"
    : method == Method::Isometric      ? "Isometric"
                                       : "LSCM";
}

template <typename... Values>
std::string format(const char* pattern, Values... values)
{
  char text[160];
  std::snprintf(text, sizeof(text), pattern, values...);
  return text;
}

std::string thousandths(double value)
{
  return format("%.2f", 1e3 * value);
}

/// Whether a number has the digits that are printed, be they rounded or cut off.
bool hasDigits(double value, const std::string& printed)
{
  const std::size_t point = printed.find('.');
  const double unit = std::pow(10.0, static_cast<double>(point + 1) - printed.size());
  const double difference = value - std::stod(printed);
  return difference >= -0.5 * unit && difference < unit;
}

std::string milliseconds(double seconds)
{
  return format("%.1f", 1e3 * seconds);
}

/// The conformal map depends on its two pins, and the paper does not say where its were. The points
/// below, the arc's end and the next one on the boundary, and rows that are not divided by the root
/// of the area, give every digit that it prints.
FlatPiece mapQuarterSphere(const Piece& piece)
{
  constexpr vtkIdType arcEnd = 16;
  constexpr vtkIdType nextOnBoundary = 21;
  vtkNew<vtkLeastSquaresConformalFilter> filter;
  filter->SetInputData(piece.surface);
  filter->SetCurvesData(piece.curves);
  filter->SetPins(arcEnd, nextOnBoundary);
  filter->AreaNormalizedOff();
  filter->Update();
  return outputsOf(filter);
}

struct Measured
{
  FlatPiece paper; ///< with the paper's interior
  FlatPiece rigid; ///< as rigid as possible; only where wires are pinned before the interior
};

Measured measure(const Piece& piece, const Example& example, Method method)
{
  if (method == Method::LeastSquaresConformal)
  {
    const bool sphere = std::string(example.name) == "quarter_sphere";
    return { sphere ? mapQuarterSphere(piece) : flatten(piece, method), {} };
  }
  if (method == Method::Isometric)
  {
    return { flatten(piece, method), {} };
  }
  return { flatten(piece, method, Interior::Paper), flatten(piece, method, Interior::Rigid) };
}

void printHeader()
{
  std::cout << format("%-25s %9s  %-11s | %-52s | %s\n", "", "", "",
    "interior: Eq. 11, as in the paper (Isometric: own)", "interior: as rigid as possible");
  std::cout << format("%-25s %9s  %-11s | %7s %7s %6s %6s %7s %7s %6s | %7s %6s %6s %7s %6s | %s\n",
    "piece", "triangles", "method", "E_len", "E_ang", "E_h", "E_r", "T_opt", "T_all", "flips",
    "E_ang", "E_h", "E_r", "T_all", "flips", "overlaps");
  std::cout << format("%-25s %9s  %-11s | %7s %7s %6s %6s %7s %7s %6s | %7s %6s %6s %7s %6s |\n",
    "", "", "", "x1e3", "x1e3", "", "", "[ms]", "[ms]", "", "x1e3", "", "", "[ms]", "");
}

std::string opening(const std::string& title, const std::string& triangles, const char* method)
{
  return format("%-25s %9s  %-11s | ", title.c_str(), triangles.c_str(), method);
}

/// T_opt is the time for the wires, T_all that for the interior as well.
std::string timeOfAll(const FlatPiece& piece)
{
  return milliseconds(piece.seconds[0] + piece.seconds[1]);
}

void printRow(const Example& example, Method method, const Measured& measured)
{
  const FlatPiece& paper = measured.paper;
  const std::string optimized =
    method == Method::LeastSquaresConformal ? "Nil" : milliseconds(paper.seconds[0]);
  std::cout << opening(example.title, format("%.0f", paper.number("Triangles")), nameOf(method))
            << format("%7s %7s %6.3f %6.3f %7s %7s %6.0f | ",
                 thousandths(paper.number("EdgeLengthError")).c_str(),
                 thousandths(paper.number("AngleErrorMean")).c_str(),
                 paper.number("GlobalHomogeneity"), paper.number("GlobalAspectRatio"),
                 optimized.c_str(), timeOfAll(paper).c_str(), paper.number("FlippedTriangles"));
  const FlatPiece& rigid = measured.rigid;
  std::cout << (rigid.flat ? format("%7s %6.3f %6.3f %7s %6.0f",
                               thousandths(rigid.number("AngleErrorMean")).c_str(),
                               rigid.number("GlobalHomogeneity"), rigid.number("GlobalAspectRatio"),
                               timeOfAll(rigid).c_str(), rigid.number("FlippedTriangles"))
                           : std::string(36, ' '))
            << format(" | %8.0f\n", paper.number("Overlaps"));
}

void printPaperRow(Method method)
{
  const PrintedRow row = printedRow(method);
  std::cout << opening("", "", "  the paper")
            << format("%7s %7s %6s %6s\n", row.lengthError, row.angleError, row.homogeneity,
                 row.aspectRatio);
}

/// What the table must show; says what does not hold.
bool check(const Example& example, Method method, const Measured& measured)
{
  bool good = true;
  const auto expect = [&](bool fact, const std::string& what) {
    if (!fact)
    {
      std::cerr << example.title << ", " << nameOf(method) << ": " << what << '\n';
      good = false;
    }
  };
  for (const FlatPiece* piece : { &measured.paper, &measured.rigid })
  {
    if (!piece->flat)
    {
      continue;
    }
    for (const char* array :
      { "EdgeLengthError", "AngleErrorMean", "GlobalHomogeneity", "GlobalAspectRatio" })
    {
      expect(std::isfinite(piece->number(array)), std::string(array) + " is not finite");
    }
    const double error = piece->number("MaxEdgeLengthError");
    expect(method == Method::LeastSquaresConformal || error <= 1e-10,
      format("a wire edge is off by %.3g of its length", error));
  }
  if (std::string(example.name) == "quarter_sphere" && method != Method::Isometric)
  {
    const PrintedRow row = printedRow(method);
    const FlatPiece& paper = measured.paper;
    const auto same = [&](double ours, const std::string& theirs) {
      expect(hasDigits(ours, theirs), format("%.6g where the paper has ", ours) + theirs);
    };
    same(1e3 * paper.number("EdgeLengthError"), row.lengthError);
    same(1e3 * paper.number("AngleErrorMean"), row.angleError);
    same(paper.number("GlobalHomogeneity"), row.homogeneity);
    if (method == Method::LeastSquaresConformal)
    {
      same(paper.number("GlobalAspectRatio"), row.aspectRatio);
    }
  }
  return good;
}
}

int main(int argc, char* argv[])
{
  const bool checked = argc == 3 && std::string(argv[2]) == "--check";
  if (argc != 2 && !checked)
  {
    std::cerr << "usage: PaperTable DATA_FOLDER [--check]\n";
    return EXIT_FAILURE;
  }
  bool good = true;
  try
  {
    printHeader();
    for (const Example& example : examples)
    {
      const Piece piece = readPiece(argv[1], example.name, example.set);
      for (const Method method :
        { Method::Progressive, Method::Global, Method::Isometric, Method::LeastSquaresConformal })
      {
        if (method == Method::LeastSquaresConformal && !example.conformal)
        {
          continue;
        }
        const Measured measured = measure(piece, example, method);
        printRow(example, method, measured);
        if (std::string(example.name) == "quarter_sphere" && method != Method::Isometric)
        {
          printPaperRow(method);
        }
        good = check(example, method, measured) && good;
      }
    }
  }
  catch (const std::exception& error)
  {
    std::cerr << "PaperTable: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  std::cout
    << "E_r: min s / max S of the singular values of the triangles' maps; the paper's E_r is "
       "defined elsewhere and\ndiffers. LSCM of the quarter-sphere: pins 16 and 21, rows not "
       "divided by the root of the area; the paper\ncuts its E_ang off. Its own other pieces "
       "are not public.\n";
  return good || !checked ? EXIT_SUCCESS : EXIT_FAILURE;
}
