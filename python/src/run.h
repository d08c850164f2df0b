#pragma once
// Run: one way through a program, with the motions it has made so far. Not for two threads at once: the second is refused.

#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include "motion_rows.h"
#include "program.h"

namespace kadr::python {

/// A block, by its place.
struct Place {
  std::string file;
  std::uint32_t line = 0;
  std::int64_t block = -1;  // N…; -1: none
  std::uint32_t depth = 0;  // calls around it
};

class Run {
 public:
  ///   most  motions that are kept at most
  Run(std::shared_ptr<const ProgramSpec> spec, std::size_t most);
  Run(const Run&) = delete;  // its session calls it back
  Run& operator=(const Run&) = delete;

  // ---- with the interpreter lock released (module.cpp)
  /// To the end.
  ///   throws  Alarmed, Interrupted, Failed
  void run();
  /// Carries the next block out, and stands before the one after it.
  ///   returns  the block; nothing: the program is at its end
  ///   throws   as run()
  std::optional<Place> step();
  /// Everything that decides how it goes on.
  struct Kept {
    const ProgramSpec* spec;  // only compared
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

  // ---- what is known now
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
  class Alone;  // keeps others out

  void look_at(std::size_t channel);
  void take(const Step& step, std::size_t channel);
  void go();
  Place place_of(const Origin& origin) const;

  std::shared_ptr<const ProgramSpec> spec_;
  std::atomic<bool> stop_ = false;
  std::mutex busy_;
  std::unique_ptr<Session> session_;
  std::vector<TimeEstimate> clocks_;  // of each channel
  std::vector<std::uint32_t> tools_;  // in the spindle of each channel
  MotionRows rows_;
  std::size_t most_;
  bool too_many_ = false;
  std::vector<ToolPosition> at_;  // where the machine stands, of each channel
  std::vector<Finding> warnings_;
  Session::State state_ = Session::State::running;
  bool stepping_ = false;
  bool may_pass_ = false;
  bool at_block_ = false;  // stands before next_
  Origin next_;
};

}  // namespace kadr::python
