#include "config/toml_tools.h"

#include <fstream>
#include <sstream>

#include "config/embedded.h"

namespace kadr::toml_tools {

std::optional<std::string> read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::ostringstream text;
  text << file.rdbuf();
  return std::move(text).str();
}

std::optional<std::string_view> embedded_text(std::string_view name) {
  for (const EmbeddedFile& file : embedded_files())
    if (file.name == name) return file.text;
  return std::nullopt;
}

void merge(toml::table& under, const toml::table& over) {
  for (const auto& [key, node] : over) {
    toml::table* const old = under[key].as_table();
    if (const toml::table* const table = node.as_table(); table != nullptr && old != nullptr)
      merge(*old, *table);
    else
      under.insert_or_assign(key, node);
  }
}

std::string place(const std::string& file, const toml::node& node) {
  return file + ":" + std::to_string(node.source().begin.line) + ": ";
}

Text text_of(const toml::table& row) {
  return {row["en"].value_or(std::string()), row["ru"].value_or(std::string())};
}

}  // namespace kadr::toml_tools
