// Describes the keys of a set-up: the page docs/setup.md, and the keys that one control supports (kadr explain ID setup). Used by
// cli/explain.

#include "out/text/explain/setup_page.h"

#include <fmt/core.h>

#include <algorithm>

#include "config/setup/setup_check.h"
#include "config/setup/setup_names.h"

namespace kadr {
namespace {

std::string_view in(const SetupKey& row, Lang lang) { return lang == Lang::ru ? row.ru : row.en; }

/// Returns the values that a key accepts, their unit, and whether null is allowed: "a number, zero or above; mm/min; or null".
std::string form_text(const SetupKey& row, SetupRange range, Lang lang) {
  const auto words = form_of(row, range);
  std::string text = lang == Lang::ru ? words.ru : words.en;
  const SetupWords unit = name_of(row.unit);
  if (!unit.en.empty()) text += fmt::format("; {}", lang == Lang::ru ? unit.ru : unit.en);
  if (row.null) text += lang == Lang::ru ? "; или null" : "; or null";
  return text;
}

/// Returns the names below a table: "axes", «номер — целое число от 1 до 99».
std::string names_text(const SetupKey& row, const SetupNamesOf& names, Lang lang) {
  const bool ru = lang == Lang::ru;
  const bool is_below = row.form == SetupForm::table;
  switch (row.names) {
    case SetupNames::fixed:
    case SetupNames::any: return {};
    case SetupNames::axis:
    case SetupNames::axis_of_any: return is_below ? (ru ? "имена осей" : "names of axes") : (ru ? "ось" : "an axis");
    case SetupNames::axis_or_all: return ru ? "имена осей или \"*\"" : "names of axes, or \"*\"";
    case SetupNames::axis_or_plane:
      return ru ? "имена осей; где есть базовые повороты, G17, G18, G19" : "names of axes; with basic rotations G17, G18, G19";
    case SetupNames::signal: {
      std::string list;
      for (const SetupSignal& signal : setup_signals())
        list += fmt::format("{}{} ({}, {})", list.empty() ? "" : "; ", signal.name, ru ? signal.ru : signal.en, signal.manual);
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
    default: return ru ? names.form(row.names).ru : names.form(row.names).en;
  }
}

/// Returns the example of the key; for the table of parameters with names that the control has.
std::string example_of(const SetupKey& row, const SetupNamesOf& names) {
  if (row.names != SetupNames::parameter) return std::string(row.example);
  std::string rows;
  for (const std::string& name : names.forms_of_parameters()) rows += fmt::format("{}\"{}\": 1", rows.empty() ? "" : ", ", name);
  return "{" + rows + "}";
}

bool is_row_of_table(const SetupKey& row) { return row.path.ends_with(".*") && row.form == SetupForm::table; }

/// Returns the path of a key in readable form: "offsets.*.length" → `offsets.….length`.
std::string path_shown(std::string_view path) {
  std::string text(path);
  for (std::size_t at = 0; (at = text.find('*', at)) != std::string::npos;) text.replace(at, 1, "…"), at += 3;
  return text;
}

std::string page_head(Lang lang) {
  if (lang == Lang::ru)
    return "# Исходное состояние (`--setup`)\n\n<!-- Страница создана dev/docs из src/config/setup/setup_keys.cpp. -->\n\n"
           "Файл JSON: то, что оператор задаёт на пульте до пуска, и характеристики станка. Все ключи необязательны; если ключа нет, "
           "принимается 0, "
           "«выключено» или «пусто». Длины в мм, углы в градусах, в каких бы единицах ни была написана программа; размеры по осям с "
           "программированием в "
           "диаметрах задаются радиусами. Неизвестный ключ, ключ, которого у этого УЧПУ нет, и недопустимое значение — ошибка с указанием "
           "строки и "
           "ближайшего правильного ключа (код возврата 2).\n\n"
           "Ключи, которые поддерживает УЧПУ: `kadr explain УЧПУ setup`. Шаблон для программы записывает `kadr setup ПРОГРАММА`. "
           "Значения файла заменяют ключи `--tool 1:r8,l100`, `--zero G54=X-400,Y-250,Z-300`, `--corrector 17=-0.35`.\n\n";
  return "# The set-up (`--setup`)\n\n<!-- Made by dev/docs from src/config/setup/setup_keys.cpp. -->\n\n"
         "A JSON file: what the operator sets on the panel before the start, and what the machine has. All keys are optional; a missing "
         "one is 0, off, "
         "empty. Lengths are in mm, angles in degrees, whatever the program's unit; an axis in diameter programming is given by its "
         "radius. An unknown "
         "key, one that the control has not, and a value that cannot be are errors that name the line and the nearest right key (exit "
         "status 2).\n\n"
         "What one control knows: `kadr explain ID setup`. A template for a program: `kadr setup PROGRAM`. Laid over the file: `--tool "
         "1:r8,l100`, "
         "`--zero G54=X-400,Y-250,Z-300`, `--corrector 17=-0.35`.\n\n";
}

/// Returns "all", or the ids of the controls that support the key.
std::string knowers(const SetupKey& row, const std::vector<const ControlDef*>& controls, Lang lang) {
  std::string list;
  std::size_t count = 0;
  for (const ControlDef* const def : controls) {
    if (!has(*def, row.needs)) continue;
    ++count;
    list += (list.empty() ? "" : ", ") + def->id;
  }
  return count == controls.size() ? (lang == Lang::ru ? "все" : "all") : list;
}

std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, 1, '\\');
  return text;
}

}  // namespace

std::string setup_page(const std::vector<const ControlDef*>& controls, Lang lang) {
  const bool ru = lang == Lang::ru;
  const SetupNamesOf names(nullptr, {}, {});
  std::string page = page_head(lang);
  page += ru ? "| ключ | значение | что это | УЧПУ | пример |\n|---|---|---|---|---|\n"
             : "| key | value | what it is | controls | example |\n|---|---|---|---|---|\n";
  for (const SetupKey& row : setup_keys()) {
    if (is_row_of_table(row)) continue;
    const std::string below = names_text(row, names, lang);
    page +=
        fmt::format("| `{}` | {}{} | {} | {} | `{}` |\n", path_shown(row.path), cell(form_text(row, row.range, lang)),
                    below.empty() ? "" : "; " + cell(below), in(row, lang), knowers(row, controls, lang), cell(std::string(row.example)));
  }
  return page;
}

std::string explain_setup(const ControlDef& def, Lang lang) {
  const bool ru = lang == Lang::ru;
  const SetupNamesOf names(&def, def.axes, def.axes);
  std::string text = ru ? fmt::format("{}: ключи исходного состояния (--setup ФАЙЛ.json)\n", def.id)
                        : fmt::format("{}: keys of the set-up (--setup FILE.json)\n", def.id);
  for (const SetupKey& row : setup_keys()) {
    if (is_row_of_table(row) || !names.knows(row)) continue;
    text += fmt::format("  {:<28}{}\n", path_shown(row.path), in(row, lang));
    const std::string below = names_text(row, names, lang);
    text += fmt::format("  {:<28}  {}{}\n", "", form_text(row, names.range(row), lang), below.empty() ? "" : "; " + below);
    text += fmt::format("  {:<28}  {} {}\n", "", ru ? "пример:" : "example:", example_of(row, names));
  }
  return text;
}

}  // namespace kadr
