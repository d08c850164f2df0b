#pragma once
// LineTracker: finds the line of a job that a Grbl controller executes now. The controller's `ok` only means that a line was read: up to
// 15 planned blocks and 127 bytes lie between reading and moving. The tracker compares the reported position with the paths of the lines.
//
//   sent ──ok──▶ accepted ──position on its path──▶ executed

#include <cstdint>
#include <deque>
#include <optional>

#include "drive/grbl/job_line.h"

namespace kadr::drive {

/// The result of comparing a reported position with the job.
struct Tracked {
  std::optional<std::uint32_t> line;  // program line whose path contains the position; nullopt: no line has begun to move
  double off = 0;                     // distance of the position from the nearest path that it may be on, mm
  bool on_path = true;                // `off` is within the tolerance
};

class LineTracker {
 public:
  ///   tolerance  mm; how far a reported position may be from the path: rounding of the report, steps, chords of arcs
  explicit LineTracker(double tolerance) : tolerance_(tolerance) {}

  /// Notes that a line was sent.
  void sent(const JobLine& line);
  /// Notes that the oldest sent line, which was not accepted yet, was answered with `ok`.
  void accepted();
  /// Notes that everything accepted is executed: the controller reports that it is idle and that its buffers are empty.
  void all_executed();
  /// Compares a position with the paths. The result never goes back to an earlier line. If the position lies on several paths, the
  /// earliest of them is the result, so the result may be late but is never early.
  ///   blocks_in_use  blocks in the controller's planner; nullopt: the report does not have them
  Tracked at(const GrblPoint& machine, std::optional<int> blocks_in_use);
  /// Returns the distance of a position from the end of the last executed path, mm; 0 if nothing has moved.
  double off_end(const GrblPoint& machine) const;
  /// Returns the program line of the last result, or of the last executed line that moves.
  std::optional<std::uint32_t> last_line() const { return last_line_; }
  /// Forgets all lines.
  void clear();

  /// Number of lines of the job that are executed completely.
  std::uint64_t executed() const { return executed_; }
  /// Number of lines that are sent and not known to be executed.
  std::size_t pending() const { return lines_.size(); }
  /// Time that the lines need that are sent and not known to be executed, s.
  double seconds_pending() const { return seconds_; }

 private:
  struct Entry {
    std::uint32_t number;
    double seconds;
    std::vector<GrblPoint> path;
    bool probes;
  };
  struct Place {
    std::size_t entry = 0, segment = 0;
    double along = 0;  // distance from the start of the segment, mm
  };
  void drop(std::size_t entries);
  std::size_t least_entry(std::optional<int> blocks_in_use) const;

  double tolerance_;
  std::deque<Entry> lines_;   // sent lines, the oldest first; the first one is executed now, or waits
  std::size_t accepted_ = 0;  // how many of them are accepted
  std::uint64_t executed_ = 0;
  double seconds_ = 0;
  Place now_;                               // where the tool is on the first line
  std::optional<std::uint32_t> last_line_;  // line of the last result
  std::optional<GrblPoint> end_;            // end of the last executed path
};

}  // namespace kadr::drive
