// SPDX-License-Identifier: BSD-3-Clause
#include "Options/OptionStructures.h"
#include "Options/OptionTable.h"
#include "Options/OptionValues.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <variant>
#include <vector>

using namespace flattening;

namespace
{
constexpr OptionOwner owners[] = { OptionOwner::Warping, OptionOwner::Suggestion,
  OptionOwner::Reshaping, OptionOwner::Conformal, OptionOwner::Sewing };

/// What is said of flattening with these words given.
std::string idle(const std::vector<std::pair<std::string, OptionValue>>& given,
  OptionSpelling spelling = OptionSpelling::Command)
{
  OptionValues values(OptionOwner::Warping);
  for (const auto& [property, value] : given)
  {
    values.set(property, value);
    values.markGiven(property);
  }
  return describeIdleOption(values, spelling);
}
constexpr double global = static_cast<double>(Scheme::Global);
}

TEST(OptionTable, NamesAreUniqueInEachFilterAndHelpIsASentence)
{
  for (const OptionOwner owner : owners)
  {
    std::set<std::string> properties;
    std::set<std::string> spellings;
    for (const Option* const option : optionsOf(owner))
    {
      EXPECT_TRUE(properties.insert(option->property).second) << option->property;
      EXPECT_TRUE(spellings.insert(spelled(*option, OptionSpelling::Command)).second);
      EXPECT_EQ(option->help.back(), '.') << option->property;
      const bool turnsOff =
        option->type == OptionType::Flag && textOf(*option, option->byDefault) == "1";
      EXPECT_EQ(turnsOff, !option->helpOff.empty()) << option->property;
      EXPECT_EQ(option->type == OptionType::Word, !option->words.empty()) << option->property;
    }
  }
}

TEST(OptionTable, DefaultsAreValidAndEndsOfRangesToo)
{
  for (const Option& option : optionTable())
  {
    EXPECT_TRUE(isValid(option, option.byDefault)) << option.property;
    const bool bounded = option.type == OptionType::Integer || option.type == OptionType::Number;
    EXPECT_EQ(bounded || option.property == "Gravity", !rangeOf(option).empty()) << option.property;
    if (bounded)
    {
      EXPECT_EQ(isValid(option, option.minimum), !option.open) << option.property;
      EXPECT_FALSE(isValid(option, option.minimum - 1.0)) << option.property;
      EXPECT_TRUE(isValid(option, option.sliderMinimum)) << option.property;
      EXPECT_TRUE(isValid(option, option.sliderMaximum)) << option.property;
    }
  }
}

TEST(OptionTable, ConditionsNameOptionsAndTheirWords)
{
  for (const OptionOwner owner : owners)
  {
    for (const Option* const option : optionsOf(owner))
    {
      for (const OptionCondition& condition : option->conditions)
      {
        const bool conformal = owner == OptionOwner::Conformal; // a scheme of programs
        const Option* const other =
          findOption(conformal ? OptionOwner::Warping : owner, condition.property);
        ASSERT_NE(other, nullptr) << condition.property;
        for (const std::string& word : condition.words)
        {
          EXPECT_TRUE(other->type == OptionType::Text ||
            std::any_of(other->words.begin(), other->words.end(),
              [&word](const OptionWord& one) { return one.word == word; }))
            << word;
        }
      }
    }
  }
}

TEST(OptionTable, SetsTheMembersOfTheStructures)
{
  OptionStructures structures;
  const auto set = [&structures](
                     OptionOwner owner, const char* property, const OptionValue& value) {
    findOption(owner, property)->set(structures, value);
  };
  set(OptionOwner::Warping, "Spacing", 7.0);
  set(OptionOwner::Warping, "Scheme", global);
  set(OptionOwner::Warping, "Arrange", 0.0);
  set(OptionOwner::Suggestion, "MaximumCuts", 3.0);
  set(OptionOwner::Sewing, "Gravity", std::vector<double>{ 1.0, 2.0, 3.0 });
  EXPECT_EQ(structures.flattening.spacing, 7.0);
  EXPECT_EQ(structures.flattening.scheme, Scheme::Global);
  EXPECT_FALSE(structures.flattening.arrange);
  EXPECT_EQ(structures.search.maximumCuts, 3);
  EXPECT_EQ(structures.sewing.gravity, Point3(1.0, 2.0, 3.0));
  EXPECT_EQ(std::get<double>(findOption(OptionOwner::Warping, "Spacing")->byDefault),
    FlatteningOptions().spacing);
}

TEST(OptionTable, RangesAndValuesAsText)
{
  const auto range = [](const char* property) {
    return rangeOf(*findOption(OptionOwner::Warping, property));
  };
  EXPECT_EQ(range("AreaBias"), "[-0.99, 0.99]");
  EXPECT_EQ(range("RelaxationFactor"), "(0, 2)");
  EXPECT_EQ(range("ClosureTolerance"), "[0, inf)");
  EXPECT_EQ(range("RigidMaximumIterations"), "from 1");
  EXPECT_EQ(range("Scheme"), "");
  const OptionValues values(OptionOwner::Warping);
  EXPECT_EQ(values.text("Scheme"), "isometric");
  EXPECT_EQ(values.text("ClosureTolerance"), "1e-12");
  EXPECT_EQ(values.text("Pins"), "-1 -1");
}

TEST(OptionTable, AnOptionWithoutEffectIsNamedWithWhatItIsFor)
{
  EXPECT_EQ(idle({}), "");
  EXPECT_EQ(idle({ { "IsometricTolerance", 1.0 } }), "");
  EXPECT_EQ(idle({ { "Scheme", global }, { "IsometricTolerance", 1.0 } }),
    "--isometric-tolerance is for --scheme isometric, not for --scheme global; leave one of them "
    "out");
  EXPECT_EQ(idle({ { "AreaBias", 0.5 }, { "DistortionEnergy", 1.0 } }),
    "--area-bias is for --energy automatic or rigid, not for --energy dirichlet; leave one of them "
    "out");
  EXPECT_EQ(idle({ { "AreaBias", 0.5 }, { "Material", std::string("twill") } }),
    "--area-bias is for a sheet without --material or with --material isotropic, not for "
    "--material twill; leave one of them out");
  EXPECT_EQ(idle({ { "Arrange", 0.0 }, { "Spacing", 1.0 } }),
    "--spacing is for pieces without --no-arrange; leave one of them out");
  EXPECT_EQ(idle({ { "Grain", std::string("30") } }),
    "--grain is for --material NAME|FILE; give that as well, or leave --grain out");
  EXPECT_EQ(idle({ { "RigidEnergyTolerance", 0.0 }, { "Interior", 0.0 } }, OptionSpelling::Python),
    "rigid_tolerance is for interior='arap', not for interior='laplacian'; leave one of them out");
  EXPECT_EQ(idle({ { "ReleaseTrials", 0.0 }, { "Scheme", 3.0 } }, OptionSpelling::Property),
    "ReleaseTrials is for Scheme Global or Isometric, not for Scheme lscm; leave one of them "
    "out");
}
