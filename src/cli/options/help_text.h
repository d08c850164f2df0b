#pragma once
// The help of the commands: its layout, and the examples and exit status at its end (texts::help_examples).

#include <memory>
#include <string>

#include "texts/help_examples.h"

namespace CLI {
class App;
class FormatterBase;
}  // namespace CLI

namespace kadr::cli {

/// Lays out option names and descriptions in two columns, counted in characters, in the language of the thread.
std::shared_ptr<CLI::FormatterBase> help_formatter();

/// Returns the full name of a command: "kadr tape decode".
std::string whole_name(const CLI::App& command);

}  // namespace kadr::cli
