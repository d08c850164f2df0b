#include "config/toml_tools.h"

#include <algorithm>
#include <fstream>
#include <numeric>
#include <sstream>
#include <utility>

#include "config/embedded.h"
#include "config/packed_toml.h"

namespace kadr::toml_tools {

std::optional<std::string> read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::ostringstream text;
  text << file.rdbuf();
  return std::move(text).str();
}

namespace {

const EmbeddedFile* embedded(std::string_view name) {
  for (const EmbeddedFile& file : embedded_files())
    if (file.name == name) return &file;
  return nullptr;
}

}  // namespace

std::optional<std::string_view> embedded_text(std::string_view name) {
  const EmbeddedFile* const file = embedded(name);
  return file == nullptr ? std::nullopt : std::optional(file->text);
}

std::optional<toml::table> embedded_table(std::string_view name) {
  const EmbeddedFile* const file = embedded(name);
  return file == nullptr ? std::nullopt : std::optional(unpacked(file->table));
}

tl::expected<toml::table, std::string> parsed(std::string_view text, const std::string& file) {
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    return tl::unexpected(file + ":" + std::to_string(error.source().begin.line) + ": " + std::string(error.description()));
  }
}

void merge(toml::table& under, toml::table&& over) {
  for (auto&& [key, node] : over) {
    toml::table* const old = under[key].as_table();
    if (toml::table* const table = node.as_table(); table != nullptr && old != nullptr) merge(*old, std::move(*table));
    else node.visit([&, &name = key](auto& value) { under.insert_or_assign(name, std::move(value)); });  // moved: a copy forgets its place
  }
}

std::string place(const std::string& file, const toml::node& node) {
  const toml::source_path_ptr& path = node.source().path;  // of the file it extends, it may be
  const auto line = node.source().begin.line;
  return (path ? *path : file) + ":" + (line == 0 ? "" : std::to_string(line) + ":") + " ";
}

std::string place(const std::string& file, const toml::table& row, std::string_view key) {
  const toml::node* const node = row.get(key);
  return place(file, node != nullptr ? *node : static_cast<const toml::node&>(row));
}

Text text_of(const toml::table& row) { return {row["en"].value_or(std::string()), row["ru"].value_or(std::string())}; }

namespace {

/// Letters to be changed, added or left out (Levenshtein).
std::size_t changes(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t corner = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t kept = corner + (a[i] == b[j] ? 0 : 1);
      corner = row[j + 1];
      row[j + 1] = std::min({kept, corner + 1, row[j] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string_view nearest(std::string_view word, const std::vector<std::string_view>& names) {
  constexpr std::size_t longest = 64;  // no key of ours is longer
  if (word.size() > longest) return {};
  std::string_view best;
  std::size_t least = std::max<std::size_t>(word.size(), 3) / 3 + 1;
  for (const std::string_view name : names)
    if (const std::size_t count = changes(word, name); count < least) {
      least = count;
      best = name;
    }
  return best;
}

}  // namespace kadr::toml_tools
