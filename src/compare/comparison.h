#pragma once
// Comparison: checks whether two programs do the same. Each is run by its own control, and their courses are compared step by step: the
// paths of the axes as curves (a line cut in two is still the same line), in order, with tool, feed, spindle and coolant along them, and
// what happens in between.
//
//   compare_sessions(a, b, rules)
//
// Follows both once, in constant memory; where they part, it searches for the next position that they have in common.

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "compare/course.h"

namespace kadr {

/// A piece of one of the two paths. The pieces of both come interleaved, each path in its order.
struct ComparedPiece {
  enum class Part : std::uint8_t { together, changed, apart };  // changed: on the same path, with another feed, tool …
  Part part = Part::together;
  bool of_b = false;
  bool act = false;  // something happens while the axes are at rest; reported only where it differs
  CourseMove move = CourseMove::rapid;
  Axes from{}, to{};
  Origin origin;
  std::size_t number = 0;  // index of the difference in Comparison::differences
  double distance = 0;     // CourseDifference::distance of that difference
};

struct CompareRules {
  double tolerance = 0.001;     // mm; degrees of rotary axes
  bool messages = true;         // messages to the operator are compared
  bool tools_by_hand = false;   // a tool change counts as a stop
  bool feeds_at_speed = false;  // a feed per revolution equals the feed per minute that results at the speed in force
  double feed_step = 0;         // the least increment of b's F word, mm/min or mm/rev: feeds that it cannot distinguish are equal
  std::map<std::string, double> zero_of_b{};  // mm by axis: b's control has no work offsets; the operator sets its origin here
  bool first_only = false;                    // stop at the first difference
  bool times = true;                          // fill CourseSpot::at
  std::size_t most_told = 1000;               // differences that are listed one by one
  StopToken stop{};
  std::function<void(const ComparedPiece&)> on_piece{};  // called while both are followed
};

/// A position in one of the two programs.
struct CourseSpot {
  Origin origin;       // of what comes next there
  std::string file{};  // the file of that line, if it is not the program itself
  double at = 0;       // s since the start, as programmed; 0 if the rules want no times
  Axes stand{};        // machine coordinates, in the order of Comparison::axes
};

struct CourseDifference {
  enum class Kind : std::uint8_t { way, move, feed, tool, spindle, coolant, corners, act, end };
  Kind kind = Kind::way;
  CourseSpot a, b;             // where it begins
  CourseSpot a_to, b_to;       // where both do the same again
  double distance = 0;         // mm, for a path: the greatest distance of a vertex of either from the other's path in this difference
  Axes a_far{}, b_far{};       // the positions of the two that are that far apart
  std::string a_says, b_says;  // values that differ: "F200", "M8"; empty if the other does not have the act
};

struct Comparison {
  bool cancelled = false;
  double greatest = 0;                                        // mm, where both follow the same path
  std::size_t moves_a = 0, moves_b = 0;                       // blocks that move
  std::vector<std::string> axes;                              // names
  std::vector<CourseDifference> differences;                  // in the order of the programs
  std::size_t more = 0;                                       // number of differences that are not listed
  std::optional<AlarmReport> stopped_a, stopped_b;            // the alarm that stopped it; nothing is known of what would follow
  std::vector<std::string> read_a, read_b;                    // files that they have called
  std::map<std::uint16_t, std::string> files_a{}, files_b{};  // by Origin::file: the files of the pieces, except the programs themselves
  Vec3 zero;                                                  // origin of the work system of the first cut, in machine coordinates
  std::size_t passed_messages = 0;                            // of a; ignored by the rules
  std::size_t passed_exact_stops = 0;                         // of a, if b's control has no exact stops
  bool feeds_at_speed = false;                                // somewhere the feeds were equal by CompareRules::feeds_at_speed only
  bool feeds_rounded = false;                                 // somewhere the feeds were equal by CompareRules::feed_step only
  bool lost = false;                                          // after the last difference no common position was found

  bool equal() const { return !cancelled && differences.empty(); }
};

/// Returns the names of the axes of both, each once.
std::vector<std::string> common_frame(const Session& a, const Session& b);
Comparison compare_sessions(std::unique_ptr<Session> a, std::unique_ptr<Session> b, const CompareRules& rules);

/// Returns what happens as words that users of any control understand: "F200", "S1200 M3", ….
std::string text_of(const CourseAct& act);

}  // namespace kadr
