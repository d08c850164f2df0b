#pragma once
// Macros of DEFINE (spec/sinumerik 6.1): a name stands for a text. The text takes the place of the name before the block is read.

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace kadr {

/// The text of each macro, by its name in upper case.
using NamedMacros = std::map<std::string, std::string>;

/// Returns the text with every macro in it replaced by its own text; nullopt if it has no macro. Names within quotation marks are texts,
/// and a name within the text of a macro is replaced too, as far as a depth that no program of the control needs.
std::optional<std::string> with_macros(std::string_view text, const NamedMacros& macros);

}  // namespace kadr
