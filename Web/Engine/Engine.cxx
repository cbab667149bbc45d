// SPDX-License-Identifier: BSD-3-Clause
// The module for JavaScript: classes Surface, Flattening and Editor; see Web/package/index.d.ts.
#include "PageWriter.h"
#include "Values.h"

#include "Base/LengthUnit.h"
#include "Cloth/ClothMaterial.h"
#include "Editing/CurveEditor.h"
#include "Editing/CurveSnapping.h"
#include "Editing/DrawingSurface.h"
#include "FaceSeams.h"
#include "Formats/PatternData.h"
#include "Formats/PatternFile.h"
#include "Formats/PatternOptionTable.h"
#include "Input/ClothInput.h"
#include "Input/CurvedSurface.h"
#include "InputError.h"
#include "Options/OptionTable.h"
#include "Options/OptionValues.h"
#include "ReadCurves.h"
#include "ReadSurface.h"
#include "Report/QualityReport.h"
#include "Report/ReportKeys.h"
#include "Report/SuggestionReport.h"
#include "Report/SurfaceRun.h"
#include "Suggestion/SymmetryPlane.h"
#include "Surface/TriangleMesh.h"
#include "Units.h"

#include <cstdint>
#include <exception>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace flattening::web
{
namespace
{
struct GivenOptions
{
  OptionStructures structures;
  std::string weights; ///< cell array of the surface
};

/// What the options of an object say. Throws std::invalid_argument.
GivenOptions optionsFrom(OptionOwner owner, const val& given)
{
  OptionStructures structures;
  structures.proposes = owner == OptionOwner::Suggestion;
  OptionValues values(owner);
  std::map<std::string, const Option*> known;
  for (const Option* const option : values.options())
  {
    known[spelled(*option, OptionSpelling::Python)] = option;
    if (option->set) // defaults of structures are those of single stages
    {
      option->set(structures, option->byDefault);
    }
  }
  const auto names = emscripten::vecFromJSArray<std::string>(
    val::global("Object").call<val>("keys", given.isUndefined() ? val::object() : given));
  std::vector<std::string> grain;
  for (const std::string& name : names)
  {
    const auto found = known.find(name);
    if (found == known.end())
    {
      throw std::invalid_argument("there is no option " + name);
    }
    const Option& option = *found->second;
    if (option.type == OptionType::List)
    {
      if (option.property != "Grain")
      {
        throw std::invalid_argument("option " + name + " cannot be given here");
      }
      grain = emscripten::vecFromJSArray<std::string>(given[name]);
      continue;
    }
    const OptionValue value = valueOf(option, given[name]);
    values.set(option.property, value);
    values.markGiven(option.property);
    if (option.set)
    {
      option.set(structures, value);
    }
  }
  const std::string idle = describeIdleOption(values, OptionSpelling::Python);
  if (!idle.empty())
  {
    throw std::invalid_argument(idle);
  }
  if (const std::string material = values.text("Material"); !material.empty())
  {
    structures.flattening.cloth = readCloth(material, grain);
  }
  return { structures, values.text("WeightArray") };
}

/// Calls progress(fraction), which ends the run where it returns false.
Execution executionOf(const val& progress)
{
  Execution execution;
  if (!progress.isUndefined() && !progress.isNull())
  {
    const auto ended = std::make_shared<bool>(false);
    execution.progress = [progress, ended](double fraction, const char*) {
      *ended = *ended || progress(fraction).isFalse();
    };
    execution.cancel = [ended] { return *ended; };
  }
  return execution;
}

/// Flat pieces, which can be drawn as patterns.
class Flattening
{
public:
  Flattening(const SurfaceRun& run, std::optional<FlatteningReport> report)
    : Made(std::move(report))
    , Words(val::object())
  {
    if (this->Made)
    {
      this->Words = objectOf(ReportValue{ flattening::objectOf(*this->Made) });
    }
    this->Words.set("status", objectOf(run.run.status));
    this->Words.set("refused", run.run.status.refused());
    this->Words.set("warnings", val::array(run.run.warnings));
  }

  val report() const { return this->Words; }
  val flat() const { return this->part(&FlatteningData::flat); }
  val wires() const { return this->part(&FlatteningData::wires); }
  val cut() const { return this->part(&FlatteningData::cut); }

  /// \return { status, warnings, bytes } \param ending of the file: svg, dxf, plt, json or csv; or
  /// pdf, of which the pages are drawn on a canvas, without bytes
  val pattern(const std::string& ending, const val& options, const val& canvas) const
  {
    pattern::FileOptions file;
    file.format = pattern::formatOf("x." + ending);
    std::optional<PageWriter> writer;
    if (!canvas.isUndefined())
    {
      file.canvas = &writer.emplace(canvas);
    }
    for (const pattern::PatternOption& option : pattern::patternOptionTable())
    {
      const val given =
        options.isUndefined() ? options : options[spelled(option, OptionSpelling::Python)];
      if (!given.isUndefined() && option.setIn)
      {
        option.setIn(file, valueOf(option, given));
      }
    }
    pattern::Pattern drawing;
    if (!options.isUndefined() && options["date"].isString())
    {
      drawing.date = options["date"].as<std::string>();
    }
    std::string content;
    Status status{ StatusCode::InvalidOption, ending + " is not an ending of a pattern's file" };
    if (this->Made && file.format != pattern::FileFormat::Automatic)
    {
      pattern::PatternSource source;
      const FlatteningData& data = this->Made->data;
      file.pattern.unit = static_cast<Unit>(unitNamed(wirewarp::unitOf(data.flat)));
      status = pattern::readPattern(data.flat, &data.wires, &data.cut, source);
      status = status.ok() ? pattern::makePatternFile(source, file, drawing, content) : status;
    }
    val warnings = val::array();
    for (const pattern::PatternPiece& piece : drawing.pieces)
    {
      for (const std::string& warning : piece.warnings)
      {
        warnings.call<void>("push", warning);
      }
    }
    val result = val::object();
    result.set("status", objectOf(status));
    result.set("warnings", warnings);
    result.set("bytes",
      val(emscripten::typed_memory_view(
            content.size(), reinterpret_cast<const unsigned char*>(content.data())))
        .call<val>("slice"));
    return result;
  }

private:
  val part(DataSet FlatteningData::*which) const
  {
    return this->Made ? objectOf(this->Made->data.*which) : val::null();
  }

  std::optional<FlatteningReport> Made;
  val Words;
};

/// A surface, as a file or arrays have it.
class Surface
{
public:
  explicit Surface(DataSet given)
    : Data(std::move(given))
  {
  }
  /// Of points, and ids of the corners of triangles.
  static std::shared_ptr<Surface> ofArrays(
    const val& points, const val& corners, const std::string& unit)
  {
    DataSet data;
    data.points = std::make_shared<const Points3>(pointsOf(points));
    const std::vector<int> ids = emscripten::convertJSArrayToNumberVector<int>(corners);
    for (std::size_t k = 3; k <= ids.size(); k += 3)
    {
      data.faces.add(std::vector<std::int64_t>(ids.begin() + static_cast<std::ptrdiff_t>(k - 3),
        ids.begin() + static_cast<std::ptrdiff_t>(k)));
    }
    wirewarp::setUnit(data, unit);
    return std::make_shared<Surface>(std::move(data));
  }
  /// Of a file in the module's file system. Throws InputError.
  static std::shared_ptr<Surface> ofFile(const std::string& path)
  {
    wirewarp::SurfaceContents contents = wirewarp::readSurface(path);
    wirewarp::setUnit(contents.surface, contents.unit);
    auto surface = std::make_shared<Surface>(std::move(contents.surface));
    surface->Lines = std::move(contents.curves);
    return surface;
  }

  val arrays() const { return objectOf(this->Data); }
  std::string unit() const { return wirewarp::unitOf(this->Data); }
  void setUnit(const std::string& unit) { wirewarp::setUnit(this->Data, unit); }
  std::string likelyUnit() const { return wirewarp::likelyUnit(this->Data).unit; }
  /// Curves of the surface's file, or those of another one.
  val curves(const std::string& path) const
  {
    return objectOf(path.empty() ? this->Lines : wirewarp::readCurves(path, this->Data).curves);
  }
  /// The angle defect at each point; empty where the surface is refused.
  val developability() const
  {
    const LoadedSurface loaded = this->loaded();
    return loaded.outcome.refused()
      ? val::null()
      : objectOf(Columns{ developabilityOfPoints(loaded, Execution()) });
  }
  LoadedSurface loaded() const
  {
    return loadSurface(readTriangles(this->Data), CoincidentPoints::Automatic, Defects::Heal);
  }

  std::shared_ptr<Flattening> flatten(
    const val& curves, const val& options, const val& progress) const
  {
    const auto [structures, weights] = optionsFrom(OptionOwner::Warping, options);
    SurfaceRun source(this->Data, { curvesOf(curves) });
    const Execution execution = executionOf(progress);
    std::optional<FlatteningReport> report;
    if (source.load(structures, {}, weights, execution))
    {
      if (const auto done = source.run.flatten(structures.flattening, { -1, -1 }, execution))
      {
        report = reportFlattening(source, *done, structures.flattening);
      }
    }
    return std::make_shared<Flattening>(source, std::move(report));
  }

  /// \param preview gets the points of each cut found so far
  /// \return { flattening, cuts, boundMet }
  val suggest(const val& curves, const val& options, const val& progress, const val& preview) const
  {
    const auto [structures, weights] = optionsFrom(OptionOwner::Suggestion, options);
    SurfaceRun source(this->Data, { curvesOf(curves) });
    Execution execution = executionOf(progress);
    if (!preview.isUndefined() && !preview.isNull())
    {
      execution.preview = [&preview](const std::vector<Points3>& lines) {
        val found = val::array();
        for (const Points3& line : lines)
        {
          found.call<void>("push", arrayOf<double>(line));
        }
        preview(found);
      };
    }
    CurveSuggestions found;
    std::optional<FlatteningReport> report;
    if (source.load(structures, {}, weights, execution))
    {
      if (const auto done = source.run.suggest(
            structures, execution, [] {}, found))
      {
        report = reportFlattening(source, *done, structures.flattening);
      }
    }
    val cuts = val::array();
    const ReportList rows =
      reportRows(suggestionArrays(found.curves, 0), reportKeys("SuggestedCut"));
    for (std::size_t k = 0; k < found.curves.size(); ++k)
    {
      const Polyline& curve = found.curves[k].curve;
      val cut = objectOf(rows[k]);
      cut.set("points", arrayOf<double>(curve.points));
      cut.set("type", std::string(curveTypeName(curve.type)));
      cut.set("name", curve.name);
      cuts.call<void>("push", cut);
    }
    val result = val::object();
    result.set("flattening", std::make_shared<Flattening>(source, std::move(report)));
    result.set("cuts", cuts);
    result.set("boundMet", found.boundMet);
    return result;
  }

private:
  DataSet Data;
  DataSet Lines;
};

/// Of SegmentKind.
const std::vector<std::string> segmentWords{ "geodesic", "section", "edges", "spline" };

/// Curves drawn on a surface by commands that can be undone; each says what is wrong with it.
class Editor
{
public:
  explicit Editor(TriangleMesh mesh)
    : Drawn(std::make_shared<const DrawingSurface>(std::move(mesh)))
    , Curves(this->Drawn)
  {
  }
  /// Throws std::invalid_argument where the surface is refused.
  static std::shared_ptr<Editor> of(const Surface& surface)
  {
    LoadedSurface loaded = surface.loaded();
    if (loaded.outcome.refused())
    {
      throw std::invalid_argument(objectOf(loaded.outcome)["message"].as<std::string>());
    }
    return std::make_shared<Editor>(std::move(loaded.prepared.mesh));
  }

  /// \return { point, target } \param reach in space
  val snap(const val& place, double reach, int exceptCurve) const
  {
    SnapOptions options;
    options.reach = reach;
    options.exceptCurve = exceptCurve;
    const SnappedPoint snapped =
      snapPoint(*this->Drawn, this->Curves.state(), this->near(place), options);
    val result = val::object();
    result.set("point", arrayOf<double>(Points3{ snapped.point.position }));
    result.set("target", static_cast<int>(snapped.target));
    return result;
  }
  /// \param kinds one for all segments, or a list
  val add(const std::string& type, const std::string& name, const val& nodes, const val& kinds,
    bool closed)
  {
    EditedCurve curve;
    curve.traits = traitsOf(type, name);
    curve.closed = closed;
    for (const Point3& point : pointsOf(nodes))
    {
      curve.nodes.push_back(this->Drawn->pointNear(point));
    }
    if (kinds.isString())
    {
      curve.kinds.assign(segmentCount(curve.nodes.size(), closed), kindOf(kinds.as<std::string>()));
    }
    else
    {
      for (const std::string& kind : emscripten::vecFromJSArray<std::string>(kinds))
      {
        curve.kinds.push_back(kindOf(kind));
      }
    }
    return objectOf(this->Curves.add(std::move(curve)));
  }
  /// A smooth curve along a stroke by hand, up to a tolerance in space.
  val addStroke(const val& places, double tolerance)
  {
    std::vector<SurfacePoint> stroke;
    for (const Point3& place : pointsOf(places))
    {
      stroke.push_back(this->Drawn->pointNear(place));
    }
    return objectOf(this->Curves.addStroke(stroke, tolerance));
  }
  val describe(int curve, const std::string& type, const std::string& name)
  {
    return objectOf(this->Curves.describe(static_cast<std::size_t>(curve), traitsOf(type, name)));
  }
  /// The curve's image in the plane of symmetry of the surface.
  val addImage(int curve)
  {
    const std::optional<SymmetryPlane> plane = findSymmetryPlane(this->Drawn->mesh());
    if (!plane)
    {
      return objectOf(
        Status{ StatusCode::InvalidOption, "the surface is not its own mirror image" });
    }
    this->Curves.beginGroup();
    this->Curves.setMirror(MirrorPlane{ plane->offset * plane->normal, plane->normal });
    const Status status = this->Curves.addImage(static_cast<std::size_t>(curve));
    this->Curves.endGroup();
    return objectOf(status);
  }
  val addOffset(int curve, double distance)
  {
    return objectOf(this->Curves.addOffset(static_cast<std::size_t>(curve), distance));
  }
  val remove(int curve) { return objectOf(this->Curves.remove(static_cast<std::size_t>(curve))); }
  val moveNode(int curve, int node, const val& place)
  {
    return objectOf(this->Curves.moveNode(
      static_cast<std::size_t>(curve), static_cast<std::size_t>(node), this->near(place)));
  }
  val insertNode(int curve, int node, const val& place, const std::string& kind)
  {
    return objectOf(this->Curves.insertNode(static_cast<std::size_t>(curve),
      static_cast<std::size_t>(node), this->near(place), kindOf(kind)));
  }
  val removeNode(int curve, int node)
  {
    return objectOf(
      this->Curves.removeNode(static_cast<std::size_t>(curve), static_cast<std::size_t>(node)));
  }
  val setClosed(int curve, bool closed)
  {
    return objectOf(this->Curves.setClosed(static_cast<std::size_t>(curve), closed));
  }
  void undo() { this->Curves.undo(); }
  void redo() { this->Curves.redo(); }
  bool canUndo() const { return this->Curves.canUndo(); }
  bool canRedo() const { return this->Curves.canRedo(); }
  void beginGroup() { this->Curves.beginGroup(); }
  void endGroup() { this->Curves.endGroup(); }

  /// Of each { name, type, closed, points, nodes, kinds, length }.
  val curves() const
  {
    val list = val::array();
    for (const auto& curve : this->Curves.state().curves)
    {
      Points3 nodes;
      for (const SurfacePoint& node : curve->nodes)
      {
        nodes.push_back(node.position);
      }
      val kinds = val::array();
      for (const SegmentKind kind : curve->kinds)
      {
        kinds.call<void>("push", segmentWords[static_cast<std::size_t>(kind)]);
      }
      const CurveTraits& traits = curve->traits;
      val object = val::object();
      object.set("name", traits.name);
      object.set("type",
        traits.type == CurveType::Key && traits.keyShape == KeyShape::Straight
          ? std::string("straight")
          : std::string(curveTypeName(traits.type)));
      object.set("closed", curve->closed);
      object.set("points", arrayOf<double>(pointsAlong(curve->segments)));
      object.set("nodes", arrayOf<double>(nodes));
      object.set("kinds", kinds);
      object.set("length", lengthOf(*curve));
      list.call<void>("push", object);
    }
    return list;
  }

private:
  SurfacePoint near(const val& place) const
  {
    const Points3 points = pointsOf(place);
    if (points.size() != 1)
    {
      throw std::invalid_argument("a place must be three numbers");
    }
    return this->Drawn->pointNear(points.front());
  }

  static CurveTraits traitsOf(const std::string& type, const std::string& name)
  {
    const auto kind = wirewarp::curveKindOf(type);
    if (!kind)
    {
      throw std::invalid_argument(
        std::string("the type of a curve must be ") + wirewarp::curveKindWords);
    }
    CurveTraits traits;
    traits.name = name;
    traits.type = static_cast<CurveType>(kind->type);
    traits.keyShape = static_cast<KeyShape>(kind->keyShape);
    return traits;
  }

  static SegmentKind kindOf(const std::string& word)
  {
    for (std::size_t k = 0; k < segmentWords.size(); ++k)
    {
      if (segmentWords[k] == word)
      {
        return static_cast<SegmentKind>(k);
      }
    }
    throw std::invalid_argument("segments are geodesic, section, edges or spline, not " + word);
  }

  std::shared_ptr<const DrawingSurface> Drawn;
  CurveEditor Curves;
};

/// { name, about } of each known material.
val materials()
{
  val list = val::array();
  for (const ClothMaterial& material : materialPresets())
  {
    val object = val::object();
    object.set("name", material.name);
    object.set("about", material.description);
    list.call<void>("push", object);
  }
  return list;
}

/// { name, words, type, default, range, label, help, ofSuggestion } of each option.
val optionsOfFlattening()
{
  val list = val::array();
  for (const Option* const option : optionsOf(OptionOwner::Suggestion))
  {
    val words = val::array();
    for (const OptionWord& word : option->words)
    {
      words.call<void>("push", word.word);
    }
    val object = val::object();
    object.set("name", spelled(*option, OptionSpelling::Python));
    object.set("words", words);
    object.set("type", static_cast<int>(option->type));
    object.set("default", textOf(*option, option->byDefault));
    object.set("range", rangeOf(*option));
    object.set("label", labelOf(*option));
    object.set("help", option->help);
    object.set("ofSuggestion", option->owner == OptionOwner::Suggestion);
    list.call<void>("push", object);
  }
  return list;
}

/// Calls a function; what C++ throws becomes an Error of JavaScript.
template <class Job>
auto orError(const Job& job)
{
  try
  {
    return job();
  }
  catch (const std::exception& error)
  {
    val::global("Error").new_(std::string(error.what())).throw_();
  }
}

template <auto Function>
struct Safe;
template <class Result, class... Arguments, Result (*Function)(Arguments...)>
struct Safe<Function>
{
  static Result call(Arguments... arguments)
  {
    return orError([&] { return Function(arguments...); });
  }
};
template <class Result, class Self, class... Arguments, Result (Self::*Function)(Arguments...)>
struct Safe<Function>
{
  static Result call(Self& self, Arguments... arguments)
  {
    return orError([&] { return (self.*Function)(arguments...); });
  }
};
template <class Result, class Self, class... Arguments,
  Result (Self::*Function)(Arguments...) const>
struct Safe<Function>
{
  static Result call(const Self& self, Arguments... arguments)
  {
    return orError([&] { return (self.*Function)(arguments...); });
  }
};
}
}

EMSCRIPTEN_BINDINGS(surfaceflattening)
{
  using namespace emscripten;
  using namespace flattening::web;
  class_<Flattening>("Flattening")
    .smart_ptr<std::shared_ptr<Flattening>>("FlatteningPtr")
    .function("report", &Safe<&Flattening::report>::call)
    .function("flat", &Safe<&Flattening::flat>::call)
    .function("wires", &Safe<&Flattening::wires>::call)
    .function("cut", &Safe<&Flattening::cut>::call)
    .function("pattern", &Safe<&Flattening::pattern>::call);
  class_<Surface>("Surface")
    .smart_ptr<std::shared_ptr<Surface>>("SurfacePtr")
    .class_function("ofArrays", &Safe<&Surface::ofArrays>::call)
    .class_function("ofFile", &Safe<&Surface::ofFile>::call)
    .function("arrays", &Safe<&Surface::arrays>::call)
    .function("unit", &Safe<&Surface::unit>::call)
    .function("setUnit", &Safe<&Surface::setUnit>::call)
    .function("likelyUnit", &Safe<&Surface::likelyUnit>::call)
    .function("curves", &Safe<&Surface::curves>::call)
    .function("developability", &Safe<&Surface::developability>::call)
    .function("flatten", &Safe<&Surface::flatten>::call)
    .function("suggest", &Safe<&Surface::suggest>::call);
  class_<Editor>("Editor")
    .smart_ptr<std::shared_ptr<Editor>>("EditorPtr")
    .class_function("of", &Safe<&Editor::of>::call)
    .function("snap", &Safe<&Editor::snap>::call)
    .function("add", &Safe<&Editor::add>::call)
    .function("addStroke", &Safe<&Editor::addStroke>::call)
    .function("addImage", &Safe<&Editor::addImage>::call)
    .function("addOffset", &Safe<&Editor::addOffset>::call)
    .function("describe", &Safe<&Editor::describe>::call)
    .function("remove", &Safe<&Editor::remove>::call)
    .function("moveNode", &Safe<&Editor::moveNode>::call)
    .function("insertNode", &Safe<&Editor::insertNode>::call)
    .function("removeNode", &Safe<&Editor::removeNode>::call)
    .function("setClosed", &Safe<&Editor::setClosed>::call)
    .function("undo", &Safe<&Editor::undo>::call)
    .function("redo", &Safe<&Editor::redo>::call)
    .function("canUndo", &Safe<&Editor::canUndo>::call)
    .function("canRedo", &Safe<&Editor::canRedo>::call)
    .function("beginGroup", &Safe<&Editor::beginGroup>::call)
    .function("endGroup", &Safe<&Editor::endGroup>::call)
    .function("curves", &Safe<&Editor::curves>::call);
  function("materials", &materials);
  function("options", &optionsOfFlattening);
}
