#pragma once
// How a session is carried out: whole, a part of its program, by hand.

#include <memory>
#include <optional>
#include <string>

#include "cli/job.h"
#include "session/stepping.h"

namespace kadr::cli {

class Drive {
 public:
  virtual ~Drive() = default;
  /// Before anybody looks. An exit status: there is nothing to carry out, it has been said why.
  virtual std::optional<Exit> begin(Session& session, const Job& job);
  virtual void carry_out(Session& session) { (void)session.run(); }
  virtual bool wants_summary() const { return true; }
  /// The session ends: nothing holds on to it any longer.
  virtual void leave() {}
};

/// Opens what the options name, carries it out, writes what they ask for.
///   returns  exit status
int run_by(const Options& options, Drive& drive);

/// A part of the program: what --from and --to name.
class PartOfProgram : public Drive {
 public:
  PartOfProgram(StopPoint from, std::uint32_t to) : from_(std::move(from)), to_(to) {}
  /// Through what stands before, silently; the state that it begins with is said.
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

/// LINE[:PASS] and LINE of --from and --to.
struct Part {
  StopPoint from;
  std::uint32_t to = 0;
  bool is_whole() const { return from.line == 0 && to == 0; }
};
/// Nothing: complained of.
std::optional<Part> part_of(const Options& options);
/// By --from and --to; nullptr: complained of.
std::unique_ptr<Drive> drive_of(const Options& options);

/// Line and text, as they are found in an editor: `part.nc:12: N40 G1 X10`.
std::string place_text(const AlarmReport::Line& line);

}  // namespace kadr::cli
