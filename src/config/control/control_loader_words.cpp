// Reads the sections of a control file about the form and meaning of its words: grammar, behaviour, axes, addresses.

#include <algorithm>
#include <set>

#include "base/ascii.h"
#include "config/control/control_loader.h"
#include "lang/block/format.h"
#include "texts/control_file.h"
#include "texts/control_file_grammar.h"
#include "texts/control_file_words.h"

namespace kadr {

using toml_tools::place;
using toml_tools::text_of;

namespace {

/// Boolean keys of [grammar].
constexpr std::pair<std::string_view, bool Grammar::*> grammar_flags[] = {
    {"block_number_required", &Grammar::block_number_required},
    {"program_start_required", &Grammar::program_start_required},
    {"percent_number", &Grammar::percent_number},
    {"percent_ignored", &Grammar::percent_ignored},
    {"semicolon_comments", &Grammar::semicolon_comments},
    {"slash_comments", &Grammar::slash_comments},
    {"expressions", &Grammar::expressions},
    {"lower_case", &Grammar::lower_case},
    {"main_blocks", &Grammar::main_blocks},
    {"skip_levels", &Grammar::skip_levels},
    {"mark_everywhere", &Grammar::mark_everywhere},
    {"zero_between_slashes", &Grammar::zero_between_slashes},
    {"macro", &Grammar::custom_macros},
    {"operator_i", &Grammar::operator_i},
    {"comments_span_lines", &Grammar::comments_span_lines},
    {"comma_words", &Grammar::comma_words},
    {"file_names", &Grammar::file_names},
    {"o_words", &Grammar::o_words},
    {"percent_encloses", &Grammar::percent_encloses},
    {"code_by_rounding", &Grammar::code_by_rounding},
    {"filtered_lines", &Grammar::filtered_lines},
    {"short_words", &Grammar::short_words},
    {"semicolon_ends", &Grammar::semicolon_ends},
    {"colon_is_label", &Grammar::colon_is_label},
    {"condition_alone", &Grammar::condition_alone},
    {"condition_words", &Grammar::condition_words},
    {"conditions_are_values", &Grammar::conditions_are_values},
    {"assignment_and_words", &Grammar::assignment_and_words},
    {"percent_frames", &Grammar::percent_frames},
    {"ports_without_number", &Grammar::ports_without_number},
    {"programs_by_label", &Grammar::programs_by_label},
    {"rounds_in_address", &Grammar::rounds_in_address},
    {"named_blocks", &Grammar::named_blocks},
    {"klartext_blocks", &Grammar::klartext_blocks},
};

}  // namespace

tl::expected<ControlDef, std::string> ControlLoader::load() {
  const Done done = sections();
  // If the file has two errors, bad_value_ contains the one that was found first, so it is reported
  if (!bad_value_.empty()) return Failed(bad_value_);
  if (!done) return Failed(done.error());
  return std::move(def_);
}

Done ControlLoader::sections() {
  def_.id = text(file_, "id");
  if (def_.id.empty()) return Failed(translated(texts::control_file::no_id, name_));
  if (const toml::table* const name = section("name")) def_.name = text_of(*name);
  def_.spec = text(file_, "spec");
  KADR_LOAD(known_keys(
      file_,
      {"id",        "aliases",  "guess",      "name",        "spec",    "extends",  "dialect", "format", "grammar",         "expressions",
       "behaviour", "axes",     "order",      "address",     "groups",  "g",        "m",       "cycle",  "variables",       "parameters",
       "alarms",    "defaults", "feed_codes", "speed_codes", "convert", "encoding", "systems", "names",  "cycle_parameters"}));
  KADR_LOAD(names());
  KADR_LOAD(encoding());
  KADR_LOAD(dialect());
  KADR_LOAD(grammar());
  KADR_LOAD(expressions());
  KADR_LOAD(behaviour());
  KADR_LOAD(check_machine());
  KADR_LOAD(axes());
  KADR_LOAD(order());
  KADR_LOAD(addresses());
  KADR_LOAD(groups());
  KADR_LOAD(cycles());
  KADR_LOAD(codes("g", 'G'));
  KADR_LOAD(codes("m", 'M'));
  KADR_LOAD(initial_codes());
  KADR_LOAD(variables());
  KADR_LOAD(parameters());
  KADR_LOAD(systems());
  figures();
  KADR_LOAD(alarms());
  KADR_LOAD(code_table("feed_codes", def_.feed_codes));
  KADR_LOAD(code_table("speed_codes", def_.speed_codes));
  KADR_LOAD(machine_codes());
  KADR_LOAD(check_grammar());
  KADR_LOAD(check_behaviour());
  KADR_LOAD(check_axes());
  return check_functions();
}

/// Reads `dialect`, which selects the part of the engine for behaviour that no row can express.
Done ControlLoader::dialect() {
  const toml::node* const node = file_.get("dialect");
  if (node == nullptr) return {};
  const std::string name = text(file_, "dialect");
  const auto found = std::find(dialect_names.begin(), dialect_names.end(), name);
  if (found == dialect_names.end()) {
    return Failed(place(name_, *node) + translated(texts::control_file::unknown_dialect, name) +
                  nearest_hint(toml_tools::nearest(name, {dialect_names.begin(), dialect_names.end()})));
  }
  def_.dialect = static_cast<DialectId>(found - dialect_names.begin());
  return {};
}

std::uint32_t ControlLoader::whole(const toml::table& row, std::string_view key, std::uint32_t otherwise, std::uint32_t most) {
  const toml::node* const node = row.get(key);
  if (node == nullptr) return otherwise;
  const auto number = node->value_exact<std::int64_t>();
  if (number && *number >= 0 && *number <= std::int64_t{most}) return static_cast<std::uint32_t>(*number);
  if (bad_value_.empty()) bad_value_ = place(name_, *node) + translated(texts::control_file::must_be_whole, key, 0, most);
  return otherwise;
}

void ControlLoader::ranged(const toml::table& row, std::string_view key, const NumberRange& range, double& to) {
  if (auto done = toml_tools::number(name_, row, key, range, to); !done && bad_value_.empty()) bad_value_ = done.error();
}

Done ControlLoader::known_keys(const toml::table& table, const std::vector<std::string_view>& known) const {
  for (const auto& [key, node] : table)
    if (std::find(known.begin(), known.end(), key.str()) == known.end()) return unknown_key(node, key.str(), known);
  return {};
}

tl::unexpected<std::string> ControlLoader::unknown_key(const toml::node& node, std::string_view key,
                                                       const std::vector<std::string_view>& known, TextId<1> what) const {
  return Failed(place(name_, node) + translated(what, key) + nearest_hint(toml_tools::nearest(key, known)));
}

const toml::table* ControlLoader::section(std::string_view key) {
  const toml::node* const node = file_.get(key);
  if (node != nullptr && !node->is_table() && bad_value_.empty())
    bad_value_ = place(name_, *node) + translated(texts::control_file::must_be_table, key);
  return node == nullptr ? nullptr : node->as_table();
}

const toml::array* ControlLoader::list(const toml::table& row, std::string_view key) {
  const toml::node* const node = row.get(key);
  if (node != nullptr && !node->is_array() && bad_value_.empty())
    bad_value_ = place(name_, *node) + translated(texts::control_file::must_be_list, key);
  return node == nullptr ? nullptr : node->as_array();
}

std::string ControlLoader::text(const toml::table& row, std::string_view key) {
  const toml::node* const node = row.get(key);
  if (node == nullptr) return {};
  if (const auto value = node->value_exact<std::string>()) return *value;
  if (bad_value_.empty()) bad_value_ = place(name_, *node) + translated(texts::control_file::must_be_text, key);
  return {};
}

bool ControlLoader::is_own(const toml::node& node) const {
  const toml::source_path_ptr& path = node.source().path;
  return path && *path == name_;
}

Done ControlLoader::no_effect(const toml::table& row, std::string_view key, const std::string& why) const {
  const toml::node* const node = row.get(key);
  if (node == nullptr || !is_own(*node)) return {};
  return Failed(place(name_, *node) + why);
}

Done ControlLoader::grammar() {
  def_.descriptor = text(file_, "format");
  Grammar& g = def_.grammar;
  if (!def_.descriptor.empty())
    if (auto applied = apply_descriptor(def_.descriptor, g); !applied)
      return Failed(translated(texts::control_file_grammar::format_fault, name_, format_fault_message(applied.error())));
  const toml::table* const t = section("grammar");
  if (t == nullptr) return {};
  std::set<std::string_view> known = {
      "percent_digits",   "comment_forbidden", "block_length", "formal_parameter", "parameters_in", "most_codes",
      "long_parameters",  "variables",         "label",        "section",          "end_of_block",  "named_variables",
      "least_increments", "given_names"};
  for (const auto& [key, to] : grammar_flags) {
    known.insert(key);
    g.*to = typed(*t, key, g.*to);
  }
  for (const auto& [key, node] : *t)
    if (!known.contains(key.str())) return unknown_key(node, key.str(), {known.begin(), known.end()});
  if (typed(*t, "named_variables", false)) g.named_variables = std::make_shared<VariableNames>();
  if (typed(*t, "given_names", false)) g.given_names = std::make_shared<VariableNames>();
  g.percent_digits = static_cast<std::uint8_t>(whole(*t, "percent_digits", g.percent_digits, 9));
  g.comment_forbidden = text(*t, "comment_forbidden");
  g.least_increments = text(*t, "least_increments");
  g.block_length = whole(*t, "block_length", g.block_length, limits::line_bytes);
  g.variables = whole(*t, "variables", g.variables, max_variables);
  g.parameter_address = first_letter(*t, "formal_parameter");
  g.label_address = first_letter(*t, "label");
  g.long_parameters = (*t)["long_parameters"].value_or(g.long_parameters);
  const auto fits = [](char c) { return is_capital(c) || is_parameter_sign(c); };
  if (!std::all_of(g.long_parameters.begin(), g.long_parameters.end(), fits) || g.long_parameters.size() > max_long_parameters)
    return Failed(place(name_, *t, "long_parameters") + translated(texts::control_file_grammar::long_parameters_letters));
  g.section_address = first_letter(*t, "section");
  const std::string end = text(*t, "end_of_block");
  if (end == "line_only") g.end_of_block = EndOfBlock::line_only;
  else if (!end.empty() && end != "line")
    return Failed(place(name_, *t, "end_of_block") + translated(texts::control_file_grammar::end_of_block_values));
  for (const char letter : text(*t, "parameters_in")) {
    if (!is_capital(letter))
      return Failed(place(name_, *t, "parameters_in") + translated(texts::control_file_grammar::parameters_in_letters));
    g.word(letter).parameter = true;
  }
  if (t->contains("most_codes") && !(*t)["most_codes"].is_table())
    return Failed(place(name_, *t, "most_codes") + translated(texts::control_file_grammar::most_codes_is_table));
  if (const toml::table* const most = (*t)["most_codes"].as_table())
    for (const auto& [letter, node] : *most) {
      if (letter.str().size() != 1 || !is_capital(letter.str()[0]))
        return Failed(place(name_, node) + translated(texts::control_file_grammar::most_codes_letters));
      most_codes_[letter.str()[0]] = static_cast<std::uint8_t>(whole(*most, letter.str(), 0, limits::block_words));
    }
  return {};
}

char ControlLoader::first_letter(const toml::table& t, std::string_view key) {
  const std::string letter = text(t, key);
  if (letter.empty()) return '\0';
  const bool good = letter.size() == 1 && is_capital(letter[0]);
  if (!good && bad_value_.empty()) bad_value_ = place(name_, t, key) + translated(texts::control_file::must_be_letter, key);
  return good ? letter[0] : '\0';
}

Done ControlLoader::axes() {
  const toml::table* const t = section("axes");
  const toml::array* const names = t == nullptr ? nullptr : list(*t, "names");
  if (names == nullptr || names->empty() || names->size() > max_axes) return Failed(translated(texts::control_file::axis_count, name_));
  KADR_LOAD(known_keys(*t, {"names", "rotary", "diameter"}));
  for (const auto& node : *names) {
    const std::string name = node.value_exact<std::string>().value_or(std::string());
    if (name.empty() || axis_named(name) >= 0) return Failed(place(name_, node) + translated(texts::control_file::axis_names_differ));
    def_.axes.push_back(name);
  }
  if (const toml::array* const rotary = list(*t, "rotary"))
    for (const auto& name : *rotary) {
      const int axis = axis_named(name.value_or(std::string()));
      if (axis < 0) return Failed(place(name_, name) + translated(texts::control_file::no_rotary_axis));
      def_.rotary |= 1u << axis;
    }
  def_.diameter_by_setup = (*t)["diameter"].value_exact<std::string>() == "setup";
  if (const toml::array* const diameter = def_.diameter_by_setup ? nullptr : list(*t, "diameter"))
    for (const auto& name : *diameter) {
      const int axis = axis_named(name.value_or(std::string()));
      if (axis < 0) return Failed(place(name_, name) + translated(texts::control_file::no_diameter_axis));
      def_.diameter |= 1u << axis;
    }
  return {};
}

int ControlLoader::axis_named(const std::string& name) const {
  const auto found = std::find(def_.axes.begin(), def_.axes.end(), name);
  return found == def_.axes.end() ? -1 : static_cast<int>(found - def_.axes.begin());
}

Done ControlLoader::order() {
  const toml::table* const t = section("order");
  const toml::array* const phases = t == nullptr ? nullptr : list(*t, "phases");
  if (phases == nullptr) return Failed(translated(texts::control_file::no_phases, name_));
  KADR_LOAD(known_keys(*t, {"phases"}));
  for (const auto& node : *phases) {
    const Phase phase = phase_named(node.value_or(std::string()));
    if (phase == Phase::count)
      return Failed(place(name_, node) + translated(texts::control_file::unknown_phase, node.value_or(std::string())));
    if (def_.order[static_cast<std::size_t>(phase)] != 0) return Failed(place(name_, node) + translated(texts::control_file::phase_twice));
    def_.order_list.push_back(phase);
    def_.order[static_cast<std::size_t>(phase)] = static_cast<std::uint8_t>(def_.order_list.size());
  }
  return {};
}

/// Returns the phase of a row: its key `phase`, or else the phase of its function. The control's order must list this phase.
tl::expected<Phase, std::string> ControlLoader::phase_of(const toml::table& row, Function function) {
  Phase phase = traits_of(function).phase;
  if (row.contains("phase")) phase = phase_named(text(row, "phase"));
  if (phase == Phase::count) return Failed(place(name_, row, "phase") + translated(texts::control_file::unknown_phase, text(row, "phase")));
  if (phase != Phase::none && def_.order[static_cast<std::size_t>(phase)] == 0)
    return Failed(place(name_, row, "phase") + translated(texts::control_file::phase_not_listed, name_of(phase)));
  return phase;
}

Done ControlLoader::addresses() {
  const toml::table* const t = section("address");
  if (t == nullptr) return Failed(translated(texts::control_file_words::no_addresses, name_));
  for (const auto& [key, node] : *t) {
    const toml::table* const row = node.as_table();
    const std::string_view text = key.str();
    const bool comma = text.size() == 2 && text[0] == ',';
    if (sign_address(text) && row != nullptr) {
      KADR_LOAD(address(def_.grammar.names.back().address, *row));
      continue;
    }
    const char letter = comma ? comma_address(text[1]) : text.size() == 1 ? text[0] : '\0';
    if (letter == 0 || (!comma && (letter < 'A' || letter > 'Z')) || row == nullptr)
      return Failed(place(name_, node) + translated(texts::control_file_words::address_is_letter));
    KADR_LOAD(address(letter, *row));
  }
  return {};
}

/// Adds an address that is not a letter (spec/linuxcnc 7.1, 8) to the list of named addresses.
bool ControlLoader::sign_address(std::string_view text) {
  constexpr std::string_view signs = "$@^";
  if (text.size() != 1 || signs.find(text[0]) == std::string_view::npos) return false;
  std::vector<AddressName>& names = def_.grammar.names;
  names.push_back({std::string(text), static_cast<char>(first_name + static_cast<char>(names.size()))});
  return true;
}

Done ControlLoader::address(char letter, const toml::table& row) {
  KADR_LOAD(known_keys(row, {"does", "axis", "unit", "scale", "least", "most", "whole", "point", "format", "phase", "second", "many", "en",
                             "ru", "manual"}));
  AddressRow& a = def_.addresses[static_cast<std::size_t>(letter - 'A')];
  a.letter = letter;
  const auto function = function_of(row, CalledBy::word, address_written(letter));
  if (!function) return Failed(function.error());
  a.function = *function;
  const auto phase = phase_of(row, *function);
  if (!phase) return Failed(phase.error());
  a.phase = *phase;
  if (row.contains("axis")) {
    const std::string axis = text(row, "axis");
    const int index = axis_named(axis);
    if (index < 0) return Failed(place(name_, row, "axis") + translated(texts::control_file_words::no_axis, axis));
    a.axis = static_cast<std::uint8_t>(index);
  }
  const std::string unit = text(row, "unit");
  if (!unit.empty() && unit != "length" && unit != "angle")
    return Failed(place(name_, row, "unit") + translated(texts::control_file_words::unit_values));
  a.unit = unit == "length" ? WordUnit::length : unit == "angle" ? WordUnit::angle : WordUnit::none;
  ranged(row, "scale", ranges::scale, a.scale);
  ranged(row, "least", ranges::any, a.least);
  ranged(row, "most", ranges::any, a.most);
  if (a.least > a.most) return Failed(place(name_, row, "least") + translated(texts::control_file_words::least_is_above_most));
  a.whole = typed(row, "whole", false);
  a.text = text_of(row);
  a.manual = text(row, "manual");
  a.format = text(row, "format");
  KADR_LOAD(check_address(letter, row, a));
  return word_format(letter, row, a);
}

Done ControlLoader::word_format(char letter, const toml::table& row, const AddressRow& a) {
  WordFormat& w = def_.grammar.word(letter);
  const bool parameter = w.parameter;
  if (a.format == "free" || a.format == "+free") {
    w = {};
    w.known = w.drop_zeros = w.point = true;
    w.sign = a.format[0] == '+';
  } else if (!a.format.empty()) {
    auto parsed = parse_word_format(a.format, false);
    if (!parsed) return Failed(place(name_, row, "format") + format_fault_message(parsed.error()));
    w = *parsed;
  }
  // A control has the addresses that its format string lists, and each address whose row states a format of its own.
  w.known = def_.descriptor.empty() || !a.format.empty() || w.known || a.function == Function::formal_parameter;
  if (!typed(row, "point", true)) w.point = false;
  w.parameter = parameter;
  w.second_number = typed(row, "second", false);
  w.code = a.function == Function::code;
  if (w.code && w.at_most == 1) w.at_most = 0;
  if (most_codes_.contains(letter)) w.at_most = most_codes_[letter];
  if (typed(row, "many", false)) w.at_most = 0;
  return {};
}

}  // namespace kadr
