#pragma once
// Describes an error in the command line, and suggests what the user may have meant.

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace kadr::cli {

/// Returns two lines: the error, and a suggestion or a hint to --help. `app` must be in the state in which its parser threw `error`.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error);

}  // namespace kadr::cli
