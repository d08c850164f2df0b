// kadr serve: offers a web page for the programs of a folder over HTTP, until the user presses Ctrl-C. The command is tested by
// tests/serve.py.

#include <fmt/core.h>
#include <spawn.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "cli/job/outputs.h"
#include "cli/job/stop_signals.h"
#include "cli/job/terminal.h"
#include "cli/options/command_parts.h"
#include "cli/options/help_text.h"
#include "cli/options/option_values.h"
#include "cli/report_files.h"
#include "panel/panel_hub.h"
#include "panel/panel_journal.h"
#include "server/http_server.h"
#include "server/page_files.h"
#include "texts/drive_command.h"
#include "texts/grbl_machine.h"
#include "texts/serve_command.h"
#include "texts/values.h"
#include "view/memory_bound.h"
#include "view/page/page_drive.h"
#include "view/served_folder.h"

extern char** environ;

namespace kadr::cli {
namespace {

constexpr double max_port = 65535;

/// Opens the address in the web browser of the desktop. Does nothing if there is no browser, since the address is also printed.
void open_browser(const std::string& address) {
  std::string program = "xdg-open", where = address;
  char* const words[] = {program.data(), where.data(), nullptr};
  posix_spawn_file_actions_t silent;
  posix_spawn_file_actions_init(&silent);
  for (const int stream : {1, 2}) posix_spawn_file_actions_addopen(&silent, stream, "/dev/null", 1, 0);
  const SignalsOfChild usual;
  pid_t child = 0;
  (void)posix_spawnp(&child, program.c_str(), &silent, &usual.attributes, words, environ);
  posix_spawn_file_actions_destroy(&silent);
}

/// Returns the ports with real machines that the pages may use, or an error sentence.
tl::expected<RealPorts, std::string> real_ports(const ServeOptions& options) {
  if (!drive::is_baud_rate(options.baud)) return tl::unexpected(translated(texts::drive_command::no_baud, options.baud));
  RealPorts real;
  real.baud = options.baud, real.log = options.drive_log, real.control = "grbl";
  for (const std::string& port : options.drives)
    if (port == "found") real.all_found = true;
    else real.ports.push_back(port);
  return real;
}

}  // namespace

void add_serve(CLI::App& app, Commands& c) {
  CLI::App* const serve = app.add_subcommand("serve", translated(texts::serve_command::about));
  ServeOptions& o = c.serve;
  takes(serve->add_option(translated(texts::serve_command::folder_name), o.folder, translated(texts::serve_command::folder)),
        plain_text(texts::serve_command::folder_name));
  whole_number(serve->add_option("--port", o.port, translated(texts::serve_command::port)), 0, max_port)->capture_default_str();
  takes(serve->add_option("--host", o.host, translated(texts::serve_command::host))->capture_default_str(),
        plain_text(texts::serve_command::address_name));
  writes_file(serve->add_option("--state", o.state, translated(texts::serve_command::state_folder)));
  serve->add_flag("--open", o.open, translated(texts::serve_command::open_to_pages));
  number(serve->add_option("--max-memory", o.max_memory, translated(texts::serve_command::max_memory)),
         plain_text(texts::values::megabytes), 100, 1e6)
      ->capture_default_str();
  takes(serve->add_option("--drive", o.drives, translated(texts::grbl_machine::serve_drive))->allow_extra_args(false),
        plain_text(texts::drive_command::port_value));
  whole_number(serve->add_option("--baud", o.baud, translated(texts::drive_command::baud)), 300, 921600)->capture_default_str();
  writes_file(serve->add_option("--drive-log", o.drive_log, translated(texts::drive_command::log))->capture_default_str());
  serve->add_flag("--no-browser", o.no_browser, translated(texts::serve_command::no_browser));
  language_option(*serve, o.lang);
  serve->footer(plain_text(texts::help_examples::serve));
}

int serve(const ServeOptions& options) {
  const auto folder = ServedFolder::open(options.folder);
  if (!folder) {
    complain(folder.error());
    return wrong_usage;
  }
  ServedAddress requested_address{options.host, std::uint16_t(options.port)};
  LastOpened last;
  std::unique_ptr<PanelJournal> journal = std::make_unique<PanelJournal>();
  if (!options.state.empty()) {
    auto opened = PanelJournal::open(options.state);
    if (!opened) {
      complain(opened.error());
      return wrong_usage;
    }
    journal = std::move(*opened);
  }
  const auto real = real_ports(options);
  if (!real) {
    complain(real.error());
    return wrong_usage;
  }
  PanelHub hub;
  constexpr double bytes_of_mb = 1e6;
  const MemoryBound memory(std::size_t(options.max_memory * bytes_of_mb));
  const PageServer page{*folder,
                        new_token(),
                        requested_address.is_open() || !options.open,
                        language_named(options.lang).value_or(Lang::en),
                        KADR_VERSION,
                        &last,
                        &hub,
                        journal.get(),
                        &memory,
                        {report_file("report.html"), report_file("licences.txt")},
                        options.drives.empty() ? nullptr : &*real};
  const auto server = HttpServer::listen(requested_address, page);
  if (!server) {
    complain(server.error());
    return wrong_usage;
  }
  const std::string address = fmt::format("http://{}:{}/#token={}", options.host, (*server)->address().port, page.token);
  type_out("kadr serve: {}\n", address);
  if (!came_out()) return wrong_usage;
  if (page_files().empty()) complain(translated(texts::serve_command::built_without_page));
  else if (!options.no_browser) open_browser(address);
  (*server)->run();
  return ok;
}

}  // namespace kadr::cli
