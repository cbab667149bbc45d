// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening.h"

#include "Input/ClothInput.h"
#include "Input/StatusWords.h"
#include "InputError.h"
#include "NeutralLayer.h"
#include "Options/OptionStructures.h"
#include "Outlines/PatternSource.h"
#include "Paths/PlaneSection.h"
#include "Patterns.h"
#include "Progress.h"
#include "ReadCurves.h"
#include "ReadSurface.h"
#include "Report.h"
#include "Report/FlatteningData.h"
#include "Report/FlatteningTables.h"
#include "Report/SuggestionReport.h"
#include "Report/SurfaceRun.h"
#include "Resewing.h"
#include "Sizes.h"
#include "Suggestion/SymmetryPlane.h"
#include "Surface/SurfacePreparation.h"
#include "SurfaceMending.h"
#include "TableOptions.h"
#include "TextFile.h"
#include "TriangleList.h"
#include "Units.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <map>
#include <memory>
#include <sstream>
#include <utility>

namespace wirewarp
{
namespace
{
using Clock = std::chrono::steady_clock;
using flattening::Column;
using flattening::Columns;
using flattening::OptionOwner;
using flattening::Status;

/// A bound that was given and is missed by more than half of it, or a width that is exceeded; what
/// helps is in the warning of the search.
void checkBound(const Options& options, Flattening& result)
{
  if (result.exitCode != Done || rowsOf(result.search) == 0)
  {
    return;
  }
  const double bound = options.values.number("Bound");
  const bool bounded = options.values.isGiven("Bound") && bound > 0.0;
  const double strain = numberIn(result.search, 0, "StrainAfter");
  const double mostWidth = options.values.number("MaximumWidth");
  const double width = numberIn(result.search, 0, "Width");
  const bool wide = mostWidth > 0.0 && width > mostWidth;
  const bool kept = !bounded || strain <= missedBy * bound;
  if (kept && !wide)
  {
    return;
  }
  std::ostringstream message;
  message << std::setprecision(4);
  if (kept)
  {
    message << "a piece is " << width << ' ' << result.unit << " wide, more than the " << mostWidth
            << " allowed (--max-width, --max-cuts)";
  }
  else if (std::isnan(strain))
  {
    message << "no cuts are found with which the surface can be flattened, so that the bound of "
            << bound << " is not met";
  }
  else
  {
    const bool darts = options.values.text("SuggestedCuts") == "darts";
    message << "a strain of " << 100.0 * strain << " % is left, more than half above the bound of "
            << 100.0 * bound << " %; take " << (darts ? "--kind all, " : "")
            << "a longer --effort, more --max-cuts, or a larger --max-strain";
  }
  result.exitCode = Flawed;
  result.status = "BoundMissed";
  result.message = message.str();
}

using CurveFiles = std::map<std::string, CurveContents>;

/// The curves that need no surface to be read, by their files.
CurveFiles readSavedCurves(const Options& options)
{
  CurveFiles saved;
  for (const std::string& path : options.curves)
  {
    const std::string extension = lowerCaseExtension(path);
    if (extension == ".vtp" || extension == ".vtk" || extension == ".obj")
    {
      saved[path] = readCurves(path, {});
    }
  }
  return saved;
}

/// What --unit says goes before what the surface says, and that before what curves say.
void chooseUnit(const Options& options, const CurveFiles& curves, const SurfaceContents& contents,
  Flattening& result)
{
  std::string stated = options.unit.empty() ? contents.unit : options.unit;
  for (const auto& [path, contentsOfFile] : curves)
  {
    const std::string unit = unitOf(contentsOfFile.curves);
    stated = stated.empty() ? unit : stated;
    if (!unit.empty() && unit != stated)
    {
      std::string& note = result.warnings.emplace_back(inQuotes(path) + " was saved in " + unit);
      note.append(", and ").append(inQuotes(options.surface)).append(" is taken in ");
      note.append(stated).append("; check --unit");
    }
  }
  if (stated.empty() && options.height > 0.0)
  {
    stated = "mm"; // in which the surface is once it is scaled
  }
  result.unitStated = !stated.empty();
  if (result.unitStated)
  {
    result.unit = stated;
    return;
  }
  LikelyUnit taken = likelyUnit(contents.surface);
  if (!options.unitOtherwise.empty())
  {
    taken.unit = options.unitOtherwise;
  }
  result.unit = taken.unit;
  result.unitNote = unitTaken(options.surface, taken);
}

/// Curves that were proposed lie on the surface as it was mended for that.
DataSet mended(const Options& options, const SurfaceContents& contents, const CurveFiles& curves,
  Flattening& result)
{
  const bool proposed = std::any_of(curves.begin(), curves.end(), [](const auto& file) {
    return findColumn(file.second.curves.cellArrays, "PredictedGain") != nullptr;
  });
  MendedSurface mend = mendedSurface(options, contents, result.unit, proposed);
  result.warnings.insert(result.warnings.end(), mend.notes.begin(), mend.notes.end());
  return std::move(mend.surface);
}

/// What --seams-from asks for; without lines where there is nothing of it.
DataSet readSeams(const std::string& path, const SurfaceContents& contents, const Options& options,
  Flattening& result)
{
  if (options.seamsFrom == SeamSource::None)
  {
    return {};
  }
  try
  {
    DataSet seams = seamsOf(contents.surface, contents.labels, options.seamsFrom);
    if (seams.lines.size() == 0)
    {
      result.warnings.emplace_back("--seams-from found no edge to cut along");
    }
    return seams;
  }
  catch (const InputError& error)
  {
    throw InputError(path, error.what());
  }
}

/// Where the plane between front and back cuts a surface in the middle.
DataSet sideSeams(const DataSet& surface)
{
  const flattening::SurfaceTriangles read = flattening::readTriangles(surface);
  const flattening::PreparedSurface prepared =
    flattening::prepareSurface(read.points, read.triangles);
  if (!prepared.status.ok())
  {
    throw InputError(messageOf(prepared.status.message, remediesOf(prepared.status)));
  }
  Points3 places;
  CurveList curves;
  for (const flattening::PlaneSection& section : flattening::planeSections(
         prepared.mesh, boxOf(listTriangles(surface)).center(), flattening::frontOf(prepared.mesh)))
  {
    curves.add(
      flattening::positionsOf(section.path.points), places, { *curveKindOf("seam"), "side" });
  }
  if (places.empty())
  {
    throw InputError("--template front-back: the plane between front and back misses the surface");
  }
  return curves.over(std::make_shared<const Points3>(std::move(places)));
}

/// What is cut from a roll has its allowances on it: strips are narrower by these.
Options withinRoll(Options options, const std::string& unit)
{
  const std::string material = options.values.text("Material");
  const bool isSheet = !material.empty() && flattening::readCloth(material).material.sheet;
  const double given = options.pattern.values.number("Allowance");
  const double allowance = given < 0.0 ? flattening::pattern::usualAllowance(isSheet) : given;
  const double width =
    options.values.number("MaximumWidth") - 2.0 * allowance / millimetresOf(unit);
  if (!(width > 0.0))
  {
    throw InputError("--max-width is not more than both allowances of a strip; fix: a smaller "
                     "--allowance, or check --unit");
  }
  options.values.set("MaximumWidth", width);
  return options;
}

/// A surface and its curves in their files.
struct RunInput
{
  DataSet surface;
  std::vector<DataSet> curves;
  std::vector<std::string> files; ///< of the curves
};

/// \param base as flattenOne() has it
RunInput readInput(const Options& options, const std::string& base, Flattening& result)
{
  SurfaceContents contents = readSurface(options.surface);
  if (!contents.note.empty())
  {
    result.warnings.push_back(inQuotes(options.surface) + ": " + contents.note);
  }
  DataSet seams = readSeams(options.surface, contents, options, result);
  const CurveFiles saved = readSavedCurves(options);
  chooseUnit(options, saved, contents, result);
  contents.surface = mended(options, contents, saved, result);
  setUnit(contents.surface, result.unitStated ? result.unit : std::string());
  DataSet owner = contents.surface; // of the curves
  if (!base.empty())
  {
    Flattening ignored;
    SurfaceContents model = readSurface(base);
    seams = readSeams(base, model, options, ignored);
    ignored.unit = result.unit;
    model.surface = mended(options, model, saved, ignored);
    checkConnectivity(model.surface, base, contents.surface, options.surface);
    owner = model.surface;
    contents.curves = model.curves;
  }
  const bool scaled = isScaled(options);
  const double factor = scaled ? scaleOf(options, contents.surface, result.unit) : 1.0;
  if (options.neutralLayer != 0.0)
  {
    contents.surface =
      neutralLayer(contents.surface, options.neutralLayer / millimetresOf(result.unit) / factor);
  }
  RunInput input;
  input.surface = contents.surface;
  if (scaled)
  {
    scaleBy(factor, input.surface);
  }
  const auto connect = [&](const std::string& path, DataSet curves) {
    const std::string note = notesOfNumberNames(owner, curves);
    if (!note.empty())
    {
      result.warnings.push_back(inQuotes(path) + ": " + note);
    }
    if (!base.empty())
    {
      curves = movedCurves(curves, owner, contents.surface);
    }
    const bool same = curves.points == contents.surface.points;
    if (same)
    {
      curves.points = input.surface.points;
    }
    else if (factor != 1.0)
    {
      scaleBy(factor, curves);
    }
    input.files.push_back(path);
    input.curves.push_back(std::move(curves));
  };
  if (contents.curves.lines.size() > 0)
  {
    connect(options.surface, contents.curves);
  }
  if (seams.lines.size() > 0)
  {
    connect(options.surface, seams);
  }
  for (const std::string& path : options.curves)
  {
    const auto before = saved.find(path);
    const CurveContents curves = before == saved.end() ? readCurves(path, owner) : before->second;
    if (!curves.note.empty())
    {
      result.warnings.push_back(inQuotes(path) + ": " + curves.note);
    }
    connect(path, curves.curves);
  }
  if (options.seams == "front-back")
  {
    connect("--template", sideSeams(owner));
  }
  result.curveDistance = largestDistance(input.surface, input.curves);
  return input;
}

/// A flattening as it is written: a run of one surface.
class CommandRun
{
public:
  CommandRun(const Options& options, const RunInput& input, Flattening& result)
    : Given(options)
    , Input(input)
    , Result(result)
    , Settings(structuresOf(options))
    , Source(input.surface, input.curves)
    , Run(Source.run)
  {
    this->Source.unit = result.unit;
    this->Source.unitStated = result.unitStated;
    const auto tolerances = tolerancesOf(options);
    const auto elastic = tolerances.find(flattening::boundaryName);
    if (elastic != tolerances.end())
    {
      this->Settings.flattening.boundaryTolerance = elastic->second;
    }
    const std::string material = options.values.text("Material");
    if (!material.empty())
    {
      this->Settings.flattening.cloth =
        flattening::readCloth(material, options.values.list("Grain"));
    }
  }

  const flattening::FlatteningRun& run() const { return this->Run; }
  const flattening::OptionStructures& settings() const { return this->Settings; }
  const flattening::CurveInput& curves() const { return this->Source.curves; }

  void flatten(const flattening::Execution& execution)
  {
    if (this->load(execution))
    {
      const std::string& command = this->Given.command;
      if (command == "cut" || command == "make")
      {
        this->suggest(execution);
      }
      else if (command == "reshape")
      {
        this->reshape(execution);
      }
      else if (command != "prices" || this->price(execution))
      {
        this->take(this->Run.flatten(this->Settings.flattening, pinsOf(this->Given), execution));
      }
    }
    std::vector<std::string>& warnings = this->Result.warnings;
    warnings.insert(warnings.begin(), this->Run.warnings.begin(), this->Run.warnings.end());
  }

private:
  /// \return whether the surface can be used
  bool load(const flattening::Execution& execution)
  {
    const bool loaded = this->Source.load(
      this->Settings, tolerancesOf(this->Given), this->Given.values.text("WeightArray"), execution);
    const int blamed = this->Run.source.blamed;
    if (!loaded && blamed > 0 && this->Input.curves.size() > 1)
    {
      this->Run.status.message =
        "connection " + std::to_string(blamed - 1) + " of the curves: " + this->Run.status.message;
    }
    return loaded;
  }

  bool price(const flattening::Execution& execution)
  {
    const auto prices = this->Run.price(this->Settings.flattening, execution);
    if (prices)
    {
      this->Result.keyPrices = keyPriceTable(this->Run.source.imprinted.curves, *prices);
    }
    return prices.has_value();
  }

  void suggest(const flattening::Execution& watched)
  {
    const Interruption interruption;
    flattening::Execution execution = watched;
    execution.cancel = &Interruption::pressed;
    const std::vector<flattening::Polyline> given = this->Run.source.curves.polylines;
    flattening::CurveSuggestions found;
    const auto result = this->Run.suggest(this->Settings, execution, &Interruption::forget, found);
    if (!result)
    {
      return;
    }
    this->take(result);
    this->Result.curves = this->stated(suggestionData(given, found));
    this->Result.search = searchTable(found);
    this->Result.leftOutLines = leftOutTable(found);
  }

  void reshape(const flattening::Execution& execution)
  {
    const std::vector<std::string>& kept = this->Given.reshaping.list("KeptCurves");
    const flattening::LoadedBody body = loadedBody(this->Given.body);
    flattening::CurvedSurface& source = this->Run.source;
    const auto moved =
      this->Run.reshape({ kept.begin(), kept.end() }, body, this->Settings, execution);
    if (!moved)
    {
      return;
    }
    this->Result.piecesBefore =
      flattening::pieceTable(source, moved->before, this->Result.unit, this->names(moved->before));
    Columns shifts = shiftArrays(source.imprinted.mesh, *moved);
    source.imprinted.mesh = moved->mesh;
    this->take(moved->after);
    DataSet cut = *this->Result.cut;
    dropNormals(cut);
    this->Result.cut = std::make_shared<const DataSet>(std::move(cut));
    flattening::ImprintData imprint = imprintData(this->Source.arrays, source);
    dropNormals(imprint.surface);
    dropNormals(imprint.curves);
    for (Column& column : imprint.surface.pointArrays)
    {
      column.role =
        column.role == flattening::ArrayRole::Scalars ? flattening::ArrayRole::None : column.role;
    }
    for (Column& column : shifts)
    {
      column.role = column.name == "ShiftDistance" ? flattening::ArrayRole::Scalars
                                                   : flattening::ArrayRole::None;
    }
    setColumns(imprint.surface.pointArrays, std::move(shifts));
    this->Result.flattenable = this->stated(std::move(imprint.surface));
    this->Result.flattenableCurves = this->stated(std::move(imprint.curves));
    this->Result.shiftMeasures = shiftTable(*moved);
    this->Result.shiftTrials = moved->trials.size();
  }

  /// The data with the unit of the surface, where one is stated.
  Data stated(DataSet data) const
  {
    setUnit(data, this->Result.unitStated ? this->Result.unit : std::string());
    return std::make_shared<const DataSet>(std::move(data));
  }

  std::vector<std::string> names(const flattening::FlatteningResult& result) const
  {
    const Column* const all = findColumn(this->Source.arrays.cells, "PieceName");
    std::vector<std::string> names;
    for (std::size_t t = 0; all && all->isText() && t < result.cut->pieceOfTriangle.size(); ++t)
    {
      names.push_back(all->text(static_cast<std::size_t>(
        this->Run.source.cellOf(result.cut->originalTriangle(static_cast<flattening::Index>(t))))));
    }
    return names;
  }

  void take(const std::optional<flattening::FlatteningResult>& flattened)
  {
    if (!flattened)
    {
      return;
    }
    flattening::FlatteningReport report =
      reportFlattening(this->Source, *flattened, this->Settings.flattening);
    this->Result.flat = std::make_shared<const DataSet>(std::move(report.data.flat));
    this->Result.wires = std::make_shared<const DataSet>(std::move(report.data.wires));
    this->Result.cut = std::make_shared<const DataSet>(std::move(report.data.cut));
    this->Result.tables = std::move(report.tables);
    this->Result.seconds = report.seconds;
  }

  const Options& Given;
  const RunInput& Input;
  Flattening& Result;
  flattening::OptionStructures Settings;
  flattening::SurfaceRun Source;
  flattening::FlatteningRun& Run;
};
}

std::vector<Remedy> remediesOf(const flattening::ReportTables& tables, std::size_t piece)
{
  std::vector<Remedy> remedies;
  const Table& all = tables.pieceRemedies;
  for (std::size_t row = 0; row < rowsOf(all); ++row)
  {
    if (integerIn(all, row, "Piece") == static_cast<long long>(piece))
    {
      remedies.push_back({ textIn(all, row, "Remedy"), textIn(all, row, "Subject") });
    }
  }
  return remedies;
}

void Flattening::conclude(const flattening::Status& outcome)
{
  this->status = flattening::statusName(outcome.code);
  this->remedies = remediesOf(outcome);
  if (outcome.code == flattening::StatusCode::ClosedSurface)
  {
    this->remedies.push_back({ "Give", "one side of a sheet with thickness (--outer-side)" });
  }
  this->message = messageOf(outcome.message, this->remedies);
  this->idKind = flattening::kindName(outcome.ids.kind);
  this->ids.assign(outcome.ids.values.begin(), outcome.ids.values.end());
  this->exitCode = outcome.refused() ? InputRefused : outcome.ok() ? Done : Flawed;
}

MendedSurface mendedSurface(
  const Options& options, const SurfaceContents& contents, const std::string& unit, bool proposed)
{
  MendingRequest request;
  if (double distance = 0.0; parseNumber(options.weld, distance))
  {
    request.weld = distance;
  }
  request.doubled = contents.doubled;
  const std::string format = lowerCaseExtension(options.surface);
  const bool proposes = proposed || options.command == "cut" || options.command == "make";
  request.likely = options.weld.empty() && (format == ".obj" || format == ".ply") && proposes;
  request.fillHoles = options.fillHoles;
  request.millimetres = millimetresOf(unit);
  request.outerSide = options.outerSide == "true";
  request.likelySide = options.outerSide.empty() && proposes;
  return mendSurface(contents.surface, request);
}

bool isScaled(const Options& options)
{
  return options.scale != 1.0 || options.height > 0.0;
}

double scaleOf(const Options& options, const DataSet& surface, const std::string& unit)
{
  if (!(options.height > 0.0))
  {
    return options.scale;
  }
  const Eigen::AlignedBox3d box = boxOf(listTriangles(surface));
  const Point3 sizes = box.isEmpty() ? Point3(Point3::Zero()) : Point3(box.sizes());
  const std::string up = options.pattern.values.text("UpAxis"); // x, y, z, or a longer word
  const Eigen::Index axis = up.size() == 1 ? up.front() - 'x' : flattening::upAxisOf(sizes);
  if (!(sizes[axis] > 0.0))
  {
    throw InputError(options.surface,
      std::string("has no extent in ") + static_cast<char>('x' + axis) +
        ", its up axis, that could have the --height; give --scale");
  }
  return options.height / millimetresOf(unit) / sizes[axis];
}

void scaleBy(double factor, DataSet& data)
{
  Points3 points = *data.points; // those of the file as it was read may be others'
  for (Point3& point : points)
  {
    point *= factor;
  }
  data.points = std::make_shared<const Points3>(std::move(points));
}

void dropNormals(DataSet& data)
{
  flattening::eraseIf(data.pointArrays,
    [](const Column& column) { return column.role == flattening::ArrayRole::Normals; });
}

std::string unitTaken(const std::string& surface, const LikelyUnit& taken)
{
  return surface + ' ' + describe(taken) + "; state it with --unit mm, cm, m or inch";
}

Flattening outOfMemory(const std::string& surface, const std::string& limit)
{
  Flattening result;
  result.exitCode = InputRefused;
  result.status = "OutOfMemory";
  result.message = surface + ": memory ran out" +
    (limit.empty() ? " around the flattening; "
                   : ", or the limit of threads was met (" + limit +
          "); give a higher limit of processes (ulimit -u), or ") +
    wayOutOfMemory;
  return result;
}

Flattening flattenOne(const Options& options, const std::string& base)
{
  Flattening result;
  const Clock::time_point start = Clock::now();
  try
  {
    if (!options.source.empty())
    {
      result = readResult(options);
      sewAgain(options, result);
      return result;
    }
    const RunInput input = readInput(options, base, result);
    result.secondsRead = secondsSince(start);
    Options inUnit = withLengthsIn(result.unit, options);
    if (options.seams == "strips")
    {
      inUnit = withinRoll(std::move(inUnit), result.unit);
    }
    CommandRun run(inUnit, input, result);
    checkPattern(options, input.surface, run.curves(), run.settings(), result);
    if (result.refused())
    {
      result.message = options.surface + ": " + result.message;
      return result;
    }
    {
      Progress progress(options.quiet);
      run.flatten(progress.execution(options.threads));
    }
    result.conclude(run.run().status);
    if (options.seams == "gores" && result.status == "InvalidOption")
    {
      result.message += ", or another --template: front-back, strips, foam-shell";
    }
    checkBound(inUnit, result);
    const int curves = run.run().status.refused() ? run.run().source.blamed - 1 : -1;
    const bool ofFile = curves >= 0 && curves < static_cast<int>(input.files.size());
    const std::string& file =
      ofFile ? input.files[static_cast<std::size_t>(curves)] : options.surface; // or of a proposal
    sewAgain(options, result);
    if (result.refused())
    {
      result.message = file + ": " + result.message;
    }
  }
  catch (const InputError& error)
  {
    result.exitCode = InputRefused;
    result.status = "UnreadableInput";
    result.message = error.what();
  }
  catch (const std::bad_alloc&)
  {
    result = outOfMemory(options.surface);
  }
  catch (const std::runtime_error& error) // of TBB: it cannot start a thread
  {
    result = outOfMemory(options.surface, error.what());
  }
  result.secondsTotal = secondsSince(start);
  return result;
}
}
