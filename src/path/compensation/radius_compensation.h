#pragma once
// RadiusCompensation converts programmed actions to actions of the tool's centre (cutter radius compensation). A motion and the actions
// after it are stored until the next motion in the plane determines the corner between the two motions. The interference check needs more
// stored motions: NCT 15.5. The path of a turning tool is the path of its imaginary tip: the path of the nose centre, moved by the vector
// from this centre to the tip (path/compensation/nose_tip.h; fanuc-t 7.2). All corners and checks are computed for the centre.
//
//   programmed ──▶ window: motion k · actions between · motion k+1 … ──▶ junction k/k+1, check ──▶ motion k · actions between · corner
//
// The input is in radius_compensation.cpp, the output in compensated_path.cpp.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "action/tool_position.h"
#include "base/tolerance.h"
#include "path/compensation/gouge_detector.h"
#include "path/compensation/interference.h"

namespace kadr {

/// An alarm or warning, with the block to which it belongs.
struct CompensationFault {
  Alarm alarm;
  Origin origin;
  Origin other{};  // For the warning contour_cut: the block of the contour into which the tool cuts.
};

class RadiusCompensation {
 public:
  /// `start` is the position of the tool before the first action.
  explicit RadiusCompensation(const ToolPosition& start) { now_.at = now_.stand = start; }

  /// Processes a batch and replaces its actions by the actions that are final. `last` is true if no batch follows.
  ///   alarms  compensation_no_intersection (nct 2047), compensation_interference (2049), compensation_buffer (2090), compensation_turn
  ///           (2048, INFERRED); on controls that state their own CompensationApproach also compensation_entry_short,
  ///           compensation_corner_sharp, compensation_gouge; the batch then has only the actions before the alarm's block, and the stored
  ///           motions are dropped
  ///   law     the output ends at the end of the programmed path plus a vector whose length is within the corner rules
  std::optional<CompensationFault> take(ActionBatch& batch, bool last);

  /// The warnings of the last batch: at most one contour_cut per contour, at the deepest cut of the contour.
  const std::vector<CompensationFault>& warnings() const { return warnings_; }

  /// True if cutter compensation is in progress after the last emitted action: a motion is stored, or the tool is not at the programmed
  /// point.
  bool at_work() const { return now_.count > 0 || off_contour(); }

  /// True if the tool's centre, or the imaginary tip of a turning tool, is not at the programmed point after the last emitted action.
  bool off_contour() const { return dot(now_.vector, now_.vector) + dot(now_.tip, now_.tip) > tol::same_point * tol::same_point; }

  /// Discards the stored motions and actions, because the control does not execute them.
  void drop();

 private:
  // The greatest number of actions between two motions in the plane. The limit of the NCT control is unknown.
  static constexpr std::size_t max_waiting = 64;
  // The greatest number of stored motions, rounded up to a power of two. Up to 3 motions are stored, or up to 8 by parameter N1404 (NCT
  // 15.5.7), and the motion that arrives.
  static constexpr std::size_t max_held = 16;

  /// A motion of the contour, with the actions between this motion and the next motion.
  struct Held {
    Motion motion;
    Origin origin;
    ContourElement element;
    Vec2 start_vector;
    // Vectors from the programmed end of the motion to the tool's centre. The list is empty if they are unknown or the offsets do not meet.
    JunctionVectors end;
    // Vector from the tool's centre to the imaginary tip at the end of the motion; zero if the tip is then at the programmed point.
    Vec2 tip;
    // True if the side changes after an arc without an intersection; an arc of the programmed radius then joins the compensated ends (NCT
    // 15.5.4).
    bool rejoins = false;
    // True if the corner rules determine the vectors in `end`, and the tool is on the same side of this motion and the next motion.
    bool regular = false;
    std::uint64_t number = 0;       // number of the motion's contour piece in GougeDetector
    bool watched = false;           // True if GougeDetector checks whether the tool cuts into the contour on this path.
    std::vector<Action> waiting{};  // actions after the motion
  };

 public:
  /// The state that RadiusCompensation keeps between batches.
  struct Memory {
    ToolPosition at;     // programmed position after the last received action
    ToolPosition stand;  // programmed position after the last emitted action
    std::size_t first = 0, second = 1;
    // True on controls that state their own CompensationApproach. On these controls the vector stays until a programmed motion changes it.
    bool keeps_vector = false;
    Vec2 vector;  // vector from the programmed point to the tool's centre after the last emitted action, mm
    // Vector from the tool's centre to the imaginary tip after the last emitted action, mm. The emitted positions are the programmed
    // positions plus `vector` and `tip`.
    Vec2 tip;
    std::array<Held, max_held> window;
    std::size_t head = 0, count = 0;
    Motion round_first;  // the motion before an arc about the programmed point
    CompensationCheck check;
    std::optional<Action> corner;  // a G39 that waits for the next motion
    // A block without displacement in the plane, in which the tool's centre moves to the vector of the next junction.
    std::optional<Action> zero;
    GougeDetector watch;
    double radius_before = 0;    // tool radius of the last emitted motion, mm
    bool regular_start = false;  // True if the first motion of the window starts at a regular junction (Held::regular).
    bool astray = false;         // True after an alarm or the end of the program. The contour is then unknown until a new contour starts.
  };
  const Memory& memory() const { return now_; }
  void resume_from(const Memory& memory) { now_ = memory; }

 private:
  // The functions below are the input: they accept actions and store motions in the window.
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

  // The functions below are the output: they check and emit the stored motions.
  enum class RepairOutcome : std::uint8_t { sound, next_fails, first_fails };
  RepairOutcome mend_first();
  std::span<const CompensatedBlock> checked_blocks();
  void release_first();
  bool let_go(Held& held);
  bool rejoin(Motion& motion, const Held& held, Vec2 end_vector) const;
  void go_around_corner(const Held& first);
  void emit_waiting(Held& first);
  void round(Vec2 to, const Origin& origin, const Motion& like);
  void step(Vec2 vector, Vec2 tip, const Motion& like, const Origin& origin);
  void turn_to(Motion& motion, const Held& held, Vec2 end_vector) const;
  void deliver(Action action);
  void shift(Motion& motion, Vec2 by) const;
  void shift(FrameChange& frame) const;
  void watch_last();
  void watch_path(const Held& held, Vec2 end_vector);
  void watch_step(Vec2 from, Vec2 to, const Motion& like, const Origin& origin, ContourSpan known);
  void end_watch();

  /// The vector from the programmed point to the emitted point.
  Vec2 displacement() const { return now_.vector + now_.tip; }
  Vec2 in_plane(const Axes& axes) const { return {axes[now_.first], axes[now_.second]}; }
  void fault(const Alarm& alarm, const Origin& origin) { fault_ = CompensationFault{alarm, origin}; }

  // The functions below access the window of stored motions.
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
