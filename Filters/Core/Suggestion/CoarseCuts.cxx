// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestion/CoarseCuts.h"

#include "Imprint/CurveImprint.h"
#include "Suggestion/CutThinning.h"
#include "Suggestion/CutTrials.h"
#include "Suggestion/SeamDrawing.h"
#include "Suggestion/SurfaceCoarsening.h"

#include <algorithm>

namespace flattening
{
namespace
{
/// Those left where cuts that cannot be laid into the surface are taken out, with their images:
/// what crosses itself, and otherwise the shortest of those that meet.
std::vector<SuggestedCurve> possible(
  const TriangleMesh& mesh, std::vector<SuggestedCurve> cuts, const FlatteningOptions& flattening)
{
  const CutTrials trials(mesh, {}, {}, flattening);
  while (!cuts.empty() && trials.paths(linesOf(cuts)).empty())
  {
    std::vector<Indices> bad = failingLines(imprintCurves(mesh, linesOf(cuts), {}), cuts.size());
    const auto alone = [](const Indices& set) { return set.front() == set.back(); };
    const bool all = bad.size() == cuts.size() || std::none_of(bad.begin(), bad.end(), alone);
    std::vector<char> out(cuts.size(), 0);
    for (const Indices& set : bad)
    {
      out[*std::min_element(set.begin(), set.end(),
        [&](Index a, Index b) { return cuts[a].length < cuts[b].length; })] |= all || alone(set);
    }
    if (bad.empty() || bad.size() == cuts.size())
    {
      return {};
    }
    std::vector<SuggestedCurve> left;
    Indices place(cuts.size(), none);
    for (std::size_t k = 0; k < cuts.size(); ++k)
    {
      const Index first = cuts[k].mirrorOf;
      const bool image = k + 1 < cuts.size() && cuts[k + 1].mirrorOf == static_cast<Index>(k);
      if (out[k] || (image && out[k + 1]) || (first != none && place[first] == none))
      {
        continue;
      }
      place[k] = static_cast<Index>(left.size());
      left.push_back(std::move(cuts[k]));
      left.back().mirrorOf = first == none ? none : place[first];
    }
    cuts = std::move(left);
  }
  return cuts;
}
}

TriangleMesh fewTriangles(const TriangleMesh& mesh, Index most)
{
  std::vector<char> kept(mesh.vertexCount(), 0);
  const std::vector<char> creases = creasesOf(mesh, creaseCosine);
  for (Index h = 0; h < mesh.halfedgeCount(); ++h)
  {
    kept[mesh.from(h)] = kept[mesh.from(h)] || creases[h] ? 1 : 0;
  }
  return coarsened(mesh, std::move(kept), most).mesh;
}

std::vector<SuggestedCurve> movedCuts(const TriangleMesh& mesh,
  std::optional<SurfaceMirror>& mirror, std::vector<SuggestedCurve> cuts,
  const FlatteningOptions& flattening)
{
  if (mirror && mirror->plane())
  {
    mirror = SurfaceMirror(measuredPlane(mesh, *mirror->plane()));
  }
  const SeamDrawing drawing(mesh);
  const bool exact = mirror && mirror->plane() && mirror->error <= SurfaceMirror::exact;
  for (SuggestedCurve& cut : cuts)
  {
    Points3& points = cut.curve.points;
    if (exact && cut.mirrorOf != none)
    {
      points = mirror->mirrored(cuts[cut.mirrorOf].curve.points);
      continue;
    }
    points = drawing.draw(drawing.place(points), SeamDrawing::levels - 1);
    cut.length = lengthOf(points);
  }
  return possible(mesh, std::move(cuts), flattening);
}
}
