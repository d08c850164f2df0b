#pragma once
// Opens a program of the folder, with everything that is needed to run it, as the page requests.

#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "config/alarm_texts.h"
#include "config/guess.h"
#include "config/setup_file.h"
#include "lang/text/utf16.h"
#include "session/checklist/tool_table.h"
#include "session/session.h"

namespace kadr {

/// Paths in the file system; empty if not given.
struct OpeningWish {
  std::string path;
  std::string control, machine, setup, encoding;
  std::optional<std::string> text;  // UTF-8, run instead of the contents of the file
  std::string tables{};             // JSON in the form of a set-up, which overrides the set-up; empty: none
  Lang lang = Lang::en;
  const FileDoor* door = nullptr;  // opens all these files and those they name; outlives the run
};

struct OpenedProgram {
  std::string path;
  std::shared_ptr<const ControlDef> def;
  std::shared_ptr<const AlarmTexts> texts;
  MachineProfile machine;
  Setup setup;
  std::set<std::string> stated;  // PlacedSetup::stated
  SaidEncoding encoding;
  std::shared_ptr<const ToolTable> tools;  // compared with by the checklist
  std::optional<Guess> guess;              // nullopt: the user named the control
  std::optional<std::string> text;
  std::uint32_t number = 0;  // of the program on a tape with several programs; 0: the first
  RunLimits limits;          // the run writes no files
  const FileDoor* door = nullptr;

  /// The program's text; on a tape with several programs, that with `number`.
  ///   returns  an error sentence
  tl::expected<Program, std::string> program() const;
  /// The same with another text.
  tl::expected<Program, std::string> program_of(const std::string& other) const;
  tl::expected<Program, std::string> program_of(OpenedText other) const;
  SessionSpec spec(Program program, const StopToken& stop) const;
};

/// The set-up file, overridden by the tables.
tl::expected<PlacedSetup, std::string> read_with_tables(const OpeningWish& wish, const ControlDef& def);

/// returns  an error sentence if it cannot be read, is no program of a control that Kadr supports, or the set-up is wrong
tl::expected<OpenedProgram, std::string> open_for_page(const OpeningWish& wish);

}  // namespace kadr
