#pragma once
// What is wrong with a command line, in words, with what was perhaps meant.

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace kadr::cli {

/// `app` as the parser left it when it threw `error`. Two lines.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error);

}  // namespace kadr::cli
