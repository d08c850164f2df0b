// Common functions of the readers of TOML files: built-in texts, merging for `extends`, messages with a location. Used by the rest of
// config.

#include "config/tools/toml_tools.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "config/embedded.h"
#include "config/packed_toml.h"
#include "config/read_file.h"
#include "config/toml_scan.h"
#include "texts/toml_faults.h"

namespace kadr::toml_tools {

std::optional<std::string_view> embedded_text(std::string_view name) {
  const EmbeddedFile* const file = embedded(name);
  return file == nullptr ? std::nullopt : std::optional(file->text);
}

std::optional<toml::table> embedded_table(std::string_view name) {
  const EmbeddedFile* const file = embedded(name);
  return file == nullptr ? std::nullopt : std::optional(unpacked(file->table));
}

std::optional<toml::table> embedded_sections(std::string_view name, std::initializer_list<std::string_view> keys) {
  const EmbeddedFile* const file = embedded(name);
  return file == nullptr ? std::nullopt : std::optional(unpacked(file->table, keys));
}

namespace {

/// Translates the error of toml++, such as "Error while parsing array: …". In languages other than English, the message states only what
/// was being read.
std::string parse_error_message(std::string_view description) {
  if (thread_language() == Lang::en) return std::string(description);
  static constexpr std::pair<std::string_view, PlainText> what[] = {
      {"key-value pair", texts::toml_faults::wrong_key_value},
      {"key", texts::toml_faults::wrong_key},
      {"table header", texts::toml_faults::wrong_heading},
      {"inline table", texts::toml_faults::wrong_inline_table},
      {"array", texts::toml_faults::wrong_list},
      {"string", texts::toml_faults::wrong_string},
      {"integer", texts::toml_faults::wrong_integer},
      {"floating-point", texts::toml_faults::wrong_number},
      {"boolean", texts::toml_faults::wrong_boolean},
      {"date", texts::toml_faults::wrong_date},
      {"time", texts::toml_faults::wrong_time},
      {"comment", texts::toml_faults::wrong_comment},
  };
  constexpr std::string_view begin = "Error while parsing ";
  for (const auto& [english, translation] : what)
    if (description.find(std::string(begin) + std::string(english)) != std::string_view::npos) return translated(translation);
  return translated(texts::toml_faults::no_toml);
}

}  // namespace

tl::expected<toml::table, std::string> parsed(std::string_view text, const std::string& file) {
  if (std::string fault = no_text_message(text, file); !fault.empty()) return tl::unexpected(fault);
  if (std::string fault = toml_limit_message(text, file); !fault.empty()) return tl::unexpected(fault);
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    const auto at = error.source().begin;
    return tl::unexpected(location_prefix(file, at.line, at.column) + parse_error_message(error.description()));
  }
}

void merge(toml::table& under, toml::table&& over) {
  for (auto&& [key, node] : over) {
    toml::table* const old = under[key].as_table();
    if (toml::table* const table = node.as_table(); table != nullptr && old != nullptr) merge(*old, std::move(*table));
    // The value is moved and not copied, because a copy of a node loses its position in the file.
    else node.visit([&, &name = key](auto& value) { under.insert_or_assign(name, std::move(value)); });
  }
}

std::string place(const std::string& file, const toml::node& node) {
  const toml::source_path_ptr& path = node.source().path;  // path of the base file, if the node comes from a file that `file` extends
  const auto line = node.source().begin.line;
  return (path ? *path : file) + ":" + (line == 0 ? "" : std::to_string(line) + ":") + " ";
}

std::string place(const std::string& file, const toml::table& row, std::string_view key) {
  const toml::node* const node = row.get(key);
  return place(file, node != nullptr ? *node : static_cast<const toml::node&>(row));
}

Text text_of(const toml::table& row) { return {row["en"].value_or(std::string()), row["ru"].value_or(std::string())}; }

namespace {

std::optional<double> within(const toml::node* node, const NumberRange& range) {
  if (node == nullptr || !node->is_number()) return std::nullopt;
  const double value = node->value<double>().value_or(0);
  return is_within(value, range) ? std::optional(value) : std::nullopt;  // NaN is outside every range
}

tl::unexpected<std::string> must_be(const std::string& file, const toml::node& node, std::string_view key, const std::string& form) {
  return tl::unexpected(place(file, node) + translated(texts::toml_faults::must_be, key, form));
}

/// Returns the number of letters that must be changed, added or removed to convert one text to the other (Levenshtein distance).
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

tl::expected<void, std::string> number(const std::string& file, const toml::table& row, std::string_view key, const NumberRange& range,
                                       double& to) {
  const toml::node* const node = row.get(key);
  if (node == nullptr) return {};
  const auto value = within(node, range);
  if (!value) return must_be(file, *node, key, range_in_words(range));
  to = *value;
  return {};
}

tl::expected<void, std::string> span(const std::string& file, const toml::table& row, std::string_view key, const NumberRange& range,
                                     double& least, double& most) {
  const toml::node* const node = row.get(key);
  if (node == nullptr) return {};
  const toml::array* const pair = node->as_array();
  const bool two = pair != nullptr && pair->size() == 2;
  const auto from = within(two ? pair->get(0) : nullptr, range), to = within(two ? pair->get(1) : nullptr, range);
  if (!from || !to || !(*from < *to))
    return must_be(file, *node, key, translated(texts::toml_faults::least_and_most, range_in_words(range)));
  least = *from;
  most = *to;
  return {};
}

std::string_view nearest(std::string_view word, const std::vector<std::string_view>& names) {
  constexpr std::size_t longest = 64;  // longer words are not compared, because no key is so long
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
