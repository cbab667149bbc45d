// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Base/Status.h"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace flattening
{
/// The least and the greatest strain that a thread takes, as fractions: its length on the surface
/// over its length in the plane, less 1.
struct StrainLimits
{
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();
};

/// What a sheet is made of: how it resists in the directions of its two threads and against the
/// change of the angle between them. Stiffnesses are forces over widths (N/m); only their ratios
/// matter to the flat shape, since wires do not give way.
///
/// Warp is the direction of the grain (of knits the wales, of leather the spine, of laminates the
/// stiffer axis), weft lies across.
struct ClothMaterial
{
  std::string name;
  std::string description;
  std::string source; ///< of the numbers
  /// A sheet without threads, alike in all directions: the numbers below have no meaning, and it
  /// is flattened as without a material.
  bool isotropic = false;
  double warp = 0.0;
  double weft = 0.0;
  double shear = 0.0;       ///< over the angle in radians
  double cross = 0.0;       ///< what couples the strains of both threads
  double compression = 1.0; ///< stiffness of a thread that is compressed over that in tension
  StrainLimits warpLimits;
  StrainLimits weftLimits;
  /// The greatest change of the angle between the threads, in radians; beyond it they lock.
  double shearLimit = std::numeric_limits<double>::infinity();
  /// Of a material that could not be read; then it has no numbers.
  Status status;
  bool oneWay = false; ///< nap, pile or print: the pieces may not be turned by half a turn
  bool sheet = false;  ///< its edges do not fray: patterns have no seam allowance by default
};

/// Its own status, or InvalidOption where a number has no meaning: a modulus that is not above 0,
/// a coupling that makes the sheet unstable, limits that leave out the unstrained sheet.
Status checkMaterial(const ClothMaterial& material);

/// Materials by name, each with the source of its numbers. Measured ones are of one cloth each;
/// another of the same name may differ by half, and shear over thread stiffness, which decides the
/// flat shape, by less.
const std::vector<ClothMaterial>& materialPresets();

/// No value where none has the name; capitals count as small letters.
std::optional<ClothMaterial> findPreset(const std::string& name);

/// The names, for messages: "isotropic, plain, ...".
std::string presetNames();
}
