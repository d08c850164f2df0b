// What a machine's sessions are made of. For view/page_panel, view/page_tables; tested by tests/panel_tables.py.

#include "view/panel_program.h"

#include "config/setup_check.h"
#include "config/setup_file.h"
#include "config/told.h"

namespace kadr {
namespace {

constexpr std::size_t most_edited = 1 << 20;  // bytes

/// Where the axes stand when the program begins; the tables are those of the set-up.
Setup standing_at(Setup setup, const std::vector<std::string>& axes, const Axes& start) {
  setup.start_in_work = false;
  for (std::size_t a = 0; a < std::min(axes.size(), max_axes); ++a) setup.start[axes[a]] = start[a];
  return setup;
}

}  // namespace

PanelProgram::PanelProgram(OpenedProgram opened, OpeningWish wish)
    : opened_(std::move(opened)), wish_(std::move(wish)), edited_(PageJson::object()), setup_(opened_.setup) {
  if (!wish_.tables.empty()) edited_ = PageJson::parse(wish_.tables, nullptr, false);
  if (!edited_.is_object()) edited_ = PageJson::object();
}

tl::expected<std::unique_ptr<Session>, std::string> PanelProgram::open(const std::optional<Axes>& start, const StopToken& stop) {
  auto text = opened_.program();
  if (!text) return tl::unexpected(text.error());
  SessionSpec spec = opened_.spec(std::move(*text), stop);
  {
    const std::lock_guard hold(lock_);
    spec.setup = start ? standing_at(setup_, axes_, *start) : setup_;
  }
  auto session = Session::open(std::move(spec));
  if (!session) return tl::unexpected(told(session.error().fault.en, session.error().fault.ru));
  const std::lock_guard hold(lock_);
  axes_ = (*session)->control().axes();
  return std::move(*session);
}

tl::expected<PageJson, std::string> PanelProgram::of_file() const {
  if (wish_.setup.empty()) return PageJson::object();
  const auto source = setup_source(wish_.setup, wish_.door);
  if (!source) return tl::unexpected(source.error());
  PageJson json = PageJson::parse(source->json, nullptr, false);
  return json.is_object() ? json : PageJson::object();
}

tl::expected<PanelProgram::Tables, std::string> PanelProgram::changed(const PageJson& patch) const {
  Tables tables{edited(), {}};
  tables.edited.merge_patch(patch);
  const std::string text = dumped(tables.edited);
  if (!tables.edited.is_object() || text.size() > most_edited) return tl::unexpected(told("these are no tables", "это не таблицы"));
  OpeningWish wish = wish_;
  wish.tables = text;
  wish.lang = told_lang();
  auto setup = read_with_tables(wish, *opened_.def);
  if (!setup) return tl::unexpected(setup.error());
  tables.setup = std::move(setup->setup);
  return tables;
}

void PanelProgram::take(Tables tables) {
  const std::lock_guard hold(lock_);
  edited_ = std::move(tables.edited);
  setup_ = std::move(tables.setup);
}

PageJson PanelProgram::edited() const {
  const std::lock_guard hold(lock_);
  return edited_;
}

std::vector<std::string> PanelProgram::sections() const {
  std::vector<std::string> all;
  for (const char* const name : {"work_offsets", "zeros", "offsets", "correctors", "tool_table", "place_table", "form_table", "variables", "parameters"}) {
    const nlohmann::json table = {{name, nlohmann::json::object()}};
    if (!fault_of(table, table, opened_.def.get())) all.push_back(name);
  }
  return all;
}

}  // namespace kadr
