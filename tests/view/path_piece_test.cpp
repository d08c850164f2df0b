// Levels of detail of a piece of path: they are nested and as exact as they promise; and the frame of a piece.

#include "view/path_piece.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace kadr::path_piece_test {
namespace {

Vec3 place(const PathVertex& v) { return {double(v.at[0]), double(v.at[1]), double(v.at[2])}; }

double distance(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 delta = b - a, from = p - a;
  const double square = delta.x * delta.x + delta.y * delta.y + delta.z * delta.z;
  const double along = square > 0 ? std::clamp((from.x * delta.x + from.y * delta.y + from.z * delta.z) / square, 0.0, 1.0) : 0;
  return length(from - along * delta);
}

ViewPiece random_piece() {
  ViewPiece piece;
  const auto count = *rc::gen::inRange<std::size_t>(1, 1500);
  Vec3 at;
  double turn = 0;
  for (std::size_t i = 0; i < count; ++i) {
    PathVertex v;
    turn += 0.001 * *rc::gen::inRange(-400, 400);
    at = at + Vec3{std::cos(turn), std::sin(turn), 0.05 * *rc::gen::inRange(-3, 3)};
    v.at = {float(at.x), float(at.y), float(at.z)};
    v.kind = *rc::gen::inRange(0, 40) == 0 ? PathKind::rapid : PathKind::feed;
    v.line = std::uint32_t(i);
    piece.vertices.push_back(v);
  }
  return piece;
}

RC_GTEST_PROP(PathPieceProperty, WhatALevelLeavesOutIsNearWhatItKeeps, ()) {
  ViewPiece piece = random_piece();
  set_levels(piece);
  const auto& v = piece.vertices;
  RC_ASSERT(v.front().level == 15 && v.back().level == 15);
  for (int level = 0; level < 16; ++level) {
    std::size_t last = 0;
    for (std::size_t i = 1; i < v.size(); ++i) {
      if (v[i].level < level) continue;
      for (std::size_t j = last + 1; j < i; ++j)
        RC_ASSERT(distance(place(v[j]), place(v[last]), place(v[i])) <= 0.001 * std::pow(2, level) + 1e-6);
      last = i;
    }
  }
}

TEST(PathPiece, ChangesOfKindStayAtEveryLevel) {
  ViewPiece piece;
  for (int i = 0; i < 6; ++i) {
    PathVertex v;
    v.at = {float(i), 0, 0};
    v.kind = i < 3 ? PathKind::rapid : PathKind::feed;
    piece.vertices.push_back(v);
  }
  set_levels(piece);
  EXPECT_EQ(piece.vertices[2].level, 15);
  EXPECT_EQ(piece.vertices[1].level, 0);
  EXPECT_EQ(piece.vertices[4].level, 0);
}

TEST(PathPiece, AFrameIsAsLongAsItSays) {
  ViewPiece piece;
  piece.begins = 2.5;
  piece.vertices.resize(3);
  piece.vertices[1].line = 77;
  set_levels(piece);
  const std::string frame = path_frame(piece, 1, 2);
  ASSERT_EQ(frame.size(), 96 + 40 * 3U);
  std::uint32_t head[4];
  std::memcpy(head, frame.data(), sizeof head);
  EXPECT_EQ(head[0], 1U);
  EXPECT_EQ(head[1], 1U);
  EXPECT_EQ(head[2], 3U);
  EXPECT_EQ(head[3], 2U);
  double begins = 0;
  std::memcpy(&begins, frame.data() + 16, sizeof begins);
  EXPECT_EQ(begins, 2.5);
  std::uint32_t line = 0;
  std::memcpy(&line, frame.data() + 96 + 16 * 3 + 4, sizeof line);
  EXPECT_EQ(line, 77U);
}

}  // namespace
}  // namespace kadr::path_piece_test
