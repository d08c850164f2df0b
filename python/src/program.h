#pragma once
// ProgramSpec: a program with its control, machine and set-up, checked at construction. It can be opened as a session any number of
// times.

#include <atomic>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "failures.h"

namespace kadr::python {

/// The arguments that Python passes.
struct ProgramRequest {
  std::string file;                 // path of the program; if `text` is set, the name used in messages
  std::optional<std::string> text;  // the program text, bytes in any encoding that Kadr supports
  std::string control;              // id or file of the control; empty: guessed
  std::string machine;              // id or file of the machine
  std::string setup_file;           // path of the set-up file, or
  std::string setup_json;           // the set-up as JSON text; both empty: no set-up
  Lang lang = Lang::en;
};

class ProgramSpec {
 public:
  ///   throws  Failed, FileFailed
  explicit ProgramSpec(const ProgramRequest& request);

  /// Opens a new, independent session at the start of the program.
  ///   stop    the session ends when this flag is set; must outlive the session
  ///   throws  Failed, FileFailed
  std::unique_ptr<Session> open(const std::atomic<bool>& stop, RunLimits limits = {}) const;
  /// The same for one program of a tape with several programs.
  std::unique_ptr<Session> open(const std::atomic<bool>& stop, RunLimits limits, std::size_t program) const;
  /// Returns the number of programs in the file; 1 unless it is a tape with several programs.
  std::size_t count_programs() const;

  const ControlDef& control() const { return *control_; }
  const MachineProfile& machine() const { return machine_; }
  const std::string& file() const { return file_; }
  Lang lang() const { return lang_; }
  /// Returns why Kadr refuses to read this program for the named control, as `kadr check` does: the program is for a lathe, and Kadr
  /// reads the control as that of a mill. Empty: it does not.
  std::string refusal() const;

  const std::set<std::string>& stated() const { return stated_; }  // the keys that the set-up states
  Finding finding(const AlarmReport& report) const { return finding_of(report, *texts_, lang_); }

 private:
  std::unique_ptr<ByteSource> source() const;
  Setup setup_of(const ProgramRequest& request);
  std::unique_ptr<Session> open(OpenedText text, const std::atomic<bool>& stop, RunLimits limits) const;

  std::string file_, named_;  // named_: the control that the request names; empty: it was guessed
  std::optional<std::string> text_;
  Lang lang_;
  std::shared_ptr<const ControlDef> control_;
  MachineProfile machine_;
  Setup setup_;
  std::set<std::string> stated_;
  std::shared_ptr<const AlarmTexts> texts_;
};

/// Returns a clock that times the motions of a channel by programmed feeds.
TimeEstimate clock_of(Session& session, std::size_t channel);

}  // namespace kadr::python
