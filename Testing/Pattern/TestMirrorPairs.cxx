// SPDX-License-Identifier: BSD-3-Clause
// Shapes turned over, turned and moved, and shapes that are not quite that.
#include "Outlines/MirrorPairs.h"

#include "Shapes.h"

namespace
{
using namespace shapes;

/// A sleeve of sorts, without any symmetry, with a line in it.
PieceShape sleeve()
{
  PieceShape shape;
  shape.outline = { { 0.0, 0.0 }, { 300.0, 20.0 }, { 340.0, 200.0 }, { 180.0, 330.0 },
    { -20.0, 240.0 } };
  shape.lines = { { { 40.0, 30.0 }, { 60.0, 200.0 } } };
  return shape;
}

/// A regular polygon: its area is as long one way as the other.
PieceShape wheel(int corners, double spoke)
{
  PieceShape shape;
  shape.outline = regular(corners, 100.0);
  shape.lines = { { { 0.0, 0.0 }, { 80.0 * std::cos(spoke), 80.0 * std::sin(spoke) } } };
  return shape;
}

template <class Map>
PieceShape mapped(PieceShape shape, const Map& map)
{
  std::vector<Points2*> all{ &shape.outline };
  for (Points2& line : shape.lines)
  {
    all.push_back(&line);
  }
  for (Points2* points : all)
  {
    for (Point2& p : *points)
    {
      p = map(p);
    }
  }
  return shape;
}

PieceShape moved(const PieceShape& shape, double angle)
{
  return mapped(shape, [=](const Point2& p) {
    return Point2(900.0 + std::cos(angle) * p.x() - std::sin(angle) * p.y(),
      -50.0 + std::sin(angle) * p.x() + std::cos(angle) * p.y());
  });
}

/// Turned over; the outline stays counter-clockwise.
PieceShape mirrored(const PieceShape& shape)
{
  PieceShape image = mapped(shape, [](const Point2& p) { return Point2(-p.x(), p.y()); });
  image.outline = Points2(image.outline.rbegin(), image.outline.rend());
  return image;
}

using Found = std::vector<std::size_t>;
}

TEST(MirrorPairs, AreFoundInAnyPose)
{
  for (double angle = -3.0; angle < 3.2; angle += 0.7)
  {
    EXPECT_EQ(
      findMirrorPairs({ sleeve(), moved(mirrored(sleeve()), angle) }, 0.5), (Found{ noPair, 0 }))
      << angle;
    EXPECT_EQ(findMirrorPairs({ wheel(7, 0.3), moved(mirrored(wheel(7, 0.3)), angle) }, 0.5),
      (Found{ noPair, 0 }))
      << angle;
  }
}

TEST(MirrorPairs, TheSameShapeOnTheSameSideIsNone)
{
  EXPECT_EQ(findMirrorPairs({ sleeve(), moved(sleeve(), 1.0) }, 0.5), (Found{ noPair, noPair }));
}

TEST(MirrorPairs, LinesInsideMustAgreeAsWell)
{
  PieceShape other = mirrored(sleeve());
  other.lines[0][1].x() += 2.0;
  EXPECT_EQ(findMirrorPairs({ sleeve(), other }, 0.5), (Found{ noPair, noPair }));
  EXPECT_EQ(findMirrorPairs({ sleeve(), other }, 3.0), (Found{ noPair, 0 }));
  other.lines.clear();
  EXPECT_EQ(findMirrorPairs({ sleeve(), other }, 3.0), (Found{ noPair, noPair }));
}

TEST(MirrorPairs, VerticesNeedNotBeTheSame)
{
  PieceShape other = mirrored(sleeve());
  other.outline.insert(other.outline.begin() + 1, (other.outline[0] + other.outline[1]) / 2.0);
  EXPECT_EQ(findMirrorPairs({ sleeve(), other }, 0.5), (Found{ noPair, 0 }));
}

TEST(MirrorPairs, OfManyEachBelongsToOne)
{
  const PieceShape image = mirrored(sleeve());
  EXPECT_EQ(
    findMirrorPairs({ sleeve(), wheel(5, 0.1), sleeve(), image, moved(image, 0.4), image }, 0.5),
    (Found{ noPair, noPair, noPair, 0, 2, noPair }));
  EXPECT_TRUE(findMirrorPairs({}, 0.5).empty());
}

TEST(MirrorPairs, TheAxisOfASymmetricShapeIsFoundHoweverItIsTurned)
{
  for (const double angle : { 0.3, 1.2, 2.0 })
  {
    const Point2 along(std::cos(angle), std::sin(angle));
    const Point2 left(-along.y(), along.x());
    Points2 kite{ -10.0 * along, 20.0 * along - 30.0 * left, 30.0 * along,
      20.0 * along + 30.0 * left };
    const std::optional<MirrorAxis> axis = findMirrorAxis({ kite, {} }, 0.5);
    ASSERT_TRUE(axis.has_value());
    EXPECT_NEAR(std::abs(axis->along.dot(along)), 1.0, 1e-9);
    EXPECT_NEAR(axis->miss, 0.0, 1e-9);
    kite[1] *= 1.1;
    EXPECT_FALSE(findMirrorAxis({ kite, {} }, 0.5).has_value());
  }
}
