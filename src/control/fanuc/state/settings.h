#pragma once
// Settings of axes, frames, spindles and cycles, derived from the parameters (spec/nct, the parameter tables of each chapter) in the form
// that the interpreter uses. A write to a parameter derives them again. Macros have settings of their own:
// control/macro_b/variables/settings.h.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "action/action.h"
#include "base/vec.h"
#include "config/control/code_system.h"
#include "control/macro_b/variables/settings.h"
#include "kinematics/five_axis.h"

namespace kadr::fanuc {

inline constexpr std::size_t max_spindles = 16;

struct AxisSettings {
  bool diameter = false;              // N0106 #0 DIA: the axis is in diameter programming at power-on
  bool switches_by_code = false;      // N0106 #5 MGD: G10.9 may switch diameter programming
  int role = 0;                       // N0103: role of the axis: 1, 2, 3 main axis X, Y, Z; 5, 6, 7 axis parallel to X, Y, Z; 0 neither
  bool rolls = false;                 // N0107 #0 REN: a rotary axis whose position restarts at 0 after each travel of `period` degrees
  bool shortest = false;              // N0107 #1 ASH: in an absolute motion the rotary axis turns in the shorter direction
  bool by_sign = false;               // N0107 #2 ABS: the sign of an absolute value gives the direction in which the rotary axis turns
  bool cuts_turns = false;            // N0107, a bit that 5.6 does not name: a rotary axis drops the full revolutions of an increment
  double period = 360;                // N0108 RollAmount: travel in degrees after which the axis position restarts at 0
  double polar_offset = 0;            // N0217: perpendicular offset of the rotation centre in G12.1, mm
  double feed_most = 0;               // N0305 Max Feed: highest feed of the axis, mm/min or degrees/min; 0: no limit
  std::array<double, 4> reference{};  // N0200 … N0203: reference points, machine coordinates; 0 means the point that the set-up gives
};

struct SpindleSettings {
  bool orients = false;                 // N0607 #1 ORI: M19 can orient the spindle
  bool indexes = false;                 // N0607 #2 INX: the position loop of the spindle can be closed
  bool index_negative = false;          // N0607 #7 IDS: indexing turns the spindle in the negative direction
  int m_low = 0, m_high = 0;            // N0689, N0690: first and last optional M code of the spindle; 0: none
  int index_from = 0, index_count = 0;  // N0820, N0821: first M code that indexes the spindle, and number of such codes
  double index_angle = 0;               // N0822: angle in degrees by which one step of indexing turns the spindle
  int closing_code = 0;                 // N0823: M code that closes the position loop of the spindle
};

/// The settings of a lathe (spec/fanuc-t 13, spec/haas-st 11). Lengths are in mm; those along X are radii.
struct LatheSettings {
  bool is_lathe = false;
  bool is_haas = false;                // the lathe has a control of Haas, whose words and cycles differ (spec/haas-st)
  bool is_yasnac = false;              // Haas setting 33 is 2: R1 of G71 and G72 means pockets (spec/haas-st 6.2)
  bool inch_at_start = false;          // Haas setting 9: G20 is in force at power-on
  bool corners_without_comma = false;  // 3405#4 CCR: C, R, A of G1 mean ,C ,R ,A
  bool offset_ends = false;            // 5003#6 LVC: a reset ends the tool offset
  // 5028, 5002#0 LD1: ten to the power of the number of digits of the offset in T
  std::uint32_t offset_numbers = 100;
  bool geometry_by_tool = false;     // 5002#1 LGN: the geometry offset has the number of the tool, not of the offset
  bool wear_shifts = false;          // 5002#2 LWT: the wear shifts the work system; false: the axes move by it
  bool geometry_moves = false;       // 5002#4 LGT: the axes move by the geometry; false: it shifts the work system
  bool wear_waits = false;           // 5002#6 LWM: the axes move by the wear with the next motion, not in the block of T
  bool offsets_are_radii = false;    // 5004#1 ORC: the offsets of X that a program reads and writes are radii, not diameters
  bool pecks_to_level = false;       // 5101#2 RTR: between the pecks of G83 and G87 the tool returns to R
  bool level_is_diameter = false;    // 5102#7 RDI: R of drilling along X is a diameter
  bool level_is_position = false;    // 5102#6 RAB, with 0001#1 FCV: R of drilling is a coordinate, not a distance
  bool tool_changer = false;         // 5040#3 TCT: the lathe has a tool changer, so that G49 is a code
  double turret_distance = 0;        // 1290: shift of X in G68, mm, as a radius
  bool feed_per_minute = false;      // 3402#4 FPM: the feed per minute is in force at power-on
  double boring_back_percent = 100;  // 5121: feed of the way back of G85 and G89, % of F
  int clamp_code = 0;                // 5110: M code that clamps the C axis for drilling; 0: none
  double release_dwell = 0;          // 5111: dwell after the C axis is released, s
  double run_out = 0;                // 5130: length of a thread's run-out, in leads
  double run_out_angle = 45;         // 5131: angle of the run-out to the axis of the thread, degrees
};

/// Parameters of Fanuc's multiple repetitive turning cycles (spec/fanuc-t 9, 13). Lengths in mm; depths are radii.
struct RepetitiveSettings {
  double depth = 0, back = 0;      // 5132, 5133: depth of a pass and escape of G71, G72
  double clearance = 0;            // 5134: clearance before a pocket
  Vec2 relief;                     // 5136, 5135: shift of the first pass of G73 along the first and the second axis
  double passes = 0;               // 5137: number of passes of G73
  Vec2 reversal;                   // 5145, 5146: by how much the first and the second axis of a figure may reverse
  bool leaves_out_first = false;   // 5105#1 RF1: type I without the pass along the figure
  bool leaves_out_second = false;  // 5105#2 RF2: type II without it
};

/// The settings of axes, spindles, canned cycles and five-axis functions.
struct Settings {
  LatheSettings lathe;
  std::array<AxisSettings, max_axes> axes;                 // settings of each axis, by index of the axis in the channel
  std::array<SpindleSettings, max_spindles + 1> spindles;  // settings of each spindle, by spindle number
  // interpretation
  double radius_difference = 0.01;  // N1339: permitted difference of an arc's two radii, mm; infinite: no check (spec/fanuc 3.2)
  // greatest permitted excess in mm of an arc's chord over 2R; a longer chord is an error even if radius_difference turns its check off
  double radius_shortfall = 0.01;
  bool dwell_seconds = false;     // N1337 #1 SEC: a dwell is in seconds even in G95
  bool centers_absolute = false;  // N1337 #2 CCA: I, J, K of an arc are absolute coordinates
  bool feed_along_helix = false;  // N1337 #3 HEF: the feed of a helix is along all axes, not only along the arc
  // N1300: for each of the codes G01 G18 G19 G20 G22 or G23 G43 G44 G91, whether the code is in force at power-on
  std::array<bool, 8> default_1{};
  bool default_per_rev = false;            // N1301 #0: G95 (feed per revolution) is in force at power-on
  bool keeps_codes = false;                // N1301 CLR: a reset keeps the codes of the modal groups in kept_groups
  std::array<bool, 40> kept_groups{};      // CLR G Table, bits Cnn: numbers of the modal groups whose code a reset keeps
  bool in_position_check = false;          // N1337 PCH: rapid motions end with an in-position check
  bool length_of_block = false;            // 5001#0: the tool length acts on the axes that the block names (spec/fanuc 7.1)
  bool arc_without_data_straight = false;  // 3403#5 is 0: an arc without R and centre is executed as a line (spec/fanuc 3.2)
  bool angles_from_minus = false;          // 6004#0: ATAN gives -180 to 180 degrees, not 0 to 360 (spec/fanuc 5.3)
  bool offsets_are_diameters = false;      // setting 40: the operator enters tool radii as diameters (spec/haas 2.4)
  double return_rise = 0;                  // setting 52: height in mm above R to which the tool returns between pecks (spec/haas 8.3)
  bool taps_rigid = false;                 // 5200#0: G84 and G74 always tap rigidly (spec/fanuc 10.4)
  bool drills_across = false;              // 5101#0: drilling is normal to the plane, not always along Z (spec/fanuc 10.1)
  double scale_unit = 1;                   // 5400#7: unit of the scale factor P of G51 if P has no decimal point (spec/fanuc 6.9)
  bool scale_each = false;                 // 5400#6: G51 may give a scale factor for each axis, by I J K (spec/fanuc 6.9)
  double scale_usual = 0;                  // 5411 (spec/fanuc 6.9), setting 71 (spec/haas 6.3): scale factor of G51 without P; 0: no factor
  // 5400#0 (spec/fanuc 6.8), setting 73 (spec/haas 6.2): in G91 the rotation angle R of G68 is an increment
  bool rotation_adds = false;
  double rotation_usual = 0;    // 5410 (Fanuc), setting 72 (Haas): rotation angle in degrees of G68 without R
  bool holes_exact = false;     // setting 57: the tool stops exactly over each hole (spec/haas 8.1)
  bool length_of_tool = false;  // setting 15: word H must be the number of the tool in the spindle (spec/haas 10)
  // setting 27: direction in which G76 and G87 shift the tool at the bottom: X+, X-, Y+, Y- as 0 … 3 (spec/haas 8.6)
  int shift_direction = 0;
  bool shift_is_global = false;         // setting 33 is 1: a reset keeps the shift of G52 (spec/haas 5.3)
  unsigned mirrored = 0;                // settings 45 to 48: mirrored axes, one bit per axis (spec/haas 6.1)
  bool feed_counts_increments = false;  // setting 77 is 0: F without a decimal point counts least increments of a length (spec/haas 1.2)
  bool feed_whole = false;              // setting 77 is 1: F without a decimal point is a whole number
  bool feed_in_thousandths = false;     // 1403#0: a feed per minute F without a decimal point counts in units of 0.001 (spec/fanuc 1.3)
  bool shift_negative = false;          // 5101#4: G76 and G87 shift the tool in the negative direction of an axis (spec/fanuc 10.5)
  bool shift_second = false;            // 5101#5: G76 and G87 shift the tool along the second axis of the plane (spec/fanuc 10.5)
  // N1416: axes on which the tool length acts; 0: the axes that the block names, 1: Z, 2: the plane's normal
  int length_axes = 0;
  bool turning_offsets = false;          // N1416 #2 TOL: the offset table for turning is in use
  CompensationCheck compensation_check;  // N1403 … N1405: settings of cutter compensation
  bool skip_breaks_compensation = true;  // N1337 #4 CBB is 0: a block with / interrupts cutter compensation (15.5.2)
  // 5003#0 SUP: start-up type A (square) or B (by_corner) (spec/fanuc 7.3, spec/fanuc-t 7.3); INFERRED: #1 SUV is not read there
  CompensationApproach approach = CompensationApproach::by_corner;
  bool approach_own_block = false;  // 5003#1 SUV: start-up of type C, which Kadr does not have
  // true: a lathe. G41 and G42 without a motion start compensation in the next motion, and turning cycles compensate (spec/fanuc-t 7)
  bool compensates_nose = false;
  // the two bits that decide which positions system variables report
  bool without_length = false;  // N1755 #6 TLC: system variables report positions without the tool length
  bool in_frame = false;        // N1755 #5 PCS: system variables report positions in the programming frame
  // M codes, spindles
  std::array<std::pair<int, int>, 16> m_groups{};  // N1341…, N1357…: first and last code of each exclusive group of M codes
  int part_code = 0;                               // N2305: M code that counts a part; 0: the end of the program counts a part
  int offset_numbers = 999;                        // N1400: greatest offset number of H and D; 0: no limit
  // N1338 #0 M06: in a block search, M6 changes the tool; INFERRED: the bit has no effect outside the block search
  bool change_on_m6 = true;
  int default_spindle = 0;   // N0604: number of the spindle to which S without a number refers
  double surface_speed = 0;  // N0686: constant surface speed of G96 at power-on, m/min
  // N0687: at power-on, number of the axis whose position is the diameter for G96; the count includes the axes of all channels
  int css_axis = 0;
  double min_css_speed = 0;  // N0688: lowest spindle speed in G96, rev/min
  // cycles, measuring (18, 21)
  double return_g73 = 0, clearance_g83 = 0;  // N1500, N1501: distances in mm of the pecking cycles: retract of G73, clearance of G83
  double extraction = 0;                     // N1502: feed of the retract from the hole in % of the programmed feed
  bool lathe_codes = false;                  // N1503 CSM: the codes of lathes G83.1, G84.1, G86.1 replace the drilling cycles G73, G74, G76
  bool tap_orients = false;                  // N1503 TSC: M19 orients the spindle before rigid tapping
  bool tap_normal = false;                   // N1503 #3 PTC: between pecks the tap returns to the R level
  bool tap_override = false;                 // N1503 #4 EOE: in rigid tapping, word I or N1506 sets the feed of the retract
  // N1503 #5 ROE: in rigid tapping with pecks, N1507 sets the feed of the tap's return to the R level
  bool tap_return_override = false;
  // N1504, N1505: distances in mm of a tap between pecks, without and with return to R; N1506, N1507: feeds of its retract and of its
  // return to R, in % of the programmed feed
  double tap_back = 0, tap_clearance = 0, tap_extraction = 0, tap_return = 0;
  bool measure_parameter_feed = false;  // N3001 #0 SKF: G31 measures with the feed of N0311, not with the feed in force
  bool length_parameter_feed = false;   // N3003 #0 TLF: G37 measures with the feed of N0312, not with the feed in force
  // N3003 #1 TMW: G37 corrects the wear of the tool length; false: G37 corrects the geometry value
  bool length_wear = false;
  // N3003 #2 TCA: G37 adds the measured difference to the tool length; false: G37 subtracts the difference
  bool length_adds = false;
  double measure_feed = 0, length_feed = 0;   // N0311, N0312: feeds of G31 and of G37, mm/min
  double length_rapid = 0, length_alarm = 0;  // N3004, N3005: rapid distance and alarm distance of G37 from the expected position, mm
  bool torque_known = true;                   // INFERRED: the drive of an axis reports its torque, because a virtual drive always does
  RepetitiveSettings repetitive;
  // kinematics of the five axes (N3200 … N3224); the travel limits of the rotary axes come from the machine profile
  FiveAxis five_axis;
  bool keeps_linear = false;  // N3212 #7 FOS: X, Y, Z do not move in a block that moves rotary axes alone
  bool tilts_tool = false;    // N3212 #4 BSE: the basic rotation of the work system tilts the tool
  double accuracy = 0;        // N3103: displacement in mm up to which short straight motions are joined to one motion
};

/// Reads all settings. `axis_numbers`: numbers of the channel's axes; the numbering includes the axes of all channels. `axis_names` (X, Y,
/// Z, …) determine the role of an axis for which N0103 gives none. `lathe`: the manner in which the control reads lathe programs.
Settings read_settings(const macro_b::ParameterSource& source, const std::vector<std::string>& axis_names,
                       const std::array<std::uint8_t, max_axes>& axis_numbers, Lathe lathe);

}  // namespace kadr::fanuc
