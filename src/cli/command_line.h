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
  std::string shell;  // of completion
};

std::unique_ptr<CLI::App> make_app(Commands& commands);

std::string manual_page(const CLI::App& app);
/// `shell`: bash, zsh or fish.
std::string completion(const CLI::App& app, const std::string& shell);

}  // namespace kadr::cli
