#pragma once
// The command line: commands, options, and help with examples. The manual page and the shell completion are generated from the same
// definitions.

#include <memory>
#include <string>

#include "cli/options/options.h"

namespace CLI {
class App;
}

namespace kadr::cli {

/// The options of all commands, as parsed.
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
  ServeOptions serve;
  ReportOptions report;
  std::string machine;  // value of `machines`; empty: all machines
  std::string shell;    // value of `completion`
};

/// Returns the parser. Its texts are in the language that is set for the calling thread.
std::unique_ptr<CLI::App> make_app(Commands& commands);

/// Returns the language that --lang specifies anywhere on the command line; empty if it is absent. It is read before parsing, so that the
/// errors of a wrong command line are in that language too.
std::string language_on(int argc, const char* const* argv);

/// Sets the language of the output of every command.
void speak(Commands& commands, const std::string& lang);

std::string manual_page(const CLI::App& app);
///   shell  bash, zsh or fish
std::string completion(const CLI::App& app, const std::string& shell);
/// Returns the names that `kadr explain CONTROL` can explain, one per line; empty if there is no such control.
std::string codes_of(const std::string& control);

}  // namespace kadr::cli
