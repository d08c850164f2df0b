#pragma once
// Defines the command line: commands, options, and help with examples. The manual page and the shell completion are generated from the same
// definitions.

#include <memory>
#include <string>

#include "cli/options/options.h"

namespace CLI {
class App;
}

namespace kadr::cli {

/// The values of the options of all commands, after the command line has been parsed.
struct Commands {
  Options options;
  ExplainOptions explain;
  TapeOptions tape;
  StateOptions state;
  SetupOptions setup;
  MillOptions mill;
  CutOptions cut;
  DiffOptions diff;
  ConvertOptions convert;
  EditOptions edit;
  ServeOptions serve;
  LspOptions lsp;
  DriveOptions drive;
  DncOptions dnc;
  ReportOptions report;
  std::string machine;  // argument of the command `machines`; empty: all machines
  std::string shell;    // argument of the command `completion`
};

/// Returns the parser of the command line. Its texts are in the language of the calling thread.
std::unique_ptr<CLI::App> make_app(Commands& commands);

/// Returns the language that --lang states anywhere on the command line; empty if the option is missing. The language is read before
/// parsing, so that the errors of a wrong command line are in that language too.
std::string language_on(int argc, const char* const* argv);

/// Sets the language for the output of all commands.
void speak(Commands& commands, const std::string& lang);

std::string manual_page(const CLI::App& app);
/// Returns the completion script.
///   shell  bash, zsh or fish
std::string completion(const CLI::App& app, const std::string& shell);
/// Returns the names that `kadr explain CONTROL` can explain, one per line; empty if there is no control with this name.
std::string codes_of(const std::string& control);

}  // namespace kadr::cli
