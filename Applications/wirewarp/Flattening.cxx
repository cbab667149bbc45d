// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening.h"

#include "InputError.h"
#include "NeutralLayer.h"
#include "Patterns.h"
#include "Progress.h"
#include "ReadCurves.h"
#include "ReadSurface.h"
#include "Report.h"
#include "Resewing.h"
#include "Sizes.h"
#include "SurfaceMending.h"
#include "TableOptions.h"
#include "TextFile.h"
#include "Units.h"
#include "VtkMessages.h"

#include <cmath>
#include <vtkCommand.h>
#include <vtkFeatureCurveSuggestion.h>
#include <vtkFlatPieceAlgorithm.h>
#include <vtkFlatteningAlgorithm.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkTrivialProducer.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <iomanip>
#include <map>
#include <optional>
#include <sstream>

namespace wirewarp
{
namespace
{
using Clock = std::chrono::steady_clock;

volatile std::sig_atomic_t interrupted = 0;

/// While it lives, Ctrl+C aborts a filter, and pressed once more ends the program.
class Interruption
{
public:
  explicit Interruption(vtkAlgorithm* filter)
    : Filter(filter)
    , Observer(filter->AddObserver(vtkCommand::ProgressEvent, this, &Interruption::look))
  {
    interrupted = 0;
    this->Before = std::signal(SIGINT, [](int) {
      interrupted = 1;
      std::signal(SIGINT, SIG_DFL);
    });
    if (this->Before == SIG_IGN)
    {
      std::signal(SIGINT, SIG_IGN);
    }
  }
  ~Interruption()
  {
    std::signal(SIGINT, this->Before);
    this->Filter->RemoveObserver(this->Observer);
  }
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

private:
  void look()
  {
    if (interrupted != 0)
    {
      interrupted = 0;
      this->Filter->SetAbortExecute(1);
    }
  }

  vtkAlgorithm* Filter;
  unsigned long Observer;
  void (*Before)(int) = SIG_DFL;
};

/// A bound that was asked for and is missed by more than half of it, or a width that is exceeded.
void checkBound(const Options& options, Flattening& result)
{
  if (result.exitCode != Done || result.search->GetNumberOfRows() == 0)
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
    message << "a piece is " << width << " wide, more than the " << mostWidth
            << " allowed; allow more cuts (--max-cuts), or part it by seams";
  }
  else if (std::isnan(strain))
  {
    message << "no cuts are found with which the surface can be flattened, so that the bound of "
            << bound << " is not met; draw seams that open the surface";
  }
  else
  {
    message << "the proposed cuts leave a strain of " << strain
            << ", more than half above the bound of " << bound
            << "; allow more cuts (--max-cuts) or work (--max-work), or a larger bound";
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
      saved[path] = readCurves(path, nullptr);
    }
  }
  return saved;
}

/// What --unit says goes before what the surface says, and that before what curves say.
void setUnit(const Options& options, const CurveFiles& curves, const SurfaceContents& contents,
  Flattening& result)
{
  std::string stated = options.unit.empty() ? contents.unit : options.unit;
  for (const auto& [path, contentsOfFile] : curves)
  {
    const std::string unit = vtkFlatteningAlgorithm::GetLengthUnitOf(contentsOfFile.curves);
    stated = stated.empty() ? unit : stated;
    if (!unit.empty() && unit != stated)
    {
      std::string& note = result.notes.emplace_back(inQuotes(path) + " was saved in " + unit);
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

vtkSmartPointer<vtkPolyData> mended(
  const Options& options, const SurfaceContents& contents, Flattening& result)
{
  MendedSurface mend = mendedSurface(options, contents, result.unit);
  result.notes.insert(result.notes.end(), mend.notes.begin(), mend.notes.end());
  return mend.surface;
}

/// What --seams-from asks for; null where there is nothing of it.
vtkSmartPointer<vtkPolyData> readSeams(const std::string& path, const SurfaceContents& contents,
  const Options& options, Flattening& result)
{
  if (options.seamsFrom == SeamSource::None)
  {
    return nullptr;
  }
  try
  {
    vtkSmartPointer<vtkPolyData> seams =
      seamsOf(contents.surface, contents.labels, options.seamsFrom);
    if (!seams)
    {
      result.notes.emplace_back("--seams-from found no edge to cut along");
    }
    return seams;
  }
  catch (const InputError& error)
  {
    throw InputError(path, error.what());
  }
}

/// Returns the file of each connection of curves.
/// \param base as flattenOne() has it
std::vector<std::string> readInput(const Options& options, const std::string& base,
  vtkFlatPieceAlgorithm* filter, Flattening& result)
{
  SurfaceContents contents = readSurface(options.surface);
  vtkSmartPointer<vtkPolyData> seams = readSeams(options.surface, contents, options, result);
  const CurveFiles saved = readSavedCurves(options);
  setUnit(options, saved, contents, result);
  contents.surface = mended(options, contents, result);
  vtkFlatteningAlgorithm::SetLengthUnitOf(contents.surface, result.unit);
  vtkSmartPointer<vtkPolyData> owner = contents.surface; // of the curves
  if (!base.empty())
  {
    Flattening ignored;
    SurfaceContents model = readSurface(base);
    seams = readSeams(base, model, options, ignored);
    ignored.unit = result.unit;
    model.surface = mended(options, model, ignored);
    checkConnectivity(model.surface, base, contents.surface, options.surface);
    owner = model.surface;
    contents.curves = model.curves;
  }
  if (options.neutralLayer != 0.0)
  {
    const double inwards = options.neutralLayer / millimetresOf(result.unit);
    contents.surface = neutralLayer(contents.surface,
      isScaled(options) ? inwards / scaleOf(options, owner, result.unit) : inwards);
  }
  vtkSmartPointer<vtkPolyData> surface = contents.surface;
  double factor = 1.0;
  if (isScaled(options))
  {
    factor = scaleOf(options, contents.surface, result.unit);
    surface = vtkSmartPointer<vtkPolyData>::New();
    surface->ShallowCopy(contents.surface);
    scaleBy(factor, surface);
  }
  filter->SetInputData(surface);
  std::vector<std::string> files;
  std::vector<vtkPolyData*> read; // which the filter's connections keep
  const auto connect = [&](const std::string& path, vtkSmartPointer<vtkPolyData> curves) {
    const std::string note = notesOfNumberNames(owner, curves);
    if (!note.empty())
    {
      result.notes.push_back(inQuotes(path) + ": " + note);
    }
    vtkNew<vtkTrivialProducer> producer;
    if (owner != contents.surface)
    {
      curves = movedCurves(curves, owner, contents.surface);
    }
    if (factor != 1.0)
    {
      scaleBy(factor, curves);
    }
    producer->SetOutput(curves);
    filter->AddCurvesConnection(producer->GetOutputPort());
    files.push_back(path);
    read.push_back(curves);
  };
  if (contents.curves)
  {
    connect(options.surface, contents.curves);
  }
  if (seams)
  {
    connect(options.surface, seams);
  }
  for (const std::string& path : options.curves)
  {
    const auto before = saved.find(path);
    const CurveContents curves = before == saved.end() ? readCurves(path, owner) : before->second;
    if (!curves.note.empty())
    {
      result.notes.push_back(inQuotes(path) + ": " + curves.note);
    }
    connect(path, curves.curves);
  }
  if (options.seams.given())
  {
    connect("--template", seamsOf(options.seams, owner));
  }
  result.curveDistance = largestDistance(surface, read);
  return files;
}

/// A unit that is taken is none that the files state, and a note says of it what the filter warns
/// of.
void forgetUnit(vtkFlatPieceAlgorithm* filter, Flattening& result)
{
  if (result.unitStated)
  {
    return;
  }
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkFlatteningAlgorithm::SetLengthUnitOf(filter->GetOutputDataObject(port), "");
  }
  const std::string warning = filter->GetSizeWarning();
  result.warnings.erase(
    std::remove(result.warnings.begin(), result.warnings.end(), warning), result.warnings.end());
}

void takeTables(vtkFlatPieceAlgorithm* filter, Flattening& result)
{
  result.tables = PieceTables{ filter->GetPieces(), filter->GetAngleIterations(),
    filter->GetIsometricIterations(), filter->GetReleases(), filter->GetPieceRemedies() };
  result.leftOutPieces = filter->GetLeftOutPieces();
  result.curveTable = filter->GetCurves();
  std::copy_n(filter->GetSeconds(), 4, result.seconds.begin());
}

void run(vtkFlatPieceAlgorithm* filter, bool quiet, Flattening& result)
{
  const VtkMessages messages;
  {
    const Progress progress(filter, quiet);
    std::optional<Interruption> interruption;
    if (filter->IsA("vtkFeatureCurveSuggestion"))
    {
      interruption.emplace(filter);
    }
    filter->Update();
  }
  result.flat = filter->GetOutput(0);
  result.wires = filter->GetOutput(1);
  result.cut = filter->GetOutput(2);
  if (!filter->IsRefused())
  {
    takeTables(filter, result);
  }
  result.warnings = textsOf(filter->GetStatusWarnings());
  forgetUnit(filter, result);
  takeReshaped(filter, result);
  if (filter->IsA("vtkKeyCurvePrices"))
  {
    result.keyPrices = vtkTable::SafeDownCast(filter->GetOutputDataObject(5));
  }
  else if (auto* const suggestion = vtkFeatureCurveSuggestion::SafeDownCast(filter))
  {
    result.curves = filter->GetOutput(5);
    result.search = vtkTable::SafeDownCast(filter->GetOutputDataObject(6));
    result.leftOutLines = suggestion->GetLeftOutLines();
  }
  result.status = filter->GetStatusName();
  result.remedies = remediesOf(filter);
  if (result.status == "ClosedSurface")
  {
    result.remedies.push_back({ "Give", "one side of a sheet with thickness (--outer-side)" });
  }
  result.message = messageOf(filter->GetStatusDefect(), result.remedies);
  result.idKind = filter->GetStatusIdKind();
  vtkIdTypeArray* const ids = filter->GetStatusIds();
  for (vtkIdType k = 0; k < ids->GetNumberOfValues(); ++k)
  {
    result.ids.push_back(ids->GetValue(k));
  }
  if (filter->IsRefused())
  {
    result.exitCode = InputRefused;
  }
  else if (filter->GetStatusCode() != vtkFlatteningAlgorithm::OK)
  {
    result.exitCode = Flawed;
  }
  else if (!messages.errors().empty())
  {
    throw InputError(messages.firstError());
  }
}
}

std::vector<std::string> textsOf(vtkStringArray* array)
{
  std::vector<std::string> texts;
  for (vtkIdType k = 0; k < array->GetNumberOfValues(); ++k)
  {
    texts.push_back(array->GetValue(k));
  }
  return texts;
}

std::vector<Remedy> remediesOf(const PieceTables& tables, vtkIdType piece)
{
  std::vector<Remedy> remedies;
  vtkTable* const table = tables.remedies;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    if (integerIn(table, row, "Piece") == piece)
    {
      remedies.push_back({ textIn(table, row, "Remedy"), textIn(table, row, "Subject") });
    }
  }
  return remedies;
}

MendedSurface mendedSurface(
  const Options& options, const SurfaceContents& contents, const std::string& unit)
{
  MendingRequest request;
  if (double distance = 0.0; parseNumber(options.weld, distance))
  {
    request.weld = distance;
  }
  request.doubled = contents.doubled;
  request.fillHoles = options.fillHoles;
  request.millimetres = millimetresOf(unit);
  request.outerSide = options.outerSide;
  return mendSurface(contents.surface, request);
}

bool isScaled(const Options& options)
{
  return options.scale != 1.0 || options.height > 0.0;
}

double scaleOf(const Options& options, vtkPolyData* surface, const std::string& unit)
{
  const vtkBoundingBox box = boxOf(listTriangles(surface));
  const double height = box.IsValid() ? std::max(box.GetLength(1), box.GetLength(2)) : 0.0;
  if (options.height > 0.0 && !(height > 0.0))
  {
    throw InputError(options.surface, "has no extent in y or z that could have the --height");
  }
  return options.height > 0.0 ? options.height / millimetresOf(unit) / height : options.scale;
}

void scaleBy(double factor, vtkPolyData* data)
{
  const vtkNew<vtkPoints> points; // the others may be those of the file as it was read
  points->SetDataTypeToDouble();
  points->DeepCopy(data->GetPoints());
  for (vtkIdType k = 0; k < points->GetNumberOfPoints(); ++k)
  {
    std::array<double, 3> x{};
    points->GetPoint(k, x.data());
    points->SetPoint(k, factor * x[0], factor * x[1], factor * x[2]);
  }
  data->SetPoints(points);
}

vtkBoundingBox boxOf(const TriangleList& list)
{
  vtkBoundingBox box;
  for (const ListedTriangle& triangle : list.triangles)
  {
    for (const vtkIdType corner : triangle.corners)
    {
      box.AddPoint(list.points->GetPoint(corner));
    }
  }
  return box;
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
    const vtkSmartPointer<vtkFlatPieceAlgorithm> filter = makeFilter(options);
    filter->CachingOff(); // it runs once
    setOptions(options, filter);
    setBody(options.body, filter);
    const std::vector<std::string> curveFiles = readInput(options, base, filter, result);
    result.secondsRead = secondsSince(start);
    checkCurveNames(options.pattern, options.surface, filter, result);
    if (result.refused())
    {
      result.message = options.surface + ": " + result.message;
      return result;
    }
    run(filter, options.quiet, result);
    checkBound(options, result);
    const int curves = filter->GetStatusConnection();
    const bool ofFile = curves >= 0 && curves < static_cast<int>(curveFiles.size());
    const std::string& file = ofFile ? curveFiles[curves] : options.surface; // or of a proposal
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
