// Reads the sections of a control file about codes: groups, G, M, cycles, variables, parameters, alarms.

#include <algorithm>
#include <cmath>
#include <set>

#include "config/control/control_loader.h"
#include "config/setup/parameter_table.h"
#include "lang/block/format.h"
#include "texts/control_file.h"
#include "texts/control_file_codes.h"
#include "texts/control_file_cycles.h"

namespace kadr {

using toml_tools::place;
using toml_tools::text_of;

namespace {

constexpr std::string_view step_names[] = {
    "feed_bottom", "rapid_bottom", "retract",   "feed_retract", "dwell",     "spindle_stop", "spindle_reverse", "spindle_restore",
    "orient",      "stop",         "peck_full", "peck_break",   "shift_out", "shift_back",   "feed_face",       "passes_by_parameter"};
static_assert(std::size(step_names) == static_cast<std::size_t>(CycleStep::count));

}  // namespace

std::string_view name_of(CycleStep step) { return step_names[static_cast<std::size_t>(step)]; }

Done ControlLoader::groups() {
  def_.groups.push_back({"", false, -1, {}});
  const toml::table* const t = section("groups");
  if (t == nullptr) return {};
  for (const auto& [key, node] : *t) {
    const toml::table* const row = node.as_table();
    if (row == nullptr) return Failed(place(name_, node) + translated(texts::control_file_codes::group_is_table));
    KADR_LOAD(known_keys(*row, {"modal", "initial", "en", "ru"}));
    if (def_.groups.size() == most_groups)
      return Failed(place(name_, node) + translated(texts::control_file_codes::too_many_groups, most_groups - 1));
    def_.groups.push_back({std::string(key.str()), typed(*row, "modal", true), -1, text_of(*row)});
    initial_.push_back(text(*row, "initial"));
  }
  return {};
}

int ControlLoader::group_named(std::string_view name) const {
  for (std::size_t i = 1; i < def_.groups.size(); ++i)
    if (def_.groups[i].name == name) return static_cast<int>(i);
  return -1;
}

/// Converts "XYZ" to a letter mask. Every letter must be an address of this control; this is checked when all sections have been read. The
/// characters c, r, a stand for the words ,C ,R ,A; `*` (takes_all_axes) stands for no letter.
std::uint64_t ControlLoader::letters(const std::string& text) const {
  std::uint64_t bits = 0;
  for (const char c : text) {
    if (c >= 'A' && c <= 'Z') bits |= letter_bit_of(c);
    for (const AddressName& name : def_.grammar.names)
      if (name.text.size() == 1 && name.text[0] == c) bits |= letter_bit_of(name.address);
    if (c == 'c' || c == 'r' || c == 'a') bits |= letter_bit_of(comma_address(static_cast<char>(c - 'a' + 'A')));
  }
  return bits;
}

std::uint64_t ControlLoader::letters(const toml::table& row, std::string_view key, std::string_view also_allowed) {
  const std::string all = text(row, key);
  for (const char c : all)
    if (letters(std::string(1, c)) == 0 && also_allowed.find(c) == std::string_view::npos && bad_value_.empty())
      bad_value_ = place(name_, row, key) + translated(texts::control_file_codes::letters_of_code, key);
  return letters(all);
}

Done ControlLoader::codes(std::string_view key, char letter) {
  const toml::table* const t = section(key);
  if (t == nullptr) return {};
  std::vector<std::pair<double, const toml::table*>> rows;
  for (const auto& [code, node] : *t) {
    const toml::table* const row = node.as_table();
    if (row == nullptr) return Failed(place(name_, node) + translated(texts::control_file_codes::code_is_table));
    if (code.str() == "other") {
      KADR_LOAD(other_codes(*row, letter));
      continue;
    }
    char* end = nullptr;
    const std::string digits(code.str());
    const double number = std::strtod(digits.c_str(), &end);
    if (end == digits.c_str() || *end != '\0' || number < 0 || number * 10 >= ControlDef::max_tenths)
      return Failed(place(name_, node) + translated(texts::control_file_codes::no_code_number, digits));
    for (const char* const limit : {"from", "to"})
      if (row->contains(limit)) return Failed(place(name_, *row, limit) + translated(texts::control_file_codes::belongs_to_other, limit));
    rows.emplace_back(number, row);
  }
  std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [number, row] : rows) KADR_LOAD(code(letter, number, *row));
  return {};
}

Done ControlLoader::code(char letter, double number, const toml::table& row) {
  KADR_LOAD(known_keys(row, {"group", "does", "arg", "takes", "needs", "needs_axis", "own_block", "modal", "phase", "with", "works",
                             "in_part", "told", "en", "ru", "manual", "from", "to"}));
  CodeRow c;
  c.letter = letter;
  c.tenth = static_cast<std::int32_t>(std::lround(number * 10));
  c.code = letter + std::to_string(c.tenth / 10) + (c.tenth % 10 != 0 ? "." + std::to_string(c.tenth % 10) : "");
  const auto function = function_of(row, CalledBy::code, c.code);
  if (!function) return Failed(function.error());
  c.function = *function;
  if (row.contains("group")) {
    const std::string group = text(row, "group");
    const int index = group_named(group);
    if (index < 0) return Failed(place(name_, row, "group") + translated(texts::control_file_codes::no_group, group));
    c.group = static_cast<std::uint8_t>(index);
  }
  const auto phase = phase_of(row, *function);
  if (!phase) return Failed(phase.error());
  c.phase = *phase;
  c.arg = static_cast<int>(whole(row, "arg", 0, 1000));
  c.modal = typed(row, "modal", c.group != 0 && def_.groups[c.group].modal);
  c.own_block = typed(row, "own_block", false);
  c.takes = letters(row, "takes", "*");
  c.takes_all_axes = text(row, "takes").find('*') != std::string::npos;
  c.needs = letters(row, "needs");
  c.needs_axis = typed(row, "needs_axis", false);
  c.works = typed(row, "works", true) && c.function != Function::not_available;
  c.in_part = typed(row, "in_part", false);
  c.reported = typed(row, "told", false);
  if (const toml::array* const with = list(row, "with"))
    for (const auto& other : *with) {
      const std::string code = other.value_exact<std::string>().value_or(std::string());
      char* end = nullptr;
      const double tenth = code.size() < 2 || code[0] != letter ? -1 : std::strtod(code.c_str() + 1, &end) * 10;
      if (!(tenth >= 0 && tenth < ControlDef::max_tenths) || *end != '\0')
        return Failed(place(name_, other) + translated(texts::control_file_codes::with_codes_of_group, letter));
      c.with.push_back(static_cast<std::int32_t>(std::lround(tenth)));
    }
  for (int i = 0; i <= comma_vector - 'A'; ++i)
    if ((c.takes >> i & 1u) != 0 && def_.addresses[static_cast<std::size_t>(i)].function == Function::count &&
        !(def_.grammar.zero_between_slashes && i == 0))
      return Failed(place(name_, row, "takes") +
                    translated(texts::control_file_codes::takes_no_address, address_written(static_cast<char>('A' + i))));
  KADR_LOAD(check_code(row, c));
  c.text = text_of(row);
  c.manual = text(row, "manual");
  constexpr std::size_t max_rows = 32'000;
  if (def_.codes.size() == max_rows) return Failed(place(name_, row) + translated(texts::control_file_codes::too_many_codes, max_rows));
  if (c.function == Function::cycle || c.function == Function::permanent_subprogram) {
    c.cycle = cycle_named(c.code);
    if (c.cycle == 0) return Failed(place(name_, row) + translated(texts::control_file_codes::no_cycle, c.code));
    const CycleRow& cycle = def_.cycles[c.cycle - std::size_t{1}];
    if (c.function == Function::cycle && cycle.steps.empty())
      return Failed(place(name_, row) + translated(texts::control_file_codes::cycle_needs_steps, c.code, c.code));
    if (c.function == Function::permanent_subprogram && cycle.body.empty())
      return Failed(place(name_, row) + translated(texts::control_file_codes::cycle_needs_body, c.code, c.code));
  }
  auto& index = letter == 'G' ? def_.g_rows : def_.m_rows;
  if (index.size() <= static_cast<std::size_t>(c.tenth)) index.resize(static_cast<std::size_t>(c.tenth) + 1, -1);
  if (index[static_cast<std::size_t>(c.tenth)] >= 0)
    return Failed(place(name_, row) + translated(texts::control_file_codes::has_row_already, c.code));
  index[static_cast<std::size_t>(c.tenth)] = static_cast<std::int16_t>(def_.codes.size());
  def_.codes.push_back(std::move(c));
  return {};
}

/// Reads the key "other": the range of M codes without rows of their own that go to the machine.
Done ControlLoader::other_codes(const toml::table& row, char letter) {
  if (letter != 'M') return Failed(place(name_, row) + translated(texts::control_file_codes::other_is_for_m));
  constexpr std::uint32_t max_code = 99'999'999;
  const std::uint32_t from = whole(row, "from", 0, max_code);
  const std::uint32_t to = whole(row, "to", max_code, max_code);
  if (from > to) return Failed(place(name_, row, "from") + translated(texts::control_file_codes::from_above_to));
  if (text(row, "does") != "machine_function")
    return Failed(place(name_, row, "does") + translated(texts::control_file_codes::other_is_machine_function));
  KADR_LOAD(code('M', 0, row));
  CodeRow& c = def_.codes.back();
  c.code = "M" + std::to_string(from) + "…M" + std::to_string(to);
  c.tenth = -1;
  def_.m_rows[0] = -1;
  def_.m_user_from = static_cast<std::int32_t>(from * 10);
  def_.m_user_to = static_cast<std::int32_t>(to * 10);
  def_.m_user_row = static_cast<std::int32_t>(def_.codes.size()) - 1;
  return {};
}

std::uint16_t ControlLoader::cycle_named(std::string_view name) const {
  for (std::size_t i = 0; i < def_.cycles.size(); ++i)
    if (def_.cycles[i].name == name) return static_cast<std::uint16_t>(i + 1);
  return 0;
}

Done ControlLoader::cycles() {
  const toml::table* const t = section("cycle");
  if (t == nullptr) return {};
  for (const auto& [key, node] : *t) {
    const toml::table* const row = node.as_table();
    if (row == nullptr) return Failed(place(name_, node) + translated(texts::control_file_cycles::cycle_is_table));
    KADR_LOAD(known_keys(*row, {"steps", "body", "needs", "left_out", "needs_spindle", "needs_spindle_cw", "needs_override_off", "printed",
                                "parameters", "en", "ru", "manual"}));
    CycleRow c;
    c.name = std::string(key.str());
    if (c.name.size() < 2 || (c.name[0] != 'G' && c.name[0] != 'M' && c.name[0] != 'L'))
      return Failed(place(name_, node) + translated(texts::control_file_cycles::cycle_name));
    if (c.name[0] == 'L') c.call_number = static_cast<std::uint32_t>(std::atoi(c.name.c_str() + 1));
    if (const toml::array* const steps = list(*row, "steps"))
      for (const auto& step : *steps) {
        const auto* const found = std::find(std::begin(step_names), std::end(step_names), step.value_or(std::string()));
        if (found == std::end(step_names)) return Failed(place(name_, step) + translated(texts::control_file_cycles::unknown_step));
        c.steps.push_back(static_cast<CycleStep>(found - std::begin(step_names)));
      }
    if (const toml::array* const body = list(*row, "body"))
      for (const auto& line : *body) {
        if (!line.is_string()) return Failed(place(name_, line) + translated(texts::control_file_cycles::body_is_texts));
        c.body += line.value_or(std::string()) + "\n";
      }
    if (const toml::array* const printed = list(*row, "printed"))
      for (const auto& line : *printed) c.printed += line.value_or(std::string()) + "\n";
    if (const toml::table* const to = (*row)["parameters"].as_table()) KADR_LOAD(cycle_parameters(*to, c));
    if (c.steps.empty() == c.body.empty()) return Failed(place(name_, node) + translated(texts::control_file_cycles::steps_or_body));
    c.needs = letters(*row, "needs");
    c.left_out = letters(*row, "left_out");
    c.needs_spindle = typed(*row, "needs_spindle", false);
    c.needs_spindle_cw = typed(*row, "needs_spindle_cw", false);
    c.needs_override_off = typed(*row, "needs_override_off", false);
    c.text = text_of(*row);
    c.manual = text(*row, "manual");
    KADR_LOAD(check_cycle(*row, c));
    def_.cycles.push_back(std::move(c));
  }
  return {};
}

/// Reads `{ X = "R01" }`: the word X of the block that calls the cycle sets the formal parameter R01 (spec/correctors 3).
Done ControlLoader::cycle_parameters(const toml::table& to, CycleRow& cycle) const {
  const std::string& letters = def_.grammar.long_parameters;
  for (const auto& [word, node] : to) {
    const std::string name = node.value_or(std::string());
    const std::size_t letter = name.empty() ? std::string::npos : letters.find(name[0]);
    const bool digits = name.size() >= 3 && name.size() <= 4 && name.find_first_not_of("0123456789", 1) == std::string::npos;
    if (word.str().size() != 1 || letter == std::string::npos || !digits)
      return Failed(place(name_, node) + translated(texts::control_file_cycles::parameters_values));
    cycle.parameters.emplace_back(word.str()[0], static_cast<int>(letter) * parameters_a_letter + std::atoi(name.c_str() + 1));
  }
  return {};
}

std::int32_t ControlLoader::row_named(const std::string& code) const {
  for (std::size_t i = 0; i < def_.codes.size(); ++i)
    if (def_.codes[i].code == code) return static_cast<std::int32_t>(i);
  return -1;
}

Done ControlLoader::initial_codes() {
  for (std::size_t i = 1; i < def_.groups.size(); ++i) {
    const std::string& code = initial_[i - 1];
    if (code.empty()) continue;
    const std::int32_t row = row_named(code);
    if (row < 0 || def_.codes[static_cast<std::size_t>(row)].group != i)
      return Failed(translated(texts::control_file_codes::initial_code_of_other_group, name_, def_.groups[i].name, code));
    def_.groups[i].power_on = row;
  }
  const toml::table* const t = section("defaults");
  if (t != nullptr) KADR_LOAD(known_keys(*t, {"end"}));
  const toml::array* const end = t == nullptr ? nullptr : list(*t, "end");
  if (end == nullptr) return {};
  for (const auto& node : *end) {
    const std::int32_t row = row_named(node.value_or(std::string()));
    if (row < 0) return Failed(place(name_, node) + translated(texts::control_file_codes::unknown_code));
    KADR_LOAD(check_end_code(node, def_.codes[static_cast<std::size_t>(row)]));
    def_.end_codes.push_back(row);
  }
  return {};
}

Done ControlLoader::parameters() {
  const toml::node* const name = file_.get("parameters");
  if (name == nullptr) return {};
  auto rows = load_parameters(name->value_or(std::string()));
  if (!rows) return Failed(place(name_, *name) + rows.error());
  def_.parameters = std::move(*rows);
  return {};
}

/// Reads `systems`, such as {"3401#6" = "fanuc-t-b"}: the G-code systems that parameters select.
Done ControlLoader::systems() {
  const toml::table* const t = section("systems");
  if (t == nullptr) return {};
  for (const auto& [parameter, node] : *t) {
    const auto control = node.value_exact<std::string>();
    if (!control) return Failed(place(name_, node) + translated(texts::control_file::system_is_control));
    def_.systems.push_back({std::string(parameter.str()), *control});
  }
  return {};
}

Done ControlLoader::alarms() {
  const toml::table* const t = section("alarms");
  if (t == nullptr) return {};
  for (const auto& [key, node] : *t) {
    const toml::table* const row = node.as_table();
    const AlarmId id = alarm_named(key.str());
    if (row == nullptr || id == no_alarm) return Failed(place(name_, node) + translated(texts::control_file::unknown_alarm, key.str()));
    KADR_LOAD(known_keys(*row, {"number", "en", "ru", "hint_en", "hint_ru"}));
    AlarmText text;
    if (const auto number = (*row)["number"].value_exact<std::int64_t>()) text.number = std::to_string(*number);
    else text.number = (*row)["number"].value_or(std::string());
    text.text = text_of(*row);
    text.hint = {(*row)["hint_en"].value_or(std::string()), (*row)["hint_ru"].value_or(std::string())};
    def_.alarms[id] = std::move(text);
  }
  return {};
}

/// Reads the values of a coded feed or speed, such as "12" = 400. With `progression = true`, the values of the standard's geometric
/// progression apply to codes that the table does not list.
Done ControlLoader::code_table(std::string_view key, std::map<std::int32_t, double>& to) {
  constexpr std::size_t max_digits = 8;
  const toml::table* const t = section(key);
  if (t == nullptr) return {};
  if (typed(*t, "progression", false)) to = coded_progression();
  for (const auto& [code, node] : *t) {
    if (code.str() == "progression") continue;
    const std::string digits(code.str());
    const bool is_code = !digits.empty() && digits.size() <= max_digits && digits.find_first_not_of("0123456789") == std::string::npos;
    if (!is_code)
      return Failed(place(name_, node) + std::string(key) + ": " + translated(texts::control_file_codes::no_code_number, digits));
    ranged(*t, digits, ranges::feed, to[std::stoi(digits)]);
  }
  return {};
}

/// Returns the standard values of coded speeds. INFERRED (spec/gost 3 names only the method; GOST 20999-83 uses the series R20 of GOST
/// 8032): code 00 means a stop, code n the 20th root of ten to the power of n: F20 is 10, F40 is 100, F60 is 1000. Code 99, the highest
/// speed, depends on the machine, so the control's file may state its value.
std::map<std::int32_t, double> ControlLoader::coded_progression() {
  constexpr double r20[] = {1.00, 1.12, 1.25, 1.40, 1.60, 1.80, 2.00, 2.24, 2.50, 2.80,
                            3.15, 3.55, 4.00, 4.50, 5.00, 5.60, 6.30, 7.10, 8.00, 9.00};
  constexpr std::int32_t members = std::size(r20), last = 98;
  std::map<std::int32_t, double> codes = {{0, 0.0}};
  double decade = 1;
  for (std::int32_t code = 1; code <= last; ++code) {
    if (code % members == 0) decade *= 10;
    codes[code] = r20[code % members] * decade;
  }
  return codes;
}

}  // namespace kadr
