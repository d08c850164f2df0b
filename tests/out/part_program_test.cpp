// Part programs: the words of each control, and the same path when the control's interpreter reads the program.

#include "out/program/part_program.h"

#include <gtest/gtest.h>

#include <cmath>

#include "config/control/control_file.h"
#include "session/program_moves.h"

namespace kadr::part_program_test {
namespace {

using area::Move;
using area::MoveKind;

const std::vector<Move> moves{{MoveKind::rapid, {10, 0, 5}},
                              {MoveKind::plunge, {10, 0, -1.5}},
                              {MoveKind::feed, {0, 10, -1.5}, std::tan(pi / 8)},
                              {MoveKind::feed, {-10.0004, 10, -1.5}},
                              {MoveKind::rapid, {-10.0004, 10, 5}}};
const Technology technology{240, 80, 800, 3, false, "", ""};

std::string program_of(const char* control) {
  const auto def = load_control(control);
  const auto program = part_program(*def, moves, technology);
  return program ? program->text : std::string(name_of(program.error().id));
}

TEST(PartProgram, IntegersOfTheIncrementAndAbsoluteCentres) {
  EXPECT_EQ(program_of("s2c42"),
            "%\nN10 G17 G90\nN20 T3 M6\nN30 S800 M3\nN40 G0 Z5000\nN50 X10000 Y0\nN60 G1 Z-1500 F80\nN70 G3 X0 Y10000 I0 J0 F240\n"
            "N80 G1 X-10000\nN90 G0 Z5000\nN100 M5\nN110 M2\n");
}

TEST(PartProgram, PointsAndCentresFromTheStart) {
  EXPECT_EQ(
      program_of("mach3"),
      "N10 G17 G90\nN20 G21 G94 G91.1\nN30 T3 M6\nN40 S800 M3\nN50 G0 Z5.\nN60 X10. Y0.\nN70 G1 Z-1.5 F80\nN80 G3 X0. Y10. I-10. J0. F240\n"
      "N90 G1 X-10.\nN100 G0 Z5.\nN110 M5\nN120 M2\n");
}

TEST(PartProgram, ToolAndCorrectorInOneWord) { EXPECT_NE(program_of("correctors").find("T303 M6"), std::string::npos); }

/// Without a point the feed would be in thousandths (spec/haas 1.2), in inches in hundredths (spec/fanuc 1.3).
TEST(PartProgram, FeedsKeepTheirPointWhereTheControlCountsIncrements) {
  EXPECT_NE(program_of("haas").find(" F240.\n"), std::string::npos);
  EXPECT_NE(program_of("fanuc").find(" F240.\n"), std::string::npos);
  EXPECT_NE(program_of("nct").find(" F240\n"), std::string::npos);
}

TEST(PartProgram, EveryControlReadsItBack) {
  for (const std::string& id : built_in_controls()) {
    const auto def = load_control(id);
    if (def->behaviour.lathe != Lathe::none) continue;  // kadr mill writes no programs for lathes
    const auto program = part_program(*def, moves, technology);
    ASSERT_TRUE(program) << id;
    const auto read = program_moves(*def, program->text);
    ASSERT_TRUE(read) << id << ' ' << name_of(read.error().id) << '\n' << program->text;
    EXPECT_TRUE(same_moves(program->moves, *read)) << id;
    std::vector<Move> other = *read;
    other[2].to.x += 0.001;
    EXPECT_FALSE(same_moves(program->moves, other)) << id;
  }
}

TEST(PartProgram, WordsWithoutRoomAreRefused) {
  const auto def = load_control("s2c42");
  const auto program = part_program(*def, {{MoveKind::rapid, {10'000, 0, 5}}}, technology);
  ASSERT_FALSE(program);
  EXPECT_EQ(program.error().id, AlarmId::word_has_no_room);
}

TEST(PartProgram, ArcsBeyondTheToleranceBecomeLines) {
  const auto def = parse_control("extends = \"s2c42\"\nid = \"coarse\"\n[behaviour]\narc_radius_difference = 0.0005\n", "coarse.toml");
  ASSERT_TRUE(def);
  const std::vector<Move> arc{{MoveKind::rapid, {0, 0, 5}}, {MoveKind::feed, {7.3333, 3.1111, 5}, 0.3}};
  const auto program = part_program(*def, arc, technology);
  ASSERT_TRUE(program);
  EXPECT_EQ(program->text.find("G3"), std::string::npos);
  EXPECT_GT(program->moves.size(), 5U);
}

}  // namespace
}  // namespace kadr::part_program_test
