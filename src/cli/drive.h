#pragma once
// How a session is executed: completely, a part of its program, or by hand.

#include <memory>
#include <optional>
#include <string>

#include "cli/job.h"
#include "session/stepping.h"

namespace kadr::cli {

class Drive {
 public:
  virtual ~Drive() = default;
  /// Called before anything is observed. Returns an exit status if there is nothing to execute; the reason has been printed.
  virtual std::optional<Exit> begin(Session& session, const Job& job);
  virtual void carry_out(Session& session) { (void)session.run(); }
  virtual bool wants_summary() const { return true; }
  /// The session ends: the drive must not use it any longer.
  virtual void leave() {}
};

/// Opens what the options name, executes it, and writes the files that they ask for.
///   returns  exit status
int run_by(const Options& options, Drive& drive);

/// Executes the part of the program that --from and --to name.
class PartOfProgram : public Drive {
 public:
  PartOfProgram(StopPoint from, std::uint32_t to) : from_(std::move(from)), to_(to) {}
  /// Executes what comes before it without output, and prints the state in which it begins.
  std::optional<Exit> begin(Session& session, const Job& job) override;
  void carry_out(Session& session) override;
  void leave() override { stepping_.reset(); }

 protected:
  Stepping& stepping() { return *stepping_; }
  std::uint32_t to() const { return to_; }

 private:
  std::optional<Exit> go_there(Session& session, const Job& job);

  StopPoint from_;    // line 0: from the beginning
  std::uint32_t to_;  // 0: to the end
  std::unique_ptr<Stepping> stepping_;
};

/// The values LINE[:PASS] of --from and LINE of --to.
struct Part {
  StopPoint from;
  std::uint32_t to = 0;
  bool is_whole() const { return from.line == 0 && to == 0; }
};
/// Returns nullopt if an option is wrong; it has complained then.
std::optional<Part> part_of(const Options& options);
/// Returns the drive by --from and --to; nullptr if an option is wrong, after a complaint.
std::unique_ptr<Drive> drive_of(const Options& options);

/// Returns line and text in the form that editors understand: `part.nc:12: N40 G1 X10`.
std::string place_text(const AlarmReport::Line& line);

}  // namespace kadr::cli
