// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/FairBorders.h"

#include "Outlines/PatternText.h"
#include "Quality/StrainMeasures.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_set>

namespace flattening::pattern
{
namespace
{
/// Whether smooth borders of two sources are the same.
bool haveSameBorders(const DrawingSource& one, const DrawingSource& other)
{
  const auto settings = [](const DrawingSource& all) {
    return std::make_tuple(all.options.unit, all.options.fairToleranceOf(all.source),
      all.options.fairToleranceOfCurve, all.options.symmetrize);
  };
  const auto surface = [](const PatternSource& source) {
    return std::tie(source.positions, source.inSpace, source.triangles, source.pieceOfTriangle);
  };
  const auto sameLists = [](const auto& a, const auto& b, const auto& key) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
      [&key](const auto& x, const auto& y) { return key(x) == key(y); });
  };
  return settings(one) == settings(other) && surface(one.source) == surface(other.source) &&
    sameLists(one.source.wires, other.source.wires,
      [](const SourceWire& wire) {
        return std::tie(wire.points, wire.type, wire.curve, wire.piece, wire.name);
      }) &&
    sameLists(one.source.sewn, other.source.sewn,
      [](const SewnEdges& pair) { return std::tie(pair.a, pair.b, pair.closed); }) &&
    sameLists(one.notches, other.notches,
      [](const NotchPlace& notch) { return std::tie(notch.edge, notch.fraction, notch.isStop); });
}

/// What 95 % of the area of a piece is strained by at most: the largest |ln s| of the singular
/// values s of the maps from the surface's triangles to the plane. 0 where the points in space are
/// not known.
/// \param positions in the plane, millimetres
double strainQuantile(const DrawingSource& all, std::size_t piece, const Points2& positions)
{
  const PatternSource& source = all.source;
  std::vector<AreaValue> strains;
  const Triangles known = source.inSpace.empty() ? Triangles() : trianglesOf(source, piece);
  for (const Triangle& corners : known)
  {
    const auto onSurface = [&](std::size_t k) {
      return Point3(all.scale() * source.inSpace[corners[k]]);
    };
    const auto inPlane = [&](std::size_t k) {
      const Point2& p = positions[static_cast<std::size_t>(corners[k])];
      return Complex(p.x(), p.y());
    };
    const TriangleFrame frame(onSurface(0), onSurface(1), onSurface(2));
    if (!(frame.area > 0.0))
    {
      continue;
    }
    const std::array<Complex, 3> images{ inPlane(0), inPlane(1), inPlane(2) };
    const double alpha = std::abs(frame.alpha(images));
    const double beta = std::abs(frame.beta(images));
    const double least = std::max(std::abs(alpha - beta), 1e-300);
    strains.push_back(
      { std::max(std::abs(std::log(alpha + beta)), std::abs(std::log(least))), frame.area });
  }
  return areaQuantile(std::move(strains));
}

/// Where the points of a piece lie if those of its borders and curves are moved and the others
/// follow: their way is the mean of their neighbours' ways.
/// \param moved all points, of which those of borders and curves are where they are to be
Points2 followBorders(const DrawingSource& all, std::size_t piece, const Points2& moved)
{
  const PatternSource& source = all.source;
  std::unordered_set<Index> held;
  for (const Indices& loop : all.loops[piece])
  {
    held.insert(loop.begin(), loop.end());
  }
  for (const SourceWire& wire : source.wires)
  {
    held.insert(wire.points.begin(), wire.points.end());
  }
  std::unordered_map<Index, Eigen::Index> unknown;
  Indices free;
  const Triangles triangles = trianglesOf(source, piece);
  for (const Triangle& corners : triangles)
  {
    for (const Index v : corners)
    {
      if (held.count(v) == 0 && unknown.emplace(v, static_cast<Eigen::Index>(free.size())).second)
      {
        free.push_back(v);
      }
    }
  }
  Points2 result = moved;
  if (free.empty())
  {
    return result;
  }
  const auto count = static_cast<Eigen::Index>(free.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(count, 2);
  for (const Triangle& corners : triangles)
  {
    for (std::size_t k = 0; k < 6; ++k)
    {
      const Index neighbour = corners[(k + (k < 3 ? 1 : 2)) % 3];
      const auto own = unknown.find(corners[k % 3]);
      if (own == unknown.end())
      {
        continue;
      }
      entries.emplace_back(own->second, own->second, 1.0);
      const auto other = unknown.find(neighbour);
      if (other != unknown.end())
      {
        entries.emplace_back(own->second, other->second, -1.0);
        continue;
      }
      const Point2 way = moved[static_cast<std::size_t>(neighbour)] -
        all.scale() * source.positions[static_cast<std::size_t>(neighbour)];
      right.row(own->second) += way.transpose();
    }
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
  const Eigen::MatrixX2d ways = factor.solve(right);
  for (Eigen::Index k = 0; k < count; ++k)
  {
    const auto v = static_cast<std::size_t>(free[static_cast<std::size_t>(k)]);
    result[v] = all.scale() * source.positions[v] + Point2(ways.row(k).transpose());
  }
  return result;
}

constexpr double maximumIncrease = 0.003; ///< of strain
constexpr double leastShare = 0.1;
constexpr double lessShare = 0.8;     ///< of the share that was too much, at most
constexpr double leastMirrored = 0.5; ///< share for which a piece stays its own mirror image

/// The parts of a chain between two places, as they are met from the first to the second.
void addParts(
  const std::vector<FairSpan>& spans, double from, double to, std::vector<FairSpan>& parts)
{
  const double low = std::min(from, to);
  const double high = std::max(from, to);
  const double least = 1e-9 * std::max(spans.back().to, high - low);
  std::vector<FairSpan> found;
  for (const FairSpan& span : spans)
  {
    const double start = std::max(low, span.from);
    const double end = std::min(high, span.to);
    if (end - start > least)
    {
      found.push_back(from <= to ? partOf(span, start, end) : partOf(span, end, start));
    }
  }
  if (from > to)
  {
    std::reverse(found.begin(), found.end());
  }
  parts.insert(parts.end(), found.begin(), found.end());
}

/// How much longer or shorter a stretch is to be drawn than it is.
double lengthChange(const PlannedChain& chain, const PlannedStretch& stretch)
{
  double change = 0.0;
  for (std::size_t k = stretch.firstInterval; k < stretch.endInterval; ++k)
  {
    const PlannedInterval& interval = chain.intervals[k];
    change += interval.length - (interval.end - interval.start);
  }
  return std::abs(change);
}

void addMirrorNotes(const FairPieceReport& report, PatternPiece& piece)
{
  if (!report.whyNotMirrored.empty())
  {
    piece.addNote("its outline is not drawn as its own mirror image: " + report.whyNotMirrored,
      NoteKind::NotMirrored);
  }
  if (report.mirror)
  {
    const double below = std::max(report.mirrorMiss, 1e-6);
    std::string note = "its outline is drawn as its own mirror image, to " +
      formatNumber(below, 6) + " mm; its flat points miss that by " +
      formatNumber(report.mirror->miss, 3) + " mm";
    if (report.lengthDifference > noticedLength)
    {
      note +=
        ", and its sides differ by " + formatNumber(report.lengthDifference, 4) + " mm in length";
    }
    piece.addNote(note, NoteKind::Mirrored);
  }
  if (report.lengthChange > noticedLength)
  {
    piece.addNote("stretches of its borders and curves are up to " +
        formatNumber(report.lengthChange, 4) +
        " mm longer or shorter than on the surface, so that those that are mirror images, and what "
        "is sewn to them, are equally long",
      NoteKind::Mirrored);
  }
}
}

std::shared_ptr<const FairBorders> FairCache::of(const DrawingSource& all)
{
  if (!this->Borders || !haveSameBorders(*this->Last, all))
  {
    this->Borders = std::make_shared<const FairBorders>(all, this->Run);
    this->Last.emplace(all);
  }
  return this->Borders;
}

FairBorders::FairBorders(const DrawingSource& all, const Execution& execution)
  : Chains(all)
{
  const std::size_t pieces = all.loops.size();
  FairLimits limits{ std::vector<double>(pieces, 1.0),
    std::vector<bool>(pieces, all.options.symmetrize) };
  this->WhyNotMirrored.resize(pieces);
  FairFit fit;
  double done = 0.0; // each round is taken for half of what is left
  for (bool lowered = true; lowered; done = 0.5 * (1.0 + done))
  {
    fit = fitFairBorders(all, this->Chains, limits, fit, execution.part(done, 0.5 * (1.0 + done)));
    this->Plan = fit.plan;
    this->Spans = fit.spans;
    this->place(all);
    this->report(all, fit);
    for (std::size_t p = 0; p < pieces; ++p)
    {
      this->Reports[p].share = limits.shares[p];
    }
    lowered = this->lower(all, fit, limits);
  }
}

void FairBorders::dropMirror(std::size_t piece, const std::string& why, FairLimits& limits)
{
  limits.mirrored[piece] = false;
  limits.shares[piece] = 1.0;
  this->WhyNotMirrored[piece] = why;
}

bool FairBorders::lower(const DrawingSource& all, const FairFit& fit, FairLimits& limits)
{
  bool lowered = false;
  bool rough = false; // a stretch whose other side was to be of another length
  for (std::size_t c = 0; c < this->plan().size(); ++c)
  {
    for (const PlannedStretch& stretch : this->plan()[c].stretches)
    {
      const double length = stretch.breaks.back() - stretch.breaks.front();
      rough = rough ||
        (stretch.form == StretchForm::Raw && !fit.unmirrored[this->Chains.chains()[c].piece] &&
          lengthChange(this->plan()[c], stretch) > sameLength * length);
    }
  }
  for (std::size_t p = 0; p < limits.shares.size(); ++p)
  {
    const FairPieceReport& report = this->Reports[p];
    const std::optional<LeftStretch>& left = fit.unmirrored[p];
    const bool strained = report.strain - report.strainBefore > maximumIncrease;
    // As its own mirror image it is strained by less the nearer it is to its points.
    const bool nearer = limits.mirrored[p] && limits.shares[p] < 1.0;
    const bool far = strained && limits.shares[p] * lessShare < leastMirrored;
    if (nearer && (left || !report.mirror || far))
    {
      this->dropMirror(p, "it would strain the piece by over 0.3 % more", limits);
    }
    else if (left)
    {
      const BorderChain& chain = this->Chains.chains()[left->chain];
      this->dropMirror(p,
        left->needed > 0.0
          ? chain.nameOf(all, left->firstPoint) + " would be " + formatNumber(left->needed, 2) +
            " mm from its points, more than " + formatNumber(left->tolerance, 3) + " mm"
          : "no such curves of these lengths were found",
        limits);
    }
    else if (report.mirror && rough && report.lengthDifference > noticedLength)
    {
      this->dropMirror(p,
        "its sides differ by " + formatNumber(report.lengthDifference, 3) +
          " mm, and what stays as the mesh has it cannot be as long as their mean",
        limits);
    }
    else if (limits.shares[p] > 0.0 && strained)
    {
      if (!report.mirror)
      {
        limits.mirrored[p] = false;
        this->WhyNotMirrored[p] = report.whyNotMirrored;
      }
      // Strain grows about as the distance does.
      const double step =
        std::clamp(maximumIncrease / (report.strain - report.strainBefore), leastShare, lessShare);
      limits.shares[p] = limits.shares[p] > leastShare ? step * limits.shares[p] : 0.0;
    }
    else
    {
      continue;
    }
    lowered = true;
  }
  return lowered;
}

void FairBorders::place(const DrawingSource& all)
{
  this->Positions.clear();
  for (std::size_t v = 0; v < all.source.positions.size(); ++v)
  {
    this->Positions.push_back(all.at(static_cast<Index>(v)));
  }
  this->Places.clear();
  for (std::size_t c = 0; c < this->plan().size(); ++c)
  {
    const BorderChain& chain = this->Chains.chains()[c];
    std::vector<double>& places = this->Places.emplace_back();
    for (const double arc : chain.arc)
    {
      places.push_back(this->placeAt(c, arc));
    }
    for (std::size_t p = 0; p < chain.points.size(); ++p)
    {
      this->Positions[static_cast<std::size_t>(chain.points[p])] =
        spanAt(this->spans()[c], places[p]).at(places[p]);
    }
  }
}

double FairBorders::placeAt(std::size_t c, double length) const
{
  const std::vector<PlannedInterval>& intervals = this->plan()[c].intervals;
  const auto found = std::partition_point(intervals.begin(), intervals.end(),
    [length](const PlannedInterval& interval) { return interval.end < length; });
  if (found == intervals.end())
  {
    return this->Chains.chains()[c].length();
  }
  return IntervalCurve(this->spans()[c], found->places)
    .placeAt((length - found->start) / (found->end - found->start));
}

void FairBorders::report(const DrawingSource& all, const FairFit& fit)
{
  this->Reports.assign(all.loops.size(), {});
  const auto addLeft = [&](const BorderChain& chain, std::size_t point, double needed,
                         double tolerance) {
    FairPieceReport& report = this->Reports[chain.piece];
    report.wantedOfWorst = needed > report.worstLeft ? tolerance : report.wantedOfWorst;
    report.worstLeft = std::max(report.worstLeft, needed);
    report.left.push_back(chain.nameOf(all, point));
  };
  for (std::size_t c = 0; c < this->plan().size(); ++c)
  {
    const BorderChain& chain = this->Chains.chains()[c];
    FairPieceReport& report = this->Reports[chain.piece];
    report.edges += chain.edges();
    const std::size_t ends = chain.closed ? 0 : 1;
    for (std::size_t k = ends; k + ends < chain.points.size(); ++k)
    {
      if (chain.bends[k] > 0.0)
      {
        addLeft(
          chain, k, chain.bends[k], all.fairToleranceAlong(chain.point(k), chain.point(k + 1)));
      }
    }
    for (const PlannedStretch& stretch : this->plan()[c].stretches)
    {
      const double length = chain.arc[stretch.lastPoint] - chain.arc[stretch.firstPoint];
      report.splines += stretch.form == StretchForm::Spline ? stretch.spans() : 0;
      report.segments += stretch.form == StretchForm::Straight ? 1
        : stretch.form == StretchForm::Raw                     ? stretch.edges()
                                                               : 0;
      report.straightened +=
        stretch.form == StretchForm::Straight && stretch.bend > inexact * length ? 1 : 0;
      report.lengthChange = std::max(report.lengthChange, lengthChange(this->plan()[c], stretch));
    }
  }
  Points2 before;
  for (const Point2& p : all.source.positions)
  {
    before.emplace_back(all.scale() * p);
  }
  for (const LeftStretch& left : fit.left)
  {
    addLeft(this->Chains.chains()[left.chain], left.firstPoint, left.needed, left.tolerance);
  }
  for (std::size_t p = 0; p < this->Reports.size(); ++p)
  {
    FairPieceReport& report = this->Reports[p];
    report.solved = fit.solved[p];
    this->reportMirror(fit, p);
    report.deviation = fit.deviation[p];
    report.strainBefore = strainQuantile(all, p, before);
    report.strain = strainQuantile(all, p, followBorders(all, p, this->Positions));
    sortUnique(report.left);
  }
}

void FairBorders::reportMirror(const FairFit& fit, std::size_t piece)
{
  FairPieceReport& report = this->Reports[piece];
  const OutlineMirror& mirror = fit.mirrors[piece];
  report.whyNotMirrored = mirror.why.empty() ? this->WhyNotMirrored[piece] : mirror.why;
  if (mirror.found())
  {
    report.mirror = mirror.axis;
    report.lengthDifference = mirror.difference;
    report.mirrorMiss =
      missOfCurves(mirror, this->plan()[mirror.chain], this->spans()[mirror.chain]);
  }
}

std::vector<FairSpan> FairBorders::curveOf(const SourceWire& wire) const
{
  // Runs of edges that follow each other in one chain, so that its splines come whole.
  std::vector<FairSpan> parts;
  std::size_t chain = 0;
  double from = 0.0;
  double to = 0.0;
  for (std::size_t k = 0; k + 1 < wire.points.size(); ++k)
  {
    // All wires are in chains.
    const ChainEdge place = *this->Chains.find(wire.points[k], wire.points[k + 1]);
    const std::vector<double>& arc = this->Places[place.chain];
    const double start = arc[place.edge + (place.backwards ? 1 : 0)];
    const double end = arc[place.edge + (place.backwards ? 0 : 1)];
    const bool goesOn =
      place.chain == chain && start == to && (from == to || (from > to) == place.backwards);
    if (k > 0 && !goesOn)
    {
      addParts(this->spans()[chain], from, to, parts);
    }
    from = k > 0 && goesOn ? from : start;
    to = end;
    chain = place.chain;
  }
  if (wire.points.size() > 1)
  {
    addParts(this->spans()[chain], from, to, parts);
  }
  return parts;
}

std::vector<FairSpan> FairBorders::alongEdge(
  Index from, Index to, double fromFraction, double toFraction) const
{
  std::vector<FairSpan> parts;
  const std::optional<ChainEdge> place = this->Chains.find(from, to);
  if (!place)
  {
    return parts;
  }
  const BorderChain& chain = this->Chains.chains()[place->chain];
  const std::vector<double>& places = this->Places[place->chain];
  const auto at = [&](double given) {
    const double fraction = place->backwards ? 1.0 - given : given;
    return fraction == 0.0 ? places[place->edge]
      : fraction == 1.0    ? places[place->edge + 1]
                           : this->placeAt(place->chain, chain.arcWithin(place->edge, fraction));
  };
  addParts(this->spans()[place->chain], at(fromFraction), at(toFraction), parts);
  return parts;
}

void addDrawnEdge(const DrawingSource& all, Index from, Index to, Points2& points)
{
  const std::size_t before = points.size();
  if (all.fair)
  {
    for (const FairSpan& span : all.fair->alongEdge(from, to))
    {
      sampleSpan(span, sampleDistance, points);
    }
  }
  if (points.size() == before)
  {
    points.push_back(all.at(from));
  }
}

Points2 drawnLine(const DrawingSource& all, const Indices& points)
{
  Points2 line;
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
  {
    addDrawnEdge(all, points[k], points[k + 1], line);
  }
  line.push_back(all.at(points.back()));
  return line;
}

Point2 pointOnDrawnEdge(
  const DrawingSource& all, Index from, Index to, double fraction, Point2& outward)
{
  Point2 along = all.at(to) - all.at(from);
  Point2 place = all.at(from) + fraction * along;
  if (all.fair)
  {
    const std::vector<FairSpan> parts = all.fair->alongEdge(from, to, 0.0, fraction);
    const std::vector<FairSpan> whole = all.fair->alongEdge(from, to);
    if (!whole.empty())
    {
      const FairSpan& last = parts.empty() ? whole.front() : parts.back();
      const double at = parts.empty() ? last.from : last.to;
      place = last.at(at);
      // A part that runs back has its slope by descending length.
      along = (last.to > last.from ? 1.0 : -1.0) * last.slope(at);
    }
  }
  outward = Point2(along.y(), -along.x()).normalized();
  return place;
}

void addFairNotes(const FairPieceReport& report, PatternPiece& piece)
{
  addMirrorNotes(report, piece);
  if (!report.solved)
  {
    piece.addNote(
      "no smooth borders of these lengths were found; they are drawn as the mesh has them",
      NoteKind::NotSmoothed);
    return;
  }
  std::string note = std::to_string(report.splines) + " curves and " +
    std::to_string(report.segments) + " straight lines instead of " + std::to_string(report.edges) +
    " edges, at most " + formatNumber(report.deviation, 3) + " mm from their points";
  if (report.strainBefore > 0.0)
  {
    note += ", with 95 % of the area strained by no more than " +
      formatNumber(100.0 * report.strain, 2) + " % (" +
      formatNumber(100.0 * report.strainBefore, 2) + " % before)";
  }
  if (report.share == 0.0)
  {
    note += ": drawn as the mesh has them, since smooth ones would strain it by over 0.3 % more";
  }
  else if (report.share < 1.0)
  {
    note += "; kept within " + formatNumber(100.0 * report.share, 1) +
      " % of the tolerance, since more would strain it by over 0.3 % more";
  }
  if (report.straightened > 0)
  {
    note += "; " + std::to_string(report.straightened) + " nearly straight stretches made straight";
  }
  piece.addNote(note, report.share == 0.0 ? NoteKind::NotSmoothed : NoteKind::Smoothed);
  if (!report.left.empty())
  {
    piece.addNote("not smooth within " + formatNumber(report.wantedOfWorst, 3) + " mm, but " +
        formatNumber(report.worstLeft, 2) +
        " mm off, and so left as the mesh has them, are corners or stretches of " +
        listed(report.left),
      NoteKind::LeftRough);
  }
}
}
