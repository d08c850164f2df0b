#pragma once
// RadiusCompensation: programmed actions in, those of the tool's centre out. It holds one motion back until the next one in the plane
// says how the corner between them goes, and the actions between the two. NCT 15.5.
//
//   programmed ──▶ held motion k · actions between ──▶ junction k/k+1 ──▶ motion k · actions between · corner · (k+1 is held now)

#include <optional>
#include <vector>

#include "base/tolerance.h"
#include "path/axis_roles.h"
#include "path/contour_offset.h"

namespace kadr {

/// An alarm and the action it belongs to.
struct CompensationFault {
  Alarm alarm;
  Origin origin;
};

class RadiusCompensation {
 public:
  /// `start`: where the tool stands before the first action.
  explicit RadiusCompensation(const ToolPosition& start) : at_(start) {}

  /// Takes a batch; leaves in it what can be said by now. `last`: nothing follows.
  ///   alarms  compensation_no_intersection (nct 2047), compensation_buffer (2090), compensation_turn (2048, INFERRED); of controls with a
  ///   ContourEntry of their own
  ///           compensation_entry_short, compensation_corner_sharp, compensation_gouge: what comes before is in the batch, what is held is
  ///           dropped
  ///   law     what is handed out ends where the programmed path ends, plus a vector no longer than the corner rules say
  std::optional<CompensationFault> take(ActionBatch& batch, bool last);

  /// The tool does not stand on the programmed point, behind what was handed out.
  bool beside() const { return length(vector_) > tol::same_point; }

  /// What is held is not carried out after all.
  void drop();

 private:
  struct Held {
    Action action;
    ContourElement element;
    Vec2 start_vector;
    bool rejoins = false;  // an arc of the programmed radius between its ends (15.5.4)
  };

  void next(Action& action);
  void frame_change(Action& action, FrameChange& frame);
  void motion(Action& action);
  void outside_contour(Action& action);
  void contour(Action& action);
  void wait(Action action);
  void flush(std::optional<Vec2> vector);
  void leave();
  void corner(Action& action);
  void round(Vec2 to, const Origin& origin, const Motion& like);
  void end_held(const JunctionVectors& vectors, const Motion* next, const Origin& origin);
  bool let_go(Vec2 end_vector);
  bool rejoin(Motion& motion, const Held& held, Vec2 end_vector) const;
  void step(Vec2 vector, const Motion& like, const Origin& origin);
  void shift(Motion& motion, Vec2 vector) const;
  void shift(FrameChange& frame) const;
  std::optional<JunctionVectors> vectors_to(const Motion& next, const ContourElement& second);
  ContourElement element_of(const Motion& motion) const;
  Vec2 in_plane(const Axes& axes) const { return {axes[first_], axes[second_]}; }

  static constexpr std::size_t most_waiting = 64;  // actions between two motions in the plane; the NCT's is not known

  ToolPosition at_;  // programmed, behind the last action taken
  std::size_t first_ = 0, second_ = 1;
  bool keeps_vector_ = false;  // as on controls with a ContourEntry of their own: only the program's motions lead back to the contour
  Vec2 vector_;                // from the programmed point to the tool's centre, behind what was handed out
  std::optional<Held> held_;
  std::optional<Action> corner_;  // G39 waits for the next motion
  std::optional<Action> zero_;    // a block of no displacement in the plane, its way is to the next vector
  std::vector<Action> waiting_;
  ActionBatch out_;
  std::optional<CompensationFault> fault_;
};

}  // namespace kadr
