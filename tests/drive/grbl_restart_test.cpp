// A program for Grbl from any of its lines on moves as the whole program does from there; and tool changes become stops.

#include "drive/grbl/grbl_restart.h"

#include "drive/grbl/grbl_job.h"
#include "lang/text/text_spool.h"
#include "session/a_session.h"

namespace kadr::drive::grbl_restart_test {

const char* const program =
    "%\n"
    "G21 G90 G55 G17 (a part)\n"
    "\n"
    "G43.1 Z2.5\n"
    "M4 S900 M8\n"
    "G0 X10 Y5\n"
    "Z1\n"
    "G1 Z-1.5 F300\n"
    "G91 X3\n"
    "G2 X4 Y4 I4 F500\n"
    "G1 G20 Y0.1 F30\n"
    "G90 X0\n"
    "G21 G18 G3 X5 Z-1.5 I2.5 F200\n"
    "G92 X100 Y0\n"
    "G1 X101\n"
    "G93 X105 F12\n"
    "G94 G1 F150 Y3\n"
    "G61 M3 S500\n"
    "Y4 M9\n"
    "M5\n"
    "G53 G0 Z0\n"
    "G54 G0 X1\n"
    "M30\n";

Setup setup_at(const GrblPoint& start) {
  Setup setup;
  setup.start = {{"X", start[0]}, {"Y", start[1]}, {"Z", start[2]}};
  setup.work_offsets["G54"] = {{"X", 1.0}, {"Y", 2.0}, {"Z", -3.0}};
  setup.work_offsets["G55"] = {{"X", -20.0}, {"Y", 7.25}, {"Z", -40.0}};
  return setup;
}

std::unique_ptr<Session> open(const GrblPoint& start, std::shared_ptr<ByteSource> text) {
  auto opened = Session::open({kadr::test::shared_control("grbl"),
                               kadr::test::generic_machine(),
                               setup_at(start),
                               {"main.nc", shared_source(std::move(text)), {}},
                               {20'000, 5}});
  EXPECT_TRUE(opened);
  return std::move(*opened);
}

struct Moved {
  std::uint32_t line;
  std::vector<GrblPoint> path;
};

/// Returns the paths of the program's lines from `first` on.
std::vector<Moved> moved(const GrblPoint& start, const GrblText& text, std::uint32_t first) {
  GrblJob job(open(start, text.text), text);
  std::vector<Moved> all;
  while (auto line = job.next())
    if (line->number >= first && !line->path.empty()) all.push_back({line->number, line->path});
  EXPECT_FALSE(job.needs().alarm) << first << ": line " << job.needs().alarm->origin.line;
  return all;
}

TEST(GrblRestart, TheRestMovesAsTheWholeProgramDoes) {
  const std::shared_ptr<ByteSource> text = text_source(program);
  GrblSettings settings;
  settings.offsets = {{"G54", {1, 2, -3}}, {"G55", {-20, 7.25, -40}}};
  const GrblPoint begin = {-50, -60, -5};
  const auto whole = moved(begin, {text}, 1);
  ASSERT_GE(whole.size(), 12U);
  std::size_t tried = 0;
  for (const Moved& from : whole) {
    GrblRestartPlan plan;
    plan.line = from.line;
    plan.from = {3, -8, -10};
    plan.clear = -1;
    plan.spin_up = 2;
    const auto restart = grbl_restart(
        text, [&](std::shared_ptr<ByteSource> part) { return open(begin, std::move(part)); }, settings, plan);
    ASSERT_TRUE(restart) << restart.error();
    for (std::size_t a = 0; a < grbl_axes; ++a) EXPECT_NEAR(restart->place[a], from.path.front()[a], 1e-9) << from.line;
    const auto rest = moved(plan.from, restart->text, from.line);
    std::string head;
    for (const std::string& line : restart->head) head += line + ' ';
    ASSERT_FALSE(rest.empty()) << from.line << ": " << head;
    const std::size_t skipped = whole.size() - rest.size();
    ASSERT_EQ(whole[skipped].line, from.line);
    for (std::size_t i = 0; i < rest.size(); ++i) {
      ASSERT_EQ(rest[i].line, whole[skipped + i].line);
      ASSERT_EQ(rest[i].path.size(), whole[skipped + i].path.size()) << from.line << ": line " << rest[i].line;
      for (std::size_t p = 0; p < rest[i].path.size(); ++p)
        for (std::size_t a = 0; a < grbl_axes; ++a)  // positions are written with three decimals
          ASSERT_NEAR(rest[i].path[p][a], whole[skipped + i].path[p][a], 0.002) << from.line << ": line " << rest[i].line;
    }
    ++tried;
  }
  EXPECT_GE(tried, 12U);
}

TEST(GrblRestart, TheSpindleTurnsBeforeTheWay) {
  GrblRestartPlan plan;
  plan.line = 9;
  plan.clear = 10;
  plan.spin_up = 1.5;
  const auto restart = grbl_restart(
      text_source(program), [](std::shared_ptr<ByteSource> part) { return open({}, std::move(part)); }, {}, plan);
  ASSERT_TRUE(restart) << restart.error();
  const auto at = [&](const std::string& line) {
    return std::find(restart->head.begin(), restart->head.end(), line) - restart->head.begin();
  };
  const auto lines = std::ssize(restart->head);
  EXPECT_LT(at("S900"), lines);
  EXPECT_LT(at("M4"), at("G4P1.5"));
  EXPECT_LT(at("G4P1.5"), at("G53G0Z10"));
  EXPECT_LT(at("G53G0Z10"), lines);
}

TEST(GrblRestart, WhatCannotContinueIsRefused) {
  const auto error_of = [](const char* text, std::uint32_t line) {
    GrblRestartPlan plan;
    plan.line = line;
    const auto restart = grbl_restart(
        text_source(text), [](std::shared_ptr<ByteSource> part) { return open({}, std::move(part)); }, {}, plan);
    return restart ? std::string() : restart.error();
  };
  EXPECT_NE(error_of("G21\n", 5).find("no block"), std::string::npos);
  EXPECT_NE(error_of("G1 X5\nX6\n", 2).find("alarm"), std::string::npos);
  EXPECT_NE(error_of("G91 G2 X10 I5 F100\nX-10 I-5\n", 2).find("G2"), std::string::npos);
  EXPECT_EQ(error_of("G91 G2 X10 I5 F100\nG2 X-10 I-5\n", 2), "");
}

TEST(GrblRestart, AToolChangeBecomesAStop) {
  std::vector<std::uint32_t> lines;
  const auto text = with_tool_stops(text_source("G21 (M6)\nT1 M6\nX5\nm06T2;M6\n"), lines);
  ASSERT_NE(text, nullptr);
  EXPECT_EQ(whole_text(*text), "G21 (M6)\nT1 M0\nX5\nm00T2;M6\n");
  EXPECT_EQ(lines, (std::vector<std::uint32_t>{2, 4}));
  lines.clear();
  EXPECT_EQ(with_tool_stops(text_source("G21\nT1 M6 X5\n"), lines), nullptr);
  EXPECT_EQ(lines, std::vector<std::uint32_t>{2});
  lines.clear();
  const std::shared_ptr<ByteSource> plain = text_source("G21\nM60\n");
  EXPECT_EQ(with_tool_stops(plain, lines), plain);
}

TEST(GrblRestart, LinesOfTheHeadHaveNoNumber) {
  const GrblText text{nullptr, 10, 120};
  EXPECT_EQ(text.line_in_program(10), 0U);
  EXPECT_EQ(text.line_in_program(11), 120U);
  EXPECT_EQ(GrblText{nullptr}.line_in_program(7), 7U);
}

}  // namespace kadr::drive::grbl_restart_test
