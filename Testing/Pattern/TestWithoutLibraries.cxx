// SPDX-License-Identifier: BSD-3-Clause
// A build without cairo, FriBidi, qpdf and Clipper says so where they are asked for, and does the
// rest.
#include "Drawing/SeamAllowance.h"
#include "Formats/PatternWriters.h"
#include "Nesting/FabricLay.h"

#include <gtest/gtest.h>

using namespace flattening;
using namespace flattening::pattern;

TEST(WithoutLibraries, PdfIsRefusedByName)
{
  std::string pdf;
  const Status status = makePdf({}, {}, pdf);
  EXPECT_FALSE(status.ok());
  EXPECT_NE(status.message.find("cairo, FriBidi or qpdf"), std::string::npos) << status.message;
  ASSERT_EQ(status.remedies.size(), 1u);
  EXPECT_EQ(status.remedies[0].remedy, Remedy::WriteOtherFormat);
  EXPECT_TRUE(pdf.empty());
}

TEST(WithoutLibraries, ALayOnClothIsRefusedByName)
{
  Pattern pattern;
  const Status status = layOnFabric({}, pattern);
  EXPECT_FALSE(status.ok());
  EXPECT_NE(status.message.find("Clipper"), std::string::npos) << status.message;
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
  const Status status = addAllowance({ triangle }, 2.0, widened);
  EXPECT_FALSE(status.ok());
  EXPECT_NE(status.message.find("Clipper"), std::string::npos) << status.message;
  ASSERT_EQ(status.remedies.size(), 1u);
  EXPECT_EQ(status.remedies[0].subject, "an allowance of 0");
  EXPECT_TRUE(widened.empty());
}
