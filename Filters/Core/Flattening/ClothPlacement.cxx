// SPDX-License-Identifier: BSD-3-Clause
#include "Flattening/ClothPlacement.h"

#include "Base/Types.h"
#include "Cloth/ClothEnergy.h"
#include "Flattening/PieceArrangement.h"
#include "Flattening/PieceWires.h"
#include "Quality/FlatteningQuality.h"
#include "Surface/VertexFan.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flattening
{
namespace
{
/// Of what is beyond a limit over the stiffer thread. More takes back little more of what exact
/// lengths force, and takes Newton's method longer.
constexpr double limitStiffness = 10.0;
/// Of wires, as a fraction. Rough starts miss them by less than they end with where slivers break.
constexpr double brokenLength = 1e-6;
/// Angles of a free grain that are tried, over the half turn after which they repeat.
constexpr int triedAngles = 8;
const char* const alreadySo = " without the material already, which no cloth can follow";
/// Angles of a sheet that is only turned.
constexpr int measuredAngles = 180;

/// The vertices of a curve in the piece in the order of the curve, the first copy of each; none
/// where less than an edge of it lies there, or it ends where it starts.
Indices lineInPiece(const PieceContext& context, Index curve)
{
  const Piece& piece = context.piece;
  const FeatureCurve& feature = context.curves[curve];
  Indices placeOf(context.cut.originalVertexCount, none);
  for (std::size_t k = feature.vertices.size(); k > 0; --k)
  {
    placeOf[feature.vertices[k - 1]] = static_cast<Index>(k - 1);
  }
  Indices vertexAt(feature.vertices.size(), none);
  for (Index h = 0; h < piece.mesh.halfedgeCount(); ++h)
  {
    if (piece.curveOfHalfedge[h] != curve)
    {
      continue;
    }
    for (const Index v : { piece.mesh.from(h), piece.mesh.to(h) })
    {
      const Index place = placeOf[context.cut.originalVertex[piece.vertices[v]]];
      if (place != none && vertexAt[place] == none)
      {
        vertexAt[place] = v;
      }
    }
  }
  eraseIf(vertexAt, [](Index v) { return v == none; });
  return vertexAt.size() < 2 || feature.closed() ? Indices() : vertexAt;
}

double withinTurn(double angle)
{
  return angle - 2.0 * pi * std::ceil(angle / (2.0 * pi) - 0.5);
}

std::vector<double> sharesOfArea(const TriangleMesh& mesh)
{
  std::vector<double> share =
    vertexAreas(mesh.triangles(), mesh.vertexCount(), [&mesh](Index t) { return mesh.area(t); });
  const double sum = mesh.area();
  for (double& s : share)
  {
    s /= sum;
  }
  return share;
}

Point2 middleOf(const Points2& positions, const std::vector<double>& share)
{
  // From the first point, which keeps the digits of pieces far from the origin.
  Point2 sum = Point2::Zero();
  for (std::size_t v = 0; v < positions.size(); ++v)
  {
    sum += share[v] * (positions[v] - positions.front());
  }
  return positions.front() + sum;
}

/// The rotation from one shape to another that fits it best.
double rotationBetween(const Points2& from, const Points2& to, const std::vector<double>& share)
{
  const Point2 middleFrom = middleOf(from, share);
  const Point2 middleTo = middleOf(to, share);
  double sine = 0.0;
  double cosine = 0.0;
  for (std::size_t v = 0; v < from.size(); ++v)
  {
    const Point2 a = from[v] - middleFrom;
    const Point2 b = to[v] - middleTo;
    sine += share[v] * cross(a, b);
    cosine += share[v] * a.dot(b);
  }
  return std::atan2(sine, cosine);
}

/// What the grain of a piece is measured from, in every shape that the piece takes in the plane:
/// the line from the start of one of its curves to its end, or the upright of the piece as it lies
/// without a material, turned with it by the rotation that fits it best.
class GrainReference
{
public:
  /// By the curve of the options that lies in the piece, or by the upright: its first key curve,
  /// else the long side of the smallest rectangle around it. \param positions without a material.
  GrainReference(const PieceContext& context, const Points2& positions)
  {
    const ClothOptions& cloth = *context.options.cloth;
    const auto count = static_cast<Index>(context.curves.size());
    for (std::size_t k = 0; k < cloth.grainCurves.size() && this->Curve == none; ++k)
    {
      for (Index c = 0; c < count && this->Curve == none; ++c)
      {
        if (context.curves[c].name == cloth.grainCurves[k])
        {
          this->takeCurve(context, c);
          this->Asked = cloth.grainAngles[k];
        }
      }
    }
    this->Missing = this->Curve == none && cloth.grain == GrainKind::Curve;
    if (this->Curve == none)
    {
      this->Asked = cloth.grainAngle;
    }
    for (Index c = 0; c < count && this->Curve == none; ++c)
    {
      if (context.curves[c].type == CurveType::Key)
      {
        this->takeCurve(context, c);
      }
    }
    if (this->Curve == none)
    {
      this->Plain = positions;
      this->Share = sharesOfArea(context.piece.mesh);
      ArrangementPiece piece;
      piece.positions = positions;
      this->Upright =
        0.5 * pi - rotationBetween(positions, arrangePieces({ piece }, 0.0).front(), this->Share);
    }
  }

  /// The angle of the grain that the options ask for.
  double asked() const { return this->Asked; }

  /// From the reference to the warp, which lies along y, counter-clockwise, in (-pi, pi].
  double angle(const Points2& positions) const
  {
    return withinTurn(0.5 * pi - this->direction(positions));
  }

  GrainReport report(const PieceContext& context, const Points2& positions) const
  {
    GrainReport report{ this->angle(positions), this->Curve, this->bend(positions), this->Missing,
      {} };
    const auto count = static_cast<Index>(this->Missing ? context.curves.size() : 0);
    for (Index c = 0; c < count; ++c)
    {
      if (!lineInPiece(context, c).empty())
      {
        report.candidates.push_back(c);
      }
    }
    return report;
  }

  /// The piece turned around its first vertex so that the grain has the angle.
  Points2 turned(double angle, const Points2& positions) const
  {
    const double turn = this->angle(positions) - angle;
    return turnedAroundFirst(positions, std::cos(turn), std::sin(turn));
  }

  /// Keeps the angle of the grain that the piece has: of a curve the direction of its line, of the
  /// upright that of the piece as a whole, which no vertex feels more than others.
  GrainHold hold(const Points2& positions) const
  {
    GrainHold hold;
    if (this->Curve != none)
    {
      const Point2 line =
        (positions[this->Line.back()] - positions[this->Line.front()]).normalized();
      const Point2 across(-line.y(), line.x());
      hold.weights = { { this->Line.front(), -across }, { this->Line.back(), across } };
      return hold;
    }
    // No turn from here: sum share (p - middle) x (x - middle) = 0.
    const Point2 middle = middleOf(positions, this->Share);
    double spread = 0.0;
    for (std::size_t v = 0; v < positions.size(); ++v)
    {
      const Point2 d = positions[v] - middle;
      spread += this->Share[v] * d.squaredNorm();
      hold.weights.push_back({ static_cast<Index>(v), this->Share[v] * Point2(-d.y(), d.x()) });
    }
    for (GrainHold::Weight& part : hold.weights)
    {
      part.weight /= std::sqrt(spread);
    }
    return hold;
  }

private:
  void takeCurve(const PieceContext& context, Index curve)
  {
    this->Line = lineInPiece(context, curve);
    this->Curve = this->Line.empty() ? none : curve;
  }

  double direction(const Points2& positions) const
  {
    if (this->Curve == none)
    {
      return this->Upright + rotationBetween(this->Plain, positions, this->Share);
    }
    const Point2 line = positions[this->Line.back()] - positions[this->Line.front()];
    return std::atan2(line.y(), line.x());
  }

  double bend(const Points2& positions) const
  {
    if (this->Line.empty())
    {
      return 0.0;
    }
    Points2 line;
    double length = 0.0;
    for (const Index v : this->Line)
    {
      length += line.empty() ? 0.0 : (positions[v] - line.back()).norm();
      line.push_back(positions[v]);
    }
    return length > 0.0 ? farthestFromChord(line) / length : 0.0;
  }

  Indices Line; ///< the curve's vertices in the piece, in its order; two at least, or none
  Index Curve = none;
  bool Missing = false;
  double Asked = 0.0;
  Points2 Plain;             ///< where the upright was taken
  double Upright = 0.0;      ///< direction there
  std::vector<double> Share; ///< of each vertex in the area
};

/// A piece with the material on it as it lies without, where the material takes it nowhere better.
void layAsItIs(const PieceContext& context, const GrainReference& grain, const std::string& why,
  Remedy remedy, PieceSolution& piece)
{
  const bool free = context.options.cloth->grain == GrainKind::Free;
  piece.positions = grain.turned(free ? 0.0 : grain.asked(), piece.positions);
  noteStatus(
    { StatusCode::NotConverged, why + "; it was laid on the piece as that is", {}, { remedy } },
    piece.placement);
}

/// The cloth's least energy with the grain at an angle.
IsometricSolution solveAt(const PieceContext& context, const GrainReference& grain, double angle,
  bool rough, const PieceSolution& piece, const Points2& positions,
  const std::vector<double>& stretch)
{
  const Points2 start = grain.turned(angle, positions);
  IsometricOptions options = context.options.isometric;
  options.cloth = ClothSheet{ context.options.cloth->material, limitStiffness, grain.hold(start) };
  options.rough = rough;
  return warpIsometrically(
    context.piece, piece.problem, start, stretch, options, context.execution.part(1.0, 1.0));
}

/// As the last, with the iterations of the first before its own.
IsometricSolution joinedHistory(const IsometricSolution& first, IsometricSolution last)
{
  last.history.insert(last.history.begin(), first.history.begin(), first.history.end());
  last.iterations += first.iterations;
  return last;
}

/// Where the parabola through a least value and its neighbours is least, in steps from it.
double vertexOfParabola(const std::vector<double>& values, int least)
{
  const auto at = [&](int k) {
    const auto count = static_cast<int>(values.size());
    return values[static_cast<std::size_t>((k + count) % count)];
  };
  const double bend = at(least - 1) - 2.0 * at(least) + at(least + 1);
  return bend > 0.0 ? 0.5 * (at(least - 1) - at(least + 1)) / bend : 0.0;
}

/// The same at the angle at which it is least.
IsometricSolution solveFree(
  const PieceContext& context, const GrainReference& grain, const PieceSolution& piece)
{
  std::vector<double> energy;
  IsometricSolution best;
  int chosen = 0;
  for (int k = 0; k < triedAngles; ++k)
  {
    IsometricSolution tried = solveAt(
      context, grain, pi * k / triedAngles, true, piece, piece.positions, piece.isometric->stretch);
    if (tried.status.refused())
    {
      return tried;
    }
    energy.push_back(tried.distortionEnergy);
    if (k == 0 || energy.back() < energy[static_cast<std::size_t>(chosen)])
    {
      chosen = k;
      best = std::move(tried);
    }
  }
  const double angle = pi * (chosen + vertexOfParabola(energy, chosen)) / triedAngles;
  return joinedHistory(
    best, solveAt(context, grain, angle, false, piece, best.positions, best.stretch));
}

/// Of a sheet that is only turned.
double leastStrainedAngle(
  const PieceContext& context, const GrainReference& grain, const Points2& positions)
{
  double least = std::numeric_limits<double>::infinity();
  double chosen = 0.0;
  TriangleFrames frames;
  const TriangleMesh& mesh = context.piece.mesh;
  for (const Triangle& c : mesh.triangles())
  {
    frames.emplace_back(mesh.points(), c);
  }
  for (int k = 0; k < measuredAngles; ++k)
  {
    const double angle = pi * k / measuredAngles;
    const ClothSummary threads = summarizeThreads(frames,
      measureThreads(frames, mesh.triangles(), grain.turned(angle, positions)),
      context.options.cloth->material);
    const double strain = std::hypot(threads.warpRms, threads.weftRms);
    if (strain < least)
    {
      least = strain;
      chosen = angle;
    }
  }
  return chosen;
}

/// Takes over the cloth's solution where it is one.
void takeSolution(const PieceContext& context, const GrainReference& grain,
  IsometricSolution solution, PieceSolution& piece)
{
  IsometricSolution& before = *piece.isometric;
  if (solution.status.refused())
  {
    piece.placement = solution.status;
    return;
  }
  if (!std::isfinite(solution.distortionEnergy))
  {
    layAsItIs(context, grain, std::string("triangles are pressed to nothing") + alreadySo,
      Remedy::AddDarts, piece);
    return;
  }
  const auto errorOf = [&](const Points2& positions, const std::vector<double>& stretch) {
    return largestLengthError(
      piece.problem, stretchedLengths(piece.problem, stretch), positions, false);
  };
  const double error = errorOf(solution.positions, solution.stretch);
  if (!(error <= brokenLength) && !(error <= errorOf(piece.positions, before.stretch)))
  {
    layAsItIs(context, grain, "on the material its wires would miss their lengths between slivers",
      Remedy::MendSlivers, piece);
    return;
  }
  before = joinedHistory(before, std::move(solution));
  piece.positions = before.positions;
  piece.report.energyUsed = context.options.isometric.energy.kind;
  piece.clothSolved = true;
  if (piece.placement.code == StatusCode::NotConverged)
  {
    piece.placement = {}; // of what was only the start
  }
  noteStatus(before.status, piece.placement);
}
}

void layOnCloth(const PieceContext& context, PieceSolution& piece)
{
  if (!context.options.cloth || piece.placement.refused() || piece.positions.empty())
  {
    return;
  }
  const GrainReference grain(context, piece.positions);
  const bool free = context.options.cloth->grain == GrainKind::Free;
  if (!piece.isometric || context.options.cloth->material.isotropic)
  {
    const double angle = free ? leastStrainedAngle(context, grain, piece.positions) : grain.asked();
    piece.positions = grain.turned(angle, piece.positions);
  }
  else if (countFlipped(context.piece.mesh, piece.positions) > 0)
  {
    layAsItIs(context, grain, std::string("triangles are turned over") + alreadySo,
      Remedy::AddDarts, piece);
  }
  else
  {
    takeSolution(context, grain,
      free ? solveFree(context, grain, piece)
           : solveAt(context, grain, grain.asked(), false, piece, piece.positions,
               piece.isometric->stretch),
      piece);
  }
  piece.grain = grain.report(context, piece.positions);
}
}
