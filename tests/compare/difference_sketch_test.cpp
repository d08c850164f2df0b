// compare/difference_sketch: the drawing has fewer points and stays within
// the chord tolerance of the original paths; nothing is drawn across gaps.

#include "compare/difference_sketch.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/matrix.h"

namespace kadr::difference_sketch_test {
namespace {

using Layer = SketchPiece::Layer;

/// Returns a circle of this number of segments, all from one program line.
std::vector<SketchPiece> circle(int pieces, Layer layer = Layer::same) {
  std::vector<SketchPiece> all;
  const auto at = [&](int i) { return Vec3{10 * std::cos(2 * pi * i / pieces), 10 * std::sin(2 * pi * i / pieces), 0}; };
  for (int i = 0; i < pieces; ++i) all.push_back({layer, at(i), at(i + 1), Stroke::feed, {7, 0}});
  return all;
}

double from_path(Vec3 p, const PlotPath& path) {
  double least = 1e300;
  for (std::size_t i = 1; i < path.points().size(); ++i) {
    if (path.points()[i].stroke == Stroke::jump) continue;
    const Vec3 from = path.points()[i - 1].at, delta = path.points()[i].at - from;
    const double part = std::clamp(dot(p - from, delta) / std::max(dot(delta, delta), 1e-300), 0.0, 1.0);
    least = std::min(least, length(p - (from + part * delta)));
  }
  return least;
}

TEST(DifferenceSketch, JoinsWhatIsFinerThanThePicture) {
  for (const double chord : {0.1, 0.01, 0.001}) {
    DifferenceSketch sketch(10'000, chord);
    const auto pieces = circle(5000);
    for (const SketchPiece& piece : pieces) sketch.take(piece);
    sketch.finish();
    EXPECT_LT(sketch.same().points().size(), 700U);
    EXPECT_GT(sketch.same().points().size(), 5U);
    for (const SketchPiece& piece : pieces) EXPECT_LE(from_path(piece.to, sketch.same()), chord * 1.001);
  }
}

TEST(DifferenceSketch, KeepsLinesAndStrokesApart) {
  DifferenceSketch sketch(100, 1);
  sketch.take({Layer::same, {0, 0, 0}, {1, 0, 0}, Stroke::feed, {1, 0}});
  sketch.take({Layer::same, {1, 0, 0}, {2, 0, 0}, Stroke::feed, {2, 0}});
  sketch.take({Layer::same, {2, 0, 0}, {3, 0, 0}, Stroke::rapid, {2, 0}});
  sketch.take({Layer::same, {5, 0, 0}, {6, 0, 0}, Stroke::feed, {3, 0}});
  sketch.finish();
  std::vector<Stroke> strokes;
  for (const PlotPoint& point : sketch.same().points()) strokes.push_back(point.stroke);
  EXPECT_EQ(strokes, (std::vector{Stroke::rapid, Stroke::feed, Stroke::feed, Stroke::rapid, Stroke::jump, Stroke::feed}));
}

TEST(DifferenceSketch, BoxesHoldWhatDiffers) {
  DifferenceSketch sketch(1000, 0.01);
  for (const SketchPiece& piece : circle(100)) sketch.take(piece);
  EXPECT_TRUE(sketch.box().empty);
  sketch.take({Layer::b, {10, 0, 0}, {30, 0, 5}, Stroke::rapid, {8, 0}});
  sketch.take({Layer::a, {10, 0, -2}, {10, 0, -2}, Stroke::feed, {8, 0}, true});
  sketch.finish();
  EXPECT_EQ(sketch.box().most, (Vec3{30, 0, 5}));
  EXPECT_EQ(sketch.box().least, (Vec3{10, 0, -2}));
  EXPECT_EQ(sketch.same().cutting_box().most.x, 30);
  EXPECT_TRUE(sketch.a().points().empty());
  sketch.move_all({1, 0, 0});
  EXPECT_EQ(sketch.box().most, (Vec3{31, 0, 5}));
  EXPECT_EQ(sketch.b().points().back().at, (Vec3{31, 0, 5}));
}

TEST(DifferenceSketch, IsBounded) {
  DifferenceSketch sketch(1000, 1e-6);
  for (int i = 0; i < 100'000; ++i)
    sketch.take({Layer::a, {i % 7 * 1.0, i * 0.01, 0}, {(i + 1) % 7 * 1.0, (i + 1) * 0.01, 0}, Stroke::feed, {std::uint32_t(i), 0}});
  sketch.finish();
  EXPECT_LE(sketch.a().points().size(), 1000U);
  EXPECT_GT(sketch.error(), 0.01);
}

}  // namespace
}  // namespace kadr::difference_sketch_test
