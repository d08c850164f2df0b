// kadr lsp: serves an editor over standard input and output, until the editor ends the session. The command is tested by tests/lsp.py.

#include <unistd.h>

#include <CLI/CLI.hpp>

#include "cli/job/stop_signals.h"
#include "cli/options/command_parts.h"
#include "cli/options/help_text.h"
#include "lsp/language_server.h"
#include "texts/help_examples.h"
#include "texts/lsp.h"

namespace kadr::cli {

void add_lsp(CLI::App& app, Commands& c) {
  CLI::App* const lsp = app.add_subcommand("lsp", translated(texts::lsp::about));
  // Editors add this option to the commands of all their servers. Standard input and output are the only way, so it changes nothing.
  lsp->add_flag("--stdio", c.lsp.stdio, translated(texts::lsp::stdio));
  language_option(*lsp, c.lsp.lang);
  lsp->footer(plain_text(texts::help_examples::lsp));
}

int serve_language(const LspOptions& options) {
  return serve_editor(STDIN_FILENO, STDOUT_FILENO, language_named(options.lang).value_or(Lang::en), KADR_VERSION, stop_token());
}

}  // namespace kadr::cli
