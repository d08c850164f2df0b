// Manual page and shell completion, from the tree of commands.

#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "cli/command_line.h"
#include "config/control_file.h"

namespace kadr::cli {
namespace {

std::vector<const CLI::App*> subcommands(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<const CLI::Option*> options(const CLI::App& app) {
  return app.get_options([&](const CLI::Option* option) { return option != app.get_help_ptr(); });
}

/// Text for roff: backslashes, dashes and leading dots.
std::string roff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\' || c == '-') out += '\\';
    if (c == '\n') {
      out += "\n";
      continue;
    }
    if (c == '.' && (out.empty() || out.back() == '\n')) out += "\\&";
    out += c;
  }
  return out;
}

void manual_of(const CLI::App& app, const std::string& name, std::string& page) {
  page += fmt::format(".SS {}\n{}.\n", roff(name), roff(app.get_description()));
  for (const CLI::Option* const option : options(app))
    page += fmt::format(".TP\n.B {}\n{}\n", roff(option->get_name(true)), roff(option->get_description()));
  if (!app.get_footer().empty()) page += fmt::format(".PP\n.nf\n{}\n.fi\n", roff(app.get_footer()));
  for (const CLI::App* const sub : subcommands(app)) manual_of(*sub, name + " " + sub->get_name(), page);
}

/// Words that may follow a command: its subcommands and long options.
std::string words_of(const CLI::App& app) {
  std::string words = "--help";
  for (const CLI::App* const sub : subcommands(app)) words += " " + sub->get_name();
  for (const CLI::Option* const option : options(app))
    for (const std::string& name : option->get_lnames()) words += " --" + name;
  return words;
}

std::string controls_list() {
  std::string words;
  for (const std::string& id : built_in_controls()) words += (words.empty() ? "" : " ") + id;
  return words;
}

std::string bash_script(const CLI::App& app) {
  std::string cases;
  for (const CLI::App* const sub : subcommands(app)) {
    cases += fmt::format("    {}) words=\"{}\" ;;\n", sub->get_name(), words_of(*sub));
  }
  return fmt::format(
      "# bash completion of kadr; made by `kadr completion bash`\n"
      "_kadr() {{\n"
      "  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} words\n"
      "  case $before in\n"
      "    --control|explain) COMPREPLY=($(compgen -W \"{0}\" -- \"$word\") $(compgen -f -X '!*.toml' -- \"$word\")); return ;;\n"
      "    --lang) COMPREPLY=($(compgen -W \"en ru\" -- \"$word\")); return ;;\n"
      "    --format) COMPREPLY=($(compgen -W \"text json sarif\" -- \"$word\")); return ;;\n"
      "    --encoding) COMPREPLY=($(compgen -W \"utf-8 cp1251 koi8-r cp866 utf-16 utf-16le utf-16be iso7 eia\" -- \"$word\")); return ;;\n"
      "  esac\n"
      "  case ${{COMP_WORDS[1]}} in\n{1}    *) words=\"{2}\" ;;\n  esac\n"
      "  COMPREPLY=($(compgen -W \"$words\" -- \"$word\") $(compgen -f -- \"$word\"))\n"
      "}}\n"
      "complete -o filenames -F _kadr kadr\n",
      controls_list(), cases, words_of(app));
}

std::string quoted(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out;
}

std::string fish_script(const CLI::App& app) {
  std::string script = "# fish completion of kadr; made by `kadr completion fish`\n";
  for (const CLI::App* const sub : subcommands(app)) {
    script += fmt::format("complete -c kadr -n __fish_use_subcommand -a {} -d '{}'\n", sub->get_name(), quoted(sub->get_description()));
    for (const CLI::Option* const option : options(*sub))
      for (const std::string& name : option->get_lnames())
        script += fmt::format("complete -c kadr -n '__fish_seen_subcommand_from {}' -l {} -d '{}'\n", sub->get_name(), name,
                              quoted(option->get_description()));
  }
  return script + fmt::format("complete -c kadr -l control -x -a '{}'\n", controls_list());
}

}  // namespace

std::string manual_page(const CLI::App& app) {
  std::string page = fmt::format(
      ".TH KADR 1 \"\" \"kadr {}\" \"User Commands\"\n.SH NAME\nkadr \\- reads part programs as a given control would\n", KADR_VERSION);
  page += ".SH SYNOPSIS\n.B kadr\n.I command\n[options]\n.SH DESCRIPTION\n" + roff(app.get_description()) + "\n.SH COMMANDS\n";
  for (const CLI::App* const sub : subcommands(app)) manual_of(*sub, sub->get_name(), page);
  page += ".SH EXIT STATUS\n0: all well. 1: stopped by an alarm, or errors found. 2: wrong usage or unreadable file.\n";
  page += ".SH SEE ALSO\nThe documentation in docs/ of the project.\n";
  return page;
}

std::string completion(const CLI::App& app, const std::string& shell) {
  if (shell == "fish") return fish_script(app);
  if (shell == "zsh") return "#compdef kadr\nautoload -U +X bashcompinit && bashcompinit\n" + bash_script(app);
  return bash_script(app);
}

}  // namespace kadr::cli
