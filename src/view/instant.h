#pragma once
// Instants: gives the state at any instant of a finished run: it restores the nearest snapshot before it, and continues block by block.

#include <memory>
#include <optional>
#include <vector>

#include "view/program_run.h"

namespace kadr {

/// What the page displays of the control at an instant.
struct InstantState {
  double at = 0;
  PathVertex vertex;   // that the tool is moving to
  Vec3 place;          // of the tip, in the picture
  bool moves = false;  // false: the path has ended, or there is none
  AlarmReport::Line line;
  Origin origin;
  std::uint32_t pass = 0;
  std::vector<AlarmReport::Call> calls;
  std::vector<InForce> before, after;  // in force before and after the block
  std::optional<double> radius;        // mm, of the tool, by the offset in force after the block; nullopt: no offset is in force
};

class Instants {
 public:
  ///   pre  the run has ended, and outlives this object
  explicit Instants(const ProgramRun& run) : run_(run) {}

  /// returns  an error sentence. For a program of several channels the state contains the path only
  tl::expected<InstantState, std::string> at(double instant, const StopToken& stop);
  /// The state at the end of a block of the run, by Origin::number; if there is no such block, of the nearest before it.
  tl::expected<InstantState, std::string> after(std::uint32_t number, const StopToken& stop);
  /// When the line was executed with a motion: instants and block numbers, up to `most`.
  struct Pass {
    double from, to;
    std::uint32_t number;
  };
  std::vector<Pass> passes(std::uint32_t line, std::uint16_t file, std::size_t most, std::size_t& count) const;

 private:
  std::optional<double> radius_in_force(const std::vector<InForce>& all) const;
  Session::State run(const StopToken& stop);
  tl::expected<InstantState, std::string> complete(InstantState state, std::uint32_t number, const StopToken& stop);
  Status reach(std::uint32_t number, InstantState& state, const StopToken& stop);
  tl::expected<Session*, std::string> session(const StopToken& stop);

  const ProgramRun& run_;
  std::unique_ptr<Session> session_;  // created at the first query
  std::uint32_t limit_ = 0;           // the session is held before the block with this number
  Origin held_;                       // that block
  double led_by_ = 0;                 // mm: compensation radius of the block's motions
};

}  // namespace kadr
