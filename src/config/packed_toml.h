#pragma once
// The built-in TOML files are parsed when Kadr is built (dev/embed.cpp). The program holds their tables in this short form, which is
// read ten times as fast as the text: half of the time of a small command was the parsing of controls/.

#include <toml++/toml.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace kadr {

/// A table as bytes, and back. Places in the text, comments and formats of numbers are lost; the order of keys is that of toml::table.
///   throws  std::invalid_argument for a date or a time: no file of ours has them
std::string packed(const toml::table& table);

/// `bytes` must come from packed().
toml::table unpacked(std::string_view bytes);

/// The texts of the list that stands under `key`, without making the rest; none where there is no such list.
std::vector<std::string> texts_of_list(std::string_view bytes, std::string_view key);

/// Of a table of tables: each text, with the key of its table and its own, without making tables. Texts stay where `bytes` are.
void each_text(std::string_view bytes,
               const std::function<void(std::string_view table, std::string_view key, std::string_view text)>& take);

}  // namespace kadr
