// compare/: small programs that are equal or differ in one way each, and random programs compared with a slow reference.

#include "compare/comparison.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "config/control/control_file.h"
#include "lang/text/utf16.h"

namespace kadr::comparison_test {
namespace {

std::unique_ptr<Session> session_of(const std::string& text, const std::string& control = "linuxcnc") {
  static std::map<std::string, std::shared_ptr<const ControlDef>> known;
  auto& def = known[control];
  if (!def) def = std::make_shared<const ControlDef>(load_control(control).value());
  SessionSpec spec{def, load_machine("generic").value(), {}, {"comparison_test", text_source(text), Encoding::utf8}, {}};
  auto session = Session::open(std::move(spec));
  EXPECT_TRUE(session);
  return std::move(*session);
}

/// Compares two programs, each for a control of its own.
Comparison compared_as(const std::string& a, const std::string& of_a, const std::string& b, const std::string& of_b) {
  return compare_sessions(session_of(a, of_a), session_of(b, of_b), {});
}

Comparison compared(const std::string& a, const std::string& b, double tolerance = 0.001) {
  CompareRules rules;
  rules.tolerance = tolerance;
  return compare_sessions(session_of(a), session_of(b), rules);
}

std::string described(const Comparison& c) {
  std::string text;
  for (const CourseDifference& d : c.differences)
    text += fmt::format("{} {}:{} {}-{} '{}' '{}' {:.3f}\n", int(d.kind), d.a.origin.line, d.b.origin.line, d.a_to.origin.line,
                        d.b_to.origin.line, d.a_value, d.b_value, d.distance);
  return text;
}

constexpr const char* plain = "G21 G90 M3 S1000\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX10\nY10\nG2 X0 Y10 I-5 J0\nG0 Z5\nM2\n";

TEST(Comparison, AProgramAndItself) {
  const Comparison c = compared(plain, plain);
  EXPECT_TRUE(c.equal()) << described(c);
  EXPECT_EQ(c.greatest, 0);
  EXPECT_EQ(c.moves_a, 6U);
  EXPECT_EQ(c.moves_b, 6U);
}

TEST(Comparison, ALineCutInTwoIsTheSameLine) {
  const Comparison c = compared(plain, "G21 G90 S1000 M3\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX3\nX7\nX10\nY10\nG2 X0 Y10 R5\nG0 Z5\nM2\n");
  EXPECT_TRUE(c.equal()) << described(c);
}

TEST(Comparison, IncrementsAndArcsByChordsAreTheSame) {
  const Comparison c = compared("G21 G90\nG0 X0 Y0\nG1 X10 F100\nG3 X20 Y10 R10\nM2\n", "G21 G91\nG1 X10 F100\nG3 X10 Y10 I0 J10\nM2\n");
  EXPECT_TRUE(c.equal()) << described(c);
}

TEST(Comparison, AnotherWayIsFoundWithBothLines) {
  const Comparison c = compared(plain, "G21 G90 M3 S1000\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX10\nX10.5 Y5\nX10 Y10\nG2 X0 Y10 I-5 J0\nG0 Z5\nM2\n");
  ASSERT_EQ(c.differences.size(), 1U) << described(c);
  const CourseDifference& d = c.differences[0];
  EXPECT_EQ(d.kind, CourseDifference::Kind::path);
  EXPECT_EQ(d.a.origin.line, 5U);
  EXPECT_EQ(d.b.origin.line, 5U);
  EXPECT_EQ(d.a_to.origin.line, 6U);
  EXPECT_EQ(d.b_to.origin.line, 7U);
  EXPECT_NEAR(d.distance, 0.5, 1e-6);
  EXPECT_FALSE(c.lost);
}

TEST(Comparison, WhatIsInForceCounts) {
  const auto kind_of = [](const std::string& other) {
    const Comparison c = compared("G21 G90 M3 S1000\nG1 X10 F100\nX20\nX30\nM2\n", other);
    return c.differences.size() == 1 ? int(c.differences[0].kind) : -int(c.differences.size());
  };
  using Kind = CourseDifference::Kind;
  EXPECT_EQ(kind_of("G21 G90 M3 S1000\nG1 X10 F100\nX20 F200\nX30 F100\nM2\n"), int(Kind::feed));
  EXPECT_EQ(kind_of("G21 G90 M3 S1000\nG1 X10 F100\nG0 X20\nG1 X30\nM2\n"), int(Kind::move));
  EXPECT_EQ(kind_of("G21 G90 M3 S1000\nG1 X10 F100\nS1200 X20\nS1000 X30\nM2\n"), int(Kind::spindle));
  EXPECT_EQ(kind_of("G21 G90 M3 S1000\nG1 X10 F100\nX20\nM8\nX30\nM2\n"), int(Kind::coolant));
  EXPECT_EQ(kind_of("G21 G90 M3 S1000\nG1 X10 F100\nX20\nG4 P1\nX30\nM2\n"), int(Kind::act));
  EXPECT_EQ(kind_of("G21 G90 M3 S1000\nG1 X10 F100\nX20\nM0\nX30\nM2\n"), int(Kind::act));
  EXPECT_EQ(kind_of("G21 G90 M3 S1000\nG1 X10 F100\nX20\nX30\nG1 X40\nM2\n"), int(Kind::path));
}

TEST(Comparison, AFeedThatChangesInMidLineIsTold) {
  const Comparison c = compared("G21 G90\nG1 X10 F100\nX20 F200\nM2\n", "G21 G90\nG1 X12 F100\nX20 F200\nM2\n");
  ASSERT_EQ(c.differences.size(), 1U) << described(c);
  EXPECT_EQ(c.differences[0].kind, CourseDifference::Kind::feed);
  EXPECT_NEAR(c.differences[0].a.stand[0], 10, 1e-9);
  EXPECT_NEAR(c.differences[0].a_to.stand[0], 12, 1e-9);
}

TEST(Comparison, AFeedOnAWayThatComesBackIsTold) {
  const Comparison c = compared("G21 G90\nG0 Z5\nG1 Z-10 F100\nZ5\nG0 X1\nM2\n", "G21 G90\nG0 Z5\nG1 Z-10 F101\nZ5\nG0 X1\nM2\n");
  ASSERT_EQ(c.differences.size(), 1U) << described(c);
  EXPECT_EQ(c.differences[0].kind, CourseDifference::Kind::feed);
}

TEST(Comparison, TheOrderOfSwitchesAtOnePlaceDoesNotCount) {
  EXPECT_TRUE(compared("M3 S500\nM8\nG1 X1 F100\nM2\n", "S500 F100\nM8\nM3\nG1 X1\nM2\n").equal());
}

TEST(Comparison, OneThatComesToAnAlarmIsNotTheSame) {
  const Comparison c = compared("G1 X1 F100\nM2\n", "G1 X1 F100\nG2 X5 I1 J1\nM2\n");
  ASSERT_EQ(c.differences.size(), 1U) << described(c);
  EXPECT_EQ(c.differences[0].kind, CourseDifference::Kind::end);
}

TEST(Comparison, TwoProgramsOfTheirOwnAreLostSoon) {
  std::string a = "G21 G90 F100\n", b = a;
  for (int i = 0; i < 20000; ++i) a += fmt::format("G1 X{} Y{}\n", i % 7, i), b += fmt::format("G1 X{} Z{}\n", 500 + i % 5, i);
  const Comparison c = compared(a + "M2\n", b + "M2\n");
  EXPECT_TRUE(c.lost);
  EXPECT_FALSE(c.equal());
}

TEST(Comparison, ManyTurnsWithinTheToleranceStayTogether) {
  std::string a = "G21 G90 F100\nG1 X1\n";
  for (int i = 0; i < 500; ++i) a += fmt::format("G1 X{}\n", 1 + (i % 2) * 0.0004);
  EXPECT_TRUE(compared(a + "G1 X5\nM2\n", "G21 G90 F100\nG1 X5\nM2\n").equal());
}

TEST(Comparison, AnExactStopIsAtTheEndOfItsMotion) {
  const std::string a = "G21 G90 G61\nG1 X10 F100\nX20\nY5\nM2\n";
  EXPECT_TRUE(compared(a, a).equal());
  EXPECT_TRUE(compared(a, "G21 G90 G61\nG1 X10 F100\nX20\nX20\nG64 Y5\nM2\n").equal()) << "nothing goes on from the last one";
  const Comparison gone = compared(a, "G21 G90 G61\nG1 X10 F100\nG64 X20\nG61 Y5\nM2\n");
  ASSERT_EQ(gone.differences.size(), 1U) << described(gone);
  EXPECT_EQ(gone.differences[0].kind, CourseDifference::Kind::act);
  EXPECT_EQ(gone.differences[0].a_value, "G9");
  EXPECT_NEAR(gone.differences[0].a.stand[0], 20, 1e-9);
  EXPECT_FALSE(compared(a, "G21 G90 G61\nG1 X5 F100\nX10\nX20\nY5\nM2\n").equal()) << "it stops in mid line";
}

TEST(Comparison, WhereSomethingIsDoneTheAxesStandAnyway) {
  EXPECT_TRUE(compared("G61\nG1 X10 F100\nG4 P1\nG64 X20\nM2\n", "G1 X10 F100\nG4 P1\nX20\nM2\n").equal());
  EXPECT_TRUE(compared("G61 G0 X10\nX20\nM2\n", "G0 X10\nX20\nM2\n").equal()) << "rapids stop by themselves";
}

TEST(Comparison, ExactStopsOfTwoControlsAreTheSameWhereBothHaveThem) {
  const std::string mode = "G21 G90 G61\nG1 X10 F100\nX20\nY5\nM2\n",
                    block = "N1 G90 G1 G9 X10000 F100 ПС\nN2 G9 X20000 ПС\nN3 Y5000 ПС\nN4 M2 ПС\n";
  const Comparison same = compared_as(mode, "mach3", "% ПС\n" + block, "s2c42");
  EXPECT_TRUE(same.equal()) << described(same);
  EXPECT_FALSE(compared_as("G21 G90\nG1 X10 F100\nX20\nY5\nM2\n", "mach3", "% ПС\n" + block, "s2c42").equal());
  EXPECT_TRUE(compared_as(mode, "mach3", "G21 G90\nG1 X10 F100\nX20\nY5\nM2\n", "grbl").equal()) << "Grbl has none";
}

TEST(Comparison, CornersCountAlongTheWay) {
  const auto kind_of = [](const Comparison& c) {
    return c.differences.size() == 1 ? int(c.differences[0].kind) : -int(c.differences.size());
  };
  EXPECT_EQ(kind_of(compared("G64 P0.01\nG1 X10 F100\nX20\nM2\n", "G64 P0.02\nG1 X10 F100\nX20\nM2\n")),
            int(CourseDifference::Kind::corners));
  EXPECT_EQ(kind_of(compared_as("G1 X10 F100\nX20\nM2\n", "nct", "G62 G1 X10 F100\nX20\nM2\n", "nct")),
            int(CourseDifference::Kind::corners));
  EXPECT_TRUE(compared_as("G21 G90 G64 P0.01\nG1 X10 F100\nX20\nM2\n", "linuxcnc", "G21 G90\nG1 X10 F100\nX20\nM2\n", "nct").equal())
      << "the NCT has no P";
}

TEST(Comparison, SwitchesAfterTheLastMotionCount) {
  const std::string motion = "% LF\nN1 G90 F100 S500 M03 LF\nN2 G01 X10000 LF\n";
  EXPECT_TRUE(compared_as(motion + "N3 M05 LF\nN4 M02 LF\n", "gost", motion + "N3 M05 M02 LF\n", "gost").equal());
  const Comparison left_on = compared_as(motion + "N3 M05 LF\nN4 M02 LF\n", "gost", motion + "N3 M02 LF\n", "gost");
  ASSERT_EQ(left_on.differences.size(), 1U) << described(left_on);
  EXPECT_EQ(left_on.differences[0].kind, CourseDifference::Kind::spindle);
  EXPECT_FALSE(compared_as(motion + "N3 M02 LF\n", "gost", motion + "N3 M08 LF\nN4 M02 LF\n", "gost").equal());
  const std::string iso = "G21 G90 F10 S500 M3\nG1 X10\n";
  EXPECT_TRUE(compared_as(motion + "N3 M02 LF\n", "gost", iso + "M2\n", "mach3").equal()) << "M2 of Mach3 stops the spindle";
}

TEST(Comparison, AFeedPerRevolutionIsOnePerMinuteAtItsSpeedByTheRules) {
  const std::string by_turns = "G21 G90 G95 S500 M3\nG1 X10 F0.2\nS1000\nX20\nM2\n",
                    by_time = "G21 G90 G94 S500 M3\nG1 X10 F100\nS1000\nF200 X20\nM2\n";
  EXPECT_FALSE(compared(by_turns, by_time).equal());
  CompareRules rules;
  rules.feeds_at_speed = true;
  const Comparison c = compare_sessions(session_of(by_turns), session_of(by_time), rules);
  EXPECT_TRUE(c.equal()) << described(c);
  EXPECT_TRUE(c.feeds_at_speed);
  EXPECT_FALSE(compare_sessions(session_of(by_turns), session_of("G21 G90 G94 S500 M3\nG1 X10 F100\nS1000\nX20\nM2\n"), rules).equal());
}

/// A path with random corners equals the same path with points added along its lines. If one corner is moved, the difference is found
/// with the distance of the move.
RC_GTEST_PROP(ComparisonProperty, divided_the_same_moved_not, ()) {
  const auto corners =
      *rc::gen::container<std::vector<std::pair<int, int>>>(rc::gen::pair(rc::gen::inRange(-50, 50), rc::gen::inRange(-50, 50)));
  RC_PRE(corners.size() >= 3U);
  const std::size_t moved = *rc::gen::inRange<std::size_t>(1, corners.size() - 1);
  std::string a = "G21 G90 F100\nG1 X0 Y0\n", divided = a, other = a;
  std::pair<double, double> at{0, 0};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto [x, y] = corners[i];
    const int parts = *rc::gen::inRange(1, 4);
    for (int k = 1; k <= parts; ++k)
      divided += fmt::format("X{:.6f} Y{:.6f}\n", at.first + (x - at.first) * k / parts, at.second + (y - at.second) * k / parts);
    a += fmt::format("X{} Y{}\n", x, y);
    other += fmt::format("X{} Y{}\n", i == moved ? x + 0.1 : x, i == moved ? y + 0.1 : y);
    at = {x, y};
  }
  const Comparison same = compared(a + "M2\n", divided + "M2\n");
  RC_ASSERT(same.equal());
  const Vec2 p{double(corners[moved].first), double(corners[moved].second)};
  const Vec2 before{double(corners[moved - 1].first), double(corners[moved - 1].second)},
      after{double(corners[moved + 1].first), double(corners[moved + 1].second)};
  const Vec2 u = p - before, v = after - p;
  const bool is_corner = std::abs(u.x * v.y - u.y * v.x) > 0.3 * length(u) * length(v);
  if (is_corner) RC_ASSERT(!compared(a + "M2\n", other + "M2\n").equal());
}

}  // namespace
}  // namespace kadr::comparison_test
