#pragma once
// Comparison: checks whether two programs, a and b, do the same. Each program is run by its own control, and their courses (compare/course)
// are compared step by step. Compared are the paths of the axes as curves (a line cut in two is still the same line), in order; tool, feed,
// spindle and coolant along the paths; and the acts between the motions.
//
//   compare_sessions(a, b, rules)
//
// The comparison follows both courses once, in constant memory. Where the courses separate, it searches for the next position at which both
// do the same again.

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "compare/course.h"

namespace kadr {

/// A straight segment of the path of program a or b. Segments of a and b arrive interleaved; the segments of each program arrive in order.
struct ComparedPiece {
  // changed: both programs follow the same path, but with another feed, tool …
  enum class Part : std::uint8_t { together, changed, apart };
  Part part = Part::together;
  bool of_b = false;
  bool act = false;  // true for an act while the axes are at rest (dwell, message …); only acts that differ are sent
  CourseMove move = CourseMove::rapid;
  Axes from{}, to{};
  Origin origin;
  std::size_t number = 0;  // index, in Comparison::differences, of the difference that contains the segment
  double distance = 0;     // distance between the paths in this difference, mm (CourseDifference::distance)
};

struct CompareRules {
  double tolerance = 0.001;  // permitted distance between the paths, mm (degrees for rotary axes)
  double chord = 0;          // greatest deviation of the straight segments from a curved path, mm; 0: a small part of the tolerance
  bool messages = true;      // true: messages to the operator are compared
  // True if both programs are of the same control: even what depends on the machine is compared, that is, which tool is made ready, and
  // spindle and coolant at a tool change and at the end
  bool same_control = false;
  bool tools_by_hand = false;  // true if a tool change counts as a program stop at which the operator changes the tool
  // True if a feed per revolution counts as equal to the feed per minute that it gives at the spindle speed in force
  bool feeds_at_speed = false;
  // Least increment of b's F word, mm/min or mm/rev; feeds count as equal if they differ only by the rounding to this increment
  double feed_step = 0;
  // Work origin that the operator sets, mm, by axis name; used if b's control has no work offsets
  std::map<std::string, double> zero_of_b{};
  bool first_only = false;          // true: the comparison stops at the first difference
  bool times = true;                // compute CourseSpot::at
  std::size_t max_reported = 1000;  // greatest number of differences in Comparison::differences; further differences are only counted
  StopToken stop{};
  // A function of the client that changes the course of a (Course::change_items), so that the comparison expects the changed program;
  // empty: b is expected to do what a does
  std::function<void(ItemRing& from, ItemRing& to)> expected_of_a{};
  // A function of the client that receives each segment while the paths are compared
  std::function<void(const ComparedPiece&)> on_piece{};
};

/// A position in the course of one of the two programs.
struct CourseSpot {
  Origin origin;       // block that is executed next at this position
  std::string file{};  // name of the called file that contains the block; empty: the block is in the program itself
  double at = 0;       // programmed time since the start, s; 0 if CompareRules::times is false
  Axes stand{};        // axis positions in machine coordinates, in the order of Comparison::axes
};

struct CourseDifference {
  enum class Kind : std::uint8_t { path, move, feed, tool, spindle, coolant, corners, act, end };
  Kind kind = Kind::path;
  CourseSpot a, b;        // positions at which the difference begins in each program
  CourseSpot a_to, b_to;  // positions at which the difference ends: both programs do the same again from there
  // Greatest distance of a vertex of one path from the other path within this difference, mm; only for a difference of paths
  double distance = 0;
  Axes a_far{}, b_far{};         // axis positions, on the paths of a and b, between which `distance` was measured
  std::string a_value, b_value;  // the values that differ: "F200", "M8"; empty for the program that lacks the act
};

struct Comparison {
  bool cancelled = false;
  double greatest = 0;                              // greatest distance between the paths where both programs follow the same path, mm
  std::size_t moves_a = 0, moves_b = 0;             // number of blocks of the program that move axes
  std::vector<std::string> axes;                    // axis names
  std::vector<CourseDifference> differences;        // the differences, in the order of the programs
  std::size_t more = 0;                             // number of further differences that are not listed
  std::optional<AlarmReport> stopped_a, stopped_b;  // alarm that stopped the program; the comparison ends at the block of this alarm
  std::vector<std::string> read_a, read_b;          // names of the files that each program called
  // Names of the called files from which segments come, by the number of the file (Origin::file)
  std::map<std::uint16_t, std::string> files_a{}, files_b{};
  // Origin of the work system in which the first cut is made, in machine coordinates.
  Vec3 zero;
  std::size_t passed_messages = 0;     // number of messages of a that the rules exclude from the comparison
  std::size_t passed_exact_stops = 0;  // number of exact stops of a that were not compared, because b's control has no exact stops
  // True if at least one pair of feeds was equal only because of CompareRules::feeds_at_speed.
  bool feeds_at_speed = false;
  // True if at least one pair of feeds was equal only because of CompareRules::feed_step.
  bool feeds_rounded = false;
  bool lost = false;  // true if, after the last difference, no position was found at which both programs do the same again

  bool equal() const { return !cancelled && differences.empty(); }
};

/// Returns the names of the axes of both sessions, each name once.
std::vector<std::string> common_frame(const Session& a, const Session& b);
Comparison compare_sessions(std::unique_ptr<Session> a, std::unique_ptr<Session> b, const CompareRules& rules);

/// Describes an act in words that users of any control understand: "F200", "S1200 M3", ….
std::string text_of(const CourseEvent& act);

}  // namespace kadr
