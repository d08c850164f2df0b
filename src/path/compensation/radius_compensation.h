#pragma once
// RadiusCompensation converts programmed actions to actions of the tool's centre (cutter radius compensation). A motion, and the actions
// after it, are stored until the next motion in the plane determines the corner between the two motions. The interference check needs more
// stored motions. NCT 15.5.
//
//   programmed ──▶ window: motion k · actions between · motion k+1 … ──▶ junction k/k+1, check ──▶ motion k · actions between · corner
//
// Input: radius_compensation.cpp; output: compensated_path.cpp.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "action/tool_position.h"
#include "base/tolerance.h"
#include "path/compensation/gouge_detector.h"
#include "path/compensation/interference.h"

namespace kadr {

/// An alarm or warning, and the block that it belongs to.
struct CompensationFault {
  Alarm alarm;
  Origin origin;
  Origin other{};  // warning contour_cut: the block of the contour that the tool cuts into
};

class RadiusCompensation {
 public:
  /// `start`: position of the tool before the first action.
  explicit RadiusCompensation(const ToolPosition& start) { now_.at = now_.stand = start; }

  /// Processes a batch in place: afterwards it contains only actions that are final. `last`: no batch follows.
  ///   alarms  compensation_no_intersection (nct 2047), compensation_interference (2049), compensation_buffer (2090), compensation_turn
  ///           (2048, INFERRED); on controls that state their own CompensationApproach also compensation_entry_short,
  ///           compensation_corner_sharp, compensation_gouge; the batch keeps the actions before the alarm's block, the stored motions are
  ///           dropped
  ///   law     the output ends at the end of the programmed path plus a vector no longer than the corner rules allow
  std::optional<CompensationFault> take(ActionBatch& batch, bool last);

  /// Warnings of the last batch: one contour_cut per contour, at the contour's deepest cut.
  const std::vector<CompensationFault>& warnings() const { return warnings_; }

  /// True if a compensated contour is active after the last emitted action.
  bool at_work() const { return now_.count > 0 || beside(); }

  /// True if the tool is not at the programmed point after the last emitted action.
  bool beside() const { return dot(now_.vector, now_.vector) > tol::same_point * tol::same_point; }

  /// Discards the stored motions and actions, because the control does not execute them.
  void drop();

 private:
  // greatest number of actions between two motions in the plane; the limit of the NCT control is unknown
  static constexpr std::size_t max_waiting = 64;
  // greatest number of stored motions: 3, or up to 8 by parameter N1404 (NCT 15.5.7), and the motion that arrives; rounded up to a power of
  // two
  static constexpr std::size_t max_held = 16;

  /// A motion of the contour, and the actions between this motion and the next.
  struct Held {
    Motion motion;
    Origin origin;
    ContourElement element;
    Vec2 start_vector;
    JunctionVectors end;            // vectors at the end of the motion; empty: unknown, or the offsets do not meet
    bool rejoins = false;           // an arc of the programmed radius joins the compensated ends (NCT 15.5.4)
    bool regular = false;           // `end` follows from the corner rules, and the tool is on the same side of this motion and the next
    std::uint64_t number = 0;       // number of the motion's contour piece in GougeDetector
    bool watched = false;           // true if GougeDetector checks that the tool on this path does not cut into the contour
    std::vector<Action> waiting{};  // actions after the motion
  };

 public:
  /// The state that RadiusCompensation keeps between batches.
  struct Memory {
    ToolPosition at;     // programmed position after the last action received
    ToolPosition stand;  // programmed position after the last emitted action
    std::size_t first = 0, second = 1;
    // true on controls that state their own CompensationApproach: the vector stays until a programmed motion changes it
    bool keeps_vector = false;
    Vec2 vector;  // vector from the programmed point to the tool's centre, after the last emitted action
    std::array<Held, max_held> window;
    std::size_t head = 0, count = 0;
    Motion round_first;  // the motion that is followed by an arc about the programmed point
    CompensationCheck check;
    std::optional<Action> corner;  // G39 waiting for the next motion
    std::optional<Action> zero;    // a block without displacement in the plane, in which the tool moves to the next vector
    GougeDetector watch;
    double radius_before = 0;    // tool radius of the last emitted motion, mm
    bool regular_start = false;  // the first motion of the window starts at a regular junction (Held::regular)
    bool astray = false;         // true after an alarm or the end of the program: the contour is unknown until a new contour starts
  };
  const Memory& memory() const { return now_; }
  void resume_from(const Memory& memory) { now_ = memory; }

 private:
  // input
  void next(Action& action);
  void frame_change(Action& action, FrameChange& frame);
  void motion(Action& action);
  void outside_contour(Action& action);
  void contour(Action& action);
  void hold(Action& action, const ContourElement& element, Vec2 start_vector);
  void corner(Action& action);
  void wait(Action action);
  void flush(std::optional<Vec2> vector);
  void leave();
  void stay();
  void join(const Motion& next, const ContourElement& second);
  std::optional<JunctionVectors> vectors_to(const Motion& next, const ContourElement& second);
  ContourElement element_of(const Motion& motion) const;

  // output
  enum class RepairOutcome : std::uint8_t { sound, next_fails, first_fails };
  RepairOutcome mend_first();
  std::span<const CompensatedBlock> checked_blocks();
  void release_first();
  bool let_go(Held& held);
  bool rejoin(Motion& motion, const Held& held, Vec2 end_vector) const;
  void go_around_corner(const Held& first);
  void round(Vec2 to, const Origin& origin, const Motion& like);
  void step(Vec2 vector, const Motion& like, const Origin& origin);
  void deliver(Action action);
  void shift(Motion& motion, Vec2 vector) const;
  void shift(FrameChange& frame) const;
  void watch_last();
  void watch_path(const Held& held, Vec2 end_vector);
  void watch_step(Vec2 from, Vec2 to, const Motion& like, const Origin& origin, ContourSpan known);
  void end_watch();

  Vec2 in_plane(const Axes& axes) const { return {axes[now_.first], axes[now_.second]}; }
  void fault(const Alarm& alarm, const Origin& origin) { fault_ = CompensationFault{alarm, origin}; }

  // the window
  Held& held(std::size_t i) { return now_.window[(now_.head + i) % now_.window.size()]; }
  Held& last_held() { return held(now_.count - 1); }
  void drop_first() { now_.head = (now_.head + 1) % now_.window.size(), --now_.count; }
  std::size_t looked_at() const { return now_.check.interference ? 3U + now_.check.further : 2U; }

  Memory now_;
  std::array<CompensatedBlock, max_held> blocks_;
  ActionBatch out_;
  std::optional<CompensationFault> fault_;
  std::vector<CompensationFault> warnings_;
};

}  // namespace kadr
