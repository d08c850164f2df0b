#pragma once
// Collects, from what the command line names, a program and everything that is needed to run it.

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
  std::uint32_t program = 0;                 // number of the program, on a tape with several
  std::optional<std::size_t> program_index;  // or its index there, from 0
  KeyLines setup_lines;                      // the lines of the set-up's keys
  std::set<std::string> stated;              // PlacedSetup::stated
  Lang lang = Lang::en;

  /// Reads the alarm texts at the first alarm, so that a run without one need not wait for them.
  const AlarmTexts& texts() const;
  /// Returns the location of a key of the set-up: "shop.json:3".
  std::string place_of(const std::string& key) const;

 private:
  mutable std::shared_ptr<const AlarmTexts> texts_;
};

/// Returns the error message for an unknown encoding.
std::string no_encoding(const std::string& name, bool ru);

/// Loads what the options name; complains to stderr.
///   returns  nullopt if something is missing or wrong (exit status 2)
std::optional<Job> make_job(const Options& options, const std::string& file);

std::optional<Job> make_job(const Options& options, const std::string& file, const std::string& control);

/// Opens the program, on a tape with several the one that the job names; complains if it cannot be read or is not there.
std::optional<Program> open_program(const Job& job);

/// Creates a session with all channels of the machine; complains if the control lacks something.
///   returns  nullptr for wrong usage
std::unique_ptr<Session> make_session(const Job& job, Program program, const RunLimits& limits);

/// Returns the number of programs in the file: 1, or more on a tape (spec/gost 1); 1 if the file cannot be read.
std::size_t count_programs(const Job& job);

}  // namespace kadr::cli
