// Answers the requests `tables`, `edit` and `keep_tables`, about the tables of a machine at its panel, and `shift`, about the log of the
// machine. Used by view/page/page_session; tested by tests/panel_tables.py.

#include <algorithm>

#include "config/json_text.h"
#include "config/state/state_json.h"
#include "texts/panel_page.h"
#include "view/page/page_inside.h"
#include "view/panel_content.h"

namespace kadr {
namespace {

constexpr std::size_t max_variables = 5000;

PageJson variables_json(const std::vector<PanelVariable>& variables) {
  PageJson list = PageJson::array();
  for (const PanelVariable& one : variables) {
    if (list.size() == max_variables) break;
    list.push_back({{"name", one.name}, {"value", std::isfinite(one.value) ? PageJson(one.value) : PageJson()}, {"line", one.line}});
  }
  return list;
}

/// Returns the present values of the tables that a program may change.
PageJson tables_of(const std::optional<RunState>& state) {
  PageJson tables = PageJson::object();
  if (!state) return tables;
  const PageJson all = ordered_json_of(state_json(*state));
  for (const char* const name : {"work_offsets", "offsets"})
    if (all.is_object() && all.contains(name)) tables[name] = all[name];
  return tables;
}

}  // namespace

PageSession::Inside::Answer PageSession::Inside::tables(const PageJson&) {
  if (!hub_machine) return refused(translated(texts::panel_page::no_machine));
  const PanelProgram& program = content_of(*hub_machine).program;
  const auto file = program.of_file();
  if (!file) return refused(file.error());
  const auto now = hub_machine->machine->tables();
  if (!now) return refused(now.error());
  PageJson of_file = PageJson::object();
  const auto sections = program.sections();
  for (const std::string& name : sections)
    if (file->contains(name)) of_file[name] = (*file)[name];
  return PageJson{{"sections", sections},
                  {"setup", program.setup_file().empty() ? std::string() : server.folder.shown(program.setup_file())},
                  {"file", std::move(of_file)},
                  {"edited", program.edited()},
                  {"now", tables_of(now->state)},
                  {"variables", variables_json(now->variables)},
                  {"lasts", server.journal != nullptr && server.journal->lasts()}};
}

/// Checks an edit of tables, saves it, and then applies it. The page thus receives the confirmation only after the edit is saved.
PageSession::Inside::Answer PageSession::Inside::edit(const PageJson& question) {
  const auto machine = held_machine();
  if (!machine) return tl::unexpected(machine.error());
  const auto patch = question.find("tables");
  if (patch == question.end() || !patch->is_object()) return refused(translated(texts::panel_page::tables_wanted));
  PanelProgram& program = content_of(*hub_machine).program;
  const std::lock_guard one_at_a_time(content_of(*hub_machine).edits);
  const auto sections = program.sections();
  for (const auto& [name, rows] : patch->items())
    if (std::find(sections.begin(), sections.end(), name) == sections.end())
      return refused(translated(texts::panel_page::no_such_table, name));
  auto changed = program.changed(*patch);
  if (!changed) return refused(changed.error());
  if (const std::string fault = program.refusal(*changed); !fault.empty()) return refused(fault);
  if (const auto may = (*machine)->may_apply_tables(); !may) return refused(may.error());
  if (const std::string fault = keep("tables", dumped(changed->edited)); !fault.empty()) return refused(fault);
  if (!program.take(std::move(*changed))) {
    (void)keep("tables", dumped(program.edited()));
    return refused(translated(texts::panel_page::tables_changed_meanwhile));
  }
  note("edit", dumped(*patch), 0);
  const auto taken = (*machine)->take_tables();
  if (!taken) return refused(taken.error());
  return PageJson{{"edited", program.edited()}};
}

/// Writes the edits of the tables into the set-up file, or into a new file if the program has no set-up file.
PageSession::Inside::Answer PageSession::Inside::keep_tables(const PageJson& question) {
  const auto machine = held_machine();
  if (!machine) return tl::unexpected(machine.error());
  const PanelProgram& program = content_of(*hub_machine).program;
  const std::string file = value_in<std::string>(question, "setup", "");
  if (!file.ends_with(".json")) return refused(translated(texts::panel_page::setup_name_wanted));
  const bool is_own = !program.setup_file().empty() && file == server.folder.shown(program.setup_file());
  auto whole = is_own ? program.of_file() : PageJson::object();
  if (!whole) return refused(whole.error());
  std::optional<FileDigest> replaces;
  if (is_own) {
    const auto digest = server.folder.digest(file);
    if (!digest) return refused(digest.error());
    replaces = *digest;
  }
  whole->merge_patch(program.edited());
  const auto saved = server.folder.save(file, whole->dump(2) + "\n", replaces);
  if (!saved) return tl::unexpected(Refusal{saved.error().text, saved.error().changed});
  note("keep", file, 0);
  return PageJson{{"digest", *saved}};
}

/// Answers with the log of the machine, the oldest entry first.
PageSession::Inside::Answer PageSession::Inside::shift(const PageJson& question) {
  const std::string name = value_in<std::string>(question, "file", hub_machine ? hub_machine->name : "");
  if (server.journal == nullptr || name.empty()) return refused(translated(texts::panel_page::no_machine));
  const std::vector<std::string> log = server.journal->log_of(name);
  const std::size_t most = std::max<std::uint32_t>(1, count_in(question, "count", 10'000));
  PageJson list = PageJson::array();
  for (std::size_t i = log.size() > most ? log.size() - most : 0; i < log.size(); ++i)
    if (PageJson entry = ordered_json_of(log[i]); entry.is_object()) list.push_back(std::move(entry));
  return PageJson{{"log", std::move(list)}, {"lasts", server.journal->lasts()}};
}

}  // namespace kadr
