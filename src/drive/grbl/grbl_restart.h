#pragma once
// grbl_restart: a program for Grbl from one of its lines on. A new text is made: at its head the lines that bring the controller into the
// state that the line requires and the tool to its place; then the rest of the program. Kadr executes this text, and sends it, as any
// other.
//
//   program ──run up to the line──▶ Restart ──▶ head: offsets, speed, spindle, spin-up, way, modes
//                                                rest: the lines from there on
//
// The same is used after a tool change, after a probe motion and after motions by hand: the place is then where the job ended, and the
// offsets are those that the controller has now.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drive/grbl/grbl_settings.h"
#include "session/restart.h"

namespace kadr::drive {

/// A text of which the first lines are Kadr's.
struct GrblText {
  std::shared_ptr<ByteSource> text;
  std::uint32_t head = 0;   // number of lines of the head
  std::uint32_t first = 1;  // number, in the program, of the line after the head

  /// Returns the number of a line in the program; 0 for a line of the head.
  std::uint32_t line_in_program(std::uint32_t line) const { return line <= head ? 0 : line - head + first - 1; }
};

struct GrblRestartPlan {
  std::uint32_t line = 1;          // line of the program at which it continues
  GrblPoint from{};                // where the machine is, machine coordinates, mm
  std::optional<GrblPoint> place;  // where the tool must be; nullopt: where the program has it
  // True: nothing was reset since the lines before were executed, so that their G10, G28.1, G30.1 and G92 are in the controller.
  bool keeps_offsets = false;
  // The offsets that were in force when the tool was at `place`. If they were changed since, the place is shifted with them, because the
  // tool must come to the same point of the part.
  std::optional<GrblSettings> offsets_at_place;
  double clear = 0;              // height above which the way is free, machine coordinates, mm
  double above = 2, feed = 100;  // from this height above the place on the tool descends at this feed, mm/min
  double spin_up = 0;            // time for the spindle to reach its speed, s
};

struct GrblRestart {
  GrblText text;
  std::vector<std::string> head;  // the lines of the head
  GrblPoint place{};              // where the tool will be before the line
  std::string source;             // text of the line
};

/// Opens a session of a text for Grbl, at the beginning.
using GrblOpener = std::function<std::unique_ptr<Session>(std::shared_ptr<ByteSource>)>;

/// Returns the program from a line on, or the error sentence: no such line, an alarm before it, a state that no line can set.
tl::expected<GrblRestart, std::string> grbl_restart(const std::shared_ptr<ByteSource>& program, const GrblOpener& open,
                                                    const GrblSettings& settings, const GrblRestartPlan& plan);

/// Returns the program with M0 for each M6, which Grbl does not have: Kadr stops there, and the operator changes the tool.
///   lines  output: the lines in which this was done
///   returns  nullptr if a line both changes the tool and moves; `lines` then ends with it
std::shared_ptr<ByteSource> with_tool_stops(const std::shared_ptr<ByteSource>& program, std::vector<std::uint32_t>& lines);

}  // namespace kadr::drive
