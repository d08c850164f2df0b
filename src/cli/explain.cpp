// kadr explain, kadr controls: these commands print the rows of the control files.

#include <fmt/format.h>

#include <algorithm>

#include "cli/job/terminal.h"
#include "cli/options/options.h"
#include "config/control/control_file.h"
#include "out/text/explain/asked_code.h"
#include "out/text/explain/code_page.h"
#include "out/text/explain/setup_page.h"
#include "texts/explain_command.h"

namespace kadr::cli {
namespace {

Lang language_named(const std::string& lang) {
  Options options;
  options.lang = lang;
  return language(options);
}

/// Returns the text of docs/setup.md, which is one page for all controls.
std::string setup_page_of_all(Lang lang) {
  std::vector<ControlDef> all;
  for (const std::string& id : built_in_controls())
    if (auto def = load_control(id)) all.push_back(std::move(*def));
  std::vector<const ControlDef*> controls;
  for (const ControlDef& def : all) controls.push_back(&def);
  return setup_page(controls, lang);
}

/// Returns the ids of the built-in controls that have the code. The control `not_this` is omitted, since the user has already asked about
/// it.
std::vector<std::string> controls_with(const std::string& code, const std::string& not_this, Lang lang) {
  std::vector<std::string> ids;
  for (const std::string& id : built_in_controls()) {
    const auto def = id == not_this ? tl::unexpected<std::string>("") : load_control(id);
    if (!def) continue;
    const auto texts = AlarmTexts::load(&*def);
    if (texts && explain_code(*def, *texts, code, lang)) ids.push_back(id);
  }
  return ids;
}

/// Returns a message about an unknown code, e.g. "no code … 'G5.1'; nct has it; did you mean G4, G9?".
std::string unknown_code(const ControlDef& def, const std::string& code, Lang lang) {
  std::string text = translated_in(lang, texts::explain_command::unknown_code, def.id, code);
  if (const auto ids = controls_with(code, def.id, lang); !ids.empty())
    text += translated_in(lang, texts::explain_command::known_to, fmt::format("{}", fmt::join(ids, ", ")));
  if (const auto names = nearest_to(def, code); !names.empty())
    text += translated_in(lang, texts::explain_command::did_you_mean, fmt::format("{}", fmt::join(names, ", ")));
  return text;
}

/// Prints the texts of all built-in controls about a code, an alarm or words. Controls with the same text are printed together.
int explain_everywhere(const std::string& what, const std::string& refusal, Lang lang) {
  // pairs of a text and the ids of the controls to which the text applies
  std::vector<std::pair<std::string, std::vector<std::string>>> answers;
  const std::vector<std::string> all = built_in_controls();
  for (const std::string& id : all) {
    const auto def = load_control(id);
    if (!def) continue;
    const auto texts = AlarmTexts::load(&*def);
    if (!texts) continue;
    auto text = explain_code(*def, *texts, what, lang);
    if (!text) text = explain_words(*def, *texts, what, lang);
    if (!text) continue;
    const auto same = std::find_if(answers.begin(), answers.end(), [&](const auto& one) { return one.first == *text; });
    if (same != answers.end()) same->second.push_back(id);
    else answers.push_back({*text, {id}});
  }
  for (const auto& [text, ids] : answers) {
    const bool is_named = text.starts_with(ids.front() + " ") || text.starts_with(ids.front() + ":");
    type_out("{}{}", is_named || ids.size() == all.size() ? std::string() : fmt::format("{}: ", fmt::join(ids, ", ")), text);
  }
  if (!answers.empty()) return ok;
  complain(refusal);
  return wrong_usage;
}

}  // namespace

int explain(const ExplainOptions& options) {
  const auto def = load_control(options.control);
  if (!def && options.code.empty() && !options.markdown && !options.control.ends_with(".toml"))
    return explain_everywhere(options.control, def.error(), language_named(options.lang));
  if (!def) {
    complain(def.error());
    return wrong_usage;
  }
  const auto texts = AlarmTexts::load(&*def);
  if (!texts) {
    complain(texts.error());
    return wrong_usage;
  }
  const Lang lang = language_named(options.lang);
  if (options.code == "setup") {
    type_out("{}", options.markdown ? setup_page_of_all(lang) : explain_setup(*def, lang));
    return ok;
  }
  if (options.markdown) {
    type_out("{}", control_page(*def, *texts));
    return ok;
  }
  if (options.code.empty()) {
    type_out("{}", explain_control(*def, lang));
    return ok;
  }
  auto text = explain_code(*def, *texts, options.code, lang);
  if (!text) text = explain_words(*def, *texts, options.code, lang);
  if (!text) {
    complain(unknown_code(*def, options.code, lang));
    return wrong_usage;
  }
  type_out("{}", *text);
  return ok;
}

int list_controls(const std::string& of, const std::string& lang_name) {
  if (!of.empty()) return explain({of, {}, lang_name});
  const Lang lang = language_named(lang_name);
  for (const std::string& id : built_in_controls()) {
    const auto def = load_control(id);
    if (!def) {
      complain(def.error());
      return wrong_usage;
    }
    type_out("{:<12}{}", id, lang == Lang::ru ? def->name.ru : def->name.en);
    if (!def->aliases.empty())
      type_out(" {}", translated_in(lang, texts::explain_command::aliases, fmt::format("{}", fmt::join(def->aliases, ", "))));
    type_out("\n");
  }
  return ok;
}

}  // namespace kadr::cli
