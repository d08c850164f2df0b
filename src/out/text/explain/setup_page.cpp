// Describes the keys of a set-up, as the page docs/setup.md or for a single control (kadr explain ID setup). This file is used by
// cli/explain.

#include "out/text/explain/setup_page.h"

#include <fmt/core.h>

#include <algorithm>

#include "config/setup/setup_check.h"
#include "config/setup/setup_names.h"
#include "texts/setup_page.h"

namespace kadr {
namespace {

/// Returns in words which values a key accepts, their unit, and whether null is allowed, e.g. "a number, zero or above; mm/min; or null".
std::string form_text(const SetupKey& row, SetupRange range, Lang lang) {
  std::string text = form_of(row, range, lang);
  if (row.unit != SetupUnit::none) text += fmt::format("; {}", name_of(row.unit, lang));
  return row.null ? translated_in(lang, texts::setup_page::or_null, text) : text;
}

/// Returns in words the names that the keys of a table in the set-up may have, or that the value of a key may be, e.g. "axes", «номер —
/// целое число от 1 до 99».
std::string names_text(const SetupKey& row, const SetupNamesOf& names, Lang lang) {
  const bool is_below = row.form == SetupForm::table;
  switch (row.names) {
    case SetupNames::fixed:
    case SetupNames::any: return {};
    case SetupNames::axis:
    case SetupNames::axis_of_any: return plain_text(is_below ? texts::setup_page::names_of_axes : texts::setup_page::name_of_axis, lang);
    case SetupNames::axis_or_all: return plain_text(texts::setup_page::names_of_axes_or_all, lang);
    case SetupNames::axis_or_plane: return plain_text(texts::setup_page::names_of_axes_or_planes, lang);
    case SetupNames::signal: {
      std::string list;
      for (const SetupSignal& signal : setup_signals())
        list += fmt::format("{}{} ({}, {})", list.empty() ? "" : "; ", signal.name, plain_text(signal.about, lang), signal.manual);
      return list;
    }
    case SetupNames::work_offset:
      if (names.control() != nullptr) {
        const auto all = names.all(SetupNames::work_offset);
        std::string list;
        for (const std::string& name : all)
          if (name.find(' ') == std::string::npos) list += (list.empty() ? "" : ", ") + name;
        for (const std::string& name : all)
          if (name.ends_with(" P1")) list += fmt::format(", {} P1 …", name.substr(0, name.size() - 3));
        return list;
      }
      [[fallthrough]];
    default: return names.form(row.names, lang);
  }
}

/// Returns an example of the key. The example of the parameter table uses parameter names of the control.
std::string example_of(const SetupKey& row, const SetupNamesOf& names) {
  if (row.names != SetupNames::parameter) return std::string(row.example);
  std::string rows;
  for (const std::string& name : names.forms_of_parameters()) rows += fmt::format("{}\"{}\": 1", rows.empty() ? "" : ", ", name);
  return "{" + rows + "}";
}

bool is_row_of_table(const SetupKey& row) { return row.path.ends_with(".*") && row.form == SetupForm::table; }

/// Returns the path of a key in readable form, e.g. `offsets.….length` for "offsets.*.length".
std::string path_shown(std::string_view path) {
  std::string text(path);
  for (std::size_t at = 0; (at = text.find('*', at)) != std::string::npos;) text.replace(at, 1, "…"), at += 3;
  return text;
}

/// Returns the ids of the controls that support the key, or the word "all".
std::string knowers(const SetupKey& row, const std::vector<const ControlDef*>& controls, Lang lang) {
  std::string list;
  std::size_t count = 0;
  for (const ControlDef* const def : controls) {
    if (!has(*def, row.needs)) continue;
    ++count;
    list += (list.empty() ? "" : ", ") + def->id;
  }
  return count == controls.size() ? plain_text(texts::setup_page::all_controls, lang) : list;
}

std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, 1, '\\');
  return text;
}

}  // namespace

std::string setup_page(const std::vector<const ControlDef*>& controls, Lang lang) {
  const SetupNamesOf names(nullptr, {}, {});
  std::string page = plain_text(texts::setup_page::page_head, lang);
  for (const SetupKey& row : setup_keys()) {
    if (is_row_of_table(row)) continue;
    const std::string below = names_text(row, names, lang);
    page += fmt::format("| `{}` | {}{} | {} | {} | `{}` |\n", path_shown(row.path), cell(form_text(row, row.range, lang)),
                        below.empty() ? "" : "; " + cell(below), plain_text(row.about, lang), knowers(row, controls, lang),
                        cell(std::string(row.example)));
  }
  return page;
}

std::string explain_setup(const ControlDef& def, Lang lang) {
  const SetupNamesOf names(&def, def.axes, def.axes);
  std::string text = translated_in(lang, texts::setup_page::keys_of_control, def.id) + "\n";
  for (const SetupKey& row : setup_keys()) {
    if (is_row_of_table(row) || !names.knows(row)) continue;
    text += fmt::format("  {:<28}{}\n", path_shown(row.path), plain_text(row.about, lang));
    const std::string below = names_text(row, names, lang);
    text += fmt::format("  {:<28}  {}{}\n", "", form_text(row, names.range(row), lang), below.empty() ? "" : "; " + below);
    text += fmt::format("  {:<28}  {}\n", "", translated_in(lang, texts::setup_page::example, example_of(row, names)));
  }
  return text;
}

}  // namespace kadr
