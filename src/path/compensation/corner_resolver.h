#pragma once
// CornerResolver: resolves the corners that depend on the next block: calculated intersections, and chamfers and roundings. NCT 17. A
// motion, and the actions after it, are stored until the next motion determines where the first one ends. A motion without such a corner
// passes unchanged.
//
//   programmed ──▶ held motion k · actions between ──▶ corner k/k+1 ──▶ motion k · chamfer or rounding · actions between · (k+1)
//
// The output consists of ordinary motions, which cutter radius compensation then processes. If an over-determined block may still move the
// end of motion k+1, it is not known yet whether k+1 is long enough for the chamfer or rounding at its start. Then motion k and its corner
// wait until motion k+1 has an end.

#include "action/tool_position.h"
#include "path/compensation/radius_compensation.h"
#include "path/curve/corner_geometry.h"

namespace kadr {

class CornerResolver {
 public:
  /// What follows a batch: more actions; nothing that could form a corner with the last motion; or an alarm, before which the last corner
  /// is left as programmed.
  enum class Follows : std::uint8_t { more, nothing, alarm };

  /// `start`: position of the tool before the first action.
  explicit CornerResolver(const ToolPosition& start) { now_.at = start; }

  /// Processes a batch in place: afterwards it contains only actions that are final.
  ///   alarms  corner_illegal (nct 2085), corner_too_large, contour_no_intersection (2047, INFERRED), reported at the block before the
  ///           corner; the batch keeps the actions before that block, the rest is dropped
  ///   law     without chamfers, roundings and over-determined blocks the output equals the input
  std::optional<CompensationFault> take(ActionBatch& batch, Follows follows);

 private:
  enum class End : std::uint8_t { programmed, open };  // open: a following over-determined block may still move the end
  enum class Certainty : std::uint8_t { certain, settled_later };

  /// The start of a motion: the corner with the previous motion, and the length that a chamfer or rounding removes from the motion at this
  /// corner.
  struct Start {
    Vec2 corner;
    Vec2 direction;           // direction of the motion's element at the corner, before a corner shortened the element
    double cut = 0;           // travel removed from the start of the motion (unit: corner_geometry.h)
    bool calculated = false;  // true if the corner is not the programmed end of the previous motion
  };
  struct Held {
    Action action;
    Start start;
    Vec2 end;  // programmed end
  };

 public:
  /// The state that CornerResolver keeps between batches.
  struct Memory {
    ToolPosition at;  // programmed position after the last action received
    std::optional<Held> held{};
    std::vector<Action> waiting{};  // actions between the held motion and the next motion
    std::vector<Action> settled{};  // actions before the held motion; they wait until the held motion's length is known
    Origin settled_origin{};        // block of the last motion in `settled`; an alarm about the corner at its end names this block
  };
  const Memory& memory() const { return now_; }
  void resume_from(const Memory& memory) { now_ = memory; }

 private:
  void put_back(ActionBatch& batch);
  std::size_t untouched(const ActionBatch& batch, Follows follows) const;
  void follow(const ActionBatch& batch, std::size_t from, std::size_t end);
  void next(ActionBatch& batch, std::size_t place, Follows follows);
  void motion(Action& action, End end);
  std::optional<Start> join(const Action& action, End end);
  std::optional<ContourElement> element_from(Vec2 corner, const Motion& m, End end) const;
  std::optional<ContourElement> held_element(Vec2 end) const;
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

  // greatest number of actions between two motions; the limit of the NCT control is unknown
  static constexpr std::size_t max_waiting = 64;

  Memory now_;
  ActionBatch out_;
  std::optional<CompensationFault> fault_;
};

}  // namespace kadr
