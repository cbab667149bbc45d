// SPDX-License-Identifier: BSD-3-Clause
#include "MethodOptions.h"

#include "NumberOptions.h"
#include "Options.h"
#include "PlainText.h"
#include "TextFile.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <limits>

namespace wirewarp
{
namespace
{
void addTolerance(const std::string& entry, std::map<std::string, double>& tolerances)
{
  std::string name;
  double value = 0.0;
  if (!splitNameAndNumber(entry, name, value) || !(value >= 0.0 && value < 1.0))
  {
    throw CLI::ValidationError(
      "--tolerance", inQuotes(entry) + " is not NAME=FRACTION with a fraction in [0, 1)");
  }
  tolerances[name] = value;
}

/// NAME:PIECE=+3%, where a name may hold both signs.
void addEase(const std::string& entry, std::vector<EaseRequest>& eases)
{
  EaseRequest ease;
  const std::size_t sign = entry.rfind('=');
  std::string value = sign == std::string::npos ? std::string() : entry.substr(sign + 1);
  const bool percent = !value.empty() && value.back() == '%';
  value.resize(value.size() - (percent ? 1 : 0));
  value.erase(0, value.size() > 1 && value[0] == '+' && value[1] != '-' ? 1 : 0);
  if (!percent || sign == 0 || !parseNumber(value, ease.fraction) ||
    !(std::abs(ease.fraction) < 100.0))
  {
    throw CLI::ValidationError("--ease",
      inQuotes(entry) + " is not NAME=PERCENT% or NAME:PIECE=PERCENT% with less than 100 %");
  }
  ease.fraction /= 100.0;
  ease.curve = entry.substr(0, sign);
  const std::size_t colon = ease.curve.rfind(':');
  long long piece = 0;
  if (colon != std::string::npos && colon > 0 && parseInteger(ease.curve.substr(colon + 1), piece))
  {
    if (piece < 1 || piece > std::numeric_limits<int>::max())
    {
      throw CLI::ValidationError("--ease", inQuotes(entry) + ": pieces are numbered from 1");
    }
    ease.piece = static_cast<int>(piece) - 1;
    ease.curve.resize(colon);
  }
  eases.push_back(std::move(ease));
}
}

//------------------------------------------------------------------------------
void addMethods(CLI::App& app, Options& options)
{
  const std::string group = "Method";
  app
    .add_option("--scheme", options.scheme,
      "How the wires get their shape: isometric (wires and interior together), global (all angles "
      "together), progressive (patch by patch), lscm (for comparison: keeps no length)")
    ->transform(CLI::IsMember({ "isometric", "global", "progressive", "lscm" }, CLI::ignore_case))
    ->capture_default_str()
    ->group(group);
  app
    .add_option("--solver", options.solver,
      "How the angles are solved for: newton (exact), sequential (the paper's). isometric only "
      "starts from that solution; not for lscm")
    ->transform(CLI::IsMember({ "newton", "sequential" }, CLI::ignore_case))
    ->capture_default_str()
    ->group(group);
  app
    .add_option("--interior", options.interior,
      "How points between wires are placed: arap (as rigid as possible), laplacian, relaxation "
      "(the paper's iteration). isometric only starts there; not for lscm")
    ->transform(CLI::IsMember({ "arap", "laplacian", "relaxation" }, CLI::ignore_case))
    ->capture_default_str()
    ->group(group);
  app
    .add_flag_callback(
      "--paper-method",
      [&options]() {
        options.scheme = "global";
        options.interior = "laplacian";
      },
      "The paper's method: --scheme global --interior laplacian. newton finds the minimum that the "
      "paper asks for; --solver sequential goes there by the paper's steps, where they converge")
    ->excludes("--scheme", "--interior")
    ->group(group);
  app.add_flag("--release-keys", options.releaseKeys, "Treat key curves as accessory curves")
    ->group(group);
  app
    .add_flag_callback(
      "--no-release-trials", [&options]() { options.releaseTrials = false; },
      "Do not try what a release would bring where a piece lies poorly, which takes up to six "
      "flattenings of it, by the isometric scheme for not much more than two seconds; rank the "
      "curves to release by their sensitivity")
    ->group(group);
  app
    .add_flag("--close-cuts", options.closeCuts,
      "Close darts and other cuts as far as their banks would lie over each other")
    ->group(group);
  app
    .add_option("--dart-legs", options.dartLegs,
      "How the legs of a dart lie: free (as the piece distorts least), straight, or mirrored (both "
      "the mean of free ones): then one folds on the other. Not for lscm")
    ->transform(CLI::IsMember({ "free", "straight", "mirrored" }, CLI::ignore_case))
    ->capture_default_str()
    ->group(group);
  app
    .add_flag("--skip-closed", options.skipClosed,
      "Leave out pieces without boundary or with handles, which cannot be laid flat, and flatten "
      "the "
      "others; without it such a surface is refused")
    ->group(group);
  app
    .add_option("--energy", options.energy,
      "isometric: what deforming the sheet costs: rigid (as rigid as possible), dirichlet "
      "(symmetric Dirichlet, which forbids flipped triangles)")
    ->transform(CLI::IsMember({ "rigid", "dirichlet" }, CLI::ignore_case))
    ->capture_default_str()
    ->group(group);
  app
    .add_option("--area-bias", options.areaBias,
      "isometric with rigid: above 0 a change of area costs more than one of angle (stiff sheet), "
      "below 0 less (stretchy sheet)")
    ->check(number(-0.99, 0.99, "[-0.99, 0.99]"))
    ->capture_default_str()
    ->group(group);
  app
    .add_option("--angle-weight", options.angleWeight,
      "isometric: weight of the wires' bending against the sheet")
    ->check(number(0.0, 100.0, "[0, 100]"))
    ->capture_default_str()
    ->group(group);
  app
    .add_option_function<std::vector<std::string>>(
      "--tolerance",
      [&options](const std::vector<std::string>& entries) {
        for (const std::string& entry : entries)
        {
          addTolerance(entry, options.tolerances);
        }
      },
      "Make a curve elastic: its length may change by up to this fraction, from 0 up to but not "
      "including 1; may be given several times")
    ->type_name("NAME=FRACTION")
    ->allow_extra_args(false)
    ->group(group);
  app
    .add_option_function<std::vector<std::string>>(
      "--ease",
      [&options](const std::vector<std::string>& entries) {
        for (const std::string& entry : entries)
        {
          addEase(entry, options.eases);
        }
      },
      "Make a seam or a named edge longer in one piece (numbered from 1; without it the only one "
      "that it is in) than on the surface and than what it is sewn to, -3% shorter, in place of "
      "the "
      "LengthEase of its file. The curve needs a --tolerance as large; may be given several times")
    ->type_name("NAME[:PIECE]=PERCENT%")
    ->allow_extra_args(false)
    ->group(group);
  app
    .add_option("--pins", options.pins,
      "lscm: the two vertices that are pinned, ids counted from 0 (default: the boundary vertices "
      "farthest apart)")
    ->check(wholeNumber(0, std::numeric_limits<int>::max(), "from 0"))
    ->type_name("V0 V1")
    ->group(group);
}
}
