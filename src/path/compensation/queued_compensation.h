#pragma once
// QueuedCompensation is cutter compensation as LinuxCNC computes it. It converts programmed actions to actions of the tool's centre. A
// motion along the contour waits in a queue, with all actions that follow it, until the next element determines where the motion ends. The
// end of this motion and the ends of the queued motions along the third axis are then moved to this point, and the queue is emitted.
// Sources: spec/linuxcnc 7.5, and LinuxCNC's interp_convert.cc (convert_straight_comp1 and 2, convert_arc_comp1 and 2) and interp_queue.cc.
//
//   programmed ──▶ queue: motion · actions · motions in Z ──▶ next element: corner ──▶ ends moved, out ──▶ corner, next element queued
//
// Messages and tool selections do not wait in the queue. The input is in queued_compensation.cpp, the output in queued_output.cpp, and the
// corners are in queued_corner.h. Other controls use path/compensation/radius_compensation.

#include <optional>
#include <vector>

#include "action/tool_position.h"
#include "base/units.h"
#include "path/compensation/queued_corner.h"
#include "path/compensation/radius_compensation.h"

namespace kadr {

class QueuedCompensation {
 public:
  /// What follows a batch: more actions, or nothing.
  enum class Follows : std::uint8_t { more, nothing };

  /// `start` is the position of the tool before the first action.
  explicit QueuedCompensation(const ToolPosition& start);

  /// Processes a batch and replaces its actions by the actions that are final. With Follows::nothing (an alarm, the end of a file) the
  /// queue is dropped, as in LinuxCNC. Before a stop or M2, a CompensationBreak emits the queue instead.
  ///   alarms  reported at the block that is being read: the alarms of queued_corner.h, gouge_feed, gouge_rapid, gouge_arc,
  ///           offset_arc_radii, entry_line_within_tool, compensated_thread, compensation_buffer; the batch then has only the actions
  ///           before that block, and the queue is dropped
  ///   law     if no motion has a compensation side, the output equals the input
  std::optional<CompensationFault> take(ActionBatch& batch, Follows follows);

  /// The warnings of the last batch: at most one contour_cut per contour, at the deepest cut of the contour.
  const std::vector<CompensationFault>& warnings() const { return warnings_; }

  /// True if cutter compensation is in progress after the last emitted action: a motion is stored, or the tool is not at the programmed
  /// point.
  bool at_work() const { return !now_.queue.empty() || off_contour(); }

  /// True if the tool is not at the programmed point after the last emitted action.
  bool off_contour() const { return now_.dropped || dot(now_.off_contour, now_.off_contour) > tol::same_point * tol::same_point; }

 private:
  // The greatest number of queued actions in this implementation. LinuxCNC's queue is limited only by the memory.
  static constexpr std::size_t max_queued = 4096;

  struct Queued {
    Action action;
    bool moves = false;  // true for a motion; false for an action that only waits in the queue
    Vec2 end;            // end position of the tool's centre in the plane, mm
    Vec2 direction;      // programmed direction of a straight motion; zero for a motion along the third axis
    // The tool's path along the arc, if the motion is an arc. When the queue is corrected, its end becomes equal to the member `end`.
    std::optional<QueuedArc> arc{};
    double swept = 0;  // swept angle of the programmed arc, rad
    // The programmed length divided by the programmed time, mm/min, with inverse-time feed; 0: the feed of the action applies.
    double speed = 0;
    bool watched = false;  // True if GougeDetector checks whether the tool cuts into the contour on this path.
    ContourSpan known{};   // the contour pieces with which GougeDetector does not compare this path
  };

 public:
  /// The state that QueuedCompensation keeps between batches.
  struct Memory {
    ToolPosition at;                    // programmed position after the last received action
    std::size_t first = 0, second = 1;  // indices of the two axes of the plane
    bool on = false;                    // true after the first compensated motion has been read
    bool inch = false;                  // true if the unit of the last motion that was read is the inch
    Vec2 tool;                          // Tool position at the end of the last element, before a corner shortens this element.
    // The tool position at the start of the queue. Empty: the position is unknown, so the queued motions are not checked.
    std::optional<Vec2> start;
    std::vector<Queued> queue;  // the queued actions, in the order of the program
    // The arc that is the first motion of the queue. If the queue is empty, it is the arc of the previous queue, because LinuxCNC's source
    // still reads that arc.
    std::optional<QueuedArc> first_arc{};
    Axes stands{};         // work coordinates of the tool after the last emitted action
    Vec2 off_contour;      // offset of the tool from the programmed point after the last emitted action, mm
    bool dropped = false;  // True if a queue was dropped. The tool has then not reached the programmed point.
    GougeDetector watch;
  };
  const Memory& memory() const { return now_; }
  void resume_from(const Memory& memory) { now_ = memory; }

 private:
  // The functions below are the input: they accept actions and put them into the queue.
  void next(Action& action);
  void wait(Action& action);
  void end_here(const CompensationBreak& end);
  void motion(Action& action);
  void outside_contour(Action& action);
  void enter(Queued& queued, const Motion& m);
  void queue_lead_in(const Queued& arc, Vec2 from);
  void line(Queued& queued, const Motion& m);
  void arc(Queued& queued, const Motion& m);
  CornerSituation place_before(const Motion& m) const;
  double programmed_speed(const Motion& m) const;
  void watch_element(Queued& queued, const Motion& m);
  void lose();
  void follow(const Action& action);

  // The functions below are the queue and its output. A function with the result bool returns false if it raised an alarm.
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
  Origin origin_;  // origin of the action that is being processed
  ActionBatch out_;
  std::optional<CompensationFault> fault_;
  std::vector<CompensationFault> warnings_;
};

}  // namespace kadr
