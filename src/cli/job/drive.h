#pragma once
// Drive: executes a session as a whole, in part (--from, --to), or step by step in the debugger.

#include <memory>
#include <optional>
#include <string>

#include "cli/job/job.h"
#include "session/stepping.h"

namespace kadr::cli {

class Drive {
 public:
  virtual ~Drive() = default;
  /// Called before observers are attached. Returns nullopt to continue. If there is nothing to execute, prints the reason and returns the
  /// exit status.
  virtual std::optional<Exit> begin(Session& session, const Job& job);
  virtual void execute(Session& session) { (void)session.run(); }
  virtual bool wants_summary() const { return true; }
  /// Called before the session is destroyed; the drive must not use the session afterwards.
  virtual void leave() {}
};

/// Opens the files that the options name, executes the program, and writes the output files.
///   returns  exit status
int run_by(const Options& options, Drive& drive);

/// Executes the part of the program from line --from to line --to.
class PartOfProgram : public Drive {
 public:
  PartOfProgram(StopPoint from, std::uint32_t to) : from_(std::move(from)), to_(to) {}
  /// Executes the blocks before --from without output, and prints the state in force there.
  std::optional<Exit> begin(Session& session, const Job& job) override;
  void execute(Session& session) override;
  void leave() override { stepping_.reset(); }

 protected:
  Stepping& stepping() { return *stepping_; }
  std::uint32_t to() const { return to_; }

 private:
  std::optional<Exit> go_there(Session& session, const Job& job);

  StopPoint from_;    // location of --from; line 0: start at the beginning
  std::uint32_t to_;  // line number of --to; 0: run to the end
  std::unique_ptr<Stepping> stepping_;
};

/// The values of --from (LINE[:PASS], the n-th time the line is reached) and of --to (LINE).
struct Part {
  StopPoint from;
  std::uint32_t to = 0;
  bool is_whole() const { return from.line == 0 && to == 0; }
};
/// Reads --from and --to. Returns nullopt, after printing the error, if one of them is wrong.
std::optional<Part> part_of(const Options& options);
/// Returns the drive that --from and --to select; nullptr if an option is wrong, after printing the error.
std::unique_ptr<Drive> drive_of(const Options& options);

/// Returns the location of a program line and its text, as editors understand it: `part.nc:12: N40 G1 X10`.
std::string place_text(const AlarmReport::Line& line);

}  // namespace kadr::cli
