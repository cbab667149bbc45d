// SPDX-License-Identifier: BSD-3-Clause
// Flat pieces sewn again, drawn as patterns and graded; files of surfaces, curves and patterns.
#include "Pieces.h"

#include "Conversions.h"

#include "Base/LengthUnit.h"
#include "Base/Memory.h"
#include "FaceSeams.h"
#include "Formats/GarmentCodeFile.h"
#include "Formats/PatternData.h"
#include "Formats/PatternOptionTable.h"
#include "Grading/SizeGrading.h"
#include "Input/ClothInput.h"
#include "Input/MappedSurface.h"
#include "Input/StatusWords.h"
#include "InputError.h"
#include "ReadCurves.h"
#include "ReadSurface.h"
#include "Report/SewingReport.h"
#include "TextFile.h"
#include "Units.h"

#include <pybind11/stl.h>

#include <map>
#include <memory>
#include <optional>

namespace flattening::python
{
namespace
{
using pybind11::literals::operator""_a;

py::dict resew(const py::dict& flat, const py::dict& design, const py::dict& options,
  const py::object& bodySurface, py::object progress)
{
  Settings settings("vtkSewnShape", options);
  SewingOptions& sewing = settings.structures.sewing;
  const auto material = options["Material"].cast<std::string>();
  if (!material.empty())
  {
    sewing.material = readCloth(material).material;
  }
  const LoadedBody body = bodyOf(bodySurface);
  sewing.body = body.get();
  const DataSet inPlane = dataSetOf(flat);
  const DataSet inSpace = dataSetOf(design);
  WatchedRun watched(std::move(progress));
  Status status;
  SewnArrays arrays;
  {
    const py::gil_scoped_release free;
    const SewnInput input = makeSewnInput(
      loadMappedSurface(inSpace, &inPlane, nullptr), findColumn(inPlane.fieldArrays, "SeamPairs"));
    status = input.outcome.ok() ? body.outcome : input.outcome;
    if (!status.refused())
    {
      const SewingResult sewn =
        sewPieces(input.cut, input.map.positions, sewing, watched.execution());
      status = inInput(sewn.status, input.map.surface.input.cellOfTriangle);
      arrays = status.refused() ? SewnArrays() : sewnArrays(*inSpace.points, input, sewn);
    }
  }
  watched.finish(false);
  py::dict result("status"_a = tupleOf(status), "refused"_a = status.refused(),
    "warnings"_a = textsOf(arrays.warnings));
  if (!status.refused())
  {
    result["points"] = arrayOf<double>(std::move(arrays.points));
    arrays.designDistance.name = "DesignDistance";
    result["distances"] = dictOf(Columns{ arrays.distance, arrays.designDistance });
    result["cell_arrays"] = dictOf(std::move(arrays.cellArrays));
    result["field_arrays"] = dictOf(std::move(arrays.fieldArrays));
    std::vector<ReportKey> keys = reportKeys("ResewnShape");
    if (findColumn(arrays.shapes, "StrainWarpRms"))
    {
      const std::vector<ReportKey>& threads = reportKeys("ResewnThreads");
      keys.insert(keys.end(), threads.begin(), threads.end());
    }
    result["shapes"] = objectOf({ reportRows(arrays.shapes, keys) });
  }
  return result;
}

/// The options of a file: those of the table by their properties, lists by the names of
/// write_pattern().
pattern::FileOptions fileOptionsOf(const py::dict& given)
{
  pattern::FileOptions file;
  pattern::PatternOptions& drawn = file.pattern;
  for (const pattern::PatternOption& option : pattern::patternOptionTable())
  {
    if (const py::str name(option.property); option.setIn && given.contains(name))
    {
      const py::object value = given[name];
      option.setIn(file,
        py::isinstance<py::str>(value) ? OptionValue(value.cast<std::string>())
                                       : OptionValue(value.cast<double>()));
    }
  }
  const auto take = [&given](const char* name, auto& kept) {
    using Kept = std::decay_t<decltype(kept)>;
    if (!given.contains(name))
    {
      return;
    }
    if constexpr (std::is_enum_v<Kept>)
    {
      kept = static_cast<Kept>(given[name].cast<int>());
    }
    else
    {
      kept = given[name].cast<Kept>();
    }
  };
  take("format", file.format);
  take("unit", drawn.unit);
  take("piece_quantities", drawn.pieceQuantities);
  take("piece_names", drawn.pieceNames);
  take("curve_allowances", drawn.allowanceOfCurve);
  take("curve_notches", drawn.notchesOfCurve);
  take("double_notches", drawn.doubleNotches);
  take("folds", drawn.foldsAlong);
  take("curve_dart_tips", drawn.dartTipOfCurve);
  take("curve_fairs", drawn.fairToleranceOfCurve);
  return file;
}

py::tuple writePattern(const py::dict& flat, const py::object& wires, const py::object& cut,
  const std::string& path, const py::dict& options, const pattern::Grading* sizes)
{
  const auto partOf = [](const py::object& data) {
    return data.is_none() ? std::optional<DataSet>() : dataSetOf(data.cast<py::dict>());
  };
  const DataSet pieces = dataSetOf(flat);
  const std::optional<DataSet> lines = partOf(wires);
  const std::optional<DataSet> surface = partOf(cut);
  pattern::FileOptions file = fileOptionsOf(options);
  file.grading = sizes;
  Status status;
  pattern::Pattern drawing;
  {
    const py::gil_scoped_release free;
    status = withinMemory([&] {
      pattern::PatternSource source;
      Status read = pattern::readPattern(
        pieces, lines ? &*lines : nullptr, surface ? &*surface : nullptr, source);
      return read.ok() ? pattern::writePattern(path, source, file, drawing) : read;
    });
  }
  py::list warnings;
  for (const pattern::PatternPiece& piece : drawing.pieces)
  {
    for (const std::string& warning : piece.warnings)
    {
      warnings.append(textOf(warning));
    }
  }
  return py::make_tuple(tupleOf(status), warnings);
}

/// Sizes as tuples of a name, flat pieces and wires.
py::tuple grade(const py::list& given, const std::string& base, int unit, const std::string& at)
{
  std::vector<pattern::PatternSize> sizes;
  Status status;
  for (const py::handle item : given)
  {
    const auto row = item.cast<py::tuple>();
    sizes.push_back({ row[0].cast<std::string>(), {} });
    const DataSet wires = dataSetOf(row[2].cast<py::dict>());
    status = status.ok() ? pattern::readPattern(dataSetOf(row[1].cast<py::dict>()), &wires, nullptr,
                             sizes.back().source)
                         : status;
  }
  auto grading = std::make_unique<pattern::Grading>();
  if (status.ok())
  {
    status = withinMemory([&] {
      return pattern::gradeSizes(sizes, { static_cast<Unit>(unit), base, at }, *grading);
    });
  }
  py::dict result;
  if (status.ok())
  {
    py::list positions;
    for (const Points2& places : grading->positions)
    {
      positions.append(arrayOf<double>(Points2(places)));
    }
    py::list rules;
    for (const pattern::GradeRule& rule : grading->rules)
    {
      py::list deltas;
      for (const Point2& delta : rule.deltas)
      {
        deltas.append(py::make_tuple(delta.x(), delta.y()));
      }
      rules.append(py::make_tuple(rule.piece, rule.point, textOf(rule.name), py::tuple(deltas)));
    }
    result = py::dict("sizes"_a = grading->sizes, "base"_a = grading->base,
      "positions"_a = positions, "rules"_a = rules);
    result["grading"] = py::cast(std::move(grading));
  }
  return py::make_tuple(tupleOf(status), result);
}

py::tuple readGarment(const std::string& path)
{
  pattern::GarmentData data;
  const Status status = pattern::readGarmentCode(path, data);
  return py::make_tuple(tupleOf(status), dictOf(std::move(data.flat)),
    dictOf(std::move(data.wires)), dictOf(std::move(data.cut)));
}

/// Refuses formats that VTK reads: its meshes go to other functions.
void leaveToVtk(const std::string& path)
{
  const std::string extension = wirewarp::lowerCaseExtension(path);
  for (const char* const one : { ".vtp", ".vtk", ".gltf", ".glb" })
  {
    if (extension == one)
    {
      wirewarp::checkedFileSize(path); // a missing file has no format
      throw wirewarp::InputError(path,
        wirewarp::inQuotes(extension) +
          " is read by VTK (as vtkXMLPolyDataReader) and PyVista, whose meshes flatten_polydata() "
          "takes");
    }
  }
}

/// What is wrong with a file, its surface, curves and unit, and what of it is not read.
py::tuple readSurfaceFile(const std::string& path, int seams)
{
  wirewarp::SurfaceContents contents;
  const std::string failure = wirewarp::failureOf(path, [&] {
    leaveToVtk(path);
    contents = wirewarp::readSurface(path);
    wirewarp::addSeams(static_cast<wirewarp::SeamSource>(seams), contents);
  });
  return py::make_tuple(textOf(failure), dictOf(std::move(contents.surface)),
    dictOf(std::move(contents.curves)), contents.unit, textOf(contents.note));
}

/// What is wrong with a file, its curves, and what of it is not read.
py::tuple readCurveFile(const std::string& path, const py::dict& surface)
{
  const DataSet owner = dataSetOf(surface);
  wirewarp::CurveContents contents;
  const std::string failure = wirewarp::failureOf(path, [&] {
    leaveToVtk(path);
    contents = wirewarp::readCurves(path, owner);
  });
  return py::make_tuple(textOf(failure), dictOf(std::move(contents.curves)), textOf(contents.note));
}
}

void definePieces(py::module_& module)
{
  py::class_<pattern::Grading>(module, "Grading", py::module_local()); // two versions may be loaded
  module.def("resew", &resew);
  module.def("write_pattern", &writePattern);
  module.def("grade", &grade);
  module.def("read_garmentcode", &readGarment);
  module.def("read_surface", &readSurfaceFile);
  module.def("read_curves", &readCurveFile);
}
}
