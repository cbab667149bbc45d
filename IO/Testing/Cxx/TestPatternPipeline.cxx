// SPDX-License-Identifier: BSD-3-Clause
// A pattern writer that is given the flat pieces alone finds wires and lengths where they come
// from, as long as nobody has changed the pieces in between.
#include "FlatteningTesting.h"

#include "vtkCleanPolyData.h"
#include "vtkPassThrough.h"
#include "vtkPatternWriter.h"
#include "vtkWireWarpingFilter.h"

#include <vtksys/SystemTools.hxx>

#include <cstdlib>
#include <fstream>
#include <sstream>

using namespace flatteningTesting;

namespace
{
std::string written(vtkPatternWriter* writer)
{
  const std::string path = "TestPatternPipeline.svg";
  vtksys::SystemTools::RemoveFile(path);
  writer->SetFileName(path.c_str());
  writer->SetUnitToCentimetre();
  writer->Write();
  std::ostringstream content;
  content << std::ifstream(path).rdbuf();
  return content.str();
}
}

int TestPatternPipeline(int, char*[])
{
  Checks check;
  vtksys::SystemTools::PutEnv("SOURCE_DATE_EPOCH=0");
  const auto surface = makeQuarterSphere();
  vtkNew<vtkWireWarpingFilter> flattening;
  flattening->SetInputData(surface);
  flattening->SetCurvesData(makeQuarterSphereArc(surface));

  vtkNew<vtkPatternWriter> all;
  for (int port = 0; port < 3; ++port)
  {
    all->SetInputConnection(port, flattening->GetOutputPort(port));
  }
  const std::string expected = written(all);
  check.contains(expected, "class=\"internal\"", "the pattern of three connections");

  vtkNew<vtkPassThrough> between;
  between->SetInputConnection(flattening->GetOutputPort());
  vtkNew<vtkPatternWriter> one;
  one->SetInputConnection(between->GetOutputPort());
  const std::string outlines = written(one);
  check.that(outlines.find("class=\"internal\"") == std::string::npos, "outlines by default");
  one->FollowPipelineOn();
  check.that(written(one) == expected, "one connection and the pipeline give the same pattern");

  // Other points: wires of the flattening may lie elsewhere.
  vtkNew<vtkCleanPolyData> changed;
  changed->SetInputConnection(flattening->GetOutputPort());
  one->SetInputConnection(changed->GetOutputPort());
  const std::string cleaned = written(one);
  check.that(!cleaned.empty() && cleaned.find("class=\"internal\"") == std::string::npos,
    "outlines of changed pieces");
  return check.result();
}
