#pragma once
// The help of the commands: its layout, and the examples at its end.

#include <memory>
#include <string>

namespace CLI {
class App;
class FormatterBase;
}  // namespace CLI

namespace kadr::cli {

/// Lays out option names and descriptions in two columns, counted in characters, in the language of told().
std::shared_ptr<CLI::FormatterBase> help_formatter();

/// Returns the full name of a command: "kadr tape decode".
std::string whole_name(const CLI::App& command);

/// The *_examples() functions return examples and exit status of a command, in the language of told().
std::string run_examples();
std::string check_examples();
std::string debug_examples();
std::string explain_examples();
std::string controls_examples();
std::string machines_examples();
std::string setup_examples();
std::string tape_examples();
std::string state_examples();
std::string mill_examples();
std::string cut_examples();
std::string diff_examples();
std::string convert_examples();
std::string report_examples();
std::string serve_examples();
std::string man_examples();
std::string completion_examples();

}  // namespace kadr::cli
