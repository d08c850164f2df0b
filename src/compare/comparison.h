#pragma once
// Comparison: do two programs do the same? Their courses side by side, each run by its own control: the ways of the axes as curves (a line
// cut in two is the same line), in their order, with tool, feed, spindle and coolant along them, and what happens between.
//
//   compare_courses(a, b, rules)
//
// Goes along both once, in constant memory; where they part it looks for the next place that they have in common.

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "compare/course.h"

namespace kadr {

/// A piece of one of the two ways. Those of both come in turn, each in its order.
struct ComparedPiece {
  enum class Part : std::uint8_t { together, changed, apart };  // changed: together, with another feed, tool …
  Part part = Part::together;
  bool of_b = false;
  bool act = false;  // something is done where the axes stand; told only where it differs
  CourseMove move = CourseMove::rapid;
  Axes from{}, to{};
  Origin origin;
  std::size_t number = 0;  // of the difference, from 0 on in the order of Comparison::differences
  double distance = 0;     // of that difference
};

struct CompareRules {
  double tolerance = 0.001;     // mm; degrees of rotary axes
  bool messages = true;         // what is shown to the operator counts
  bool tools_by_hand = false;   // a change of the tool is the same as a stop
  bool feeds_at_speed = false;  // a feed per revolution is the same as what it makes per minute at the speed in force
  double feed_step = 0;         // the least increment of b's F word, mm/min or mm/rev: feeds that it cannot tell apart are the same
  std::map<std::string, double> zero_of_b{};  // mm by axis: b's control has no work zeros, the operator sets it to count from there
  bool first_only = false;                    // it is over with the first difference
  bool times = true;                          // CourseSpot::at is told
  std::size_t most_told = 1000;               // differences that are told one by one
  StopToken stop{};
  std::function<void(const ComparedPiece&)> on_piece{};  // called as both are gone along
};

/// A place of one of the two.
struct CourseSpot {
  Origin origin;       // of what comes next there
  std::string file{};  // that its line stands in, if that is not the program itself
  double at = 0;       // s since the start, as programmed; 0 where the rules want no times
  Axes stand{};        // machine coordinates, in the order of Comparison::axes
};

struct CourseDifference {
  enum class Kind : std::uint8_t { way, move, feed, tool, spindle, coolant, corners, act, end };
  Kind kind = Kind::way;
  CourseSpot a, b;             // where it begins
  CourseSpot a_to, b_to;       // where both do the same again
  double distance = 0;         // mm, of a way: the farthest that a vertex of either is from the other's way meanwhile
  Axes a_far{}, b_far{};       // places of the two that are so far apart
  std::string a_says, b_says;  // values of what differs: "F200", "M8"; of an act that the other has not the other is empty
};

struct Comparison {
  bool cancelled = false;
  double greatest = 0;                                        // mm, where both go together
  std::size_t moves_a = 0, moves_b = 0;                       // blocks that move
  std::vector<std::string> axes;                              // names
  std::vector<CourseDifference> differences;                  // in the order of the programs
  std::size_t more = 0;                                       // that are not told one by one
  std::optional<AlarmReport> stopped_a, stopped_b;            // the alarm that it has stopped by: nothing is known of what would follow
  std::vector<std::string> read_a, read_b;                    // files that they have called
  std::map<std::uint16_t, std::string> files_a{}, files_b{};  // by Origin::file: those that pieces stand in, but for the programs
  Vec3 zero;                                                  // of the work system of the first cut, machine coordinates
  std::size_t passed_messages = 0;                            // of a, that do not count by the rules
  std::size_t passed_exact_stops = 0;                         // of a, where b's control has none
  bool feeds_at_speed = false;                                // they were equal so somewhere
  bool feeds_rounded = false;                                 // they were equal but for the increment of the F word somewhere
  bool lost = false;                                          // from the last difference on they have no place in common that was found

  bool equal() const { return !cancelled && differences.empty(); }
};

/// Names of the axes of both, each once.
std::vector<std::string> common_frame(const Session& a, const Session& b);
Comparison compare_sessions(std::unique_ptr<Session> a, std::unique_ptr<Session> b, const CompareRules& rules);

/// "F200", "S1200 M3" …: what is in force, in words that any control's people read.
std::string text_of(const CourseAct& act);

}  // namespace kadr
