// Writes the manual page, in roff, from the tree of commands.

#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "cli/options/command_line.h"
#include "cli/options/help_text.h"
#include "cli/options/option_values.h"
#include "config/language.h"

namespace kadr::cli {
namespace {

/// Escapes text for roff: backslashes, dashes, and what would be a request at the beginning of a line.
std::string roff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool begins = out.empty() || out.back() == '\n';
    if (begins && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\') out += "\\e";
    else if (c == '-') out += "\\-";
    else if (c == '`' || c == '^' || c == '~') out += c == '`' ? "\\(ga" : c == '^' ? "\\(ha" : "\\(ti";
    else if (c == '\'') out += "\\(aq";
    else out += c;
  }
  return out;
}

std::string bold(const std::string& text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + roff(text) + "\\fR"; }

std::string tag_of(const CLI::Option& option) {
  if (option.get_positional()) return italic(option.get_name(true, false));
  std::string tag;
  for (const std::string& name : option.get_snames()) tag += (tag.empty() ? "" : ", ") + bold("-" + name);
  for (const std::string& name : option.get_lnames()) tag += (tag.empty() ? "" : ", ") + bold("--" + name);
  return takes_nothing(option) ? tag : tag + " " + italic(option.get_type_name());
}

void options_of(const CLI::App& app, std::string& page) {
  for (const CLI::Option* const option : app.get_options([&](const CLI::Option* o) { return o != app.get_help_ptr(); })) {
    if (option->get_group().empty()) continue;
    std::string text = option->get_description();
    if (!takes_nothing(*option) && !option->get_default_str().empty())
      text += told(" (default: ", " (по умолчанию ") + option->get_default_str() + ")";
    page += fmt::format(".TP\n{}\n{}\n", tag_of(*option), roff(text));
  }
}

void command_of(const CLI::App& app, std::string& page) {
  page += fmt::format(".SS \"{}\"\n{}.\n", roff(whole_name(app)), roff(app.get_description()));
  options_of(app, page);
  for (const CLI::App* const sub : app.get_subcommands([](const CLI::App*) { return true; })) command_of(*sub, page);
  const CLI::App* const above = app.get_parent();
  const bool told_above = above != nullptr && above->get_footer() == app.get_footer();
  if (!app.get_footer().empty() && !told_above) page += fmt::format(".PP\n.nf\n{}\n.fi\n", roff(app.get_footer()));
}

void section(const char* en, const char* ru, const std::string& text, std::string& page) {
  page += fmt::format(".SH \"{}\"\n{}", told(en, ru), text);
}

/// Returns a list of items with their meanings.
std::string list(std::initializer_list<std::pair<std::string, std::string>> items) {
  std::string text;
  for (const auto& [what, meaning] : items) text += fmt::format(".TP\n{}\n{}\n", what, roff(meaning));
  return text;
}

std::string exit_statuses() {
  return list(
      {{"0", told("All well: ran to its end, no error, written.", "Без ошибок: УП дошла до конца, ошибок нет, записано.")},
       {"1", told("Stopped by an alarm, or errors found, or what was to be written is faulty.",
                  "Остановлено ошибкой УП, найдены ошибки или записать нечего из-за ошибки.")},
       {"2", told("Wrong usage, an unreadable file, or an output that could not be written whole.",
                  "Неверная команда, файл не читается или вывод не записан целиком.")},
       {"129, 130, 131, 143",
        told("Ended by SIGHUP, Ctrl-C, SIGQUIT, SIGTERM: within 0.2 s; what is not complete is removed.",
             "Прервано сигналом SIGHUP, клавишами Ctrl-C, сигналом SIGQUIT, SIGTERM: не позже чем через 0,2 с; недописанное удаляется.")}});
}

std::string files() {
  return list({{italic(told("NAME.toml", "ИМЯ.toml")), told("A control or a machine of one's own, for --control and --machine.",
                                                            "Своё УЧПУ или свой станок: для --control и --machine.")},
               {italic(told("SETUP.json", "СОСТОЯНИЕ.json")),
                told("State before the start; `kadr setup` writes one to be filled in, `kadr explain ID setup` names its keys.",
                     "Исходное состояние; бланк выдаёт `kadr setup`, ключи называет `kadr explain ОБОЗНАЧЕНИЕ setup`.")},
               {told("The controls and machines that Kadr knows", "УЧПУ и станки, которые знает Kadr"),
                told("are a part of the program: `kadr controls`, `kadr machines`.",
                     "входят в саму программу: `kadr controls`, `kadr machines`.")}});
}

std::string environment() {
  return list({{bold("LC_ALL") + ", " + bold("LC_MESSAGES") + ", " + bold("LANG"),
                told("Language of help and messages, where --lang does not say: Russian, if the first of them that is set begins with ru.",
                     "Язык справки и сообщений, если его не указывает --lang: русский, если первая из заданных начинается с ru.")},
               {bold("NO_COLOR"), told("If set and not empty: no colours. There are none, either, beside a terminal or where TERM is dumb.",
                                       "Если задана и не пуста — без цвета. Без цвета и не на терминале или при TERM=dumb.")},
               {bold("TERM"), told("Kind of the terminal.", "Вид терминала.")}});
}

}  // namespace

std::string manual_page(const CLI::App& app) {
  std::string page = fmt::format(".TH KADR 1 \"\" \"kadr {}\" \"{}\"\n", KADR_VERSION, told("User Commands", "Команды пользователя"));
  section("NAME", "ИМЯ",
          "kadr \\- " + told("reads part programs as a given control would", "читает управляющие программы, как их прочло бы УЧПУ") + "\n",
          page);
  section("SYNOPSIS", "ВЫЗОВ",
          fmt::format("{} {} [{}]\n.br\n{} {} {}\n", bold("kadr"), italic(told("COMMAND", "КОМАНДА")), italic(told("OPTIONS", "КЛЮЧИ")),
                      bold("kadr"), italic(told("COMMAND", "КОМАНДА")), bold("--help")),
          page);
  section("DESCRIPTION", "ОПИСАНИЕ", roff(app.get_description()) + "\n", page);
  section("OPTIONS", "ОБЩИЕ КЛЮЧИ", "", page);
  options_of(app, page);
  section("COMMANDS", "КОМАНДЫ", "", page);
  for (const CLI::App* const sub : app.get_subcommands([](const CLI::App*) { return true; })) command_of(*sub, page);
  section("EXIT STATUS", "КОД ВОЗВРАТА", exit_statuses(), page);
  section("FILES", "ФАЙЛЫ", files(), page);
  section("ENVIRONMENT", "ПЕРЕМЕННЫЕ СРЕДЫ", environment(), page);
  section("SEE ALSO", "СМ. ТАКЖЕ",
          bold("kadr") + " " + italic(told("COMMAND", "КОМАНДА")) + " " + bold("--help") +
              told(", and the pages of docs/ of the project: commands, controls, set-up.",
                   ", а также страницы docs/ru/ проекта: команды, УЧПУ, исходное состояние.") +
              "\n",
          page);
  return page;
}

}  // namespace kadr::cli
