// Loads controls/*.toml as ControlDef: merges a file with the control that it extends. Used by cli; tested by
// tests/config/control_file_test.cpp.

#include "config/control/control_file.h"

#include <algorithm>
#include <set>

#include "base/file_id.h"
#include "config/control/control_loader.h"
#include "config/embedded.h"
#include "config/nearest.h"
#include "config/packed_toml.h"
#include "config/read_file.h"
#include "config/setup/parameter_table.h"
#include "texts/control_file.h"

namespace kadr {

namespace {

using Table = tl::expected<toml::table, std::string>;

/// The form in which a built-in file is read: the packed table, which is fast to read, or the text, whose nodes have line numbers. A build
/// for browsers has only the table.
enum class From : std::uint8_t { table, text };

std::optional<Table> built_in(const std::string& file, From from) {
  const auto text = toml_tools::embedded_text(file);
  if (from == From::table || (text && text->empty())) return toml_tools::embedded_table(file);
  return text ? std::optional(toml_tools::parsed(*text, file)) : std::nullopt;
}

/// Adds the section [expressions] if neither the file nor its base has one. A control with macros gets the rows of nct; any other gets
/// those of mach3, which are the rows of RS274/NGC.
void lay_operations(toml::table& under, const toml::table& over) {
  const auto is_on = [&](std::string_view key) {
    return over["grammar"][key].value<bool>().value_or(under["grammar"][key].value_or(false));
  };
  if (under.contains("expressions") || !is_on("expressions")) return;
  auto base = toml_tools::embedded_sections(is_on("macro") ? "controls/nct.toml" : "controls/mach3.toml", {"expressions"});
  if (base) under.insert("expressions", std::move(*(*base)["expressions"].as_table()));
}

/// Returns true if two nodes of any type are equal.
bool are_equal(const toml::node& a, const toml::node& b) {
  if (a.type() != b.type()) return false;
  switch (a.type()) {
    case toml::node_type::string: return *a.as_string() == *b.as_string();
    case toml::node_type::integer: return *a.as_integer() == *b.as_integer();
    case toml::node_type::floating_point: return *a.as_floating_point() == *b.as_floating_point();
    case toml::node_type::boolean: return *a.as_boolean() == *b.as_boolean();
    case toml::node_type::array: return *a.as_array() == *b.as_array();
    case toml::node_type::table: return *a.as_table() == *b.as_table();
    default: return false;
  }
}

/// Returns true if the table `below` contains every key of `row` with the same value.
bool is_part_of(const toml::table& row, const toml::table& below) {
  return !row.empty() && std::all_of(row.begin(), row.end(), [&](const auto& entry) {
    const toml::node* const same = below.get(entry.first.str());
    return same != nullptr && are_equal(entry.second, *same);
  });
}

/// Removes the rows of the base control for which this control's file has the value `false`.
void take_away(toml::table& merged_table) {
  for (const std::string_view section : {"g", "m", "address", "cycle", "groups", "alarms"}) {
    toml::table* const rows = merged_table[section].as_table();
    if (rows == nullptr) continue;
    std::vector<std::string> gone;
    for (const auto& [key, row] : *rows)
      if (row.value<bool>() == false) gone.emplace_back(key.str());
    for (const std::string& key : gone) rows->erase(key);
  }
}

/// Finds a row, or a key of a section without rows, that only repeats a value of the base control. Returns a message with its location.
std::optional<std::string> repeated_row(const toml::table& under, const toml::table& over, const std::string& file) {
  constexpr std::string_view with_rows[] = {"g", "m", "address", "groups", "cycle", "alarms"};
  constexpr std::string_view one_by_one[] = {"grammar", "behaviour", "axes", "order", "feed_codes", "speed_codes", "convert"};
  const auto each = [&](std::string_view name, bool rows) -> std::optional<std::string> {
    const toml::table *const below = under[name].as_table(), *const own = over[name].as_table();
    if (below == nullptr || own == nullptr) return std::nullopt;
    for (const auto& [key, node] : *own) {
      const toml::node* const same = below->get(key.str());
      if (same == nullptr || node.is_table() != rows || same->type() != node.type()) continue;
      const bool is_same = rows ? is_part_of(*node.as_table(), *same->as_table()) : are_equal(node, *same);
      if (is_same) return toml_tools::place(file, node) + translated(texts::control_file::repeats_base, name, key.str());
    }
    return std::nullopt;
  };
  for (const std::string_view name : with_rows)
    if (auto fault = each(name, true)) return fault;
  for (const std::string_view name : one_by_one)
    if (auto fault = each(name, false)) return fault;
  return std::nullopt;
}

/// Inherits the variables of the base control. A variable whose symbol occurs in the file is left out, because the row of the file replaces
/// it. A row of the file without the key `is` only removes the variable.
void lay_variables(const toml::table& under, toml::table& over) {
  const toml::array* const below = under["variables"].as_array();
  toml::array* const own = over["variables"].as_array();
  if (below == nullptr || own == nullptr) return;
  const auto symbol_of = [](const toml::node& row) {
    const toml::table* const table = row.as_table();
    return table == nullptr ? std::string() : (*table)["symbol"].value_or(std::string());
  };
  std::set<std::string> replaced;
  for (const toml::node& row : *own) replaced.insert(symbol_of(row));
  replaced.erase("");
  for (const toml::node& row : *below)
    if (!replaced.contains(symbol_of(row))) row.visit([&](const auto& value) { own->push_back(value); });
  for (auto row = own->begin(); row != own->end();) {
    const toml::table* const table = row->as_table();
    const bool removes = table != nullptr && table->size() == 1 && table->contains("symbol");
    row = removes ? own->erase(row) : std::next(row);
  }
}

bool is_built_in(const std::string& file) { return toml_tools::embedded_text(file).has_value(); }

/// Clears all `manual` keys. They refer to the manual of the base control, so a control with another manual must not inherit them.
void forget_sections(toml::table& table) {
  for (auto&& [key, value] : table) {
    if (key == "manual" && value.is_string()) *value.as_string() = "";
    else if (toml::table* const inner = value.as_table()) forget_sections(*inner);
    else if (toml::array* const rows = value.as_array())
      for (toml::node& row : *rows)
        if (toml::table* const one = row.as_table()) forget_sections(*one);
  }
}

/// The controls and files that merged() has found by following `extends` from file to file.
struct Below {
  std::vector<std::string>& lineage;  // ids of the base controls
  std::set<FileId> files;             // the user's own files so far; a file that occurs a second time extends itself, which is a fault
};

/// The controls over which the rows of a file are laid.
struct Bases {
  std::optional<std::string> next;  // control that the file extends
  std::string over;                 // control that `next` extends here, in place of its own base; empty: its own base
};

/// Reads the key `extends`: the name of a control; or two names, [A, B], of which B is laid over A, not over its own base. `over`: the
/// control in place of the base that the file itself names; empty if there is none.
Bases bases_of(const toml::table& table, const std::string& over) {
  const auto base = table["extends"].value<std::string>();
  if (!over.empty()) return {over, {}};
  if (const toml::array* const pair = table["extends"].as_array(); pair != nullptr && pair->size() == 2)
    return {(*pair)[1].value<std::string>(), (*pair)[0].value_or(std::string())};
  return {base, {}};
}

/// Prepares a file that is laid over a control of another maker: the file gives that control no alarm numbers, and a code that means
/// something of its own (key `does`) keeps nothing of the other maker's code of the same name.
void lay_on_other_maker(toml::table& under, toml::table& over) {
  over.erase("alarms");
  for (const std::string_view section : {"g", "m"}) {
    toml::table *const below = under[section].as_table(), *const own = over[section].as_table();
    if (below == nullptr || own == nullptr) continue;
    for (const auto& [key, row] : *own)
      if (row.is_table() && row.as_table()->contains("does")) below->erase(key.str());
  }
}

/// Returns the table of a file, merged over the tables of the controls that it extends.
///   over  id of the control over which the file is laid, in place of the base that the file names; empty: the base that the file names
Table merged(Table table, const std::string& file, From from, Below& below, const FileAccess* door, const std::string& over = {}) {
  constexpr std::size_t deepest = 16;  // greatest number of controls that may extend one another
  if (!table) return table;
  const auto [base, base_over] = bases_of(*table, over);
  if (!base && table->contains("extends"))
    return Failed(toml_tools::place(file, *table->get("extends")) + translated(texts::control_file::extends_form));
  if (!base) return table;
  if (!table->contains("id")) return Failed(translated(texts::control_file::extending_needs_id, file));
  if (below.lineage.size() == deepest) return Failed(translated(texts::control_file::extends_too_deep, file, deepest));
  below.lineage.push_back(*base);
  std::string name = "controls/" + *base + ".toml";
  auto base_table = built_in(name, from);
  if (!base_table) {
    const auto slash = file.rfind('/');
    name = (slash == std::string::npos || base->starts_with('/') ? std::string() : file.substr(0, slash + 1)) + *base;
    const auto text = read_file(name, limits::config_file_bytes, door);
    if (!text) return Failed(translated(texts::control_file::extended_not_found, file, *base, text.error()));
    if (!below.files.insert(file_id_of(name).value_or(FileId{})).second)
      return Failed(translated(texts::control_file::extends_itself, file));
    base_table = toml_tools::parsed(*text, name);
  }
  auto under = merged(std::move(*base_table), name, from, below, door, base_over);
  if (!under) return under;
  if (!over.empty()) lay_on_other_maker(*under, *table);
  // The keys `aliases`, `guess` and `systems` belong to the base control only, so a control that extends it does not inherit them
  for (const std::string_view own : {"aliases", "guess", "systems"}) under->erase(own);
  if (const auto spec = (*table)["spec"].value<std::string>(); spec && spec != (*under)["spec"].value<std::string>())
    forget_sections(*under);
  if (const auto fault = is_built_in(file) ? std::nullopt : repeated_row(*under, *table, file)) return Failed(*fault);
  lay_operations(*under, *table);
  lay_variables(*under, *table);
  if (toml::table* const alarms = (*table)["alarms"].as_table(); alarms != nullptr && (*alarms)["alone"].value_or(false)) {
    under->erase("alarms");  // [alarms] has the key `alone`, so the control does not inherit numbers and texts of alarms
    alarms->erase("alone");
  }
  toml_tools::merge(*under, std::move(*table));
  take_away(*under);
  return under;
}

/// Returns false for files of controls/ that do not describe a control: texts of alarms, program languages that Kadr does not read,
/// parameter tables.
bool is_control(std::string_view name) { return name != "alarms" && name != "dialects" && !is_parameter_table(name); }

/// Returns the id of the control with this name: the name itself if it is an id, or the id that the alias belongs to.
std::string id_meant_by(const std::string& name) {
  if (toml_tools::embedded_text("controls/" + name + ".toml")) return name;
  const auto& aliases = control_aliases();
  const auto found = std::find_if(aliases.begin(), aliases.end(), [&](const auto& row) { return row.first == name; });
  return found == aliases.end() ? name : found->second;
}

}  // namespace

std::int32_t ControlDef::row_of(char letter, std::int32_t tenth) const {
  const std::vector<std::int16_t>& rows = letter == 'G' ? g_rows : m_rows;
  // As an unsigned index, a negative code is greater than every row's index, so the function returns -1 for it
  const auto at = static_cast<std::size_t>(tenth);
  if (at < rows.size() && rows[at] >= 0) return rows[at];
  if (letter == 'M' && m_user_row >= 0 && tenth >= m_user_from && tenth <= m_user_to && tenth % 10 == 0) return m_user_row;
  return -1;
}

namespace {

tl::expected<ControlDef, std::string> load(Table own, const std::string& file, From from, const FileAccess* door) {
  std::vector<std::string> lineage;
  Below below{lineage, {}};
  if (const auto id = file_id_of(file)) below.files.insert(*id);
  auto table = merged(std::move(own), file, from, below, door);
  if (!table) return Failed(table.error());
  lay_operations(*table, *table);
  auto def = ControlLoader(*table, file).load();
  if (def) def->lineage = std::move(lineage);
  return def;
}

}  // namespace

tl::expected<ControlDef, std::string> parse_control(std::string_view toml, const std::string& file) {
  return load(toml_tools::parsed(toml, file), file, From::text, nullptr);
}

tl::expected<ControlDef, std::string> load_control(const std::string& name, const FileAccess* door) {
  if (name.ends_with(".toml")) {
    const auto text = read_file(name, limits::config_file_bytes, door);
    if (!text) return Failed(text.error());
    return load(toml_tools::parsed(*text, name), name, From::text, door);
  }
  const std::string id = id_meant_by(in_small_letters(name)), file = "controls/" + id + ".toml";
  auto table = is_control(id) ? built_in(file, From::table) : std::nullopt;
  if (!table) {
    std::string known;
    for (const std::string& one : built_in_controls()) known += (known.empty() ? "" : ", ") + one;
    return Failed(translated(texts::control_file::no_such_control, name, known) + did_you_mean(name, control_names()));
  }
  auto def = load(std::move(*table), file, From::table, door);
  return def ? def : load(*built_in(file, From::text), file, From::text, door);
}

std::vector<std::string> built_in_controls() {
  std::vector<std::string> ids;
  for (const EmbeddedFile& file : embedded_files()) {
    std::string_view name = file.name;
    // The list of built-in files also contains machines and macros, which are skipped
    if (!name.starts_with("controls/") || !name.ends_with(".toml")) continue;
    name.remove_prefix(9);
    name.remove_suffix(5);
    if (is_control(name)) ids.emplace_back(name);
  }
  std::sort(ids.begin(), ids.end());  // the files are sorted with their suffix, which puts fanuc-t-b.toml before fanuc-t.toml
  return ids;
}

const std::vector<std::pair<std::string, std::string>>& control_aliases() {
  static const std::vector<std::pair<std::string, std::string>> all = [] {
    std::vector<std::pair<std::string, std::string>> rows;
    for (const std::string& id : built_in_controls())
      for (std::string& alias : texts_of_list(embedded("controls/" + id + ".toml")->table, "aliases"))
        rows.emplace_back(std::move(alias), id);
    std::sort(rows.begin(), rows.end());
    return rows;
  }();
  return all;
}

std::vector<std::string> control_names() {
  std::vector<std::string> names = built_in_controls();
  for (const auto& [alias, id] : control_aliases()) names.push_back(alias);
  return names;
}

}  // namespace kadr
