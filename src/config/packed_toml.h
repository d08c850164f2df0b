#pragma once
// Packed TOML tables. The built-in TOML files are parsed when Kadr is built (dev/embed.cpp), and the executable contains their tables in
// this compact form. It is read ten times as fast as the text; parsing the text of controls/ took half of the time of a small command.

#include <toml++/toml.h>

#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace kadr {

/// Converts a table to bytes. Positions in the text, comments and number formats are lost; the order of keys is the order of toml::table.
///   throws  std::invalid_argument for a date or a time, which the built-in files do not contain
std::string packed(const toml::table& table);

/// Converts bytes back to a table. `bytes` must come from packed().
toml::table unpacked(std::string_view bytes);

/// Converts only the values under these keys of the outermost table; the others are skipped, which is ten times as fast.
toml::table unpacked(std::string_view bytes, std::initializer_list<std::string_view> keys);

/// Returns the texts of the list under `key` without unpacking the rest; empty if there is no such list.
std::vector<std::string> texts_of_list(std::string_view bytes, std::string_view key);

/// Calls `take` for each text in a table whose values are tables, without unpacking these tables. `table` is the key of the inner table,
/// `key` the key of the text in it. The texts refer to memory of `bytes`.
void each_text(std::string_view bytes,
               const std::function<void(std::string_view table, std::string_view key, std::string_view text)>& take);

}  // namespace kadr
