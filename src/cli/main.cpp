// The main program: reads the command line, executes one command and returns its exit status.

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <exception>

#include "cli/job/outputs.h"
#include "cli/job/stop_signals.h"
#include "cli/job/terminal.h"
#include "cli/options/command_line.h"
#include "cli/options/usage_error.h"
#include "config/texts.h"
#include "texts/command_line.h"

namespace kadr::cli {

Lang language(const Options& options) {
  if (const std::optional<Lang> selected = language_named(options.lang)) return *selected;
  for (const char* const name : {"LC_ALL", "LC_MESSAGES", "LANG"})
    if (const char* const value = std::getenv(name); value != nullptr && *value != '\0') return language_named(value).value_or(Lang::en);
  return Lang::en;
}

namespace {

int perform(const CLI::App& app, const Commands& commands) {
  if (app.got_subcommand("run")) return run(commands.options);
  if (app.got_subcommand("debug")) return debug(commands.options);
  if (app.got_subcommand("check")) return check(commands.options);
  if (app.got_subcommand("explain")) return explain(commands.explain);
  if (app.got_subcommand("setup")) return write_setup(commands.setup);
  if (app.got_subcommand("controls")) return list_controls(commands.explain.control, commands.options.lang);
  if (app.got_subcommand("machines")) return list_machines(commands.machine);
  if (app.got_subcommand("tape")) {
    TapeOptions options = commands.tape;
    options.decode = app.get_subcommand("tape")->got_subcommand("decode");
    return tape(options);
  }
  if (app.got_subcommand("state")) {
    StateOptions options = commands.state;
    options.recover = app.get_subcommand("state")->got_subcommand("recover");
    return state(options);
  }
  if (app.got_subcommand("mill")) {
    MillOptions options = commands.mill;
    options.task = app.get_subcommand("mill")->get_subcommands().front()->get_name();
    return mill(options);
  }
  if (app.got_subcommand("cut")) return cut(commands.cut);
  if (app.got_subcommand("diff")) return diff(commands.diff);
  if (app.got_subcommand("convert")) return convert(commands.convert);
  if (app.got_subcommand("edit")) return edit(commands.edit);
  if (app.got_subcommand("report")) return report(commands.report);
  if (app.got_subcommand("serve")) return serve(commands.serve);
  if (app.got_subcommand("drive")) return drive_machine(commands.drive);
  if (app.got_subcommand("dnc")) {
    DncOptions options = commands.dnc;
    options.task = app.get_subcommand("dnc")->get_subcommands().front()->get_name();
    return exchange_programs(options);
  }
  if (app.got_subcommand("lsp")) return serve_language(commands.lsp);
  if (app.got_subcommand("dap")) return serve_debugging(commands.lsp);
  if (app.got_subcommand("man")) {
    type_out("{}", manual_page(app));
    return ok;
  }
  type_out("{}", completion(app, commands.shell));
  return ok;
}

/// Replaces the words in "kadr help run" and "kadr version" by the options --help and --version. Many other programs accept these words, so
/// users try them.
void take_usual_words(int argc, char** argv) {
  static char help[] = "--help", version[] = "--version";
  if (argc < 2) return;
  const std::string_view word = argv[1];
  if (word == "version") argv[1] = version;
  if (word != "help") return;
  for (int i = 1; i + 1 < argc; ++i) argv[i] = argv[i + 1];
  argv[argc - 1] = help;
}

/// Checks that the output was written, unless the command has already reported an error. Returns the exit status, which is then that of an
/// error.
int printed(int status) { return status == wrong_usage || came_out() ? status : wrong_usage; }

}  // namespace
}  // namespace kadr::cli

int main(int argc, char** argv) {
  using namespace kadr::cli;
  survive_refused_writing();
  catch_interrupts();
  take_usual_words(argc, argv);
  Commands commands;
  commands.options.limits.stop = commands.cut.run.limits.stop = commands.diff.both.limits.stop = commands.convert.run.limits.stop =
      commands.edit.run.limits.stop = commands.report.cut.run.limits.stop = commands.drive.run.limits.stop = commands.dnc.run.limits.stop =
          stop_token();
  commands.options.lang = language_on(argc, argv);
  const kadr::Lang lang = language(commands.options);
  kadr::set_process_language(lang);
  const auto app = make_app(commands);
  app->failure_message(
      [](const CLI::App* root, const CLI::Error& error) { return usage_error(*root, dynamic_cast<const CLI::ParseError&>(error)); });
  try {
    app->parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app->exit(error) == 0 ? printed(ok) : wrong_usage;
  }
  speak(commands, lang == kadr::Lang::ru ? "ru" : "en");
  try {
    return printed(perform(*app, commands));
  } catch (const std::bad_alloc&) {
    complain(kadr::plain_text(kadr::texts::command_line::out_of_memory));
  } catch (const std::exception& error) {  // a library has thrown an exception, which is a fault of Kadr; the user still gets a sentence
    complain(error.what());
  }
  return wrong_usage;
}
