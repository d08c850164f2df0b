#pragma once
// GrblReply: one line that a controller of the Grbl family sends, as a value. The forms are those of report.c of Grbl 1.1h: answers to
// lines (`ok`, `error:20`), alarms, status reports, settings, messages in square brackets, and the banner after a reset. A line with any
// other form is Unknown: a byte of it was lost or changed, or the sender is no Grbl.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace kadr::drive {

/// The state of the controller, as a status report names it. `tool` is the state of grblHAL in which it waits for a tool change.
enum class GrblState : std::uint8_t { unknown, idle, run, hold, jog, alarm, door, check, home, sleep, tool };

/// Returns the name that the controller reports: "Idle", "Run" …; "?" for `unknown`.
std::string_view name_of(GrblState state);

inline constexpr std::size_t grbl_axes = 3;
using GrblPoint = std::array<double, grbl_axes>;  // X, Y, Z

/// Free space in the controller's buffers, from the field `Bf:`.
struct GrblFree {
  int blocks = 0;  // free blocks of the planner
  int bytes = 0;   // free bytes of the receive buffer
  friend bool operator==(const GrblFree&, const GrblFree&) = default;
};

/// The overrides in percent, from the field `Ov:`.
struct GrblOverrides {
  int feed = 100, rapid = 100, spindle = 100;
};

/// A status report, `<Run|MPos:1.000,2.000,0.000|Bf:12,100|FS:500,8000>`. A field that the report does not have is nullopt.
struct GrblReport {
  GrblState state = GrblState::unknown;
  int substate = 0;                   // the number after the colon: 0 in `Hold:0`
  std::optional<GrblPoint> machine;   // machine position, in the unit that $13 selects
  std::optional<GrblPoint> work;      // work position, if the setting $10 selects it
  std::optional<GrblPoint> offset;    // difference between machine and work position (WCO)
  std::optional<GrblFree> free;       //
  std::optional<std::uint32_t> line;  // number after N of the block that is executed (Ln)
  std::optional<double> feed, speed;  // present feed, units/min, and spindle speed, rev/min
  std::string pins;                   // letters of the active inputs (Pn)
  std::optional<GrblOverrides> overrides;
};

struct GrblOk {};
struct GrblError {
  int code = 0;
};
struct GrblAlarm {
  int code = 0;
};
/// The line that a controller sends after a reset: `Grbl 1.1h ['$' for help]`.
struct GrblBanner {
  std::string version;  // "1.1h"
};
/// A setting, `$110=500.000`.
struct GrblSetting {
  int number = 0;
  double value = 0;
};
/// A line in square brackets: `[MSG:Caution: Unlocked]`, `[GC:G0 G54 …]`, `[G54:0.000,0.000,0.000]`, `[PRB:1.000,2.000,3.000:1]`.
struct GrblBracket {
  std::string tag;   // the text before the first colon
  std::string text;  // the text after it
};
/// An executed startup line, `>G54G20:ok`.
struct GrblStartup {
  std::string text;
};
struct GrblUnknown {
  std::string text;
};

using GrblReply = std::variant<GrblOk, GrblError, GrblAlarm, GrblReport, GrblBanner, GrblSetting, GrblBracket, GrblStartup, GrblUnknown>;

/// Reads a line without its end. Any text is accepted.
GrblReply grbl_reply(std::string_view line);

/// Reads three numbers separated by commas. Further numbers, of a controller with more axes, are ignored.
std::optional<GrblPoint> grbl_point(std::string_view text);

}  // namespace kadr::drive
