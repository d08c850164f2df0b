#pragma once
// Instants: computes the state of a finished run at any instant. The nearest snapshot before the instant is restored, and the blocks after
// the snapshot are executed one by one.

#include <memory>
#include <optional>
#include <vector>

#include "view/program_run.h"

namespace kadr {

/// The state of the control at an instant, as the page displays it.
struct InstantState {
  double at = 0;
  PathVertex vertex;   // the vertex of the path to which the tool is moving
  Vec3 place;          // position of the tool tip in the coordinates of the picture
  Vec3 block_end;      // the same at the end of the block
  bool moves = false;  // true if the tool is moving to `vertex`; false if the path has ended, or the program has no motion
  AlarmReport::Line line;
  Origin origin;
  std::uint32_t pass = 0;
  std::vector<AlarmReport::Call> calls;
  std::vector<InForce> before, after;  // modes, tool and offsets that are in force before and after the block
  LatheModes lathe;                    // what is in force after the block on a lathe
  std::optional<double> radius;        // tool radius in mm by the offset in force after the block; nullopt if no offset is in force
};

class Instants {
 public:
  /// Answers questions about a finished run.
  ///   pre  the run has ended, and outlives this object
  explicit Instants(const ProgramRun& run) : run_(run) {}

  /// Returns the state at an instant, or an error sentence. For a program of several channels the state contains the path only.
  tl::expected<InstantState, std::string> at(double instant, const StopToken& stop);
  /// Returns the state at the end of the block whose Origin::number is `number`. If the run has no such block, the result is for the
  /// nearest earlier block.
  tl::expected<InstantState, std::string> after(std::uint32_t number, const StopToken& stop);
  /// One execution of a program line with motions: its start and end in s, and the number of its block. The function passes() returns at
  /// most `most` executions, and stores in `count` how often the whole run executes the line.
  struct Pass {
    double from, to;
    std::uint32_t number;
  };
  std::vector<Pass> passes(std::uint32_t line, std::uint16_t file, std::size_t most, std::size_t& count) const;

 private:
  std::optional<double> radius_in_force(const std::vector<InForce>& all) const;
  Session::State run(const StopToken& stop);
  Vec3 end_of(std::uint32_t number, Vec3 otherwise) const;
  tl::expected<InstantState, std::string> complete(InstantState state, std::uint32_t number, const StopToken& stop);
  Status reach(std::uint32_t number, InstantState& state, const StopToken& stop);
  tl::expected<Session*, std::string> session(const StopToken& stop);

  const ProgramRun& run_;
  std::unique_ptr<Session> session_;  // the session that restores snapshots; it is opened at the first question
  std::uint32_t limit_ = 0;           // number of the block before which the session is to stop
  Origin held_;                       // location of the block before which the session has stopped
  double compensated_by_ = 0;         // radius by which the block's motions are compensated, mm
};

}  // namespace kadr
