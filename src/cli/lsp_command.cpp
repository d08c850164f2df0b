// kadr lsp and kadr dap: serve an editor over standard input and output, until the editor ends the session. The commands are tested by
// tests/lsp.py and tests/dap.py.

#include <unistd.h>

#include <CLI/CLI.hpp>

#include "cli/job/stop_signals.h"
#include "cli/options/command_parts.h"
#include "cli/options/help_text.h"
#include "lsp/debug_adapter.h"
#include "lsp/language_server.h"
#include "texts/dap.h"
#include "texts/help_examples.h"
#include "texts/lsp.h"

namespace kadr::cli {

void add_lsp(CLI::App& app, Commands& c) {
  CLI::App* const lsp = app.add_subcommand("lsp", translated(texts::lsp::about));
  // Editors add this option to the commands of all their servers. Standard input and output are the only way, so it changes nothing.
  lsp->add_flag("--stdio", c.lsp.stdio, translated(texts::lsp::stdio));
  language_option(*lsp, c.lsp.lang);
  lsp->footer(plain_text(texts::help_examples::lsp));
  CLI::App* const dap = app.add_subcommand("dap", translated(texts::dap::about));
  language_option(*dap, c.lsp.lang);
  dap->footer(plain_text(texts::help_examples::dap));
}

int serve_language(const LspOptions& options) {
  return serve_editor(STDIN_FILENO, STDOUT_FILENO, language_named(options.lang).value_or(Lang::en), KADR_VERSION, stop_token());
}

int serve_debugging(const LspOptions& options) {
  return serve_debugger(STDIN_FILENO, STDOUT_FILENO, language_named(options.lang).value_or(Lang::en), stop_token());
}

}  // namespace kadr::cli
