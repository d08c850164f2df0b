// Opens the sessions of a panel machine, and edits its tables (PanelProgram). Used by view/page/page_panel, view/page/page_tables; tested
// by tests/panel_tables.py.

#include "view/panel_program.h"

#include "config/json_text.h"
#include "config/language.h"
#include "config/setup/setup_check.h"
#include "config/setup/setup_file.h"
#include "config/state/state_json.h"
#include "texts/view.h"
#include "view/source_text.h"

namespace kadr {
namespace {

constexpr std::size_t max_edited = 1 << 20;  // greatest size in bytes of all edits as JSON

/// Returns the set-up with `start` as the start position of the axes; the tables are unchanged.
Setup standing_at(Setup setup, const std::vector<std::string>& axes, const Axes& start) {
  setup.start_in_work = false;
  for (std::size_t a = 0; a < std::min(axes.size(), max_axes); ++a) setup.start[axes[a]] = start[a];
  return setup;
}

PageJson tables_json(const Setup& tables) { return ordered_json_of(state_json({tables, {}, {}})); }

PageJson part_of(const PageJson& rows, const std::string& name, const std::string& part) {
  const auto row = rows.find(name);
  return row == rows.end() || !row->contains(part) ? PageJson(0) : (*row)[part];
}

/// Compares two versions of a table of numbers, and returns the changed rows. Each row contains the values that have changed, and the
/// values that differ from `stated`, the version in the set-up file.
PageJson changed_numbers(const PageJson& before, const PageJson& after, const PageJson& stated) {
  PageJson rows = PageJson::object(), all = before;
  all.merge_patch(after);
  for (const auto& [name, row] : all.items()) {
    if (before.value(name, PageJson()) == after.value(name, PageJson())) continue;
    for (const auto& [part, value] : row.items())
      if (const PageJson now = part_of(after, name, part); now != part_of(before, name, part) || now != part_of(stated, name, part))
        rows[name][part] = now;
  }
  return rows;
}

/// Compares two versions of a table. Returns the changed rows with their values in `after`; null for a row that `after` does not have.
PageJson changed_rows(const PageJson& before, const PageJson& after) {
  PageJson rows = PageJson::object();
  for (const auto& [name, row] : after.items())
    if (!before.contains(name) || before[name] != row) rows[name] = row;
  for (const auto& [name, row] : before.items())
    if (!after.contains(name)) rows[name] = nullptr;
  return rows;
}

/// Returns the change of tables from `before` to `after` as a JSON merge patch for a set-up file that states `stated`.
PageJson difference(const Setup& before, const Setup& after, const Setup& stated) {
  const PageJson then = tables_json(before), now = tables_json(after), stated_json = tables_json(stated);
  const auto table_of = [](const PageJson& tables, const char* name) { return tables.value(name, PageJson::object()); };
  PageJson patch = PageJson::object();
  for (const char* const table : {"work_offsets", "offsets", "parameters", "tool_table"}) {
    const bool are_numbers = std::string_view(table).ends_with("offsets");
    PageJson rows = are_numbers ? changed_numbers(table_of(then, table), table_of(now, table), table_of(stated_json, table))
                                : changed_rows(table_of(then, table), table_of(now, table));
    if (!rows.empty()) patch[table] = std::move(rows);
  }
  return patch;
}

}  // namespace

PanelProgram::PanelProgram(OpenedProgram opened, OpeningRequest request)
    : opened_(std::move(opened)), request_(std::move(request)), edited_(PageJson::object()), setup_(opened_.setup) {
  if (!request_.tables.empty()) edited_ = ordered_json_of(request_.tables);
  if (!edited_.is_object()) edited_ = PageJson::object();
}

void PanelProgram::take_text(std::shared_ptr<const std::string> bytes, std::string digest) {
  const std::lock_guard hold(lock_);
  bytes_ = std::move(bytes), digest_ = std::move(digest);
}

std::string PanelProgram::digest() const {
  const std::lock_guard hold(lock_);
  return digest_;
}

std::optional<std::string> PanelProgram::text() const {
  std::shared_ptr<const std::string> bytes;
  {
    const std::lock_guard hold(lock_);
    bytes = bytes_;
  }
  if (!bytes) return std::nullopt;
  return SourceText(as_text(shared_text_source(bytes), opened_.encoding)).whole();
}

tl::expected<Program, std::string> PanelProgram::program() const {
  std::shared_ptr<const std::string> bytes;
  {
    const std::lock_guard hold(lock_);
    bytes = bytes_;
  }
  return bytes ? opened_.program_of(as_text(shared_text_source(bytes), opened_.encoding)) : opened_.program();
}

bool PanelProgram::knows_axes() const {
  const std::lock_guard hold(lock_);
  return !axes_.empty();
}

tl::expected<std::unique_ptr<Session>, std::string> PanelProgram::open(const std::optional<Axes>& start, const StopToken& stop) {
  if (start && !knows_axes())
    if (auto first = open({}, stop); !first) return first;  // this session provides the names of the axes, which standing_at() needs
  auto text = program();
  if (!text) return tl::unexpected(text.error());
  SessionSpec spec = opened_.spec(std::move(*text), stop);
  {
    const std::lock_guard hold(lock_);
    spec.setup = start ? standing_at(setup_, axes_, *start) : setup_;
  }
  auto session = Session::open(std::move(spec));
  if (!session) return tl::unexpected(in_thread_language(session.error().fault.en, session.error().fault.ru));
  const std::lock_guard hold(lock_);
  axes_ = (*session)->control().axes();
  return std::move(*session);
}

tl::expected<PageJson, std::string> PanelProgram::of_file() const {
  if (request_.setup.empty()) return PageJson::object();
  const auto source = setup_source(request_.setup, request_.door);
  if (!source) return tl::unexpected(source.error());
  PageJson json = ordered_json_of(source->json);
  return json.is_object() ? json : PageJson::object();
}

tl::expected<PanelProgram::Tables, std::string> PanelProgram::changed(const PageJson& patch) const {
  Tables tables;
  {
    const std::lock_guard hold(lock_);
    tables.edited = edited_, tables.after = changes_;
  }
  tables.edited.merge_patch(patch);
  const std::string text = dumped(tables.edited);
  if (!tables.edited.is_object() || text.size() > max_edited) return tl::unexpected(translated(texts::view::no_tables));
  OpeningRequest request = request_;
  request.tables = text;
  request.lang = thread_language();
  auto setup = read_with_tables(request, *opened_.def);
  if (!setup) return tl::unexpected(setup.error());
  tables.setup = complete_ ? complete_(std::move(setup->setup)) : std::move(setup->setup);
  return tables;
}

std::string PanelProgram::refusal(const Tables& tables) const {
  auto text = program();
  if (!text) return text.error();
  SessionSpec spec = opened_.spec(std::move(*text), {});
  spec.setup = tables.setup;
  const auto session = Session::open(std::move(spec));
  return session ? std::string() : in_thread_language(session.error().fault.en, session.error().fault.ru);
}

bool PanelProgram::take(Tables tables) {
  const std::lock_guard hold(lock_);
  if (tables.after != changes_) return false;
  ++changes_;
  edited_ = std::move(tables.edited);
  setup_ = std::move(tables.setup);
  return true;
}

tl::expected<PageJson, std::string> PanelProgram::take_by_hand(const Setup& before, const Setup& after) {
  while (true) {
    Setup stated;
    {
      const std::lock_guard hold(lock_);
      stated = setup_;
    }
    const PageJson patch = difference(before, after, stated);
    auto tables = changed(patch);
    if (!tables) return tl::unexpected(tables.error());
    if (take(std::move(*tables))) return patch;
  }
}

PageJson PanelProgram::edited() const {
  const std::lock_guard hold(lock_);
  return edited_;
}

std::vector<std::string> PanelProgram::sections() const {
  std::vector<std::string> all;
  for (const char* const name :
       {"work_offsets", "zeros", "offsets", "correctors", "tool_table", "place_table", "form_table", "variables", "parameters"}) {
    const nlohmann::json table = {{name, nlohmann::json::object()}};
    if (!fault_of(table, table, opened_.def.get())) all.push_back(name);
  }
  return all;
}

}  // namespace kadr
