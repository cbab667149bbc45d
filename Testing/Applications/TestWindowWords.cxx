// SPDX-License-Identifier: BSD-3-Clause
// The window speaks of what is on the screen, not of properties of filters.
#include "Files.h"
#include "WindowWords.h"

#include <vtkFlatteningAlgorithm.h>
#include <vtkNew.h>
#include <vtkPatternWriter.h>
#include <vtkPlaneSource.h>
#include <vtkWireWarpingFilter.h>

#include <gtest/gtest.h>

#include <regex>

namespace
{
/// Words such as LengthTolerance or LAPLACIAN; SVG and DXF are names of formats.
bool namesAProperty(const std::string& text)
{
  return std::regex_search(text, std::regex("[a-z][A-Z]|[A-Z]{4}|[A-Z]_"));
}
}

TEST(WindowWords, NameNoProperty)
{
  EXPECT_TRUE(namesAProperty(vtkFlatteningAlgorithm::GetRemedySentence("ReleaseCurves")));
  for (int k = 0; k < vtkFlatteningAlgorithm::GetNumberOfRemedies(); ++k)
  {
    const std::string name = vtkFlatteningAlgorithm::GetRemedyName(k);
    const std::string words = editor::remedyWords(name);
    EXPECT_FALSE(namesAProperty(words)) << name << ": " << words;
    EXPECT_EQ(words.find_first_of("{}[]"), std::string::npos) << name << ": " << words;
  }
  EXPECT_EQ(editor::remedyWords("UseNewton"), ""); // the window has no such option
  EXPECT_EQ(editor::remedyWords("CheckUnit"), "check the unit");
}

TEST(WindowWords, SayDefectAndWayOutOfFiltersAndPatterns)
{
  vtkNew<vtkPlaneSource> plane;
  vtkNew<vtkWireWarpingFilter> filter;
  figures::silence(filter);
  filter->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkPatternWriter> writer;
  figures::silence(writer);
  for (int port = 0; port < 3; ++port)
  {
    writer->SetInputConnection(port, filter->GetOutputPort(port));
  }
  writer->SetUnitByName("cm");
  writer->SetFileName("/nowhere/pattern.svg");
  EXPECT_EQ(writer->Write(), 0);
  const std::string written = editor::messageOf(writer);
  EXPECT_FALSE(written.empty() || namesAProperty(written)) << written;
  filter->SetMaterial("denim");
  filter->AddGrain("missing");
  filter->Update();
  const std::string said = editor::messageOf(filter);
  EXPECT_EQ(said.rfind(filter->GetStatusDefect(), 0), 0u) << said;
  EXPECT_NE(said.find("; "), std::string::npos) << said;
  EXPECT_FALSE(namesAProperty(said)) << said;
  EXPECT_NE(said, filter->GetStatusMessage());
}
