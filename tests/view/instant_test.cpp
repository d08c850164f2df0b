// The state at any instant of a run equals the state of a run that has reached it: position, modes, calls.

#include "view/instant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace kadr::instant_test {
namespace {

/// Loops, a subprogram, a canned cycle, arcs; work and machine coordinates are the same.
constexpr const char* text =
    "G21 G90 G17 F500\n"
    "T1 M6\n"
    "o10 sub\n"
    "  #1 = 0\n"
    "  o11 while [#1 LT 400]\n"
    "    #1 = [#1 + 1]\n"
    "    G1 X[#1 / 10] Y[#1 * 2] F[100 + #1]\n"
    "    G3 X[#1 / 10 + 2] I1 J0\n"
    "  o11 endwhile\n"
    "o10 endsub\n"
    "G0 X0 Y0 Z0\n"
    "o12 repeat [8]\n"
    "  o10 call\n"
    "o12 endrepeat\n"
    "G81 X5 Y5 Z-3 R2 F200\n"
    "X9\n"
    "G80 G0 Z10\n"
    "M2\n";

std::unique_ptr<ProgramRun> run_of(const std::string& program) {
  OpeningRequest request;
  request.path = "instant_test.ngc";
  request.control = "linuxcnc";
  request.text = program;
  auto opened = open_for_page(request);
  EXPECT_TRUE(opened) << opened.error();
  auto run = ProgramRun::make(*opened, {});
  EXPECT_TRUE(run);
  (*run)->execute();
  return std::move(*run);
}

double value(const std::vector<InForce>& all, InForce::Kind kind, const std::string& name) {
  for (const InForce& one : all)
    if (one.kind == kind && one.name == name) return one.value;
  return -1e300;
}

TEST(Instants, AreWhereTheRunWas) {
  const auto run = run_of(text);
  ASSERT_EQ(run->end(), ProgramRun::End::ended);
  ASSERT_GT(run->checkpoints().size(), 2U);
  std::map<std::uint32_t, std::pair<PathVertex, double>> last;  // the last vertex of each block
  for (const ViewPiece& piece : run->path().pieces())
    for (const PathVertex& v : piece.vertices)
      if (v.kind != PathKind::jump) last[v.number] = {v, PathRecord::time_of(piece, v)};
  Instants instants(*run);
  std::size_t i = 0;
  for (const auto& [number, end] : last) {
    if (i++ % 97 != 0 && i + 4 < last.size()) continue;
    const auto state = instants.at(end.second - 1e-4, {});
    ASSERT_TRUE(state);
    EXPECT_EQ(state->vertex.number, number);
    EXPECT_NEAR(value(state->after, InForce::Kind::position, "X"), double(end.first.at[0]), 1e-4) << number;
    EXPECT_NEAR(value(state->after, InForce::Kind::position, "Y"), double(end.first.at[1]), 1e-4) << number;
    if (state->vertex.line == 7) {
      EXPECT_EQ(state->calls.empty(), false);
    }
  }
}

TEST(Instants, ByTheNumberOfABlockThatDoesNotMoveToo) {
  const auto run = run_of("G21 G90 F100\nG1 X1\nM8\n#5 = 7\nG1 X2\nM2\n");
  Instants instants(*run);
  std::uint32_t before = 0;
  std::vector<std::uint32_t> lines;
  for (std::uint32_t number = 1; number <= run->blocks(); ++number) {
    const auto state = instants.after(number, {});
    ASSERT_TRUE(state);
    EXPECT_EQ(state->origin.number, number);
    EXPECT_GE(state->origin.line, before);
    before = state->origin.line;
    lines.push_back(before);
  }
  EXPECT_EQ(std::count(lines.begin(), lines.end(), 4U), 1);
  const auto moved = instants.after(2, {}), stood = instants.after(4, {});
  EXPECT_EQ(value(moved->after, InForce::Kind::position, "X"), 1);
  EXPECT_TRUE(moved->moves);
  EXPECT_FALSE(stood->moves);
  EXPECT_EQ(stood->at, moved->at);
  EXPECT_EQ(instants.after(4'000'000'000U, {})->origin.number, run->blocks());
}

TEST(Instants, PassesOfALine) {
  const auto run = run_of(text);
  Instants instants(*run);
  std::size_t count = 0;
  const auto passes = instants.passes(7, 0, 100, count);
  EXPECT_EQ(count, 3200U);
  ASSERT_EQ(passes.size(), 100U);
  for (std::size_t i = 1; i < passes.size(); ++i) EXPECT_LT(passes[i - 1].to, passes[i].to);
}

TEST(Instants, OfAProgramWithoutMotions) {
  const auto run = run_of("M2\n");
  Instants instants(*run);
  const auto state = instants.at(3, {});
  ASSERT_TRUE(state);
  EXPECT_FALSE(state->moves);
}

TEST(Instants, OfAProgramThatStopsByAnAlarm) {
  const auto run = run_of("G21 F100\nG1 X10\nG1 X20 Q\n");
  EXPECT_EQ(run->end(), ProgramRun::End::stopped);
  Instants instants(*run);
  const auto state = instants.at(1e9, {});
  ASSERT_TRUE(state);
  EXPECT_EQ(state->vertex.line, 2U);
}

}  // namespace
}  // namespace kadr::instant_test
