#pragma once
// The command line: commands, options, and help with examples. The manual page and the shell completion are built from the same tree.

#include <memory>
#include <string>

#include "cli/options.h"

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
  std::string machine;  // of `machines`; empty: all
  std::string shell;    // of `completion`
};

/// Returns the parser; its texts are in the language of told().
std::unique_ptr<CLI::App> make_app(Commands& commands);

/// Returns the language that --lang names anywhere on the line, so that a faulty line too is answered in that language; empty if there is
/// none.
std::string language_on(int argc, const char* const* argv);

/// Sets the language in which every command answers.
void speak(Commands& commands, const std::string& lang);

std::string manual_page(const CLI::App& app);
///   shell  bash, zsh or fish
std::string completion(const CLI::App& app, const std::string& shell);
/// Returns what `kadr explain CONTROL` can explain, one per line; empty if there is no such control.
std::string codes_of(const std::string& control);

}  // namespace kadr::cli
