// Checks that each key of a set-up is in the table of keys (config/setup/setup_keys) and exists on the control. Used by config/setup/setup,
// out/text/explain/setup_page.

#include "config/setup/setup_check.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "config/nearest.h"

namespace kadr {
namespace {

using Json = nlohmann::json;
using Sentence = SetupNamesOf::Words;

struct Wrong {
  SetupFault fault;
};

std::string joined(const std::vector<std::string>& names) {
  constexpr std::size_t most = 16;
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < most; ++i) text += (i == 0 ? "" : ", ") + names[i];
  return names.size() > most ? text + ", …" : text;
}

/// Returns true for null, false, 0, "", and for tables and lists of such values: they state nothing that is not the default.
bool is_neutral(const Json& value) {
  if (value.is_null() || (value.is_boolean() && !value.get<bool>()) || (value.is_number() && value.get<double>() == 0)) return true;
  if (value.is_string()) return value.get_ref<const std::string&>().empty();
  return value.is_structured() && std::all_of(value.begin(), value.end(), is_neutral);
}

bool is_unsupported(std::string_view path) { return path == "frame"; }

Sentence range_words(SetupRange range) {
  const bool least = range.least > -1e299, most = range.most < 1e299;
  if (least && most && range.least == -range.most) return {fmt::format("at most {}", range.most), fmt::format("не более {}", range.most)};
  if (least && most) return {fmt::format("{} to {}", range.least, range.most), fmt::format("от {} до {}", range.least, range.most)};
  if (least) return {"zero or above", "не меньше нуля"};
  return {};
}

std::string quoted_words(std::string_view words, const char* before_last) {
  std::string text;
  while (!words.empty()) {
    const std::size_t blank = std::min(words.find(' '), words.size());
    const bool last = blank == words.size();
    text += fmt::format("{}\"{}\"", text.empty() ? "" : last ? before_last : ", ", words.substr(0, blank));
    words.remove_prefix(std::min(blank + 1, words.size()));
  }
  return text;
}

class Checker {
 public:
  Checker(const SetupNamesOf& names) : names_(names) {}

  void table(const Json& value, const std::string& path, const std::string& key) {
    const SetupKey* const row = path.empty() ? nullptr : setup_key(path);
    const SetupNames kind = row == nullptr || row->form == SetupForm::tables ? SetupNames::fixed : row->names;
    for (const auto& [name, item] : value.items()) {
      const std::string below_key = below(key, name);
      if (kind == SetupNames::fixed) fixed(name, item, path, below_key);
      else if (kind != SetupNames::any || setup_key(path + ".*") != nullptr) named(name, item, kind, path, below_key);
    }
  }

 private:
  [[noreturn]] static void wrong(const std::string& key, Sentence words) { throw Wrong{{key, std::move(words.en), std::move(words.ru)}}; }
  [[noreturn]] static void must_be(const std::string& key, const Sentence& form) {
    wrong(key,
          {fmt::format("setup key '{}' must be {}", key, form.en), fmt::format("ключ «{}» исходного состояния: нужно: {}", key, form.ru)});
  }

  void fixed(const std::string& name, const Json& item, const std::string& path, const std::string& key) {
    const SetupKey* const row = name == "*" ? nullptr : setup_key(below(path, name));
    if (row == nullptr) unknown(name, path, key);
    if (!names_.knows(*row)) not_of_control(*row, key);
    check(item, *row, key);
  }

  /// Reports an unknown key, and suggests the nearest key that this control has in this table.
  [[noreturn]] void unknown(const std::string& name, const std::string& path, const std::string& key) const {
    std::vector<std::string> known;
    for (const SetupKey& row : setup_keys()) {
      const std::size_t point = row.path.rfind('.');
      const std::string_view parent = point == std::string_view::npos ? std::string_view() : row.path.substr(0, point);
      if (parent == path && names_.knows(row) && !is_unsupported(row.path))
        known.emplace_back(row.path.substr(path.empty() ? 0 : path.size() + 1));
    }
    const auto near = nearest(name, known);
    wrong(key,
          {fmt::format("unknown setup key '{}'; {}", key, near ? fmt::format("did you mean '{}'?", *near) : "here stand " + joined(known)),
           fmt::format("неизвестный ключ «{}» исходного состояния; {}", key,
                       near ? fmt::format("возможно, «{}»?", *near) : "здесь могут стоять " + joined(known))});
  }

  [[noreturn]] void not_of_control(const SetupKey& row, const std::string& key) const {
    const std::string& id = names_.control()->id;
    Sentence words{fmt::format("setup key '{}': the control {} has no such thing", key, id),
                   fmt::format("ключ «{}» исходного состояния: у УЧПУ {} этого нет", key, id)};
    const SetupKey* const instead = row.instead.empty() ? nullptr : setup_key(row.instead);
    if (instead != nullptr && names_.knows(*instead)) {
      words.en += fmt::format("; did you mean '{}'?", row.instead);
      words.ru += fmt::format("; возможно, «{}»?", row.instead);
    }
    wrong(key, words);
  }

  void named(const std::string& name, const Json& item, SetupNames kind, const std::string& path, const std::string& key) {
    check_name(name, kind, key);
    const SetupKey* const row = setup_key(path + ".*");
    if (!names_.knows(*row)) not_of_control(*row, key);
    if (names_.unsupported(kind, name) && !is_neutral(item))
      wrong(key, {fmt::format("setup key '{}' is not served by this control yet", key),
                  fmt::format("ключ «{}» исходного состояния пока не поддерживается", key)});
    check(item, *row, key);
    if (kind != SetupNames::parameter) return;
    if (const auto form = names_.parameter_fault(name, item.is_number() ? item.get<double>() : 0, item.is_string())) must_be(key, *form);
  }

  void check_name(const std::string& name, SetupNames kind, const std::string& key) {
    if (names_.allows(kind, name)) return;
    const std::vector<std::string> all = names_.all(kind);
    if (all.empty() || (names_.control() == nullptr && kind != SetupNames::signal)) must_be(key, names_.form(kind));
    const auto near = nearest(name, all);
    const SetupWords what = SetupNamesOf::kind_name(kind);
    const std::string list = joined(all);
    wrong(key, {fmt::format("setup key '{}': no {} '{}'; {}", key, what.en, name,
                            near ? fmt::format("did you mean '{}'?", *near) : fmt::format("there are {}", list)),
                fmt::format("ключ «{}» исходного состояния: нет {} «{}»; {}", key, what.ru, name,
                            near ? fmt::format("возможно, «{}»?", *near) : fmt::format("есть {}", list))});
  }

  void check(const Json& value, const SetupKey& row, const std::string& key) {
    if (value.is_null() && row.null) return;
    if (is_unsupported(row.path)) {
      if (is_neutral(value)) return;
      wrong(key, {fmt::format("setup key '{}' is not served by this control yet", key),
                  fmt::format("ключ «{}» исходного состояния пока не поддерживается", key)});
    }
    const SetupRange range = names_.range(row);
    if (!fits(value, row, range)) must_be(key, form_of(row, range));
    if (row.form == SetupForm::table) table(value, std::string(row.path), key);
    if (row.form == SetupForm::tables)
      for (std::size_t i = 0; i < value.size(); ++i) table(value[i], std::string(row.path), fmt::format("{}[{}]", key, i));
    const bool names_things = row.names != SetupNames::fixed && row.names != SetupNames::any;
    if (!names_things) return;
    if (row.form == SetupForm::text) check_name(value.get<std::string>(), row.names, key);
    if (row.form == SetupForm::texts)
      for (const Json& item : value) check_name(item.get<std::string>(), row.names, key);
  }

  static bool is_number(const Json& value, SetupRange range, bool whole) {
    if (!value.is_number()) return false;
    const double n = value.get<double>();
    const bool fits_range = range.by_reader || (n >= range.least && n <= range.most);
    return std::isfinite(n) && fits_range && (!whole || n == std::floor(n));
  }

  static bool is_span(const Json& value, SetupRange range) {
    return value.is_array() && value.size() == 2 && is_number(value[0], range, false) && is_number(value[1], range, false) &&
           (range.by_reader || value[0].get<double>() <= value[1].get<double>());
  }

  template <class Is>
  static bool is_list(const Json& value, Is is) {
    return value.is_array() && std::all_of(value.begin(), value.end(), is);
  }

  static bool is_among(std::string_view words, const std::string& word) {
    return !word.empty() && word.find(' ') == std::string::npos &&
           (" " + std::string(words) + " ").find(" " + word + " ") != std::string::npos;
  }

  static bool fits(const Json& value, const SetupKey& row, SetupRange range) {
    switch (row.form) {
      case SetupForm::table: return value.is_object();
      case SetupForm::tables: return is_list(value, [](const Json& item) { return item.is_object(); });
      case SetupForm::number: return is_number(value, range, false);
      case SetupForm::whole: return is_number(value, range, true);
      case SetupForm::flag: return value.is_boolean();
      case SetupForm::text: return value.is_string();
      case SetupForm::one_of: return value.is_string() && is_among(row.words, value.get<std::string>());
      case SetupForm::number_or_text: return value.is_string() || is_number(value, range, false);
      case SetupForm::info: return value.is_string() || is_number(value, range, true);
      case SetupForm::span: return is_span(value, range);
      case SetupForm::numbers: return is_list(value, [&](const Json& item) { return is_number(item, range, false); });
      case SetupForm::wholes: return is_list(value, [&](const Json& item) { return is_number(item, range, true); });
      case SetupForm::texts: return is_list(value, [](const Json& item) { return item.is_string(); });
      case SetupForm::spans: return is_list(value, [&](const Json& item) { return is_span(item, range); });
    }
    return false;
  }

  const SetupNamesOf& names_;
};

/// Returns the axes that the set-up names, else the axes of the control.
std::vector<std::string> axes_in(const Json& table, const ControlDef& def) {
  std::vector<std::string> axes;
  if (def.machine_axes() && table.is_object() && table.contains("axes") && table["axes"].is_array())
    for (const Json& axis : table["axes"])
      if (axis.is_string()) axes.push_back(axis.get<std::string>());
  return axes.empty() ? def.axes : axes;
}

}  // namespace

SetupNamesOf::Words form_of(const SetupKey& row, SetupRange range) {
  const Sentence within = range_words(range);
  const auto with = [&](const char* en, const char* ru) -> Sentence {
    if (within.en.empty()) return {en, ru};
    return {fmt::format("{}, {}", en, within.en), fmt::format("{}, {}", ru, within.ru)};
  };
  switch (row.form) {
    case SetupForm::table: return {"a table { … }", "таблица { … }"};
    case SetupForm::tables: return {"a list of tables [{ … }]", "список таблиц [{ … }]"};
    case SetupForm::number: return with("a number", "число");
    case SetupForm::whole: return with("a whole number", "целое число");
    case SetupForm::flag: return {"true or false", "true или false"};
    case SetupForm::text: return {"a text", "текст в кавычках"};
    case SetupForm::one_of: return {quoted_words(row.words, " or "), quoted_words(row.words, " или ")};
    case SetupForm::number_or_text: return {"a number or a text", "число или текст в кавычках"};
    case SetupForm::info:
      return {"a number, or five letters: U or S, E or D, N or L, C or T, I or V",
              "число или пять букв: U или S, E или D, N или L, C или T, I или V"};
    case SetupForm::span: return {"[least, most]", "[наименьшее, наибольшее]"};
    case SetupForm::numbers: return with("a list of numbers", "список чисел");
    case SetupForm::wholes: return with("a list of whole numbers", "список целых чисел");
    case SetupForm::texts: return {"a list of texts [\"…\"]", "список текстов [\"…\"]"};
    case SetupForm::spans: return {"a list of [least, most]", "список пар [наименьшее, наибольшее]"};
  }
  return {};
}

std::optional<SetupFault> fault_of(const Json& value, const Json& context, const ControlDef* def) {
  if (!value.is_object()) return SetupFault{"", "setup key 'setup' must be a table { … }", "исходное состояние: нужна таблица { … }"};
  std::vector<std::string> axes, all;
  if (def != nullptr) {
    all = axes = axes_in(context, *def);
    if (context.is_object() && context.contains("channels") && context["channels"].is_object())
      for (const Json& channel : context["channels"])
        for (const std::string& axis : axes_in(channel, *def))
          if (std::find(all.begin(), all.end(), axis) == all.end()) all.push_back(axis);
  }
  const SetupNamesOf names(def, std::move(axes), std::move(all));
  try {
    Checker(names).table(value, "", "");
  } catch (const Wrong& found) {
    return found.fault;
  }
  return std::nullopt;
}

std::set<std::string> stated_in(const Json& setup) {
  std::set<std::string> stated;
  const auto holds = [](const Json& value) {
    return value.is_object() ? std::any_of(value.begin(), value.end(), [](const Json& item) { return !item.is_null(); }) : !value.is_null();
  };
  for (const char* const table : {"work_offsets", "zeros", "correctors", "offsets"}) {
    if (!setup.contains(table)) continue;
    for (const auto& [name, row] : setup[table].items()) {
      if (holds(row)) stated.insert(fmt::format("{}.{}", table, name));
      if (std::string_view(table) != "offsets") continue;
      for (const auto& [key, value] : row.items())
        if (!value.is_null()) stated.insert(fmt::format("{}.{}.{}", table, name, key));
    }
  }
  return stated;
}

}  // namespace kadr
