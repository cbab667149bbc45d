// SPDX-License-Identifier: BSD-3-Clause
#include "Design/LineSuggestion.h"

#include "Base/Execution.h"
#include "Base/Memory.h"
#include "Cut/SurfaceCut.h"
#include "Imprint/CurveImprint.h"
#include "Paths/PlaneSection.h"
#include "Quality/ScaleFactor.h"
#include "Suggestion/CurveSuggestions.h"
#include "Suggestion/CutThinning.h"
#include "Suggestion/CutTrials.h"
#include "Suggestion/SymmetryPlane.h"
#include "Surface/SurfacePoint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace flattening
{
namespace
{
/// How many sections are looked at for girths; those at both ends are none.
constexpr int levels = 64;
constexpr int endLevels = 4;
/// A girth is longer or shorter than those around it by at least this share of the longest.
constexpr double minProminence = 0.02;
constexpr std::size_t maxGirths = 3;
/// In sqrt(area / pi) of the piece: shorter lines are none, and a style line lies at least so far
/// from the centre line.
constexpr double minLength = 0.25;
constexpr double minAside = 0.15;
/// Cosine of the least angle between a line's plane and the surface; below it the plane grazes, and
/// the section is no line to draw.
constexpr double grazing = 0.94;
/// A piece has a centre line where a plane mirrors it better than this, see findSymmetryPlane().
constexpr double mirrorTolerance = 1e-2;
/// Cosine of the angle below which the longest axis is meant to be x, y or z.
constexpr double upright = 0.94;
/// |u| below which a piece lies flat as it is, and has no style line.
constexpr double minScale = 1e-3;

struct Plane
{
  Point3 point = Point3::Zero();
  Point3 normal = Point3::UnitX();
};

/// A piece and its upright plane.
struct PieceFrame
{
  const TriangleMesh* mesh = nullptr;
  double size = 0.0;
  Plane upright;
  bool mirrored = false;
  bool hasKey = false;
};

/// How far a value stands out from those on both sides, up to where they are beyond it.
double prominence(const std::vector<double>& values, std::size_t k)
{
  const auto drop = [&](int step) {
    double deepest = 0.0;
    for (auto j = static_cast<std::ptrdiff_t>(k) + step;
         j >= 0 && j < static_cast<std::ptrdiff_t>(values.size()); j += step)
    {
      const double below = values[k] - values[static_cast<std::size_t>(j)];
      if (below < 0.0)
      {
        break;
      }
      deepest = std::max(deepest, below);
    }
    return deepest;
  };
  return std::min(drop(-1), drop(1));
}

/// Lines that a designer draws on a surface, as sections with planes, piece by piece, from edge to
/// edge or closed:
///
/// - "centre line", a straight key curve: the section with a piece's own mirror plane;
/// - "grain line", a straight key curve, for pieces without one: through the centre of area, along
///   the piece's longest axis and across its mean normal;
/// - "girth", accessory curves: across the longest axis of the whole surface (in its mirror plane,
///   where it has one; x, y or z where it is within 20 degrees of that), where its sections are
///   longer or shorter than all near them, as at bust, waist and hip; the three that stand out
///   most;
/// - "style line", accessory curves: beside the centre or grain line, where a piece is farthest
///   from lying flat (by ScaleFactor), as a princess line goes over the bust.
///
/// Pieces with a key curve get no centre or grain line. Where a plane comes within 20 degrees of
/// touching the surface no line is drawn.
class Drawing
{
public:
  Drawing(const CutSurface& cut, const std::vector<FeatureCurve>& curves, bool symmetric,
    const Execution& execution)
    : Surface(cut.mesh)
    , Pieces(extractPieces(cut))
    , Run(execution)
  {
    const SurfaceMoments whole = momentsOf(cut.mesh);
    this->Center = whole.center;
    this->Axis = longestAxis(whole,
      symmetric && this->Pieces.size() != 1 ? findSymmetryPlane(cut.mesh, mirrorTolerance)
                                            : std::nullopt);
    for (const Piece& piece : this->Pieces)
    {
      this->Frames.push_back(frameOf(piece, curves, symmetric));
      if (this->Pieces.size() == 1 && this->Frames[0].mirrored)
      {
        this->Axis = longestAxis(whole, SymmetryPlane{ this->Frames[0].upright.normal, 0.0, 0.0 });
      }
    }
  }

  std::vector<SuggestedCurve> run()
  {
    this->drawUprights();
    this->drawGirths();
    this->drawStyleLines();
    return std::move(this->Lines);
  }

private:
  static Point3 longestAxis(
    const SurfaceMoments& moments, const std::optional<SymmetryPlane>& mirror)
  {
    Point3 longest = moments.axes.col(2);
    if (mirror && std::abs(longest.dot(mirror->normal)) > 0.5)
    {
      // It lies across the mirror plane, as the span of a shirt's sleeves.
      const Point3 next = moments.axes.col(1);
      longest = (next - next.dot(mirror->normal) * mirror->normal).normalized();
    }
    Eigen::Index nearest = 0;
    return longest.cwiseAbs().maxCoeff(&nearest) > upright ? Point3(Point3::Unit(nearest))
                                                           : longest;
  }

  static PieceFrame frameOf(
    const Piece& piece, const std::vector<FeatureCurve>& curves, bool symmetric)
  {
    PieceFrame frame;
    const SurfaceMoments moments = momentsOf(piece.mesh);
    frame.mesh = &piece.mesh;
    frame.size = std::sqrt(moments.area / pi);
    frame.hasKey = std::any_of(piece.curveOfHalfedge.begin(), piece.curveOfHalfedge.end(),
      [&](Index curve) { return curve != none && curves[curve].type == CurveType::Key; });
    const std::optional<SymmetryPlane> mirror =
      symmetric ? findSymmetryPlane(piece.mesh, mirrorTolerance) : std::nullopt;
    frame.mirrored = mirror.has_value();
    if (mirror)
    {
      frame.upright = { mirror->offset * mirror->normal, mirror->normal };
      return frame;
    }
    Point3 across = Point3::Zero();
    for (Index t = 0; t < piece.mesh.triangleCount(); ++t)
    {
      across += 2.0 * piece.mesh.area(t) * triangleNormal(piece.mesh, t);
    }
    const Point3 longest = moments.axes.col(2);
    const Point3 normal = longest.cross(across);
    // The normals of a closed belt cancel.
    const bool turnsRound =
      normal.norm() < 0.05 * across.norm() || across.norm() < 0.05 * moments.area;
    frame.upright = { moments.center,
      turnsRound ? Point3(moments.axes.col(0)) : Point3(normal.normalized()) };
    return frame;
  }

  static bool grazes(const TriangleMesh& mesh, const PlaneSection& section, const Point3& normal)
  {
    return std::any_of(
      section.path.triangles.begin(), section.path.triangles.end(), [&](Index triangle) {
        return std::abs(triangleNormal(mesh, triangle).dot(normal)) > grazing;
      });
  }

  void add(const PieceFrame& frame, const PlaneSection& section, const Point3& normal,
    const std::string& name, CurveType type)
  {
    if (section.length < minLength * frame.size || grazes(*frame.mesh, section, normal))
    {
      return;
    }
    SuggestedCurve line;
    line.curve.name = name;
    line.curve.type = type;
    line.curve.keyShape = type == CurveType::Key ? KeyShape::Straight : KeyShape::Surface;
    line.curve.points = positionsOf(section.path.points);
    line.length = section.length;
    this->Lines.push_back(std::move(line));
  }

  /// Curves of a section that go from edge to edge, the longest first.
  static std::vector<PlaneSection> openSections(const TriangleMesh& mesh, const Plane& plane)
  {
    std::vector<PlaneSection> open;
    for (PlaneSection& section : planeSections(mesh, plane.point, plane.normal))
    {
      if (!section.closed)
      {
        open.push_back(std::move(section));
      }
    }
    std::stable_sort(open.begin(), open.end(),
      [](const PlaneSection& a, const PlaneSection& b) { return a.length > b.length; });
    return open;
  }

  void drawUprights()
  {
    for (const PieceFrame& frame : this->Frames)
    {
      const std::vector<PlaneSection> open = openSections(*frame.mesh, frame.upright);
      if (!frame.hasKey && !open.empty())
      {
        this->add(frame, open[0], frame.upright.normal,
          frame.mirrored ? "centre line" : "grain line", CurveType::Key);
      }
    }
  }

  void drawGirths()
  {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Point3& p : this->Surface.points())
    {
      low = std::min(low, this->Axis.dot(p));
      high = std::max(high, this->Axis.dot(p));
    }
    std::vector<Plane> planes;
    std::vector<double> lengths;
    std::vector<double> shorter;
    for (int k = 0; k < levels; ++k)
    {
      const double height = low + (high - low) * (k + 0.5) / levels;
      planes.push_back(
        { this->Center + (height - this->Axis.dot(this->Center)) * this->Axis, this->Axis });
      lengths.push_back(0.0);
      for (const PlaneSection& section :
        planeSections(this->Surface, planes.back().point, this->Axis))
      {
        lengths.back() += section.length;
      }
      shorter.push_back(-lengths.back());
    }
    const double least = minProminence * *std::max_element(lengths.begin(), lengths.end());
    std::vector<std::pair<double, std::size_t>> found;
    for (std::size_t k = endLevels; k < levels - endLevels; ++k)
    {
      const double stands = std::max(prominence(lengths, k), prominence(shorter, k));
      // Of equal neighbours the first.
      if (stands > least && lengths[k] != lengths[k - 1])
      {
        found.emplace_back(stands, k);
      }
    }
    std::stable_sort(
      found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    found.resize(std::min(found.size(), maxGirths));
    for (const auto& [stands, k] : found)
    {
      for (const PieceFrame& frame : this->Frames)
      {
        for (const PlaneSection& section :
          planeSections(*frame.mesh, planes[k].point, planes[k].normal))
        {
          this->add(frame, section, this->Axis, "girth", CurveType::Accessory);
        }
      }
    }
  }

  void drawStyleLines()
  {
    for (const PieceFrame& frame : this->Frames)
    {
      const TriangleMesh& mesh = *frame.mesh;
      if (mesh.boundaryLoops().empty())
      {
        continue;
      }
      const ScaleFactor scale(mesh, {}, this->Run);
      const std::vector<double>& u = scale.values();
      if (!scale.ok() || u.empty())
      {
        continue;
      }
      const auto aside = [&](Index v) {
        return frame.upright.normal.dot(mesh.point(v) - frame.upright.point);
      };
      Index top = none;
      for (Index v = 0; v < mesh.vertexCount(); ++v)
      {
        if (std::abs(aside(v)) > minAside * frame.size && std::abs(u[v]) > minScale &&
          (top == none || std::abs(u[v]) > std::abs(u[top])))
        {
          top = v;
        }
      }
      for (const double side : { 1.0, -1.0 })
      {
        if (top != none && (side > 0.0 || frame.mirrored))
        {
          const Plane plane{ frame.upright.point + side * aside(top) * frame.upright.normal,
            frame.upright.normal };
          const std::vector<PlaneSection> open = openSections(mesh, plane);
          if (!open.empty())
          {
            this->add(frame, open[0], plane.normal, "style line", CurveType::Accessory);
          }
        }
      }
    }
  }

  const TriangleMesh& Surface;
  std::vector<Piece> Pieces;
  const Execution& Run;
  Point3 Center = Point3::Zero();
  Point3 Axis = Point3::UnitZ();
  std::vector<PieceFrame> Frames;
  std::vector<SuggestedCurve> Lines;
};

/// An accessory curve may raise the rigid energy by this share.
constexpr double littleCost = 0.05;
/// Mean squared distances from a rotation below this are rounding.
constexpr double flatEnergy = 1e-12;

/// Numbers lines of each kind, beside the names that there are.
void numberLines(const std::vector<Polyline>& curves, std::vector<SuggestedCurve>& lines)
{
  std::map<std::string, int> numbers;
  for (SuggestedCurve& line : lines)
  {
    const std::string kind = line.curve.name;
    do
    {
      line.curve.name = kind + " " + std::to_string(++numbers[kind]);
    } while (std::any_of(curves.begin(), curves.end(),
      [&](const Polyline& curve) { return curve.name == line.curve.name; }));
  }
}

CurveSuggestions proposed(const TriangleMesh& mesh, const std::vector<Polyline>& curves,
  const SuggestionOptions& options, const Execution& execution)
{
  CurveSuggestions result;
  const double area = mesh.area();
  // With the lines proposed so far and perhaps one more.
  const auto tried = [&](const std::vector<Polyline>& more) {
    ++result.trials;
    TrialBudget unlimited(std::numeric_limits<double>::infinity());
    return CutTrials(mesh, withLines(withLines(curves, linesOf(result.curves)), more),
      options.imprint, options.flattening)
      .run({}, unlimited, execution);
  };
  const ImprintedSurface surface = imprintCurves(mesh, curves, options.imprint);
  result.status = surface.status;
  if (!surface.status.ok())
  {
    return result;
  }
  TrialOutcome now = tried({});
  result.strainBefore = now.valueOrNaN(now.strainP95);
  result.rigidEnergyBefore = now.valueOrNaN(now.energy / area);
  std::vector<SuggestedCurve> lines;
  if (now.valid)
  {
    const CutSurface cut = cutSurface(surface.mesh, surface.curves);
    lines = Drawing(cut, surface.curves, options.search.symmetric != "off", execution).run();
    numberLines(curves, lines);
  }
  for (std::size_t k = 0; k < lines.size() && !execution.cancelled(); ++k)
  {
    SuggestedCurve& line = lines[k];
    TrialOutcome after = tried({ line.curve });
    line.strainBefore = now.strainP95;
    line.strainAfter = after.valueOrNaN(after.strainP95);
    line.areaErrorBefore = now.areaError;
    line.areaErrorAfter = after.valueOrNaN(after.areaError);
    line.gain = (now.energy - after.valueOrNaN(after.energy)) / area;
    const bool cheap = line.curve.type == CurveType::Key ||
      after.energy <= (1.0 + littleCost) * now.energy + flatEnergy * area;
    const bool sound = after.soundAfter(now);
    if (sound && cheap)
    {
      now = std::move(after);
    }
    else
    {
      line.sound = sound;
    }
    (sound && cheap ? result.curves : result.leftOut).push_back(std::move(line));
    execution.report(
      static_cast<double>(k + 1) / static_cast<double>(lines.size()), "Trying lines");
  }
  if (execution.cancelled())
  {
    CurveSuggestions cancelled;
    cancelled.status = { StatusCode::Cancelled, "cancelled while trying lines" };
    return cancelled;
  }
  result.strainAfter = now.valueOrNaN(now.strainP95);
  result.rigidEnergyAfter = now.valueOrNaN(now.energy / area);
  result.boundMet = now.valid && now.strainP95 <= options.search.bound;
  return result;
}
}

CurveSuggestions suggestLines(const TriangleMesh& mesh, const std::vector<Polyline>& curves,
  const SuggestionOptions& options, const Execution& execution)
{
  CurveSuggestions refused;
  refused.status = checkSuggestion(options, mesh.triangleCount(), curves);
  if (!refused.status.ok())
  {
    return refused;
  }
  return withinMemory([&] { return proposed(mesh, curves, options, execution); });
}
}
