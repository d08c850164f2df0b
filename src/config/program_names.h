#pragma once
// Recognises part programs by their file names.

#include <string>
#include <string_view>

namespace kadr {

/// What a file's name says about its contents. nothing: the name has no ending, or a number as ending (O1001, 1.001), so the contents
/// must decide.
enum class NameVerdict { program, nothing, other };
NameVerdict judge_name(std::string_view name);

/// Returns true for a name without an ending, as controls give it: a number, with up to two letters before it (O1001, 1001, %12, P5.001).
bool is_number_name(std::string_view name);

/// Returns true if `path` or its last component matches the shell pattern (fnmatch(3)).
bool is_like(const std::string& path, const std::string& pattern);

}  // namespace kadr
