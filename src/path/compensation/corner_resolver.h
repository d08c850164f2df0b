#pragma once
// CornerResolver resolves the corners that depend on the next block: calculated intersections, chamfers and roundings (NCT 17). A motion
// and the actions after it are stored until the next motion determines where the stored motion ends. A motion without such a corner is
// emitted unchanged.
//
//   programmed ──▶ held motion k · actions between ──▶ corner k/k+1 ──▶ motion k · chamfer or rounding · actions between · (k+1)
//
// The output consists of ordinary motions, which cutter radius compensation then processes. An over-determined block (a block with more
// words than its line or circle needs, so that its intersection with motion k+1 is computed) may still move the end of motion k+1. Until
// this block is read, CornerResolver does not know whether motion k+1 is long enough for the chamfer or rounding at its start. Motion k and
// its corner then wait until motion k+1 has an end.

#include "action/tool_position.h"
#include "path/compensation/radius_compensation.h"
#include "path/curve/corner_geometry.h"

namespace kadr {

class CornerResolver {
 public:
  /// What follows a batch. `more`: more actions. `nothing`: no motion that could form a corner with the last motion. `alarm`: an alarm,
  /// before which the last corner stays as programmed.
  enum class Follows : std::uint8_t { more, nothing, alarm };

  /// `start` is the position of the tool before the first action.
  explicit CornerResolver(const ToolPosition& start) { now_.at = start; }

  /// Processes a batch and replaces its actions by the actions that are final.
  ///   alarms  corner_illegal (nct 2085), corner_too_large, contour_no_intersection (2047, INFERRED), contour_angle_end,
  ///   contour_end_missing,
  ///           reported at the block before the corner; the batch then has only the actions before that block
  ///   law     without chamfers, roundings and over-determined blocks (NCT 17.3) the output equals the input
  std::optional<CompensationFault> take(ActionBatch& batch, Follows follows);

 private:
  // The end of a motion: `programmed`: the programmed end is final; `open`: the next block may be over-determined (NCT 17.3: its words
  // also define a line or circle), and the intersection with it then replaces the programmed end.
  enum class End : std::uint8_t { programmed, open };
  enum class Certainty : std::uint8_t { certain, settled_later };

  /// The start of a motion: the corner with the previous motion, and the travel that a chamfer or rounding at this corner removes from the
  /// motion.
  struct Start {
    Vec2 corner;
    Vec2 direction;  // direction of the motion's element at the corner, before a chamfer or rounding shortened the element
    double cut = 0;  // travel that a chamfer or rounding removes from the start of the motion, in mm on a line and in revolutions on an arc
    bool calculated = false;  // True if the corner was calculated. It may then differ from the programmed end of the previous motion.
  };
  struct Held {
    Action action;
    Start start;
    Vec2 end;  // programmed end of the motion in its plane
  };

 public:
  /// The state that CornerResolver keeps between batches.
  struct Memory {
    ToolPosition at;  // programmed position after the last received action
    std::optional<Held> held{};
    std::vector<Action> waiting{};  // the actions between the stored motion and the next motion
    std::vector<Action> settled{};  // The actions before the stored motion. They wait until the length of the stored motion is known.
    // The block of the last motion in `settled`. An alarm about the corner at the end of this motion names this block.
    Origin settled_origin{};
  };
  const Memory& memory() const { return now_; }
  void resume_from(const Memory& memory) { now_ = memory; }

 private:
  void put_back(ActionBatch& batch);
  std::size_t untouched(const ActionBatch& batch, Follows follows) const;
  void follow(const ActionBatch& batch, std::size_t from, std::size_t end);
  void next(ActionBatch& batch, std::size_t place, Follows follows);
  void motion(Action& action, End end);
  bool waits_at_corner(const Motion& m) const;
  std::optional<Start> join(const Action& action, End end);
  std::optional<ContourElement> element_from(Vec2 corner, const Motion& m, End end) const;
  std::optional<ContourElement> held_element(Vec2 end) const;
  static double chamfer_leg(double chamfer, Vec2 before, Vec2 after);
  std::optional<CornerElement> element_at(Vec2 corner, const ContourElement& second, End end);
  void let_go(Vec2 corner, const CornerElement& inserted, Certainty certainty);
  Action shaped_like(const Action& before, const CornerElement& inserted) const;
  void forward_action(Action action, Certainty certainty);
  void release();
  void finish(Follows follows);
  void drop();
  void fail(AlarmId id, const Origin& origin);
  std::nullopt_t failed(AlarmId id, const Origin& origin);
  const Motion& held() const { return std::get<Motion>(now_.held->action.what); }
  bool alone_in_plane(const Motion& m) const;

  // The greatest number of actions between two motions. The limit of the NCT control is unknown.
  static constexpr std::size_t max_waiting = 64;

  Memory now_;
  ActionBatch out_;
  std::optional<CompensationFault> fault_;
};

}  // namespace kadr
