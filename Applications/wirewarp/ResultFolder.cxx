// SPDX-License-Identifier: BSD-3-Clause
#include "ResultFolder.h"

#include "InputError.h"
#include "ReadVtk.h"
#include "Report.h"
#include "TextFile.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <system_error>

namespace wirewarp
{
namespace
{
using Json = nlohmann::ordered_json;

std::string within(const Options& options, const char* name)
{
  return (std::filesystem::path(options.source) / name).string();
}

[[noreturn]] void refuseReport(const std::string& path)
{
  throw InputError(path, "is not a report of wirewarp; run wirewarp flatten again");
}

Json readReport(const std::string& path)
{
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored))
  {
    throw InputError(std::filesystem::path(path).parent_path().string(),
      "holds no result: report.json is missing; name a folder that wirewarp flatten has written");
  }
  Json report = Json::parse(readWholeFile(path), nullptr, false);
  if (!report.is_object())
  {
    refuseReport(path);
  }
  return report;
}
}

//------------------------------------------------------------------------------
void adoptReport(Options& options)
{
  const std::string path = within(options, "report.json");
  const Json report = readReport(path);
  try
  {
    if (report.at("exit_code").get<int>() == InputRefused && report.at("pieces").empty())
    {
      throw InputError(
        options.source, "holds no result: " + report.at("message").get<std::string>());
    }
    options.surface = report.at("surface").get<std::string>();
    options.values.setWord("Scheme", report.at("scheme").get<std::string>());
    if (options.values.text("Material").empty() && report.at("material").is_string())
    {
      options.values.set("Material", report.at("material").get<std::string>());
    }
    if (report.at("grain").is_string())
    {
      options.values.set("Grain", report.at("grain").get<std::string>());
    }
  }
  catch (const Json::exception&)
  {
    refuseReport(path);
  }
}

//------------------------------------------------------------------------------
Flattening readResult(const Options& options)
{
  const std::string path = within(options, "report.json");
  const Json report = readReport(path);
  Flattening result;
  try
  {
    const int exitCode = report.at("exit_code").get<int>();
    result.exitCode = exitCode == Flawed ? Flawed : Done;
    result.status = report.at("status").get<std::string>();
    result.message = report.at("message").get<std::string>();
    result.unit = report.at("unit").get<std::string>();
    result.unitStated = report.at("unit_stated").get<bool>();
    result.savedReport = report.dump();
    takeReport(result.savedReport, result);
  }
  catch (const Json::exception&)
  {
    refuseReport(path);
  }
  if (!options.unit.empty())
  {
    result.unit = options.unit;
    result.unitStated = true;
  }
  if (!result.unitStated)
  {
    result.unitNote = unitTaken(options.surface, { result.unit });
  }
  result.flat = readVtk(within(options, "flat.vtp"));
  result.wires = readVtk(within(options, "wires.vtp"));
  result.cut = readVtk(within(options, "cut.vtp"));
  const std::string sewn = within(options, "sewn.vtp");
  std::error_code ignored;
  if (options.command != "sew" && std::filesystem::exists(sewn, ignored))
  {
    result.sewn = readVtk(sewn);
  }
  return result;
}
}
