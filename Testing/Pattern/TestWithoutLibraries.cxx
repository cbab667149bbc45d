// SPDX-License-Identifier: BSD-3-Clause
// A build without cairo and Clipper says so where they are asked for, and does the rest.
#include "PdfWriter.h"
#include "SeamAllowance.h"

#include <gtest/gtest.h>

using namespace flattening;
using namespace flattening::pattern;

TEST(WithoutLibraries, PdfIsRefusedByName)
{
  std::string pdf;
  const PatternStatus status = makePdf({}, {}, pdf);
  EXPECT_FALSE(status.ok());
  EXPECT_NE(status.message.find("cairo"), std::string::npos) << status.message;
  EXPECT_NE(status.message.find("SVG or DXF"), std::string::npos) << "the way out";
  EXPECT_TRUE(pdf.empty());
}

TEST(WithoutLibraries, ASeamAllowanceIsRefusedByNameAndNoneIsDrawn)
{
  AllowancePolygon triangle;
  triangle.points = { Point2(0, 0), Point2(9, 0), Point2(0, 9) };
  triangle.allowance = { 0.0, 0.0, 0.0 };
  std::vector<Points2> widened;
  EXPECT_TRUE(addAllowance({ triangle, triangle }, 2.0, widened).ok());
  EXPECT_EQ(widened, (std::vector<Points2>{ triangle.points, triangle.points }));

  triangle.allowance[1] = 5.0;
  const PatternStatus status = addAllowance({ triangle }, 2.0, widened);
  EXPECT_FALSE(status.ok());
  EXPECT_NE(status.message.find("Clipper"), std::string::npos) << status.message;
  EXPECT_NE(status.message.find("allowance of 0"), std::string::npos) << "the way out";
  EXPECT_TRUE(widened.empty());
}
