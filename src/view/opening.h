#pragma once
// Opening: a program of the folder with all that is needed to run it, as the page asks for it.

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

/// Places in the file system; empty where nothing is said.
struct OpeningWish {
  std::string path;
  std::string control, machine, setup, encoding;
  std::optional<std::string> text;  // UTF-8, run in the place of what the file holds
  std::string tables{};             // JSON in the form of a set-up, laid over that; empty: none
  Lang lang = Lang::en;
  const FileDoor* door = nullptr;  // opens them all, and what they name; it outlives the run
};

struct OpenedProgram {
  std::string path;
  std::shared_ptr<const ControlDef> def;
  std::shared_ptr<const AlarmTexts> texts;
  MachineProfile machine;
  Setup setup;
  std::set<std::string> stated;  // PlacedSetup::stated
  SaidEncoding encoding;
  std::shared_ptr<const ToolTable> tools;  // the checklist holds it against
  std::optional<Guess> guess;              // nothing: the control was named
  std::optional<std::string> text;
  std::uint32_t number = 0;  // of the program on a tape with several; 0: the first
  RunLimits limits;          // nothing is written
  const FileDoor* door = nullptr;

  /// Its text, of a tape with several the one that `number` says.
  ///   returns  an error sentence
  tl::expected<Program, std::string> program() const;
  /// The same of another text.
  tl::expected<Program, std::string> program_of(const std::string& other) const;
  tl::expected<Program, std::string> program_of(OpenedText other) const;
  SessionSpec spec(Program program, const StopToken& stop) const;
};

/// Its set-up file with the tables laid over it.
tl::expected<PlacedSetup, std::string> read_with_tables(const OpeningWish& wish, const ControlDef& def);

/// returns  an error sentence: it cannot be read, is no program of a control that Kadr knows, the set-up is wrong
tl::expected<OpenedProgram, std::string> open_for_page(const OpeningWish& wish);

}  // namespace kadr
