#pragma once
// The command line: commands, options, help with examples. Manual page and shell completion are made from the same tree.

#include <memory>
#include <string>

#include "cli/options.h"

namespace CLI {
class App;
}

namespace kadr::cli {

/// What was asked, once parsed.
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
  std::string machine;  // of machines; empty: all
  std::string shell;    // of completion
};

/// Its texts are in the language of told().
std::unique_ptr<CLI::App> make_app(Commands& commands);

/// What --lang says anywhere on the line, so that a wrong line, too, is answered in that language; empty: nothing.
std::string language_on(int argc, const char* const* argv);

/// Every command answers in that language.
void speak(Commands& commands, const std::string& lang);

std::string manual_page(const CLI::App& app);
/// `shell`: bash, zsh or fish.
std::string completion(const CLI::App& app, const std::string& shell);
/// What `kadr explain CONTROL` may be asked for, a line each; empty: no such control.
std::string codes_of(const std::string& control);

}  // namespace kadr::cli
