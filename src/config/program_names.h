#pragma once
// Which files are part programs by their names.

#include <string>
#include <string_view>

namespace kadr {

/// What a name says of its file. Nothing: it has no ending, or a number for one (O1001, 1.001): what stands in the file must tell.
enum class NameTells { program, nothing, other };
NameTells told_by_name(std::string_view name);

/// A name without an ending that a control gives: a number, with a letter or two before it (O1001, 1001, %12, P5.001).
bool is_number_name(std::string_view name);

/// `path` or its last part is like the pattern of a shell (fnmatch(3)).
bool is_like(const std::string& path, const std::string& pattern);

}  // namespace kadr
