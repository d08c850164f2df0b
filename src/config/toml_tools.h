#pragma once
// What the readers of our TOML files share: the file's text, merging of `extends`, messages with a place.

#include <toml++/toml.h>

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "config/control_def.h"
#include "config/range.h"

namespace kadr::toml_tools {

/// Text of a built-in file ("controls/gost.toml").
std::optional<std::string_view> embedded_text(std::string_view name);

/// Table of a built-in TOML file; its nodes do not know their places.
std::optional<toml::table> embedded_table(std::string_view name);

/// TOML text; `file` names it in messages.
///   returns  an error sentence with file, line and column if it is no TOML, or beyond the limits of config/toml_scan.h
tl::expected<toml::table, std::string> parsed(std::string_view text, const std::string& file);

/// Lays `over` on `under`: tables key by key, anything else replaced.
void merge(toml::table& under, toml::table&& over);

/// "file:line: "
std::string place(const std::string& file, const toml::node& node);

/// The same of a key of a row, or of the row where the key is missing: a row may come from two files.
std::string place(const std::string& file, const toml::table& row, std::string_view key);

Text text_of(const toml::table& row);

/// The number of a key, within its range; left as it is where the key is missing.
///   returns  an error sentence with file and line: "machine.toml:3: rapid must be a number, 0.001 to 1e9 mm/min"
tl::expected<void, std::string> number(const std::string& file, const toml::table& row, std::string_view key, const NumberRange& range,
                                       double& to);

/// [least, most], both within the range, the second above the first.
tl::expected<void, std::string> span(const std::string& file, const toml::table& row, std::string_view key, const NumberRange& range,
                                     double& least, double& most);

/// The one of `names` that `word` was meant to be, or none: a letter in three may be wrong.
std::string_view nearest(std::string_view word, const std::vector<std::string_view>& names);

/// Text of a node that must be a string, number or bool; the default where the key is missing.
template <class T>
T value_or(const toml::table& row, std::string_view key, T otherwise) {
  return row[key].value_or(otherwise);
}

}  // namespace kadr::toml_tools
