#pragma once
// Formats the help of the commands, with the examples and the exit status at its end (texts::help_examples).

#include <memory>
#include <string>

#include "texts/help_examples.h"

namespace CLI {
class App;
class FormatterBase;
}  // namespace CLI

namespace kadr::cli {

/// Returns a formatter that prints option names and descriptions in two columns. Widths are counted in characters, and the texts are in the
/// language of the thread.
std::shared_ptr<CLI::FormatterBase> help_formatter();

/// Returns the full name of a command, e.g. "kadr tape decode".
std::string whole_name(const CLI::App& command);

}  // namespace kadr::cli
