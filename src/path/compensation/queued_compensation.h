#pragma once
// QueuedCompensation: cutter radius compensation as LinuxCNC computes it. It converts programmed actions to actions of the tool's centre. A
// motion along the contour waits in a queue, with everything that follows it, until the next element determines where it ends. Then its
// end, and the ends of the queued motions along the third axis, are moved to that point, and the queue is emitted. spec/linuxcnc 7.5; its
// source: interp_convert.cc (convert_straight_comp1 and 2, convert_arc_comp1 and 2), interp_queue.cc.
//
//   programmed ──▶ queue: motion · actions · motions in Z ──▶ next element: corner ──▶ ends moved, out ──▶ corner, next element queued
//
// Messages and tool selections do not wait. Input: queued_compensation.cpp; output: queued_output.cpp; the corners: queued_corner.h.
// Other controls: path/compensation/radius_compensation.

#include <optional>
#include <vector>

#include "action/tool_position.h"
#include "base/units.h"
#include "path/compensation/queued_corner.h"
#include "path/compensation/radius_compensation.h"

namespace kadr {

class QueuedCompensation {
 public:
  /// What follows a batch.
  enum class Follows : std::uint8_t { more, nothing };

  /// `start`: position of the tool before the first action.
  explicit QueuedCompensation(const ToolPosition& start);

  /// Processes a batch in place: afterwards it contains only actions that are final. Follows::nothing (an alarm, the end of a file): the
  /// queue is dropped, as in LinuxCNC; before a stop or M2 a CompensationBreak emits the queue instead.
  ///   alarms  reported at the block that is being read: the alarms of queued_corner.h, gouge_feed, gouge_rapid, gouge_arc,
  ///           offset_arc_radii, entry_line_within_tool, compensated_thread, compensation_buffer; the batch keeps the actions before that
  ///           block, the queue is dropped
  ///   law     if no motion has a compensation side, the output equals the input
  std::optional<CompensationFault> take(ActionBatch& batch, Follows follows);

  /// Warnings of the last batch: one contour_cut per contour, at the contour's deepest cut.
  const std::vector<CompensationFault>& warnings() const { return warnings_; }

  /// True if a compensated contour is active after the last emitted action.
  bool at_work() const { return !now_.queue.empty() || beside(); }

  /// True if the tool is not at the programmed point after the last emitted action.
  bool beside() const { return now_.dropped || dot(now_.beside, now_.beside) > tol::same_point * tol::same_point; }

 private:
  static constexpr std::size_t max_queued = 4096;  // a limit of this implementation; LinuxCNC has no limit but its memory

  struct Queued {
    Action action;
    bool moves = false;              // false for an action that is not a motion and only waits in the queue
    Vec2 end;                        // end position of the tool's centre, in the plane
    Vec2 direction;                  // programmed direction of a straight motion; {} for a motion along the third axis
    std::optional<QueuedArc> arc{};  // the tool's path along an arc; the member `end` above replaces the end in it
    double swept = 0;                // swept angle of the programmed arc, rad
    double speed = 0;                // inverse-time feed: programmed length divided by programmed time, mm/min; 0: the action's own feed
    bool watched = false;            // true if GougeDetector checks that the tool on this path does not cut into the contour
    ContourSpan known{};             // contour pieces with which GougeDetector does not compare this path
  };

 public:
  /// The state that QueuedCompensation keeps between batches.
  struct Memory {
    ToolPosition at;                    // programmed position after the last action received
    std::size_t first = 0, second = 1;  // indices of the two axes of the plane
    bool on = false;                    // true after the first compensated motion has been read
    bool inch = false;                  // true if the unit of the first compensated block, or of the last block, is the inch
    Vec2 tool;                          // tool position at the end of the last element, before a corner shortens that element
    std::optional<Vec2> start;          // tool position at the start of the queue; empty: unknown, so the queued motions are not checked
    std::vector<Queued> queue;          // the queued actions, in the order of the program
    // the arc that is the first motion of the queue; if the queue is empty: that of the previous queue, which LinuxCNC's source still reads
    std::optional<QueuedArc> first_arc{};
    Axes stands{};         // work coordinates of the tool after the last emitted action
    Vec2 beside;           // offset of the tool from the programmed point after the last emitted action
    bool dropped = false;  // true if a queue was dropped, so that the tool has not reached the programmed point
    GougeDetector watch;
  };
  const Memory& memory() const { return now_; }
  void resume_from(const Memory& memory) { now_ = memory; }

 private:
  // input
  void next(Action& action);
  void wait(Action& action);
  void end_here(const CompensationBreak& end);
  void motion(Action& action);
  void outside_contour(Action& action);
  void enter(Queued& queued, const Motion& m);
  void lead_tip_in(const Queued& arc, Vec2 from);
  void line(Queued& queued, const Motion& m);
  void arc(Queued& queued, const Motion& m);
  CornerSituation place_before(const Motion& m) const;
  double programmed_speed(const Motion& m) const;
  void watch_element(Queued& queued, const Motion& m);
  void lose();
  void follow(const Action& action);

  // the queue and its output; a function returns false if it raised an alarm
  bool move_ends(Vec2 to);
  bool may_end(const Queued& queued, Vec2 to);
  void push(Queued& queued);
  void go_around_corner(const Queued& next, Vec2 to);
  void deliver_queue();
  void deliver(Queued& queued);
  void move_tool(const Queued& queued, Motion& m);
  void end_watch();

  Vec2 in_plane(const Axes& axes) const { return {axes[now_.first], axes[now_.second]}; }
  std::size_t third() const { return 3 - now_.first - now_.second; }
  double unit() const { return now_.inch ? mm_per_inch : 1; }
  bool fault(const Alarm& alarm) {
    fault_ = CompensationFault{alarm, origin_};
    return false;
  }

  Memory now_;
  Origin origin_;  // origin of the action being processed
  ActionBatch out_;
  std::optional<CompensationFault> fault_;
  std::vector<CompensationFault> warnings_;
};

}  // namespace kadr
