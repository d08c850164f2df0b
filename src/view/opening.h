#pragma once
// Opens a program of the served folder as the page requests, with all that a run of this program needs.

#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "config/alarm_texts.h"
#include "config/control/guess.h"
#include "config/setup/setup_file.h"
#include "lang/text/utf16.h"
#include "session/checklist/tool_table.h"
#include "session/session.h"

namespace kadr {

/// The files that the page requests to open. Paths are in the file system; a path that the request does not give is empty.
struct OpeningRequest {
  std::string path;
  std::string control, machine, setup, encoding;
  std::optional<std::string> text;  // text of the program in UTF-8, which is used instead of the contents of the file
  std::string tables{};             // JSON in the form of a set-up, which overrides values of the set-up file; may be empty
  Lang lang = Lang::en;
  const FileAccess* door = nullptr;  // Opens the files that the page requests, and the files that these files name; must outlive the run.
};

struct OpenedProgram {
  std::string path;
  std::shared_ptr<const ControlDef> def;
  std::shared_ptr<const AlarmTexts> texts;
  MachineProfile machine;
  Setup setup;
  std::set<std::string> stated;  // keys that the set-up states; copy of PlacedSetup::stated
  GivenEncoding encoding;
  std::shared_ptr<const ToolTable> tools;  // the tools file with which the checklist compares the program
  std::optional<Guess> guess;              // the guessed control; nullopt if the user or .kadr.toml has named the control
  std::optional<std::string> text;
  std::uint32_t number = 0;  // number of the program to run, on a tape with several programs; 0: the first program
  RunLimits limits;          // limits of the run; a run for the page writes no files
  const FileAccess* door = nullptr;

  /// Returns the text of the program; on a tape with several programs, the text of program `number`.
  ///   returns  the program, or an error sentence
  tl::expected<Program, std::string> program() const;
  /// Returns a program with the text `other`; everything else is the same as in program().
  tl::expected<Program, std::string> program_of(const std::string& other) const;
  tl::expected<Program, std::string> program_of(OpenedText other) const;
  SessionSpec spec(Program program, const StopToken& stop) const;
};

/// Reads the set-up file, and overrides its values by the tables in the request.
tl::expected<PlacedSetup, std::string> read_with_tables(const OpeningRequest& request, const ControlDef& def);

/// Opens a program. Returns an error sentence if the program's file cannot be read, if Kadr supports no control for this program, or if the
/// set-up is wrong.
tl::expected<OpenedProgram, std::string> open_for_page(const OpeningRequest& request);

}  // namespace kadr
