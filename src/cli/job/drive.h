#pragma once
// Drive: executes a session completely, partly (--from, --to), or step by step in the debugger.

#include <memory>
#include <optional>
#include <string>

#include "cli/job/job.h"
#include "session/stepping.h"

namespace kadr::cli {

class Drive {
 public:
  virtual ~Drive() = default;
  /// Prepares the session; called before the observers are attached. Returns nullopt if the execution continues. If there is nothing to
  /// execute, the function prints the reason and returns the exit status.
  virtual std::optional<Exit> begin(Session& session, const Job& job);
  virtual void execute(Session& session) { (void)session.run(); }
  virtual bool wants_summary() const { return true; }
  /// run_by() calls this function before the session is destroyed. Afterwards the drive must not use the session.
  virtual void leave() {}
};

/// Opens the files that the options name, executes the program, and writes the output files.
///   returns  the exit status
int run_by(const Options& options, Drive& drive);

/// Executes the program from line --from to line --to.
class PartOfProgram : public Drive {
 public:
  PartOfProgram(StopPoint from, std::uint32_t to) : from_(std::move(from)), to_(to) {}
  /// Executes the blocks before --from without output, and prints what is in force there.
  std::optional<Exit> begin(Session& session, const Job& job) override;
  void execute(Session& session) override;
  void leave() override { stepping_.reset(); }

 protected:
  Stepping& stepping() { return *stepping_; }
  std::uint32_t to() const { return to_; }

 private:
  std::optional<Exit> go_there(Session& session, const Job& job);

  StopPoint from_;    // location that --from states; line 0: the execution starts at the beginning
  std::uint32_t to_;  // line number that --to states; 0: the program is executed to its end
  std::unique_ptr<Stepping> stepping_;
};

/// The values of --from and --to. --from has the form LINE[:PASS], where PASS means that the line is reached for the n-th time; --to has
/// the form LINE.
struct Part {
  StopPoint from;
  std::uint32_t to = 0;
  bool is_whole() const { return from.line == 0 && to == 0; }
};
/// Reads --from and --to. If one of them is wrong, the function prints the error and returns nullopt.
std::optional<Part> part_of(const Options& options);
/// Returns the drive that --from and --to select. If one of them is wrong, the function prints the error and returns nullptr.
std::unique_ptr<Drive> drive_of(const Options& options);

/// Returns the location and the text of a program line in the form that editors understand: `part.nc:12: N40 G1 X10`.
std::string place_text(const AlarmReport::Line& line);

}  // namespace kadr::cli
