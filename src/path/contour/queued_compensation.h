#pragma once
// QueuedCompensation: cutter radius compensation as LinuxCNC does it: programmed actions in, those of the tool's centre out. A motion
// beside the contour stands in a queue, with all that comes behind it, until the next element says where it ends: its end is moved there,
// so are those of the motions behind it in the third axis, and all of them are handed out. spec/linuxcnc 7.5; its source: interp_convert.cc
// (convert_straight_comp1 and 2, convert_arc_comp1 and 2), interp_queue.cc.
//
//   programmed ──▶ queue: motion · actions · motions in Z ──▶ next element: corner ──▶ ends moved, out ──▶ corner, next element queued
//
// Messages and tools selected do not wait. What comes in: queued_compensation.cpp; what goes out: queued_output.cpp; the corners:
// queued_corner.h. Other controls: path/contour/radius_compensation.

#include <optional>
#include <vector>

#include "action/tool_position.h"
#include "base/units.h"
#include "path/contour/queued_corner.h"
#include "path/contour/radius_compensation.h"

namespace kadr {

class QueuedCompensation {
 public:
  /// What comes after a batch.
  enum class Follows : std::uint8_t { more, nothing };

  /// `start`: where the tool stands before the first action.
  explicit QueuedCompensation(const ToolPosition& start);

  /// Takes a batch; leaves in it what can be said by now. Follows::nothing (an alarm, the end of a file): what is queued is dropped, as the
  /// control does; before a stop or M2 a ContourBreak hands it out.
  ///   alarms  at the block that is being read: those of queued_corner.h, gouge_feed, gouge_rapid, gouge_arc, offset_arc_radii,
  ///           entry_line_within_tool, compensated_thread, compensation_buffer: what comes before is in the batch, what is queued is
  ///           dropped
  ///   law     with no motion on a side of its path what is handed out is what came in
  std::optional<CompensationFault> take(ActionBatch& batch, Follows follows);

  /// Warnings of the last batch: contour_cut, one for a contour, at its deepest place.
  const std::vector<CompensationFault>& warnings() const { return warnings_; }

  /// A contour is under way, after what was handed out.
  bool at_work() const { return !now_.queue.empty() || beside(); }

  /// The tool does not stand on the programmed point, after what was handed out.
  bool beside() const { return now_.dropped || dot(now_.beside, now_.beside) > tol::same_point * tol::same_point; }

 private:
  static constexpr std::size_t most_queued = 4096;  // the control has no limit but its memory

  struct Queued {
    Action action;
    bool moves = false;              // else it only waits
    Vec2 end;                        // of the tool, in the plane
    Vec2 direction;                  // of a straight motion as programmed; {}: along the third axis
    std::optional<QueuedArc> arc{};  // the tool's way along an arc; its end is `end`
    double swept = 0;                // … as programmed, rad
    double speed = 0;                // inverse time: that of the programmed way in the programmed time, mm/min; 0: as the action says
    bool watched = false;            // its way must not cut into the contour …
    ContourSpan known{};             // … but for these pieces of it
  };

 public:
  /// What it remembers from batch to batch.
  struct Memory {
    ToolPosition at;                       // programmed, after the last action taken
    std::size_t first = 0, second = 1;     // axes of the plane
    bool on = false;                       // the first compensated motion has come
    bool inch = false;                     // unit of its block, or of the one taken last
    Vec2 tool;                             // where the last element ends uncut
    std::optional<Vec2> start;             // from where the queued motions go; nothing: not known, so they are not checked
    std::vector<Queued> queue;             //
    std::optional<QueuedArc> first_arc{};  // first motion of the queue; of an empty one, of the last that there was (the source reads it)
    Axes stands{};                         // work coordinates of the tool, after what was handed out
    Vec2 beside;                           // … from the programmed point
    bool dropped = false;                  // the programmed point has not been reached
    ContourWatch watch;
  };
  const Memory& memory() const { return now_; }
  void remember(const Memory& memory) { now_ = memory; }

 private:
  // what comes in
  void next(Action& action);
  void wait(Action& action);
  void end_here(const ContourBreak& end);
  void motion(Action& action);
  void outside_contour(Action& action);
  void enter(Queued& queued, const Motion& m);
  void lead_tip_in(const Queued& arc, Vec2 from);
  void line(Queued& queued, const Motion& m);
  void arc(Queued& queued, const Motion& m);
  CornerPlace place_before(const Motion& m) const;
  double programmed_speed(const Motion& m) const;
  void watch_element(Queued& queued, const Motion& m);
  void lose();
  void follow(const Action& action);

  // the queue, and what goes out: false with an alarm
  bool move_ends(Vec2 to);
  bool may_end(const Queued& queued, Vec2 to);
  void push(Queued& queued);
  void go_round(const Queued& next, Vec2 to);
  void hand_out_queue();
  void hand_out(Queued& queued);
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
  Origin origin_;  // of the action being taken
  ActionBatch out_;
  std::optional<CompensationFault> fault_;
  std::vector<CompensationFault> warnings_;
};

}  // namespace kadr
