#pragma once
// Instants: any instant of a program that has been carried out: the nearest snapshot before it, then block by block.

#include <memory>
#include <optional>
#include <vector>

#include "view/program_run.h"

namespace kadr {

/// What a person sees of the control at an instant.
struct InstantState {
  double at = 0;
  PathVertex vertex;   // under way to it
  Vec3 place;          // of the tip, in the picture
  bool moves = false;  // false: the path is over, or has none
  AlarmReport::Line line;
  Origin origin;
  std::uint32_t pass = 0;
  std::vector<AlarmReport::Call> calls;
  std::vector<InForce> before, after;  // the block
  std::optional<double> radius;        // mm, of the tool by the offset in force behind it; nothing: no offset is in force
};

class Instants {
 public:
  /// Of a run that is over and outlives this.
  explicit Instants(const ProgramRun& run) : run_(run) {}

  /// returns  an error sentence; nothing of the state but the path for a program of several channels
  tl::expected<InstantState, std::string> at(double instant, const StopToken& stop);
  /// At the end of a block of the run, by Origin::number; of one that does not exist the nearest before it.
  tl::expected<InstantState, std::string> after(std::uint32_t number, const StopToken& stop);
  /// When the line was carried out with a motion: instants and block numbers, up to `most`.
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
  std::unique_ptr<Session> session_;  // made when the first instant is asked for
  std::uint32_t limit_ = 0;           // it is held before the block of this number
  Origin held_;                       // that block
  double led_by_ = 0;                 // mm: the radius that the contour's motions of the block had
};

}  // namespace kadr
