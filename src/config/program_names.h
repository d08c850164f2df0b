#pragma once
// Decides by file names which files are part programs.

#include <string>
#include <string_view>

namespace kadr {

/// The result of judging a file by its name. nothing: the name has no ending, a number as ending, or one that others use too (O1001, 1.001,
/// PLATE.H), so the contents of the file must decide.
enum class NameVerdict { program, nothing, other };
NameVerdict judge_name(std::string_view name);

/// Returns true for a name of the kind that controls give to programs, a number with up to two letters before it: O1001, 1001, %12, P5.001.
bool is_number_name(std::string_view name);

/// Returns true if the path, or the last component of the path, matches the shell pattern (fnmatch(3)).
bool is_like(const std::string& path, const std::string& pattern);

}  // namespace kadr
