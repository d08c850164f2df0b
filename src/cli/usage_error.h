#pragma once
// Describes the error in a command line, and what was perhaps meant.

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace kadr::cli {

/// Returns two lines. `app` is in the state in which the parser threw `error`.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error);

}  // namespace kadr::cli
