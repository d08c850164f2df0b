#pragma once
// A program with everything that is needed to run it, found by what the command line names.

#include <memory>
#include <optional>

#include "cli/options.h"
#include "config/machine_profile.h"
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
  SaidEncoding encoding;
  std::uint32_t program = 0;                 // number of one on a tape with several
  std::optional<std::size_t> program_index;  // … or its place there, from 0
  KeyLines setup_lines;                      // of the set-up's keys
  std::set<std::string> stated;              // PlacedSetup::stated
  Lang lang = Lang::en;

  /// Read when the first alarm is to be told: a run without one need not wait for them.
  const AlarmTexts& texts() const;
  /// Of a key of the set-up: "shop.json:3".
  std::string place_of(const std::string& key) const;

 private:
  mutable std::shared_ptr<const AlarmTexts> texts_;
};

/// What to say where nobody knows that name.
std::string no_encoding(const std::string& name, bool ru);

/// Loads what the options name; complains to stderr.
///   returns  nothing, if something is missing or wrong (exit status 2)
std::optional<Job> make_job(const Options& options, const std::string& file);

std::optional<Job> make_job(const Options& options, const std::string& file, const std::string& control);

/// Opens the program, the one that the job names of a tape with several; complains if it cannot be read or is not there.
std::optional<Program> open_program(const Job& job);

/// All channels of the machine with it; complains of what a control has not.
///   returns  nullptr: wrong usage
std::unique_ptr<Session> make_session(const Job& job, Program program, const RunLimits& limits);

/// Programs of the file: 1, or more on a tape (spec/gost 1); of a file that cannot be read 1.
std::size_t count_programs(const Job& job);

}  // namespace kadr::cli
