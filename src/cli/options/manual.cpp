// Creates the manual page in the format roff from the definitions of the commands.

#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "cli/options/command_line.h"
#include "cli/options/help_text.h"
#include "cli/options/option_values.h"
#include "texts/help.h"
#include "texts/manual_page.h"
#include "texts/values.h"

namespace kadr::cli {
namespace {

/// Escapes text for roff: backslashes, dashes, and characters that roff would interpret as a request at the beginning of a line.
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
      text = translated(texts::help::with_default, text, option->get_default_str());
    page += fmt::format(".TP\n{}\n{}\n", tag_of(*option), roff(text));
  }
}

void command_of(const CLI::App& app, std::string& page) {
  page += fmt::format(".SS \"{}\"\n{}.\n", roff(whole_name(app)), roff(app.get_description()));
  options_of(app, page);
  for (const CLI::App* const sub : app.get_subcommands([](const CLI::App*) { return true; })) command_of(*sub, page);
  const CLI::App* const above = app.get_parent();
  const bool printed_above = above != nullptr && above->get_footer() == app.get_footer();
  if (!app.get_footer().empty() && !printed_above) page += fmt::format(".PP\n.nf\n{}\n.fi\n", roff(app.get_footer()));
}

void section(PlainText heading, const std::string& text, std::string& page) {
  page += fmt::format(".SH \"{}\"\n{}", plain_text(heading), text);
}

/// Returns a list in the format roff, in which each item is followed by its meaning.
std::string list(std::initializer_list<std::pair<std::string, std::string>> items) {
  std::string text;
  for (const auto& [what, meaning] : items) text += fmt::format(".TP\n{}\n{}\n", what, roff(meaning));
  return text;
}

std::string exit_statuses() {
  return list({{"0", plain_text(texts::manual_page::status_well)},
               {"1", plain_text(texts::manual_page::status_fault)},
               {"2", plain_text(texts::manual_page::status_wrong_usage)},
               {"129, 130, 131, 143", plain_text(texts::manual_page::status_interrupted)}});
}

std::string files() {
  return list({{italic(plain_text(texts::manual_page::own_file_name)), plain_text(texts::manual_page::own_file)},
               {italic(plain_text(texts::manual_page::setup_file_name)), plain_text(texts::manual_page::setup_file)},
               {plain_text(texts::manual_page::built_in_files_name), plain_text(texts::manual_page::built_in_files)}});
}

std::string environment() {
  return list({{bold("LC_ALL") + ", " + bold("LC_MESSAGES") + ", " + bold("LANG"), plain_text(texts::manual_page::language_variable)},
               {bold("NO_COLOR"), plain_text(texts::manual_page::no_color_variable)},
               {bold("TERM"), plain_text(texts::manual_page::term_variable)}});
}

}  // namespace

std::string manual_page(const CLI::App& app) {
  std::string page = fmt::format(".TH KADR 1 \"\" \"kadr {}\" \"{}\"\n", KADR_VERSION, plain_text(texts::manual_page::user_commands));
  section(texts::manual_page::name_heading, fmt::format("kadr \\- {}\n", plain_text(texts::manual_page::about_kadr)), page);
  section(texts::manual_page::synopsis_heading,
          fmt::format("{} {} [{}]\n.br\n{} {} {}\n", bold("kadr"), italic(plain_text(texts::values::command)),
                      italic(plain_text(texts::values::options)), bold("kadr"), italic(plain_text(texts::values::command)), bold("--help")),
          page);
  section(texts::manual_page::description_heading, roff(app.get_description()) + "\n", page);
  section(texts::manual_page::options_heading, "", page);
  options_of(app, page);
  section(texts::manual_page::commands_heading, "", page);
  for (const CLI::App* const sub : app.get_subcommands([](const CLI::App*) { return true; })) command_of(*sub, page);
  section(texts::manual_page::exit_status_heading, exit_statuses(), page);
  section(texts::manual_page::files_heading, files(), page);
  section(texts::manual_page::environment_heading, environment(), page);
  section(texts::manual_page::see_also_heading,
          translated(texts::manual_page::see_also, bold("kadr") + " " + italic(plain_text(texts::values::command)) + " " + bold("--help")) +
              "\n",
          page);
  return page;
}

}  // namespace kadr::cli
