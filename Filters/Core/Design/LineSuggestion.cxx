// SPDX-License-Identifier: BSD-3-Clause
#include "Design/LineSuggestion.h"

#include "Base/Memory.h"
#include "Design/DesignLines.h"
#include "Imprint/CurveImprint.h"
#include "Suggestion/CutTrials.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace flattening
{
namespace
{
/// An accessory curve may raise the rigid energy by this share.
constexpr double littleCost = 0.05;
/// Mean squared distances from a rotation below this are rounding.
constexpr double flatEnergy = 1e-12;

class Proposing
{
public:
  Proposing(const TriangleMesh& mesh, const std::vector<Polyline>& curves,
    const SuggestionOptions& options, const Execution& execution)
    : Mesh(mesh)
    , Curves(curves)
    , Options(options)
    , Run(execution)
  {
    for (Index t = 0; t < mesh.triangleCount(); ++t)
    {
      this->Area += mesh.area(t);
    }
  }

  CurveSuggestions run()
  {
    const ImprintedSurface surface = imprintCurves(this->Mesh, this->Curves, this->Options.imprint);
    this->Result.status = surface.status;
    if (!surface.status.ok())
    {
      return std::move(this->Result);
    }
    TrialOutcome now = this->tried();
    this->Result.strainBefore = now.known(now.strainP95);
    this->Result.rigidEnergyBefore = now.known(now.energy / this->Area);
    if (now.valid)
    {
      const CutSurface cut = cutSurface(surface.mesh, surface.curves);
      std::vector<SuggestedCurve> lines =
        designLines(cut, surface.curves, this->Options.search.symmetric != "off", this->Run);
      this->name(lines);
      for (std::size_t k = 0; k < lines.size() && !this->Run.cancelled(); ++k)
      {
        this->propose(std::move(lines[k]), now);
        this->Run.report(
          static_cast<double>(k + 1) / static_cast<double>(lines.size()), "Trying lines");
      }
    }
    if (this->Run.cancelled())
    {
      CurveSuggestions cancelled;
      cancelled.status = { StatusCode::Cancelled, "cancelled while trying lines" };
      return cancelled;
    }
    this->Result.strainAfter = now.known(now.strainP95);
    this->Result.rigidEnergyAfter = now.known(now.energy / this->Area);
    this->Result.boundMet = now.valid && now.strainP95 <= this->Options.search.bound;
    return std::move(this->Result);
  }

private:
  /// The surface with its curves, those proposed and perhaps one more.
  TrialOutcome tried(const SuggestedCurve* more = nullptr)
  {
    std::vector<Polyline> all = this->Curves;
    for (const SuggestedCurve& line : this->Result.curves)
    {
      all.push_back(line.curve);
    }
    if (more)
    {
      all.push_back(more->curve);
    }
    ++this->Result.trials;
    TrialBudget unlimited(std::numeric_limits<double>::infinity());
    return CutTrials(this->Mesh, std::move(all), this->Options.imprint, this->Options.flattening)
      .run({}, unlimited, this->Run);
  }

  void propose(SuggestedCurve line, TrialOutcome& now)
  {
    TrialOutcome after = this->tried(&line);
    line.strainBefore = now.strainP95;
    line.strainAfter = after.known(after.strainP95);
    line.areaErrorBefore = now.areaError;
    line.areaErrorAfter = after.known(after.areaError);
    line.gain = (now.energy - after.known(after.energy)) / this->Area;
    const bool cheap = line.curve.type == CurveType::Key ||
      after.energy <= (1.0 + littleCost) * now.energy + flatEnergy * this->Area;
    if (after.soundAfter(now) && cheap)
    {
      now = std::move(after);
      this->Result.curves.push_back(std::move(line));
    }
    else
    {
      line.sound = after.soundAfter(now);
      this->Result.leftOut.push_back(std::move(line));
    }
  }

  /// Numbers lines of each kind, beside the names that there are.
  void name(std::vector<SuggestedCurve>& lines) const
  {
    std::map<std::string, int> numbers;
    for (SuggestedCurve& line : lines)
    {
      const std::string kind = line.curve.name;
      do
      {
        line.curve.name = kind + " " + std::to_string(++numbers[kind]);
      } while (std::any_of(this->Curves.begin(), this->Curves.end(),
        [&](const Polyline& curve) { return curve.name == line.curve.name; }));
    }
  }

  const TriangleMesh& Mesh;
  const std::vector<Polyline>& Curves;
  const SuggestionOptions& Options;
  const Execution& Run;
  double Area = 0.0;
  CurveSuggestions Result;
};
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
  return withinMemory([&] { return Proposing(mesh, curves, options, execution).run(); });
}
}
