#pragma once
// Job: the program that the command line names, and everything that is needed to run the program.

#include <memory>
#include <optional>

#include "cli/options/options.h"
#include "config/machine/machine_profile.h"
#include "lang/text/utf16.h"
#include "session/session.h"

namespace kadr::cli {

/// A program with everything that is needed to run it.
struct Job {
  std::string file;
  std::string setup_file;
  std::shared_ptr<const ControlDef> def;
  MachineProfile profile;
  Setup setup;
  GivenEncoding encoding;
  std::uint32_t program = 0;                 // number of the program to run, if a tape contains several programs
  std::optional<std::size_t> program_index;  // index of the program on the tape, from 0; if set, it is used instead of the number
  KeyLines setup_lines;                      // line numbers of the keys in the set-up file, for messages about a key
  std::set<std::string> stated;              // keys of the set-up for which the user states a value: PlacedSetup::stated
  Lang lang = Lang::en;

  /// Returns the alarm texts. They are read at the first call, so that a run without alarms does not spend time on them.
  const AlarmTexts& texts() const;
  /// Returns the file and the line that contain a set-up key, e.g. "shop.json:3".
  std::string place_of(const std::string& key) const;

 private:
  mutable std::shared_ptr<const AlarmTexts> texts_;
};

/// Returns the error message for an unknown encoding.
std::string no_encoding(const std::string& name, Lang lang);

/// Loads the files that the options name. Prints errors on stderr.
///   returns  nullopt if something is missing or wrong (exit status 2)
std::optional<Job> make_job(const Options& options, const std::string& file);

std::optional<Job> make_job(const Options& options, const std::string& file, const std::string& control);

/// Opens the program of the job, which may be one of several programs on a tape. Prints an error and returns nullopt if the program is
/// missing or cannot be read.
std::optional<Program> open_program(const Job& job);

/// Creates a session with all channels of the machine. Prints an error if the control does not support the set-up.
///   returns  nullptr if the user has made an error
std::unique_ptr<Session> make_session(const Job& job, Program program, const RunLimits& limits);

/// Returns the number of programs in the file. It is greater than 1 only for a tape (spec/gost 1). Returns 1 if the file cannot be read.
std::size_t count_programs(const Job& job);

}  // namespace kadr::cli
