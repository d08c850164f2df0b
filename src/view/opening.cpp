// Opens a program with its control and machine. Used by view/page_session; tested by tests/serve.py.

#include "view/opening.h"

#include <fmt/core.h>

#include <cerrno>

#include "config/control_file.h"
#include "config/read_file.h"
#include "config/remembered_control.h"
#include "config/told.h"
#include "lang/text/several_programs.h"
#include "machine/plc.h"
#include "session/folder_guess.h"

namespace kadr {
namespace {

OpenedText text_of(const OpenedProgram& opened) {
  if (opened.text) return {text_source(*opened.text), Encoding::utf8};
  return open_text(opened.path, opened.encoding, opened.door);
}

tl::unexpected<std::string> wrong(std::string text) { return tl::unexpected(std::move(text)); }

/// Returns the control that the request names; else the one that the folder's .kadr.toml names; else the one that `kadr check` would
/// guess, with `opened.guess` set.
tl::expected<std::string, std::string> control_for(const OpeningWish& wish, OpenedProgram& opened) {
  std::string wrong_memory;
  RememberedControls remembered([&](const std::string& why) { wrong_memory = why; }, wish.door);
  const std::string named = wish.control.empty() ? remembered.of(wish.path) : wish.control;
  if (!wrong_memory.empty()) return wrong(wrong_memory);
  if (!named.empty()) {
    const auto beginning = wish.text ? wish.text : beginning_of_program(wish.path, opened.encoding, wish.door);
    if (!beginning) return wrong(fmt::format("{}: {}", wish.path, told_errno(errno)));
    const std::string why = named.ends_with(".toml") ? "" : refused_by_control(*beginning, named, wish.lang == Lang::ru);
    return why.empty() ? tl::expected<std::string, std::string>(named) : wrong(fmt::format("{}: {}", wish.path, why));
  }
  const auto named_for = [&](const std::string& file) { return remembered.of(file); };
  const auto answer = FolderGuess({named_for, opened.encoding, wish.door, wish.text}, {wish.path}).of(wish.path);
  if (!answer) return wrong(fmt::format("{}: {}", wish.path, told_errno(errno)));
  opened.guess = with_neighbours(*answer);
  if (!opened.guess->control.empty()) return opened.guess->control;
  return wrong(fmt::format("{}: {}",
                           told("no program of a control that Kadr knows; name the control to open it all the same",
                                "это не УП для известного УЧПУ; назовите УЧПУ, чтобы открыть его всё равно"),
                           wish.lang == Lang::ru ? opened.guess->reason_ru : opened.guess->reason_en));
}

tl::expected<Program, std::string> program_in(const OpenedProgram& opened, OpenedText text) {
  if (!text.source) return wrong(fmt::format("{}: {}", opened.path, told_errno(errno)));
  Program program{opened.path, {}, text.encoding};
  const std::shared_ptr<ByteSource> source = std::move(text.source);
  program.source = whole_file(source);
  if (!opened.def->grammar.percent_number && opened.number == 0) return program;
  const auto encoding = text.encoding ? text.encoding : detect_encoding(LineReader(source).sample());
  if (count_program_signs(*source, encoding) < 2 && opened.number == 0) return program;
  const TapeContents contents = contents_of(source, opened.def->grammar, encoding);
  const auto index = opened.number == 0 ? std::optional<std::size_t>(0) : program_numbered(contents, opened.number);
  if (!index) return wrong(fmt::format("{}: {} {}", opened.path, told("there is no program", "нет программы"), opened.number));
  if (contents.programs.size() > 1) program.source = only_program(source, contents, *index, encoding);
  return program;
}

}  // namespace

tl::expected<PlacedSetup, std::string> read_with_tables(const OpeningWish& wish, const ControlDef& def) {
  std::vector<SetupSource> sources;
  if (!wish.setup.empty()) {
    auto file = setup_source(wish.setup, wish.door);
    if (!file) return wrong(file.error());
    sources.push_back(std::move(*file));
  }
  if (!wish.tables.empty()) sources.push_back({told("tables", "таблицы"), wish.tables});
  return read_setup(sources, &def, wish.lang);
}

tl::expected<Program, std::string> OpenedProgram::program() const { return program_in(*this, text_of(*this)); }

tl::expected<Program, std::string> OpenedProgram::program_of(OpenedText other) const { return program_in(*this, std::move(other)); }

tl::expected<Program, std::string> OpenedProgram::program_of(const std::string& other) const {
  return program_in(*this, {text_source(other), Encoding::utf8});
}

SessionSpec OpenedProgram::spec(Program program, const StopToken& stop) const {
  RunLimits within = limits;
  within.stop = stop;
  within.door = door;
  return {def, machine, setup, std::move(program), within};
}

tl::expected<OpenedProgram, std::string> open_for_page(const OpeningWish& wish) {
  OpenedProgram opened;
  opened.path = wish.path;
  opened.text = wish.text;
  opened.door = wish.door;
  if (!read_encoding(wish.encoding, opened.encoding)) return wrong(fmt::format("encoding: {}", wish.encoding));
  const auto control = control_for(wish, opened);
  if (!control) return wrong(control.error());
  auto def = load_control(*control, wish.door);
  if (!def) return wrong(def.error());
  opened.def = std::make_shared<const ControlDef>(std::move(*def));
  auto texts = AlarmTexts::load(opened.def.get());
  if (!texts) return wrong(texts.error());
  opened.texts = std::make_shared<const AlarmTexts>(std::move(*texts));
  auto machine = load_machine(wish.machine.empty() ? "generic" : wish.machine, wish.door);
  if (!machine) return wrong(machine.error());
  opened.machine = std::move(*machine);
  opened.tools = tool_table_beside(wish.path, wish.door);
  if (wish.setup.empty() && wish.tables.empty()) return opened;
  auto setup = read_with_tables(wish, *opened.def);
  if (!setup) return wrong(setup.error());
  opened.setup = std::move(setup->setup);
  opened.stated = std::move(setup->stated);
  if (const std::string error = Plc(opened.setup.events, opened.def->tells_of_ends()).error(); !error.empty()) return wrong(error);
  return opened;
}

}  // namespace kadr
