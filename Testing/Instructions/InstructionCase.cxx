// SPDX-License-Identifier: BSD-3-Clause
// Flattens one fixed case on one thread, for CheckInstructions.py to count what Core executes.
#include "RefinedPiece.h"

#include "Cloth/ClothMaterial.h"
#include "Flattening/SurfaceFlattening.h"

#include <array>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

namespace
{
using namespace flattening;

struct Case
{
  const char* name;
  const char* piece;
  int division;
  Scheme scheme;
  InteriorMethod interior;
  const char* material = nullptr;
};

constexpr std::array<Case, 5> cases{ {
  { "cloth", "shirt_front", 1, Scheme::Isometric, InteriorMethod::AsRigidAsPossible, "twill" },
  { "global", "pants_front", 4, Scheme::Global, InteriorMethod::Laplacian },
  { "isometric", "shirt_front", 1, Scheme::Isometric, InteriorMethod::AsRigidAsPossible },
  { "progressive", "wetsuit_upper_front", 4, Scheme::Progressive, InteriorMethod::Laplacian },
  // Nine tenths of it are spent on flipped triangles.
  { "untangling", "wetsuit_upper_front", 4, Scheme::Progressive,
    InteriorMethod::AsRigidAsPossible },
} };

void run(const Case& one, const std::string& folder)
{
  const benchmarks::RefinedPiece piece = benchmarks::readRefined(folder, one.piece, one.division);
  FlatteningOptions options;
  options.scheme = one.scheme;
  options.interior.method = one.interior;
  if (one.material)
  {
    options.cloth.emplace().material = *findPreset(one.material);
  }
  const FlatteningResult result = flattenSurface(piece.mesh, piece.curves, options, {});
  if (result.status.refused())
  {
    throw std::runtime_error(result.status.message);
  }
}
}

/// Without a case: lists them.
int main(int argc, char** argv)
{
  try
  {
    for (const Case& one : cases)
    {
      if (argc < 3)
      {
        std::cout << one.name << '\n';
      }
      else if (argv[2] == std::string(one.name))
      {
        run(one, argv[1]);
        return EXIT_SUCCESS;
      }
    }
  }
  catch (const std::exception& error)
  {
    std::cerr << "InstructionCase: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return argc < 3 ? EXIT_SUCCESS : EXIT_FAILURE;
}
