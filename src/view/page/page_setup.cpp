// Answers the requests `setup_form` and `keep_setup`: what the open program uses of a set-up, and the set-up file that the page has
// changed. Used by view/page/page_session; tested by tests/serve_setup.py.

#include <algorithm>

#include "config/json_text.h"
#include "config/setup/setup_check.h"
#include "config/setup/setup_file.h"
#include "config/setup/setup_keys.h"
#include "config/setup/setup_names.h"
#include "out/program/setup_template.h"
#include "session/setup_use.h"
#include "texts/page.h"
#include "texts/panel_page.h"
#include "texts/view.h"
#include "view/page/page_inside.h"

namespace kadr {
namespace {

constexpr std::size_t max_setup = std::size_t{1} << 20;  // greatest size in bytes of a set-up file that the form changes
constexpr std::size_t max_setups = 200;                  // greatest number of set-ups that a page can choose from

std::string folder_part_of(const std::string& file) {
  const std::size_t slash = file.rfind('/');
  return slash == std::string::npos ? "" : file.substr(0, slash + 1);
}

/// Returns the set-ups in the folder of a program, relative to the served folder.
PageJson setups_beside(const ServedFolder& folder, const std::string& program) {
  PageJson names = PageJson::array();
  const std::string before = folder_part_of(program);
  const auto list = folder.list(before.empty() ? before : before.substr(0, before.size() - 1));
  if (!list) return names;
  for (const FolderEntry& entry : list->entries)
    if (entry.kind == FolderEntry::Kind::setup && names.size() < max_setups) names.push_back(before + entry.name);
  return names;
}

PageJson comment_json(const ToolProposal& comment) { return {{"line", comment.line}, {"text", comment.text}}; }

const char* name_of_switch(UseKind kind) {
  return kind == UseKind::skip_switch ? "skip" : kind == UseKind::optional_stop ? "optional_stop" : "tool";
}

PageJson row_json(const SetupUseRow& row, const Control& control, const ServedFolder& folder) {
  PageJson json = {{"table", row.table.empty() ? name_of_switch(row.use.kind) : row.table},
                   {"row", row.table.empty() ? std::to_string(row.use.number) : row.row},
                   {"word", row.used.word},
                   {"line", row.use.origin.line},
                   {"cells", PageJson::array()}};
  if (row.use.origin.file != 0) json["file_name"] = folder.shown(control.file_name(row.use.origin.file));
  if (row.use.tool != 0) json["tool"] = row.use.tool;
  for (const SetupUseRow::Cell& cell : row.cells) {
    json["cells"].push_back({{"key", cell.key}});
    if (cell.proposed) json["cells"].back()["proposed"] = *cell.proposed;
  }
  if (row.by) json["by"] = comment_json(*row.by);
  if (row.by && row.by->tool_data.diameter) json["diameter"] = *row.by->tool_data.diameter;
  if (row.unsure) json["unsure"] = comment_json(*row.unsure);
  return json;
}

/// Returns the columns that the offset table of a control may have, with what each of them is.
PageJson offset_columns(const ControlDef& def, Lang lang) {
  constexpr std::string_view before = "offsets.*.";
  PageJson columns = PageJson::array();
  for (const SetupKey& key : setup_keys()) {
    if (!key.path.starts_with(before) || !has(def, key.needs)) continue;
    columns.push_back({{"key", key.path.substr(before.size())}, {"about", plain_text(key.about, lang)}, {"unit", name_of(key.unit, lang)}});
  }
  return columns;
}

/// Returns the tables that a set-up of the control may have and that the form shows.
PageJson form_tables(const ControlDef& def) {
  PageJson all = PageJson::array();
  for (const char* const name : {"work_offsets", "zeros", "offsets", "correctors", "variables"}) {
    const nlohmann::json table = {{name, nlohmann::json::object()}};
    if (!fault_of(table, table, &def)) all.push_back(name);
  }
  return all;
}

}  // namespace

/// Reads a set-up of the open program's control. Returns nullopt if there is no such file, or if it is no set-up.
std::optional<FileText> PageSession::Inside::setup_file(const std::string& file) const {
  auto found = server.folder.read(file, max_setup);
  if (!found || !read_setup({{file, found->bytes}}, run->opened().def.get(), lang)) return std::nullopt;
  return std::move(*found);
}

/// Answers with what the program uses of a set-up, with what its set-up states, and with what its comments propose. The set-up is the one
/// with which the program was opened, else the one that has the name of the program.
PageSession::Inside::Answer PageSession::Inside::setup_form(const PageJson&) {
  const OpenedProgram& opened = run->opened();
  auto program = opened.program();
  if (!program) return refused(program.error());
  SessionSpec spec = opened.spec(std::move(*program), token());
  spec.setup.channels.clear();
  spec.limits.restarts = 0;
  const auto session = Session::open(std::move(spec));
  if (!session) return refused(in_thread_language(session.error().fault.en, session.error().fault.ru));
  const ExecutedBlocks done = execute_for_use(**session, token());
  if (token().requested()) return refused(translated(texts::page::interrupted));
  const Control& control = (*session)->control();
  const SetupUse use = setup_use(control, *opened.def, done);
  const std::string shown = server.folder.shown(opened.path);
  const std::size_t dot = shown.find_last_of('.');
  const bool has_ending = dot != std::string::npos && dot > folder_part_of(shown).size();
  std::string file =
      opened_request.setup.empty() ? shown.substr(0, has_ending ? dot : shown.size()) + ".json" : server.folder.shown(opened_request.setup);
  const auto text = setup_file(file);
  if (!text) file = free_name(file, ".json");
  PageJson json = {{"file", file},
                   {"digest", text ? PageJson(text->digest) : PageJson()},
                   {"in_force", !opened_request.setup.empty()},
                   {"stated", text ? ordered_json_of(text->bytes) : PageJson::object()},
                   {"setups", setups_beside(server.folder, shown)},
                   {"tables", form_tables(*opened.def)},
                   {"columns", offset_columns(*opened.def, lang)},
                   {"axes", control.axes()},
                   {"rows", PageJson::array()},
                   {"faults", use.faults},
                   {"not_executed", use.not_executed}};
  for (const SetupUseRow& row : use.rows) json["rows"].push_back(row_json(row, control, server.folder));
  return json;
}

/// Changes a set-up file of the open program, or makes a new one. The file keeps what `values` does not name.
PageSession::Inside::Answer PageSession::Inside::keep_setup(const PageJson& question) {
  if (!may_change) return refused(translated(texts::page::may_not_save));
  const std::string file = value_in<std::string>(question, "file", "");
  if (!file.ends_with(".json")) return refused(translated(texts::panel_page::setup_name_wanted));
  const auto values = question.find("values");
  if (values == question.end() || !values->is_object()) return refused(translated(texts::page::setup_values_wanted));
  PageJson whole = PageJson::object();
  std::optional<FileDigest> replaces;
  if (const auto digest = question.find("digest"); digest != question.end() && digest->is_string()) {
    const auto before = setup_file(file);
    replaces = digest->get<std::string>();
    if (!before || before->digest != *replaces) return tl::unexpected(Refusal{translated(texts::view::changed_since, file), true});
    whole = ordered_json_of(before->bytes);
  }
  whole.merge_patch(*values);
  const std::string text = setup_text(whole);
  const OpenedProgram& opened = run->opened();
  auto setup = read_setup({{file, text}}, opened.def.get(), lang);
  if (!setup) return refused(setup.error());
  auto program = opened.program();
  if (!program) return refused(program.error());
  SessionSpec spec = opened.spec(std::move(*program), token());
  spec.setup = std::move(setup->setup);
  if (const auto session = Session::open(std::move(spec)); !session)
    return refused(in_thread_language(session.error().fault.en, session.error().fault.ru));
  const auto saved = server.folder.save(file, text, replaces);
  if (!saved) return tl::unexpected(Refusal{saved.error().text, saved.error().changed});
  opened_names.insert(file);
  return PageJson{{"digest", *saved}};
}

}  // namespace kadr
