#pragma once
// RadiusCompensation: programmed actions in, those of the tool's centre out. It holds one motion back until the next one in the plane
// says how the corner between them goes, and the actions between the two; with the interference check as many as that looks at. NCT 15.5.
//
//   programmed ──▶ window: motion k · actions between · motion k+1 … ──▶ junction k/k+1, check ──▶ motion k · actions between · corner
//
// What comes in: radius_compensation.cpp; what goes out: compensated_path.cpp.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "action/tool_position.h"
#include "base/tolerance.h"
#include "path/contour/contour_watch.h"
#include "path/contour/interference.h"

namespace kadr {

/// An alarm and the action it belongs to.
struct CompensationFault {
  Alarm alarm;
  Origin origin;
  Origin other{};  // of contour_cut: the contour's block
};

class RadiusCompensation {
 public:
  /// `start`: where the tool stands before the first action.
  explicit RadiusCompensation(const ToolPosition& start) { now_.at = now_.stand = start; }

  /// Takes a batch; leaves in it what can be said by now. `last`: nothing follows.
  ///   alarms  compensation_no_intersection (nct 2047), compensation_interference (2049), compensation_buffer (2090),
  ///           compensation_turn (2048, INFERRED); of controls with a ContourEntry of their own compensation_entry_short,
  ///           compensation_corner_sharp, compensation_gouge: what comes before is in the batch, what is held is dropped
  ///   law     what is handed out ends where the programmed path ends, plus a vector no longer than the corner rules say
  std::optional<CompensationFault> take(ActionBatch& batch, bool last);

  /// Warnings of the last batch: contour_cut, one for a contour, at its deepest place.
  const std::vector<CompensationFault>& warnings() const { return warnings_; }

  /// A contour is under way, after what was handed out.
  bool at_work() const { return now_.count > 0 || beside(); }

  /// The tool does not stand on the programmed point, after what was handed out.
  bool beside() const { return dot(now_.vector, now_.vector) > tol::same_point * tol::same_point; }

  /// What is held is not carried out after all.
  void drop();

 private:
  static constexpr std::size_t most_waiting = 64;  // actions between two motions in the plane; the NCT's is not known
  static constexpr std::size_t most_held = 16;     // 3 + 8 of N1404 (15.5.7), and the one that comes; a power of two

  /// A motion of the contour, and what stands between it and the next.
  struct Held {
    Motion motion;
    Origin origin;
    ContourElement element;
    Vec2 start_vector;
    JunctionVectors end;            // none: not known, or the offsets do not meet
    bool rejoins = false;           // an arc of the programmed radius between its ends (15.5.4)
    bool regular = false;           // `end` is what the corner rules say for it and the next, both on one side
    std::uint64_t number = 0;       // of its contour, for the watch
    bool watched = false;           // its way must not cut into the contour
    std::vector<Action> waiting{};  // after it
  };

 public:
  /// What it remembers from batch to batch.
  struct Memory {
    ToolPosition at;     // programmed, after the last action taken
    ToolPosition stand;  // programmed, after what was handed out
    std::size_t first = 0, second = 1;
    bool keeps_vector = false;  // as on controls with a ContourEntry of their own: only the program's motions lead back to the contour
    Vec2 vector;                // from the programmed point to the tool's centre, after what was handed out
    std::array<Held, most_held> window;
    std::size_t head = 0, count = 0;
    Motion round_first;  // the motion before an arc about the programmed point
    ContourCheck check;
    std::optional<Action> corner;  // G39 waits for the next motion
    std::optional<Action> zero;    // a block of no displacement in the plane, its way is to the next vector
    ContourWatch watch;
    double radius_before = 0;    // of the motion handed out last, mm
    bool regular_start = false;  // the first of the window begins where such a junction ended
    bool astray = false;         // after an alarm or an end: nothing is known of the contour until it begins anew
  };
  const Memory& memory() const { return now_; }
  void remember(const Memory& memory) { now_ = memory; }

 private:
  // what comes in
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

  // what goes out
  enum class Mended : std::uint8_t { sound, next_fails, first_fails };
  Mended mend_first();
  std::span<const CompensatedBlock> checked_blocks();
  void release_first();
  bool let_go(Held& held);
  bool rejoin(Motion& motion, const Held& held, Vec2 end_vector) const;
  void go_round(const Held& first);
  void round(Vec2 to, const Origin& origin, const Motion& like);
  void step(Vec2 vector, const Motion& like, const Origin& origin);
  void hand_out(Action action);
  void shift(Motion& motion, Vec2 vector) const;
  void shift(FrameChange& frame) const;
  void watch_last();
  void watch_way(const Held& held, Vec2 end_vector);
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
  std::array<CompensatedBlock, most_held> blocks_;
  ActionBatch out_;
  std::optional<CompensationFault> fault_;
  std::vector<CompensationFault> warnings_;
};

}  // namespace kadr
