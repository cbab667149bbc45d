// SPDX-License-Identifier: BSD-3-Clause
#include "Fairing/FairNotes.h"

#include "Outlines/PatternText.h"

#include <algorithm>

namespace flattening
{
namespace pattern
{
namespace
{
constexpr double seenMiss = 1e-3; ///< of curves from their mirror images, millimetres

void addMirrorNotes(const FairPieceReport& report, PatternPiece& piece)
{
  const std::string of = "piece " + piece.name + ": ";
  if (!report.whyNotMirrored.empty())
  {
    piece.notes.push_back(
      { of + "its outline is not drawn as its own mirror image: " + report.whyNotMirrored,
        NoteKind::NotMirrored });
  }
  if (report.mirror)
  {
    const double below = std::max(report.mirrorMiss, 1e-6);
    std::string note = of + "its outline is drawn as its own mirror image, to " +
      formatNumber(below, 6) + " mm; its flat points miss that by " +
      formatNumber(report.mirror->miss, 3) + " mm";
    if (report.lengthDifference > noticedLength)
    {
      note +=
        ", and its sides differ by " + formatNumber(report.lengthDifference, 4) + " mm in length";
    }
    piece.notes.push_back({ note, NoteKind::Mirrored });
    if (report.inner.curves > 0)
    {
      const bool one = report.inner.curves == 1;
      const bool alike = report.inner.miss < seenMiss;
      const std::string lines =
        std::to_string(report.inner.curves) + (one ? " line" : " lines") + " of curves and holes ";
      piece.notes.push_back({ of + lines + "within it " +
          (alike ? std::string(one ? "is" : "are") + " drawn as mirror images as well, to " +
                formatNumber(seenMiss, 3) + " mm"
                 : (one ? "misses its" : "miss their") + std::string(" mirror image by up to ") +
                formatNumber(report.inner.miss, 3) + " mm (" + report.inner.worst + ")"),
        NoteKind::Mirrored });
    }
  }
  if (report.lengthChange > noticedLength)
  {
    piece.notes.push_back({ of + "stretches of its borders and curves are up to " +
        formatNumber(report.lengthChange, 4) +
        " mm longer or shorter than on the surface, so that those that are mirror images, and what "
        "is sewn to them, are equally long",
      NoteKind::Mirrored });
  }
}
}

void addFairNotes(const FairPieceReport& report, PatternPiece& piece)
{
  const std::string of = "piece " + piece.name + ": ";
  addMirrorNotes(report, piece);
  if (!report.solved)
  {
    piece.notes.push_back(
      { of + "no smooth borders of these lengths were found; they are drawn as the mesh has them",
        NoteKind::NotSmoothed });
    return;
  }
  std::string note = of + std::to_string(report.splines) + " curves and " +
    std::to_string(report.segments) + " straight lines in place of " +
    std::to_string(report.edges) + " edges, at most " + formatNumber(report.deviation, 3) +
    " mm from their points";
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
  piece.notes.push_back({ note, report.share == 0.0 ? NoteKind::NotSmoothed : NoteKind::Smoothed });
  if (!report.left.empty())
  {
    std::string names;
    for (const std::string& name : report.left)
    {
      names += (names.empty() ? "" : ", ") + name;
    }
    piece.notes.push_back({ of + "not smooth within " + formatNumber(report.wantedOfWorst, 3) +
        " mm, but " + formatNumber(report.worstLeft, 2) +
        " mm off, and so left as the mesh has them, are corners or stretches of " + names,
      NoteKind::LeftRough });
  }
}
}
}
