// kadr serve: serves a web page for the programs of a folder over HTTP, until Ctrl-C. Tested by tests/serve.py.

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
#include "config/language.h"
#include "panel/panel_hub.h"
#include "panel/panel_journal.h"
#include "server/http_server.h"
#include "server/page_files.h"
#include "view/memory_bound.h"
#include "view/served_folder.h"

extern char** environ;

namespace kadr::cli {
namespace {

constexpr double max_port = 65535;

/// Opens the address in the desktop's web browser; does nothing if there is none, since the address is also printed.
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

}  // namespace

void add_serve(CLI::App& app, Commands& c) {
  CLI::App* const serve = app.add_subcommand("serve", told("serve the page: the programs of a folder, their paths and states",
                                                           "открыть страницу: УП папки, их траектории и состояния"));
  ServeOptions& o = c.serve;
  takes(serve->add_option(told("FOLDER", "ПАПКА"), o.folder,
                          told("whose programs are shown (default: this one)", "чьи УП показать (по умолчанию эта)")),
        "FOLDER", "ПАПКА");
  whole_number(serve->add_option("--port", o.port, told("to listen on; 0: a free one", "порт; 0 — любой свободный")), 0, max_port)
      ->capture_default_str();
  takes(serve
            ->add_option("--host", o.host,
                         told("address to listen on; any but this machine's own needs the printed token",
                              "адрес; для любого, кроме адреса этой машины, нужен напечатанный ключ"))
            ->capture_default_str(),
        "ADDRESS", "АДРЕС");
  writes_file(serve->add_option("--state", o.state,
                                told("what happens at the panels of machines is kept there, at every block",
                                     "хранить здесь, что происходит у пультов станков, после каждого кадра")));
  serve->add_flag("--open", o.open,
                  told("pages of this machine may look without the token of the printed address",
                       "страницам этой машины смотреть можно и без ключа из напечатанного адреса"));
  number(serve->add_option("--max-memory", o.max_memory, told("of all pages together, MB", "память всех страниц вместе, МБ")), "MB", "МБ",
         100, 1e6)
      ->capture_default_str();
  serve->add_flag("--no-browser", o.no_browser, told("the browser is not opened", "не открывать браузер"));
  language_option(*serve, o.lang);
  serve->footer(plain_text(texts::help_examples::serve));
}

int serve(const ServeOptions& options) {
  const auto folder = ServedFolder::open(options.folder);
  if (!folder) {
    complain(folder.error());
    return wrong_usage;
  }
  ServedAddress wanted{options.host, std::uint16_t(options.port)};
  LastOpened last;
  std::unique_ptr<PanelJournal> journal = std::make_unique<PanelJournal>();
  if (!options.state.empty()) {
    auto kept = PanelJournal::open(options.state);
    if (!kept) {
      complain(kept.error());
      return wrong_usage;
    }
    journal = std::move(*kept);
  }
  PanelHub hub;
  constexpr double bytes_of_mb = 1e6;
  const MemoryBound memory(std::size_t(options.max_memory * bytes_of_mb));
  const PageServer page{
      *folder,       new_token(), wanted.is_open() || !options.open, options.lang == "ru" ? Lang::ru : Lang::en, KADR_VERSION, &last, &hub,
      journal.get(), &memory};
  const auto server = HttpServer::listen(wanted, page);
  if (!server) {
    complain(server.error());
    return wrong_usage;
  }
  const std::string address = fmt::format("http://{}:{}/#token={}", options.host, (*server)->address().port, page.token);
  type_out("kadr serve: {}\n", address);
  if (!came_out()) return wrong_usage;
  if (page_files().empty())
    complain(told("built without its page: only the protocol is served (docs/panel-protocol.md)",
                  "собран без страницы: есть только протокол (docs/panel-protocol.md)"));
  else if (!options.no_browser) open_browser(address);
  (*server)->run();
  return ok;
}

}  // namespace kadr::cli
