// Defines the command line: commands, options, and help with examples. This file is used by the rest of cli.

#include "cli/options/command_line.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "cli/job/terminal.h"
#include "cli/options/command_parts.h"
#include "cli/options/help_text.h"
#include "cli/options/option_values.h"
#include "config/nearest.h"
#include "texts/command_line.h"
#include "texts/program_options.h"
#include "texts/values.h"

namespace kadr::cli {

void control_option(CLI::App& app, std::string& control) {
  control_id(app.add_option("--control", control, plain_text(texts::program_options::control_wanted)))->required();
}

void language_option(CLI::App& app, std::string& lang) {
  std::vector<std::string> ids;
  for (const TextLanguage& language : text_languages()) ids.emplace_back(language.id);
  one_of(app.add_option("--lang", lang, plain_text(texts::program_options::language)), ids);
}

void quiet_option(CLI::App& app, bool& quiet) { app.add_flag("-q,--quiet", quiet, plain_text(texts::program_options::quiet)); }

namespace {

void add_explain(CLI::App& app, Commands& c) {
  CLI::App* const explain = app.add_subcommand("explain", plain_text(texts::command_line::explain_command));
  control_id(explain->add_option(plain_text(texts::values::control), c.explain.control, plain_text(texts::command_line::explained_control)))
      ->required();
  explain->add_option(plain_text(texts::values::code), c.explain.code, plain_text(texts::command_line::explained_code));
  explain->add_flag("--markdown", c.explain.markdown, plain_text(texts::command_line::markdown_page));
  language_option(*explain, c.explain.lang);
  explain->footer(plain_text(texts::help_examples::explain));
}

void add_lists(CLI::App& app, Commands& c) {
  CLI::App* const controls = app.add_subcommand("controls", plain_text(texts::command_line::controls_command));
  control_id(controls->add_option(plain_text(texts::values::control), c.explain.control, plain_text(texts::command_line::listed_control)));
  language_option(*controls, c.options.lang);
  controls->footer(plain_text(texts::help_examples::controls));
  CLI::App* const machines = app.add_subcommand("machines", plain_text(texts::command_line::machines_command));
  machine_id(machines->add_option(plain_text(texts::values::machine), c.machine, plain_text(texts::command_line::listed_machine)));
  language_option(*machines, c.options.lang);
  machines->footer(plain_text(texts::help_examples::machines));
}

void add_tape(CLI::App& app, Commands& c) {
  CLI::App* const tape = app.add_subcommand("tape", plain_text(texts::command_line::tape_command));
  tape->require_subcommand(1);
  language_option(*tape, c.tape.lang);
  for (const bool decode : {true, false}) {
    CLI::App* const sub = decode ? tape->add_subcommand("decode", plain_text(texts::command_line::decode_command))
                                 : tape->add_subcommand("encode", plain_text(texts::command_line::encode_command));
    sub->add_option(plain_text(texts::values::input), c.tape.input, plain_text(texts::command_line::input_file))->required();
    sub->add_option(plain_text(texts::values::output), c.tape.output, plain_text(texts::command_line::output_file));
    one_of(sub->add_option("--code", c.tape.code,
                           decode ? plain_text(texts::command_line::tape_code) : plain_text(texts::command_line::written_tape_code)),
           {"iso", "eia"});
    language_option(*sub, c.tape.lang);
    if (decode) continue;
    encoding(sub->add_option("--encoding", c.tape.encoding, plain_text(texts::command_line::text_encoding)));
    whole_number(sub->add_option("--leader", c.tape.leader, plain_text(texts::command_line::tape_leader)), 0, 100000)
        ->capture_default_str();
  }
  tape->footer(plain_text(texts::help_examples::tape));
}

void add_state(CLI::App& app, Commands& c) {
  CLI::App* const state = app.add_subcommand("state", plain_text(texts::command_line::state_command));
  state->require_subcommand(1);
  language_option(*state, c.state.lang);
  for (const bool recover : {false, true}) {
    CLI::App* const sub = recover ? state->add_subcommand("recover", plain_text(texts::command_line::recover_command))
                                  : state->add_subcommand("check", plain_text(texts::command_line::check_state_command));
    sub->add_option(plain_text(texts::values::file), c.state.file, plain_text(texts::command_line::state_file))->required();
    language_option(*sub, c.state.lang);
    if (!recover) continue;
    writes_file(sub->add_option("--out", c.state.out, plain_text(texts::command_line::recovered_file)));
    control_id(sub->add_option("--control", c.state.control, plain_text(texts::command_line::recovered_control)));
  }
  state->footer(plain_text(texts::help_examples::state));
}

void add_pages(CLI::App& app, Commands& c) {
  CLI::App* const man = app.add_subcommand("man", plain_text(texts::command_line::manual_command));
  language_option(*man, c.options.lang);
  man->footer(plain_text(texts::help_examples::manual));
  CLI::App* const complete = app.add_subcommand("completion", plain_text(texts::command_line::completion_command));
  one_of(complete->add_option(plain_text(texts::values::shell), c.shell, plain_text(texts::command_line::shell)), {"bash", "zsh", "fish"})
      ->required();
  const auto print_codes = [](const std::string& control) {
    type_out("{}", codes_of(control));
    throw CLI::Success();
  };
  // this hidden option is for the completion scripts
  complete->add_option_function<std::string>("--codes", print_codes, "")->trigger_on_parse()->group("");
  language_option(*complete, c.options.lang);
  complete->footer(plain_text(texts::help_examples::completion));
}

/// Makes values of options mandatory. Otherwise CLI11 would read the next option as the value, and `--trace --why` would write a file named
/// --why.
void want_values(CLI::App& app) {
  for (CLI::Option* const option : app.get_options({})) {
    if (takes_nothing(*option)) continue;
    const auto check = [option](std::string& word) {
      const bool is_option = word.size() > 2 && word.starts_with("--");
      return is_option ? translated(texts::command_line::value_is_missing, option->get_type_name()) : std::string();
    };
    // CLI11 calls a transform before the other checks of a value, so a missing value is reported first
    option->transform(CLI::Validator(check, ""));
  }
  for (CLI::App* const sub : app.get_subcommands({})) want_values(*sub);
}

}  // namespace

std::unique_ptr<CLI::App> make_app(Commands& c) {
  auto app = std::make_unique<CLI::App>(plain_text(texts::command_line::about_kadr), "kadr");
  app->formatter(std::static_pointer_cast<CLI::FormatterBase>(help_formatter()));
  app->set_help_flag("-h,--help", plain_text(texts::command_line::help_option));
  app->set_version_flag("-V,--version", std::string("kadr ") + KADR_VERSION, plain_text(texts::command_line::version_option));
  app->add_flag_callback(
         "--licences,--licenses", [] { throw CLI::RuntimeError(print_licences()); }, plain_text(texts::command_line::licences_option))
      ->trigger_on_parse();
  app->require_subcommand(1);
  language_option(*app, c.options.lang);
  add_run(*app, c);
  add_check(*app, c);
  add_debug(*app, c);
  add_explain(*app, c);
  add_lists(*app, c);
  add_setup(*app, c);
  add_tape(*app, c);
  add_state(*app, c);
  add_mill(*app, c);
  add_cut(*app, c);
  add_diff(*app, c);
  add_convert(*app, c);
  add_edit(*app, c);
  add_report(*app, c);
  add_serve(*app, c);
  add_drive(*app, c);
  add_dnc(*app, c);
  add_lsp(*app, c);
  add_pages(*app, c);
  app->footer(plain_text(texts::command_line::how_to_begin));
  want_values(*app);
  return app;
}

void speak(Commands& c, const std::string& lang) {
  for (std::string* const member : {&c.options.lang, &c.explain.lang, &c.tape.lang, &c.state.lang, &c.setup.program.lang, &c.mill.lang,
                                    &c.cut.run.lang, &c.diff.both.lang, &c.convert.run.lang, &c.edit.run.lang, &c.report.cut.run.lang,
                                    &c.serve.lang, &c.lsp.lang, &c.drive.run.lang, &c.dnc.run.lang})
    *member = lang;
}

std::string language_on(int argc, const char* const* argv) {
  constexpr std::string_view name = "--lang", assigned = "--lang=";
  std::string lang;
  for (int i = 1; i < argc && std::string_view(argv[i]) != "--"; ++i) {
    const std::string_view word = argv[i];
    if (word == name && i + 1 < argc) lang = in_small_letters(argv[i + 1]);
    else if (word.starts_with(assigned)) lang = in_small_letters(word.substr(assigned.size()));
  }
  return lang;
}

}  // namespace kadr::cli
