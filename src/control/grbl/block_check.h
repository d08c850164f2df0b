#pragma once
// Checks all words of a block before any word is executed, in the order of Grbl's source gcode.c (spec/grbl 1.3, 3, 4). The first fault in
// that order is reported.

#include <cstdint>
#include <optional>

#include "base/code_literals.h"
#include "base/result.h"
#include "base/vec.h"
#include "control/block/arc.h"
#include "control/grbl/float32_state.h"

namespace kadr {
class BlockContext;
}

namespace kadr::grbl {

class Grbl;

/// The kinds of codes that use the axis words (spec/grbl 3).
enum class AxisCommand : std::uint8_t { none, offsets, motion, length };

/// The meaning of a block. It is determined before any part of the block is executed. Codes are in tenths: G28.1 is 281; -1 means that the
/// block has no such code.
struct CheckedBlock {
  std::int32_t non_modal = -1;  // the block's code from the list G4 G10 G28 G28.1 G30 G30.1 G53 G92 G92.1
  std::int32_t motion = -1;     // motion code of the block, or the motion code in force if the block has none; no_motion: G80
  AxisCommand axis_command = AxisCommand::none;
  bool has_axis = false;
  bool moves = false;  // true: the motion code of the block, or the one in force, moves the tool
  bool inch = false, absolute = true, inverse_time = false;
  std::int32_t plane = 17_g;
  std::int32_t system = -1;       // the block's code from the list G54 … G59
  Axes start{};                   // start point, programmed coordinates in the block's work system
  Axes target{};                  // end point, programmed coordinates; with G53, machine coordinates
  std::optional<PlaneArc> arc;    // arc of G2, G3; nullopt: a straight line, or an arc that is too short to be divided into segments
  int segments = 0;               // number of straight segments into which Grbl divides the arc
  Float32Triple single_target{};  // the end point `target` in machine coordinates, as Grbl's 32-bit numbers
};

/// Returns the whole part of a number modulo 256. This is the value that gcode.c stores for G, M, L, and for P of G10.
inline std::int32_t byte_of(double value) { return static_cast<std::uint8_t>(static_cast<std::int64_t>(value)); }

/// Checks the interpreter's block. `is_jog`: the block consists of the words of a `$J=` line (9). `parted`: receives the warning that the
/// exact arc differs from Grbl's 32-bit arc, even if the block is not valid.
///   alarms  those of the reader; code_unknown, word_not_integer, group_conflict, not_together, address_twice, value_below_zero,
///           tool_number_large, block_number_large, feed_missing, word_missing, length_axis_wrong, no_axis_word, system_number_large,
///           illegal_address, machine_motion_mode, no_motion_mode, arc_without_plane_word, full_circle_by_radius, radius_too_small,
///           center_missing, radius_mismatch, probe_too_close, word_unused, jog_code, limit_exceeded
Result<CheckedBlock> check(const BlockContext& m, const Grbl& control, bool is_jog, std::optional<Alarm>& parted);

/// Checks that every segment of the motion ends within the travel of the axes, if soft limits ($20) are on (8).
///   alarms  limit_exceeded; jog_target for a jog
Status within_travel(const BlockContext& m, const Grbl& control, const CheckedBlock& block, bool is_jog);

}  // namespace kadr::grbl
