// kadr serve under Node, which only tests use: there are no sockets, so it refuses.

#include <CLI/CLI.hpp>

#include "cli/job/terminal.h"
#include "cli/options/command_parts.h"
#include "texts/serve_command.h"

namespace kadr::cli {

void add_serve(CLI::App& app, Commands&) { app.add_subcommand("serve", translated(texts::serve_command::about)); }

int serve(const ServeOptions&) {
  complain(translated(texts::serve_command::not_in_page));
  return wrong_usage;
}

}  // namespace kadr::cli
