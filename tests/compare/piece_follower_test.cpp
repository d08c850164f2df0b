// compare/piece_follower: returns the pieces of both paths in order and without a gap, each with the difference that it belongs to.

#include "compare/piece_follower.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "config/control/control_file.h"
#include "lang/text/utf16.h"

namespace kadr::piece_follower_test {
namespace {

using Part = ComparedPiece::Part;
using Kind = CourseDifference::Kind;

std::unique_ptr<Session> opened(const std::string& text) {
  static const auto def = std::make_shared<const ControlDef>(load_control("linuxcnc").value());
  SessionSpec spec{def, load_machine("generic").value(), {}, {"piece_follower_test", text_source(text), Encoding::utf8}, {}};
  auto session = Session::open(std::move(spec));
  EXPECT_TRUE(session);
  return std::move(*session);
}

struct Followed {
  Comparison made;
  std::vector<ComparedPiece> pieces;
};

Followed followed(const std::string& a, const std::string& b) {
  Followed all;
  CompareRules rules;
  rules.on_piece = [&](const ComparedPiece& piece) { all.pieces.push_back(piece); };
  all.made = compare_sessions(opened(a), opened(b), rules);
  return all;
}

constexpr const char* square = "G21 G90 M3 S1000\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX10\nY10\nX0\nY0\nG0 Z5\nM2\n";

std::string changed(const std::string& before, const std::string& after) {
  std::string text = square;
  return text.replace(text.find(before), before.size(), after);
}

TEST(PieceFollower, AllOfTheSame) {
  const Followed f = followed(square, square);
  EXPECT_EQ(f.pieces.size(), 14U);
  for (const ComparedPiece& piece : f.pieces) EXPECT_EQ(piece.part, Part::together);
}

TEST(PieceFollower, AnotherWay) {
  const Followed f = followed(square, changed("Y10\n", "X10.5 Y5\nX10 Y10\n"));
  std::vector<std::uint32_t> a, b;
  for (const ComparedPiece& piece : f.pieces) {
    if (piece.part != Part::apart) continue;
    (piece.of_b ? b : a).push_back(piece.origin.line);
    EXPECT_NEAR(piece.distance, 0.5, 1e-6);
  }
  EXPECT_EQ(a, std::vector{5U});
  EXPECT_EQ(b, (std::vector{5U, 6U}));
}

TEST(PieceFollower, WhatIsChanged) {
  const Followed f = followed(square, changed("Y10\n", "Y10 F150\n"));
  for (const ComparedPiece& piece : f.pieces) {
    const bool its = piece.origin.line >= 5 && piece.origin.line <= 7;
    EXPECT_EQ(piece.part, its ? Part::changed : Part::together) << piece.origin.line;
  }
}

TEST(PieceFollower, AnActIsToldWhereItDiffers) {
  const Followed f = followed(square, changed("Y10\n", "Y10\nG4 P1\n"));
  std::size_t acts = 0;
  for (const ComparedPiece& piece : f.pieces) {
    if (!piece.act) continue;
    ++acts;
    EXPECT_TRUE(piece.of_b && piece.part == Part::apart && piece.from == piece.to);
  }
  EXPECT_EQ(acts, 1U);
}

/// Random corners and feeds, some of them changed in the second program.
RC_GTEST_PROP(PieceFollowerProperty, without_a_gap_and_numbered_as_told, ()) {
  const auto corner = rc::gen::tuple(rc::gen::inRange(-20, 20), rc::gen::inRange(-20, 20), rc::gen::inRange(0, 12));
  const auto corners = *rc::gen::container<std::vector<std::tuple<int, int, int>>>(*rc::gen::inRange<std::size_t>(0, 16), corner);
  std::string a = "G21 G90 F100\nG1 X0 Y0\n", b = a;
  for (const auto& [x, y, change] : corners) {
    a += fmt::format("X{} Y{}\n", x, y);
    const char* const more = change == 1 ? "F120\n" : change == 2 ? "F100\n" : change == 3 ? "G4 P1\n" : change == 4 ? "M3 S100\n" : "";
    b += more + fmt::format("X{} Y{}\n", change == 5 ? x + 0.1 : x, change == 6 ? y + 0.0005 : y);
  }
  const Followed f = followed(a + "M2\n", b + "M2\n");
  std::array<std::optional<Axes>, 2> stands;
  std::size_t reached = 0;
  for (const ComparedPiece& piece : f.pieces) {
    auto& stand = stands[piece.of_b ? 1 : 0];
    if (stand) RC_ASSERT(*stand == piece.from);
    stand = piece.to;
    if (piece.part == Part::together) continue;
    RC_ASSERT(piece.number < f.made.differences.size());
    RC_ASSERT(piece.number + 1 >= reached);
    reached = std::max(reached, piece.number + 1);
    const Kind kind = f.made.differences[piece.number].kind;
    RC_ASSERT((piece.part == Part::apart) == (kind == Kind::path || kind == Kind::act));
  }
}

}  // namespace
}  // namespace kadr::piece_follower_test
