// The command line: commands, options, and help with examples. Used by the rest of cli.

#include "cli/options/command_line.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "cli/job/terminal.h"
#include "cli/options/command_parts.h"
#include "cli/options/help_text.h"
#include "cli/options/option_values.h"
#include "config/language.h"
#include "config/nearest.h"

namespace kadr::cli {

void control_option(CLI::App& app, std::string& control) {
  control_id(app.add_option(
                 "--control", control,
                 told("control: an id of `kadr controls`, or a file NAME.toml", "УЧПУ: обозначение из `kadr controls` или файл ИМЯ.toml")))
      ->required();
}

void language_option(CLI::App& app, std::string& lang) {
  one_of(app.add_option("--lang", lang,
                        told("language of help and messages (default: by LANG)", "язык справки и сообщений (по умолчанию из LANG)")),
         {"en", "ru"});
}

void quiet_option(CLI::App& app, bool& quiet) {
  app.add_flag("-q,--quiet", quiet, told("no summary, no progress bar", "без сводки и полосы хода работы"));
}

namespace {

void add_explain(CLI::App& app, Commands& c) {
  CLI::App* const explain =
      app.add_subcommand("explain", told("what a code, address, cycle or alarm means", "что значит код, адрес, цикл или ошибка"));
  control_id(explain->add_option(told("CONTROL", "УЧПУ"), c.explain.control,
                                 told("control id or NAME.toml; without it CODE is looked for in all of them",
                                      "обозначение УЧПУ или ИМЯ.toml; без него КОД ищется во всех")))
      ->required();
  explain->add_option(told("CODE", "КОД"), c.explain.code,
                      told("G41, M3, X, L81, an alarm's id or number, words (\"cutter compensation\"), setup; left out: all codes",
                           "G41, M3, X, L81, имя или номер ошибки, слова («коррекция на радиус»), setup; без него — все коды"));
  explain->add_flag("--markdown", c.explain.markdown, told("the page of the documentation", "страница документации"));
  language_option(*explain, c.explain.lang);
  explain->footer(explain_examples());
}

void add_lists(CLI::App& app, Commands& c) {
  CLI::App* const controls = app.add_subcommand("controls", told("the controls Kadr knows", "какие УЧПУ знает Kadr"));
  control_id(controls->add_option(told("CONTROL", "УЧПУ"), c.explain.control,
                                  told("its codes, as of explain; left out: all controls", "её коды, как у explain; без него — все УЧПУ")));
  language_option(*controls, c.options.lang);
  controls->footer(controls_examples());
  CLI::App* const machines =
      app.add_subcommand("machines", told("the machines Kadr knows, and what they can do", "какие станки знает Kadr и что они могут"));
  machine_id(machines->add_option(
      told("MACHINE", "СТАНОК"), c.machine,
      told("machine id or NAME.toml; left out: all machines", "обозначение станка или ИМЯ.toml; без него — все станки")));
  language_option(*machines, c.options.lang);
  machines->footer(machines_examples());
}

void add_tape(CLI::App& app, Commands& c) {
  CLI::App* const tape = app.add_subcommand("tape", told("punched tape: rows of ISO-7 with even parity or of EIA RS-244, and text",
                                                         "перфолента: строки ISO-7 с чётностью или EIA RS-244 и текст"));
  tape->require_subcommand(1);
  language_option(*tape, c.tape.lang);
  for (const bool decode : {true, false}) {
    CLI::App* const sub = decode ? tape->add_subcommand("decode", told("rows to text", "строки ленты в текст"))
                                 : tape->add_subcommand("encode", told("text to rows", "текст в строки ленты"));
    sub->add_option(told("INPUT", "ОТКУДА"), c.tape.input, told("file, or - for stdin", "файл или - стандартный ввод"))->required();
    sub->add_option(told("OUTPUT", "КУДА"), c.tape.output,
                    told("file, or - for stdout (default)", "файл или - стандартный вывод (по умолчанию)"));
    one_of(sub->add_option("--code", c.tape.code,
                           decode ? told("of the tape (default: detected)", "код ленты (по умолчанию определяется сам)")
                                  : told("of the tape (default: iso)", "код ленты (по умолчанию iso)")),
           {"iso", "eia"});
    language_option(*sub, c.tape.lang);
    if (decode) continue;
    encoding(sub->add_option("--encoding", c.tape.encoding,
                             told("of the text: utf-8, cp1251, koi8-r, cp866, utf-16 (default: detected)",
                                  "кодировка текста: utf-8, cp1251, koi8-r, cp866, utf-16 (по умолчанию определяется сама)")));
    whole_number(sub->add_option("--leader", c.tape.leader, told("rows of blank tape before and after", "пустых строк ленты до и после")),
                 0, 100000)
        ->capture_default_str();
  }
  tape->footer(tape_examples());
}

void add_state(CLI::App& app, Commands& c) {
  CLI::App* const state =
      app.add_subcommand("state", told("the file of run --state: is it sound", "файл состояния (run --state): исправен ли он"));
  state->require_subcommand(1);
  language_option(*state, c.state.lang);
  for (const bool recover : {false, true}) {
    CLI::App* const sub =
        recover ? state->add_subcommand("recover", told("write what is sound into a new file", "записать уцелевшее в новый файл"))
                : state->add_subcommand("check", told("find every damaged row", "найти все повреждённые записи"));
    sub->add_option(told("FILE", "ФАЙЛ"), c.state.file, told("state file", "файл состояния"))->required();
    language_option(*sub, c.state.lang);
    if (!recover) continue;
    writes_file(sub->add_option("--out", c.state.out,
                                told("the new file, which must not be there yet (default: FILE.recovered)",
                                     "новый файл, которого ещё нет (по умолчанию ФАЙЛ.recovered)")));
    control_id(sub->add_option("--control", c.state.control,
                               told("whose state it is, where the file no longer says", "чьё это состояние, если файл уже не говорит")));
  }
  state->footer(state_examples());
}

void add_pages(CLI::App& app, Commands& c) {
  CLI::App* const man = app.add_subcommand("man", told("print the manual page", "вывести страницу руководства (man)"));
  language_option(*man, c.options.lang);
  man->footer(man_examples());
  CLI::App* const complete =
      app.add_subcommand("completion", told("print the completion script of a shell", "вывести сценарий дополнения команд для оболочки"));
  one_of(complete->add_option(told("SHELL", "ОБОЛОЧКА"), c.shell, told("bash, zsh or fish", "bash, zsh или fish")), {"bash", "zsh", "fish"})
      ->required();
  const auto print_codes = [](const std::string& control) {
    type_out("{}", codes_of(control));
    throw CLI::Success();
  };
  complete->add_option_function<std::string>("--codes", print_codes, "")->trigger_on_parse()->group("");  // only the scripts call it
  language_option(*complete, c.options.lang);
  complete->footer(completion_examples());
}

/// Requires values for options: CLI11 would read the next option as the value, so that `--trace --why` would write a file named --why.
void want_values(CLI::App& app) {
  for (CLI::Option* const option : app.get_options({})) {
    if (takes_nothing(*option)) continue;
    const auto check = [option](std::string& word) {
      const bool is_option = word.size() > 2 && word.starts_with("--");
      return is_option ? told("a value is missing: ", "нет значения: ") + option->get_type_name() : std::string();
    };
    option->transform(CLI::Validator(check, ""));  // runs before the other validators
  }
  for (CLI::App* const sub : app.get_subcommands({})) want_values(*sub);
}

}  // namespace

std::unique_ptr<CLI::App> make_app(Commands& c) {
  auto app = std::make_unique<CLI::App>(
      told("Kadr reads part programs exactly as a given control would: checks, runs, draws and times them.",
           "Kadr читает УП так, как прочло бы её данное УЧПУ: проверяет, отрабатывает, вычерчивает, считает время."),
      "kadr");
  app->formatter(std::static_pointer_cast<CLI::FormatterBase>(help_formatter()));
  app->set_help_flag("-h,--help", told("print this help and exit", "вывести эту справку и закончить"));
  app->set_version_flag("-V,--version", std::string("kadr ") + KADR_VERSION,
                        told("print the version and exit", "вывести версию и закончить"));
  app->add_flag_callback(
         "--licences,--licenses", [] { throw CLI::RuntimeError(print_licences()); },
         told("print the notices of all that the program is made of and exit",
              "вывести лицензии всего, из чего состоит программа, и закончить"))
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
  add_report(*app, c);
  add_serve(*app, c);
  add_pages(*app, c);
  app->footer(told("`kadr COMMAND --help` shows options and examples. Try: kadr run examples/s2c42/flange.nc --plot flange.svg",
                   "`kadr КОМАНДА --help` показывает ключи и примеры. Начните так: kadr run examples/s2c42/flange.nc --plot flange.svg"));
  want_values(*app);
  return app;
}

void speak(Commands& c, const std::string& lang) {
  for (std::string* const member : {&c.options.lang, &c.explain.lang, &c.tape.lang, &c.state.lang, &c.setup.program.lang, &c.mill.lang,
                                    &c.cut.run.lang, &c.diff.both.lang, &c.convert.run.lang, &c.report.cut.run.lang, &c.serve.lang})
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
