#pragma once
// Run: one execution of a program, with the motions executed so far. Only one thread at a time may use it: a call from a second thread is
// refused.

#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include "motion_rows.h"
#include "program.h"

namespace kadr::python {

/// The location of a block in the program.
struct Place {
  std::string file;
  std::uint32_t line = 0;
  std::int64_t block = -1;  // block number N; -1: none
  std::uint32_t depth = 0;  // number of subprogram calls around the block
};

class Run {
 public:
  ///   most  greatest number of motions that are stored
  Run(std::shared_ptr<const ProgramSpec> spec, std::size_t most);
  Run(const Run&) = delete;  // its session calls back into this object
  Run& operator=(const Run&) = delete;

  // ---- the interpreter lock is released during these calls (module.cpp)
  /// Runs the program to its end.
  ///   throws  Alarmed, Interrupted, Failed
  void run();
  /// Executes the next block and stops before the one after it.
  ///   returns  the block executed; nullopt if the program is at its end
  ///   throws   as run()
  std::optional<Place> step();
  /// A snapshot: the complete state that decides how the run continues.
  struct Kept {
    const ProgramSpec* spec;  // only compared, to refuse a snapshot of another program
    SessionSnapshot session;
    std::vector<TimeEstimate> clocks;
    std::vector<std::uint32_t> tools;
    MotionRows rows;
    std::vector<ToolPosition> at;
    std::vector<Finding> warnings;
    Session::State state;
    bool at_block;
    Origin next;
  };
  std::shared_ptr<const Kept> snapshot();
  void restore(const Kept& from);

  // ---- the present state
  std::string rows() const;
  std::size_t motions() const { return rows_.size(); }
  std::vector<std::string> axes() const { return session_->control().axes(); }
  std::map<std::string, double> position(bool machine) const;
  std::string state() const;
  std::optional<Place> next() const { return at_block_ ? std::optional(place_of(next_)) : std::nullopt; }
  double seconds() const { return clocks_[session_->own()].split().total(); }
  double evaluate(const std::string& expression);
  std::vector<std::string> files() const { return session_->control().files_read(); }
  std::vector<Finding> warnings() const { return warnings_; }
  std::map<std::string, double> variables() const;
  std::vector<std::string> modal() const { return session_->control().ending().modal; }

 private:
  class Alone;  // lock that refuses calls from other threads

  void look_at(std::size_t channel);
  void take(const Step& step, std::size_t channel);
  void go();
  Place place_of(const Origin& origin) const;

  std::shared_ptr<const ProgramSpec> spec_;
  std::atomic<bool> stop_ = false;
  std::mutex busy_;
  std::unique_ptr<Session> session_;
  std::vector<TimeEstimate> clocks_;  // programmed time, by channel
  std::vector<std::uint32_t> tools_;  // tool in the spindle, by channel
  MotionRows rows_;
  std::size_t most_;
  bool too_many_ = false;
  std::vector<ToolPosition> at_;  // machine position, by channel
  std::vector<Finding> warnings_;
  Session::State state_ = Session::State::running;
  bool stepping_ = false;
  bool may_pass_ = false;
  bool at_block_ = false;  // the run is stopped before the block next_
  Origin next_;
};

}  // namespace kadr::python
