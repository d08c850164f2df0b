// Opens a program with the control and the machine that the page requests. Used by view/page/page_session; tested by tests/serve.py.

#include "view/opening.h"

#include <fmt/core.h>

#include <cerrno>

#include "config/control/control_file.h"
#include "config/control/remembered_control.h"
#include "config/read_file.h"
#include "lang/text/several_programs.h"
#include "machine/plc.h"
#include "session/folder_guess.h"
#include "texts/view.h"

namespace kadr {
namespace {

OpenedText text_of(const OpenedProgram& opened) {
  if (opened.text) return {text_source(*opened.text), Encoding::utf8};
  return open_text(opened.path, opened.encoding, opened.door);
}

tl::unexpected<std::string> wrong(std::string text) { return tl::unexpected(std::move(text)); }

/// Returns the control that the request names. If the request names no control, returns the control that .kadr.toml in the program's folder
/// names, else the control that `kadr check` would guess. A guess is stored in `opened.guess`.
tl::expected<std::string, std::string> control_for(const OpeningRequest& request, OpenedProgram& opened) {
  std::string wrong_memory;
  RememberedControls remembered([&](const std::string& why) { wrong_memory = why; }, request.door);
  const std::string named = request.control.empty() ? remembered.of(request.path) : request.control;
  if (!wrong_memory.empty()) return wrong(wrong_memory);
  if (!named.empty()) {
    const auto beginning = request.text ? request.text : beginning_of_program(request.path, opened.encoding, request.door);
    if (!beginning) return wrong(fmt::format("{}: {}", request.path, errno_message(errno)));
    const std::string why = named.ends_with(".toml") ? "" : refused_by_control(*beginning, named, request.lang);
    return why.empty() ? tl::expected<std::string, std::string>(named) : wrong(fmt::format("{}: {}", request.path, why));
  }
  const auto named_for = [&](const std::string& file) { return remembered.of(file); };
  const auto answer = FolderGuess({named_for, opened.encoding, request.door, request.text}, {request.path}).of(request.path);
  if (!answer) return wrong(fmt::format("{}: {}", request.path, errno_message(errno)));
  opened.guess = with_neighbours(*answer);
  if (!opened.guess->control.empty()) return opened.guess->control;
  return wrong(translated(texts::view::no_known_control, request.lang == Lang::ru ? opened.guess->reason_ru : opened.guess->reason_en));
}

tl::expected<Program, std::string> program_in(const OpenedProgram& opened, OpenedText text) {
  if (!text.source) return wrong(fmt::format("{}: {}", opened.path, errno_message(errno)));
  Program program{opened.path, {}, text.encoding};
  const std::shared_ptr<ByteSource> source = std::move(text.source);
  program.source = whole_file(source);
  if (!opened.def->grammar.percent_number && opened.number == 0) return program;
  const auto encoding = text.encoding ? text.encoding : detect_encoding(LineReader(source).sample());
  if (count_program_signs(*source, encoding) < 2 && opened.number == 0) return program;
  const TapeContents contents = contents_of(source, opened.def->grammar, encoding);
  const auto index = opened.number == 0 ? std::optional<std::size_t>(0) : program_numbered(contents, opened.number);
  if (!index) return wrong(translated(texts::view::no_program_numbered, opened.path, opened.number));
  if (contents.programs.size() > 1) program.source = only_program(source, contents, *index, encoding);
  return program;
}

}  // namespace

tl::expected<PlacedSetup, std::string> read_with_tables(const OpeningRequest& request, const ControlDef& def) {
  std::vector<SetupSource> sources;
  if (!request.setup.empty()) {
    auto file = setup_source(request.setup, request.door);
    if (!file) return wrong(file.error());
    sources.push_back(std::move(*file));
  }
  if (!request.tables.empty()) sources.push_back({translated(texts::view::edited_tables), request.tables});
  return read_setup(sources, &def, request.lang);
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

tl::expected<OpenedProgram, std::string> open_for_page(const OpeningRequest& request) {
  OpenedProgram opened;
  opened.path = request.path;
  opened.text = request.text;
  opened.door = request.door;
  if (!read_encoding(request.encoding, opened.encoding)) return wrong(fmt::format("encoding: {}", request.encoding));
  const auto control = control_for(request, opened);
  if (!control) return wrong(control.error());
  auto def = load_control(*control, request.door);
  if (!def) return wrong(def.error());
  opened.def = std::make_shared<const ControlDef>(std::move(*def));
  auto texts = AlarmTexts::load(opened.def.get());
  if (!texts) return wrong(texts.error());
  opened.texts = std::make_shared<const AlarmTexts>(std::move(*texts));
  auto machine = load_machine(request.machine.empty() ? "generic" : request.machine, request.door);
  if (!machine) return wrong(machine.error());
  opened.machine = std::move(*machine);
  opened.tools = tool_table_next_to(request.path, request.door);
  if (request.setup.empty() && request.tables.empty()) return opened;
  auto setup = read_with_tables(request, *opened.def);
  if (!setup) return wrong(setup.error());
  opened.setup = std::move(setup->setup);
  opened.stated = std::move(setup->stated);
  if (const std::string error = Plc(opened.setup.events, opened.def->reports_program_ends()).error(); !error.empty()) return wrong(error);
  return opened;
}

}  // namespace kadr
