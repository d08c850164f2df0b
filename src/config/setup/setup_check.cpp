// Checks that each key of a set-up is in the table of keys (config/setup/setup_keys) and exists on the control. Used by config/setup/setup,
// out/text/explain/setup_page.

#include "config/setup/setup_check.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "config/nearest.h"
#include "texts/setup_check.h"

namespace kadr {
namespace {

using Json = nlohmann::json;
namespace setup_faults = texts::setup_check;

std::string joined(const std::vector<std::string>& names) {
  constexpr std::size_t most = 16;
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < most; ++i) text += (i == 0 ? "" : ", ") + names[i];
  return names.size() > most ? text + ", …" : text;
}

/// Returns true for null, false, 0, "", and for tables and lists that contain only such values. A key with such a value states only the
/// default.
bool is_neutral(const Json& value) {
  if (value.is_null() || (value.is_boolean() && !value.get<bool>()) || (value.is_number() && value.get<double>() == 0)) return true;
  if (value.is_string()) return value.get_ref<const std::string&>().empty();
  return value.is_structured() && std::all_of(value.begin(), value.end(), is_neutral);
}

bool is_unsupported(std::string_view path) { return path == "frame"; }

/// Returns the range in words, such as "at most 5" or "0 to 9"; empty if the range has neither a lower nor an upper limit.
std::string range_words(SetupRange range, Lang lang) {
  const bool least = range.least > -1e299, most = range.most < 1e299;
  if (least && most && range.least == -range.most) return translated_in(lang, setup_faults::at_most, range.most);
  if (least && most) return translated_in(lang, setup_faults::from_to, range.least, range.most);
  return least ? plain_text(setup_faults::zero_or_above, lang) : "";
}

/// Returns the words (separated by blanks) as a list for a sentence, each word in quotes: "cw", "ccw" or "stop".
std::string quoted_words(std::string_view words, Lang lang) {
  std::vector<std::string> all;
  while (!words.empty()) {
    const std::size_t blank = std::min(words.find(' '), words.size());
    all.push_back(fmt::format("\"{}\"", words.substr(0, blank)));
    words.remove_prefix(std::min(blank + 1, words.size()));
  }
  return alternatives(all, lang);
}

/// Returns the text for the fault that no name of this kind equals the given name. Its placeholders are the key, the name, and the
/// suggested names.
TextId<3> no_such(SetupNames kind) {
  switch (kind) {
    case SetupNames::axis:
    case SetupNames::axis_of_any:
    case SetupNames::axis_or_all:
    case SetupNames::axis_or_plane: return setup_faults::no_such_axis;
    case SetupNames::work_offset: return setup_faults::no_such_work_offset;
    case SetupNames::parameter: return setup_faults::no_such_parameter;
    case SetupNames::signal: return setup_faults::no_such_signal;
    case SetupNames::shift: return setup_faults::no_such_shift;
    default: return setup_faults::no_such_row;
  }
}

class Checker {
 public:
  Checker(const SetupNamesOf& names, Lang lang) : names_(names), lang_(lang) {}

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
  template <std::size_t Holes, typename... Args>
  [[noreturn]] void wrong(const std::string& key, TextId<Holes> sentence, const Args&... args) const {
    throw KeyFault{key, translated_in(lang_, sentence, key, args...)};
  }
  [[noreturn]] void must_be(const std::string& key, const std::string& form) const { wrong(key, setup_faults::must_be, form); }

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
    if (const auto near = nearest(name, known)) wrong(key, setup_faults::unknown_key_near_one, *near);
    wrong(key, setup_faults::unknown_key, joined(known));
  }

  [[noreturn]] void not_of_control(const SetupKey& row, const std::string& key) const {
    const std::string& control = names_.control()->id;
    const SetupKey* const instead = row.instead.empty() ? nullptr : setup_key(row.instead);
    if (instead != nullptr && names_.knows(*instead)) wrong(key, setup_faults::control_has_another, control, row.instead);
    wrong(key, setup_faults::control_has_none, control);
  }

  void named(const std::string& name, const Json& item, SetupNames kind, const std::string& path, const std::string& key) {
    check_name(name, kind, key);
    const SetupKey* const row = setup_key(path + ".*");
    if (!names_.knows(*row)) not_of_control(*row, key);
    if (names_.unsupported(kind, name) && !is_neutral(item)) wrong(key, setup_faults::not_supported_yet);
    check(item, *row, key);
    if (kind != SetupNames::parameter) return;
    const double number = item.is_number() ? item.get<double>() : 0;
    if (const auto form = names_.parameter_fault(name, number, item.is_string(), lang_)) must_be(key, *form);
  }

  void check_name(const std::string& name, SetupNames kind, const std::string& key) {
    if (names_.allows(kind, name)) return;
    const std::vector<std::string> all = names_.all(kind);
    if (all.empty() || (names_.control() == nullptr && kind != SetupNames::signal)) must_be(key, names_.form(kind, lang_));
    const auto near = nearest(name, all);
    wrong(key, no_such(kind), name,
          near ? translated_in(lang_, setup_faults::did_you_mean, *near) : translated_in(lang_, setup_faults::there_are, joined(all)));
  }

  void check(const Json& value, const SetupKey& row, const std::string& key) {
    if (value.is_null() && row.null) return;
    if (is_unsupported(row.path)) {
      if (is_neutral(value)) return;
      wrong(key, setup_faults::not_supported_yet);
    }
    const SetupRange range = names_.range(row);
    if (!fits(value, row, range)) must_be(key, form_of(row, range, lang_));
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
  const Lang lang_;
};

/// Returns the axes that the set-up names; if it names none, the axes of the control.
std::vector<std::string> axes_in(const Json& table, const ControlDef& def) {
  std::vector<std::string> axes;
  if (def.machine_axes() && table.is_object() && table.contains("axes") && table["axes"].is_array())
    for (const Json& axis : table["axes"])
      if (axis.is_string()) axes.push_back(axis.get<std::string>());
  return axes.empty() ? def.axes : axes;
}

}  // namespace

std::string form_of(const SetupKey& row, SetupRange range, Lang lang) {
  const auto plain = [&](PlainText form) { return plain_text(form, lang); };
  const auto with_range = [&](PlainText form) {
    const std::string within = range_words(range, lang);
    return within.empty() ? plain(form) : fmt::format("{}, {}", plain(form), within);
  };
  switch (row.form) {
    case SetupForm::table: return plain(setup_faults::table);
    case SetupForm::tables: return plain(setup_faults::tables);
    case SetupForm::number: return with_range(setup_faults::number);
    case SetupForm::whole: return with_range(setup_faults::whole);
    case SetupForm::flag: return plain(setup_faults::flag);
    case SetupForm::text: return plain(setup_faults::text);
    case SetupForm::one_of: return quoted_words(row.words, lang);
    case SetupForm::number_or_text: return plain(setup_faults::number_or_text);
    case SetupForm::info: return plain(setup_faults::info);
    case SetupForm::span: return plain(setup_faults::span);
    case SetupForm::numbers: return with_range(setup_faults::numbers);
    case SetupForm::wholes: return with_range(setup_faults::wholes);
    case SetupForm::texts: return plain(setup_faults::text_list);
    case SetupForm::spans: return plain(setup_faults::spans);
  }
  return {};
}

std::optional<KeyFault> fault_of(const Json& value, const Json& context, const ControlDef* def, Lang lang) {
  if (!value.is_object()) return KeyFault{"", plain_text(setup_faults::must_be_table, lang)};
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
    Checker(names, lang).table(value, "", "");
  } catch (const KeyFault& fault) {
    return fault;
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
