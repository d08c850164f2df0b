#include "config/control_file.h"

#include "config/control_loader.h"
#include "config/embedded.h"
#include "config/parameter_table.h"

namespace kadr {
namespace {

/// The table of a file with what it extends laid under it; `lineage` collects the ids below.
tl::expected<toml::table, std::string> merged(std::string_view text, const std::string& file, std::vector<std::string>& lineage) {
  constexpr std::size_t deepest = 8;  // a file that extends itself would never end
  auto table = toml_tools::parsed(text, file);
  if (!table) return table;
  const auto base = (*table)["extends"].value<std::string>();
  if (!base) return table;
  if (!table->contains("id")) return Failed(file + ": id is missing: a file that extends another is a control of its own");
  if (lineage.size() == deepest) return Failed(file + ": extends itself");
  lineage.push_back(*base);
  std::string name = "controls/" + *base + ".toml";
  const auto base_text = toml_tools::embedded_text(name);
  std::optional<std::string> own_text;
  if (!base_text) {
    const auto slash = file.rfind('/');
    name = (slash == std::string::npos || base->starts_with('/') ? std::string() : file.substr(0, slash + 1)) + *base;
    own_text = toml_tools::read_text(name);
    if (!own_text) return Failed(file + ": extends '" + *base + "': no such control");
  }
  auto under = merged(base_text ? *base_text : std::string_view(*own_text), name, lineage);
  if (!under) return under;
  toml_tools::merge(*under, std::move(*table));
  return under;
}

/// The texts of alarms and the tables of parameters are no controls of their own.
bool is_control(std::string_view name) { return name != "alarms" && !is_parameter_table(name); }

}  // namespace

std::int32_t ControlDef::row_of(char letter, std::int32_t tenth) const {
  if (tenth >= 0 && tenth < most_tenths) {
    const std::int16_t row = (letter == 'G' ? g_rows : m_rows)[static_cast<std::size_t>(tenth)];
    if (row >= 0) return row;
  }
  if (letter == 'M' && m_user_row >= 0 && tenth >= m_user_from && tenth <= m_user_to && tenth % 10 == 0) return m_user_row;
  return -1;
}

namespace {

tl::expected<ControlDef, std::string> parse(std::string_view toml, const std::string& file, ParametersBeside parameters) {
  std::vector<std::string> lineage;
  auto table = merged(toml, file, lineage);
  if (!table) return Failed(table.error());
  auto def = ControlLoader(*table, file, parameters).load();
  if (def) def->lineage = std::move(lineage);
  return def;
}

}  // namespace

tl::expected<ControlDef, std::string> parse_control(std::string_view toml, const std::string& file) {
  return parse(toml, file, ParametersBeside());
}

tl::expected<ControlDef, std::string> load_control(const std::string& name) {
  if (name.ends_with(".toml")) {
    const auto text = toml_tools::read_text(name);
    if (!text) return Failed(name + ": cannot be read");
    return parse_control(*text, name);
  }
  const std::string file = "controls/" + name + ".toml";
  const auto text = toml_tools::embedded_text(file);
  if (!text || !is_control(name)) {
    std::string known;
    for (const std::string& id : built_in_controls()) known += (known.empty() ? "" : ", ") + id;
    return Failed("no control '" + name + "'; there are: " + known + ", or a file of your own (NAME.toml)");
  }
  return parse(*text, file, ParametersBeside(name));
}

std::vector<std::string> built_in_controls() {
  std::vector<std::string> ids;
  for (const EmbeddedFile& file : embedded_files()) {
    std::string_view name = file.name;
    if (!name.starts_with("controls/") || !name.ends_with(".toml")) continue;  // macros stand beside them
    name.remove_prefix(9);
    name.remove_suffix(5);
    if (is_control(name)) ids.emplace_back(name);
  }
  return ids;
}

}  // namespace kadr
