#pragma once
// What a Sinumerik remembers between two blocks (spec/sinumerik 5, 6, 9 to 13).

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "config/setup/setup.h"
#include "control/sinumerik/value.h"
#include "control/state/control_state.h"
#include "kinematics/five_axis.h"
#include "lang/block/block.h"
#include "lang/named/named_macros.h"

namespace kadr::sinumerik {

inline constexpr std::size_t parameter_count = 300;  // R0 to R299 (MD28050)
inline constexpr std::size_t settable_frames = 100;  // G500, G54 to G57, G505 to G599

/// Rows of Tables::offsets: those below tool_rows are edge 1 of the tool with this number; edge e of tool t is row 1000 e + t.
inline constexpr std::uint32_t tool_rows = 1000;
inline constexpr std::uint32_t most_edges = 9;
constexpr std::uint32_t edge_row(std::uint32_t tool, std::uint32_t edge) { return edge <= 1 ? tool : tool_rows * edge + tool; }

using Variables = std::map<std::string, std::shared_ptr<Variable>>;

/// MCALL: the program that is called after each block with path motion (spec/sinumerik 9.3).
struct ModalCall {
  std::string name;
  std::vector<Value> arguments;
};

/// The arguments of a call. `references`: for VAR, the caller's variables; nullptr: the argument is no variable.
struct CallArguments {
  std::vector<Value> values;
  std::vector<std::shared_ptr<Variable>> references;
};

/// A program that is being executed: the main program, or a subprogram.
struct Level {
  std::string name;
  Variables variables;                                // of DEF and PROC
  std::vector<Value> arguments;                       // of the call, for PROC
  std::vector<std::shared_ptr<Variable>> references;  // for VAR: the caller's variables; nullptr: the argument is no variable
  bool has_arguments = false;
  bool took_arguments = false;  // PROC was executed
  bool acted = false;           // a word, a jump or a call has been executed: DEF is too late
  bool executing = false;       // a block other than PROC, EXTERN and DEF has been executed
  std::optional<Modal> saved;   // SAVE: the modes at the call
  Frame saved_frame;
  std::optional<ModalCall> modal_call;
};

/// REPEAT LABEL: the part of the program that is repeated, and the number of calls that were open.
struct RepeatedPart {
  Position begin, end;
  std::size_t depth = 0;
};

/// HOLES1 and other patterns with MCALL of a program: the positions that follow, and the number of calls that were open.
struct Pattern {
  std::vector<Vec2> at;
  std::size_t next = 0;
  std::size_t depth = 0;
};

/// The motion of group 1 that is no G code of the table.
enum class NamedMotion : std::uint8_t { none, through_point, tangent, thread };

/// Where the feed holds on an arc under G41, G42: at the contour, on the path of the tool's centre, or at the contour on the inside only
/// (spec/sinumerik 13.2).
enum class ArcFeed : std::uint8_t { contour, centre, inside };

/// The modes that are values of a fixed size: a block that fails gets all of them back.
struct Modes {
  std::optional<Position> counts_on;       // ENDFOR has jumped to the FOR at this position, which counts on
  Frame active;                            // the settable frame that the last G54 put in force
  Frame swivel;                            // CYCLE800: between the settable and the programmable frame
  bool holds_tip = false;                  // TRAORI: the words of X, Y, Z are the tip, whatever the rotary axes do
  std::optional<RotaryPair> swivelled_to;  // CYCLE800: positions of the rotary axes, if the machine has them
  Frame programmable;                      // TRANS, ROT …
  bool in_space = false;                   // swivel and programmable frame turn in space: the placement has them, not the transformation
  NamedMotion motion = NamedMotion::none;
  Vec2 pole;  // in the plane, programmed coordinates
  double polar_angle = 0, polar_radius = 0;
  double rounding = 0;                      // RNDM
  double corner_feed = 0;                   // FRCM; 0: the feed of the block
  std::uint32_t edge = 0;                   // D in force
  bool radius_increments = false;           // DIAM90: increments of the axis of diameters are radii
  Axes positioning_feed{};                  // FA, mm/min or degrees/min; 0: rapid
  double tolerance = 0;                     // CTOL, CYCLE832: of G642 to G645, mm; 0: none
  std::array<double, 10> speeds{};          // S2=, S3= …, rev/min, by the number of the spindle
  std::array<SpindleDir, 10> directions{};  // M2=, M3= …
  double normal_offset = 0;                 // OFFN, mm
  bool goes_around = false;                 // KONT; false: NORM
  ArcFeed arc_feed = ArcFeed::contour;      // CFC, CFTCP, CFIN
  Axes area_least{}, area_most{};           // G25, G26: the working area, basic coordinates, mm
  AxisMask area_below = 0, area_above = 0;  // axes with such a limit
  bool area_watched = true;                 // WALIMON
  bool approach_in_plane = false;           // G341; false: G340
  double override_percent = 100;            // OVR
  double surface_most = 0;                  // LIMS, rev/min; 0: none
  double speed_least = 0, speed_most = 0;   // G25 S, G26 S, rev/min; 0: none
  bool feed_in_mm = false;                  // G70: words of axes are in inches, F is in mm
  Vec2 direction;                           // of the last motion at its end, in the plane of that motion, programmed coordinates
  PlaneAxes direction_plane;
  bool has_direction = false;
};

/// MEAS: where the probe has touched, or the motion has ended without a touch (spec/sinumerik 17).
struct Measured {
  static constexpr int probes = 2;
  std::array<bool, probes> touched{};  // $AC_MEA[n]
  int probe = 0;                       // number of the probe of the last MEAS
  Axes work{}, machine{};              // $AA_MW, $AA_MM
};

struct Memory : Modes {
  std::array<double, parameter_count> parameters{};
  std::vector<Level> levels{1};
  Variables globals;            // global data (GUD) of the definition files
  NamedMacros macros;           // DEFINE, of the program and the definition files
  bool globals_loaded = false;  // the definition files were looked for
  std::vector<RepeatedPart> repeated;
  std::optional<Pattern> pattern;
  std::vector<Frame> settable = std::vector<Frame>(settable_frames);
  std::map<std::pair<std::uint32_t, std::uint32_t>, ToolOffset> edges;  // of $TC_DP: {tool, edge}; edge 1 is in Tables::offsets too
  std::map<std::pair<std::string, int>, double> stored;                 // $AC_MARKER[n], $AC_PARAM[n]
  std::map<std::string, std::uint32_t> tools;                           // names of T="…"
  Measured measured;
};

/// Returns a copy whose variables are not shared with the original; references stay references among the copied levels.
Memory separate_copy(const Memory& memory);

}  // namespace kadr::sinumerik
