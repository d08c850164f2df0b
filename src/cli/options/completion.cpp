// Creates the completion scripts of bash, zsh and fish from the definitions of the commands.

#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "cli/options/command_line.h"
#include "cli/options/option_values.h"
#include "config/control/control_file.h"
#include "config/machine/machine_profile.h"
#include "texts/values.h"

namespace kadr::cli {
namespace {

/// The possible values of an option or argument.
struct Values {
  std::string words;   // possible words, separated by blanks
  std::string ending;  // pattern of file name endings, e.g. "json", "@(svg|png)"; empty: any ending
  bool folders = false;
  bool files = false;  // true: the value may be the name of any file
};

std::string joined(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : " ") + word;
  return list;
}

std::vector<const CLI::App*> subcommands(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<const CLI::Option*> named_options(const CLI::App& app) {
  return app.get_options([](const CLI::Option* option) { return option->nonpositional() && !option->get_group().empty(); });
}

/// Determines the possible values from the name of the value in the help. A list of words has a name such as "text|json|sarif" (one_of in
/// cli/options/option_values).
Values values_of(const std::string& name, const CLI::Option& option) {
  if (name == "--control") return {joined(control_names()), "toml", false};
  if (name == "--machine") return {joined(built_in_machines()), "toml", false};
  if (name == "--encoding") return {joined(encodings()), "", false};
  if (name == "--setup" || name == "--baseline") return {"", "json", false};
  if (name == "--plot" || name == "--plot-speed") return {"", "@(svg|png)", false};
  if (name == "--files") return {"", "", true};
  std::string words = option.get_type_name();
  if (words == plain_text(texts::values::file)) return {"", "", false, true};
  if (words.find('|') == std::string::npos || words.find('%') != std::string::npos) return {};
  for (char& c : words)
    if (c == '|') c = ' ';
  return {words, "", false};
}

/// Returns the subcommands and the long options of a command.
std::string words_of(const CLI::App& app) {
  std::string words;
  for (const CLI::App* const sub : subcommands(app)) words += sub->get_name() + " ";
  for (const CLI::Option* const option : named_options(app))
    for (const std::string& name : option->get_lnames()) words += "--" + name + " ";
  if (!words.empty()) words.pop_back();
  return words;
}

std::string shell_reply(const Values& values) {
  std::string reply;
  if (!values.words.empty()) reply += fmt::format("_kadr_words \"{}\"; ", values.words);
  if (values.folders) reply += "_kadr_files -d; ";
  else if (!values.ending.empty()) reply += fmt::format("_kadr_files '!*.{}'; ", values.ending);
  else if (values.files) reply += "_kadr_files; ";
  return reply;
}

/// Adds a branch to `case "$command $before"` of the script for each option with a value. The branch suggests the possible values of the
/// option.
void shell_values(const CLI::App& app, const std::string& command, std::string& cases) {
  for (const CLI::Option* const option : named_options(app)) {
    if (takes_nothing(*option)) continue;
    for (const std::string& name : option->get_lnames())
      cases += fmt::format("    '{} --{}') {}return ;;\n", command, name, shell_reply(values_of("--" + name, *option)));
  }
  for (const CLI::App* const sub : subcommands(app)) shell_values(*sub, command + (command.empty() ? "" : " ") + sub->get_name(), cases);
}

void shell_words(const CLI::App& app, const std::string& command, std::string& cases) {
  const bool files = subcommands(app).empty();
  const bool asks_control = command == "explain", asks_machine = command == "machines", asks_shell = command == "completion";
  std::string more = files ? "_kadr_files; " : "";
  if (asks_control) more = fmt::format("_kadr_explain \"{}\"; ", joined(control_names()));
  if (asks_machine) more = fmt::format("_kadr_words \"{}\"; _kadr_files '!*.toml'; ", joined(built_in_machines()));
  if (asks_shell) more = "_kadr_words \"bash zsh fish\"; ";
  if (command == "controls" || command == "man") more.clear();
  cases += fmt::format("    '{}') _kadr_words \"{}\"; {}return ;;\n", command, words_of(app), more);
  for (const CLI::App* const sub : subcommands(app)) shell_words(*sub, command + (command.empty() ? "" : " ") + sub->get_name(), cases);
}

/// Returns a shell pattern that matches the commands of two words: 'tape decode'|'tape encode'.
std::string shell_groups(const CLI::App& app) {
  std::string groups;
  for (const CLI::App* const sub : subcommands(app)) {
    if (subcommands(*sub).empty()) continue;
    for (const CLI::App* const one : subcommands(*sub))
      groups += fmt::format("{}'{} {}'", groups.empty() ? "" : "|", sub->get_name(), one->get_name());
  }
  return groups;
}

// Functions of the completion scripts of bash and zsh. They suggest the words that begin with $word, in small or capital letters. The
// tables that tables() writes call these functions.
constexpr const char* bash_functions = R"sh(# bash completion of kadr; made by `kadr completion bash`
_kadr_words() {
  local one
  for one in $1; do [[ ${one,,} == "${word,,}"* ]] && COMPREPLY+=("$one"); done
}
_kadr_files() {  # folders, and files unless the pattern leaves them out
  local IFS=$'\n' one pattern=()
  [[ -n $1 ]] && pattern=(-X "$1")
  compopt -o filenames 2>/dev/null
  for one in $(compgen -d -- "$word"); do COMPREPLY+=("$one"); done
  [[ $1 == -d ]] && return
  local extglob=$(shopt -p extglob)
  shopt -s extglob
  for one in $(compgen -f "${pattern[@]}" -- "$word"); do [[ -d $one ]] || COMPREPLY+=("$one"); done
  eval "$extglob"
}
_kadr_explain() {  # the control, then its codes
  local i control=
  for ((i = 2; i < COMP_CWORD; i++)); do [[ ${COMP_WORDS[i]} == -* ]] || control=${COMP_WORDS[i]}; done
  if [[ -z $control ]]; then _kadr_words "$1"; _kadr_files '!*.toml'
  else _kadr_words "$("${COMP_WORDS[0]}" completion --codes "$control" 2>/dev/null)";
fi
}
)sh";

constexpr const char* bash_beginning = R"sh(_kadr() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command= first=1 group=
  COMPREPLY=()
  if [[ $word == = ]]; then word=  # --format=…: bash makes three words of it
  elif [[ $before == = ]]; then before=${COMP_WORDS[COMP_CWORD-2]}; fi
  while [[ ${COMP_WORDS[first]} == --lang ]]; do ((first += 2)); done
  if ((COMP_CWORD > first)); then command=${COMP_WORDS[first]}; fi
  if ((COMP_CWORD > first + 1)); then group="$command ${COMP_WORDS[first + 1]}"; fi
)sh";

constexpr const char* zsh_functions = R"sh(#compdef kadr
# zsh completion of kadr; made by `kadr completion zsh`
_kadr_words() { compadd -M 'm:{a-zA-Z}={A-Za-z}' -- ${=1} }
_kadr_files() {
  case $1 in
    -d) _files -/ ;;
    '!'*) _files -g "${${1#!}//@/}" ;;
    *) _files ;;
  esac
}
_kadr_explain() {
  local i control=
  for ((i = 3; i < CURRENT; i++)); do [[ ${words[i]} == -* ]] || control=${words[i]}; done
  if [[ -z $control ]]; then _kadr_words "$1"; _kadr_files '!*.toml'
  else _kadr_words "$(${words[1]} completion --codes $control 2>/dev/null)";
fi
}
)sh";

constexpr const char* zsh_beginning = R"sh(_kadr() {
  local before=${words[CURRENT-1]} command= first=2 group=
  while [[ ${words[first]} == --lang ]]; do ((first += 2)); done
  if ((CURRENT > first)); then command=${words[first]}; fi
  if ((CURRENT > first + 1)); then group="$command ${words[first + 1]}"; fi
)sh";

/// Returns the part of the completion scripts of bash and zsh that lists the commands, options and values of `app`.
std::string tables(const CLI::App& app) {
  std::string values, words;
  shell_values(app, "", values);
  shell_words(app, "", words);
  return fmt::format(
      "  case $group in {}) command=$group ;; esac\n  case \"$command $before\" in\n{}  esac\n  case $command in\n{}  esac\n}}\n",
      shell_groups(app), values, words);
}

std::string bash_script(const CLI::App& app) {
  return std::string(bash_functions) + bash_beginning + tables(app) + "complete -F _kadr kadr\n";
}

/// Returns the script for zsh. In a folder of fpath the script itself is the completion function. If `source` reads the script, it must
/// register the function.
std::string zsh_script(const CLI::App& app) {
  return std::string(zsh_functions) + zsh_beginning + tables(app) +
         "if [[ ${funcstack[1]} == _kadr ]]; then _kadr \"$@\"; else compdef _kadr kadr; fi\n";
}

std::string in_quotes(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '\'' ? std::string("\\'") : c == '\\' ? std::string("\\\\") : std::string(1, c);
  return "'" + out + "'";
}

/// Returns the command part with which fish suggests the values of an option.
std::string fish_values(const Values& values) {
  std::string offer;
  if (!values.words.empty()) offer += values.words + " ";
  if (values.folders) offer += "(__fish_complete_directories)";
  else if (values.ending == "@(svg|png)") offer += "(__fish_complete_suffix .svg .png)";
  else if (!values.ending.empty()) offer += "(__fish_complete_suffix ." + values.ending + ")";
  if (offer.empty()) return values.files ? " -r" : " -x";
  return " -x -a " + in_quotes(offer);
}

void fish_lines(const CLI::App& app, const std::string& condition, std::string& script) {
  for (const CLI::Option* const option : named_options(app))
    for (const std::string& name : option->get_lnames()) {
      script += fmt::format("complete -c kadr -n {} -l {} -d {}", in_quotes(condition), name, in_quotes(option->get_description()));
      if (!option->get_snames().empty()) script += " -s " + option->get_snames().front();
      script += (takes_nothing(*option) ? "" : fish_values(values_of("--" + name, *option))) + "\n";
    }
  for (const CLI::App* const sub : subcommands(app)) {
    std::string without;
    for (const CLI::App* const other : subcommands(app)) without += " " + other->get_name();
    script += fmt::format("complete -c kadr -f -n {} -a {} -d {}\n",
                          in_quotes((condition.empty() || app.get_parent() == nullptr ? "" : condition + "; and ") +
                                    std::string("not __fish_seen_subcommand_from") + without),
                          sub->get_name(), in_quotes(sub->get_description()));
    fish_lines(*sub, (app.get_parent() == nullptr ? "" : condition + "; and ") + "__fish_seen_subcommand_from " + sub->get_name(), script);
  }
}

std::string fish_script(const CLI::App& app) {
  std::string script = "# fish completion of kadr; made by `kadr completion fish`\n";
  fish_lines(app, "true", script);
  const std::string in_explain = "__fish_seen_subcommand_from explain", controls = joined(control_names());
  script += fmt::format("complete -c kadr -f -n {} -a {}\n", in_quotes(in_explain + "; and not __fish_seen_subcommand_from " + controls),
                        in_quotes(controls));
  for (const std::string& id : control_names())
    script += fmt::format("complete -c kadr -f -n {} -a {}\n", in_quotes(in_explain + "; and __fish_seen_subcommand_from " + id),
                          in_quotes("(kadr completion --codes " + id + ")"));
  script += fmt::format("complete -c kadr -f -n {} -a {}\n", in_quotes("__fish_seen_subcommand_from machines"),
                        in_quotes(joined(built_in_machines())));
  return script +
         fmt::format("complete -c kadr -f -n {} -a {}\n", in_quotes("__fish_seen_subcommand_from completion"), in_quotes("bash zsh fish"));
}

}  // namespace

std::string completion(const CLI::App& app, const std::string& shell) {
  if (shell == "fish") return fish_script(app);
  if (shell == "zsh") return zsh_script(app);
  return bash_script(app);
}

std::string codes_of(const std::string& control) {
  const auto def = load_control(control);
  if (!def) return {};
  std::string codes = "setup\n";
  for (const CodeRow& row : def->codes) codes += row.code + "\n";
  for (const CycleRow& row : def->cycles) codes += row.name + "\n";
  for (const AddressRow& row : def->addresses)
    if (row.function != Function::count) codes += std::string(1, row.letter) + "\n";
  return codes;
}

}  // namespace kadr::cli
