#pragma once
// ProgramSpec: a program with all it is run on, verified, opened as often as wanted.

#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include "failures.h"

namespace kadr::python {

/// What Python says of it.
struct Wanted {
  std::string file;                 // path; or, of a text, what it is called
  std::optional<std::string> text;  // bytes in any encoding that Kadr knows
  std::string control;              // id, file, or empty: guessed
  std::string machine;              // id or file
  std::string setup_file;           // or …
  std::string setup_json;           // … text; both empty: none
  Lang lang = Lang::en;
};

class ProgramSpec {
 public:
  ///   throws  Failed, FileFailed
  explicit ProgramSpec(const Wanted& wanted);

  /// A chain of its own, at the start of the program.
  ///   stop    ends it when set; must outlive it
  ///   throws  Failed, FileFailed
  std::unique_ptr<Session> open(const std::atomic<bool>& stop, RunLimits limits = {}) const;

  const ControlDef& control() const { return *control_; }
  const MachineProfile& machine() const { return machine_; }
  const std::string& file() const { return file_; }
  Lang lang() const { return lang_; }
  Finding finding(const AlarmReport& report) const { return finding_of(report, texts_, lang_); }

 private:
  std::unique_ptr<ByteSource> source() const;
  Setup setup_of(const Wanted& wanted) const;

  std::string file_;
  std::optional<std::string> text_;
  Lang lang_;
  std::shared_ptr<const ControlDef> control_;
  MachineProfile machine_;
  Setup setup_;
  AlarmTexts texts_;
};

/// The times of a session by programmed feeds: who wants times needs it.
TimeEstimate clock_of(Session& session, std::size_t channel);

}  // namespace kadr::python
