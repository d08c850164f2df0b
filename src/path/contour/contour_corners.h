#pragma once
// ContourCorners: the corners that need the next block: calculated intersections, then the chamfer or rounding there. NCT 17.
// It holds a motion back until the next one says where it ends, and the actions between; a motion that no corner concerns passes.
//
//   programmed ──▶ held motion k · actions between ──▶ corner k/k+1 ──▶ motion k · chamfer or rounding · actions between · (k+1)
//
// What is handed out are ordinary motions: cutter radius compensation comes after. Where an over-determined block may still move the
// end of motion k+1, what its start was cut by cannot be judged yet: motion k and its corner wait until motion k+1 has an end.

#include "action/tool_position.h"
#include "path/contour/radius_compensation.h"
#include "path/curve/corner_geometry.h"

namespace kadr {

class ContourCorners {
 public:
  /// What comes after a batch: more, nothing that a corner could go to, or an alarm (then the programmed corner stays as it is).
  enum class Follows : std::uint8_t { more, nothing, alarm };

  /// `start`: where the tool stands before the first action.
  explicit ContourCorners(const ToolPosition& start) { now_.at = start; }

  /// Takes a batch; leaves in it what can be said by now.
  ///   alarms  corner_illegal (nct 2085), corner_too_large, contour_no_intersection (2047, INFERRED), at the block before the corner:
  ///           what comes before is in the batch, the rest is dropped
  ///   law     without chamfers, roundings and over-determined blocks what is handed out is what came in
  std::optional<CompensationFault> take(ActionBatch& batch, Follows follows);

 private:
  enum class End : std::uint8_t { programmed, open };  // open: an over-determined block may still calculate it
  enum class Certainty : std::uint8_t { certain, settled_later };

  /// How a motion begins: at the corner before it, cut by so much.
  struct Start {
    Vec2 corner;
    Vec2 direction;           // in which it was cut
    double cut = 0;           // way
    bool calculated = false;  // the corner is not the programmed one
  };
  struct Held {
    Action action;
    Start start;
    Vec2 end;  // programmed
  };

 public:
  /// What it remembers from batch to batch.
  struct Memory {
    ToolPosition at;  // programmed, after the last action taken
    std::optional<Held> held{};
    std::vector<Action> waiting{};  // between the held motion and the next one
    std::vector<Action> settled{};  // before the held motion: they wait for its length
    Origin settled_origin{};        // of the block with the corner among them
  };
  const Memory& memory() const { return now_; }
  void remember(const Memory& memory) { now_ = memory; }

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
  void hand_on(Action action, Certainty certainty);
  void release();
  void finish(Follows follows);
  void drop();
  void fail(AlarmId id, const Origin& origin);
  std::nullopt_t failed(AlarmId id, const Origin& origin);
  const Motion& held() const { return std::get<Motion>(now_.held->action.what); }
  bool alone_in_plane(const Motion& m) const;

  static constexpr std::size_t most_waiting = 64;  // actions between two motions; the NCT's is not known

  Memory now_;
  ActionBatch out_;
  std::optional<CompensationFault> fault_;
};

}  // namespace kadr
