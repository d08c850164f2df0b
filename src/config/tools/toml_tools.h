#pragma once
// Common functions of the readers of TOML files: built-in texts, merging for `extends`, messages with a location.

#include <toml++/toml.h>

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "config/control/control_def.h"
#include "config/range.h"

namespace kadr::toml_tools {

/// Returns the text of a built-in file ("controls/gost.toml").
std::optional<std::string_view> embedded_text(std::string_view name);

/// Returns the table of a built-in TOML file. The nodes of this table have no positions in the text.
std::optional<toml::table> embedded_table(std::string_view name);

/// Returns only these sections of a built-in TOML file: the keys of its outermost table that are in `keys`.
std::optional<toml::table> embedded_sections(std::string_view name, std::initializer_list<std::string_view> keys);

/// Parses TOML text; `file` is the name used in messages.
///   returns  on failure, an error sentence with file, line and column: not TOML, or beyond the limits of config/toml_scan.h
tl::expected<toml::table, std::string> parsed(std::string_view text, const std::string& file);

/// Merges `over` into `under`. Tables are merged key by key; any other value replaces the old value.
void merge(toml::table& under, toml::table&& over);

/// Returns the location of a node, "file:line: ", as the beginning of an error sentence.
std::string place(const std::string& file, const toml::node& node);

/// Returns the location "file:line: " of a key of a row; if the key is missing, of the row. The key may come from another file than the
/// row.
std::string place(const std::string& file, const toml::table& row, std::string_view key);

Text text_of(const toml::table& row);

/// Reads the number of a key, which must be in the range. If the key is missing, `to` stays unchanged.
///   returns  on failure, an error sentence with file and line: "machine.toml:3: rapid must be a number, 0.001 to 1e9 mm/min"
tl::expected<void, std::string> number(const std::string& file, const toml::table& row, std::string_view key, const NumberRange& range,
                                       double& to);

/// Reads a range [least, most]. Both numbers must be in the permitted range, and `most` must be greater than `least`.
tl::expected<void, std::string> span(const std::string& file, const toml::table& row, std::string_view key, const NumberRange& range,
                                     double& least, double& most);

/// Returns the element of `names` that `word` was probably meant to be; empty if no element is close. Up to a third of the letters may be
/// wrong.
std::string_view nearest(std::string_view word, const std::vector<std::string_view>& names);

/// Returns the value of a key (string, number or bool); if the key is missing, returns `otherwise`.
template <class T>
T value_or(const toml::table& row, std::string_view key, T otherwise) {
  return row[key].value_or(otherwise);
}

}  // namespace kadr::toml_tools
