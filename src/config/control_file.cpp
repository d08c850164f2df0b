#include "config/control_file.h"

#include <algorithm>
#include <set>

#include "config/embedded.h"
#include "config/toml_tools.h"
#include "lang/format.h"

namespace kadr {
namespace {

using toml_tools::place;
using toml_tools::text_of;
using Failed = tl::unexpected<std::string>;
using Done = tl::expected<void, std::string>;

#define KADR_LOAD(expression)                                     \
  do {                                                            \
    if (auto done_ = (expression); !done_) return Failed(done_.error()); \
  } while (false)

constexpr std::string_view step_names[] = {"feed_bottom", "rapid_bottom", "retract",   "feed_retract", "dwell",      "spindle_stop",
                                           "spindle_reverse", "spindle_restore", "orient", "stop",     "peck_full",  "peck_break",
                                           "shift_out",   "shift_back",   "feed_face", "passes_by_parameter"};
static_assert(std::size(step_names) == static_cast<std::size_t>(CycleStep::count));

constexpr std::string_view variable_kinds[] = {"free", "probe_point", "home", "home_second", "set_position", "fixture_number", "fixture"};

/// Builds a ControlDef from one (merged) table; a method a section of the file.
class Loader {
 public:
  Loader(const toml::table& file, std::string name) : file_(file), name_(std::move(name)) {}

  tl::expected<ControlDef, std::string> load() {
    def_.id = file_["id"].value_or(std::string());
    if (def_.id.empty()) return Failed(name_ + ": id is missing");
    if (const toml::table* const text = file_["name"].as_table()) def_.name = text_of(*text);
    def_.spec = file_["spec"].value_or(std::string());
    KADR_LOAD(known_keys(file_, {"id", "name", "spec", "extends", "format", "grammar", "behaviour", "axes", "order", "address", "groups", "g", "m",
                                 "cycle", "variables", "alarms", "defaults", "feed_codes", "speed_codes"}));
    KADR_LOAD(grammar());
    KADR_LOAD(behaviour());
    KADR_LOAD(axes());
    KADR_LOAD(order());
    KADR_LOAD(addresses());
    KADR_LOAD(groups());
    KADR_LOAD(cycles());
    def_.g_rows.assign(ControlDef::most_tenths, -1);
    def_.m_rows.assign(ControlDef::most_tenths, -1);
    KADR_LOAD(codes("g", 'G'));
    KADR_LOAD(codes("m", 'M'));
    KADR_LOAD(initial_codes());
    KADR_LOAD(variables());
    KADR_LOAD(alarms());
    code_table("feed_codes", def_.feed_codes);
    code_table("speed_codes", def_.speed_codes);
    return std::move(def_);
  }

 private:
  Done known_keys(const toml::table& table, std::initializer_list<std::string_view> known) const {
    for (const auto& [key, node] : table)
      if (std::find(known.begin(), known.end(), key.str()) == known.end())
        return Failed(place(name_, node) + "unknown key '" + std::string(key.str()) + "'");
    return {};
  }

  const toml::table* section(std::string_view key) const { return file_[key].as_table(); }

  Done grammar() {
    def_.descriptor = file_["format"].value_or(std::string());
    Grammar& g = def_.grammar;
    if (!def_.descriptor.empty())
      if (auto applied = apply_descriptor(def_.descriptor, g); !applied) return Failed(name_ + ": format: " + applied.error());
    const toml::table* const t = section("grammar");
    if (t == nullptr) return {};
    KADR_LOAD(known_keys(*t, {"block_number_required", "program_start_required", "percent_number", "percent_digits", "percent_ignored", "comment_forbidden",
                              "block_length", "formal_parameter", "parameters_in", "most_codes", "semicolon_comments", "slash_comments",
                              "expressions", "variables", "label", "section", "lower_case", "end_of_block", "main_blocks", "skip_levels",
                              "mark_everywhere", "zero_between_slashes"}));
    const auto flag = [&](const char* key, bool& to) { to = (*t)[key].value_or(to); };
    flag("block_number_required", g.block_number_required);
    flag("program_start_required", g.program_start_required);
    flag("percent_number", g.percent_number);
    flag("percent_ignored", g.percent_ignored);
    flag("semicolon_comments", g.semicolon_comments);
    flag("slash_comments", g.slash_comments);
    flag("expressions", g.expressions);
    flag("lower_case", g.lower_case);
    flag("main_blocks", g.main_blocks);
    flag("skip_levels", g.skip_levels);
    flag("mark_everywhere", g.mark_everywhere);
    flag("zero_between_slashes", g.zero_between_slashes);
    g.percent_digits = static_cast<std::uint8_t>((*t)["percent_digits"].value_or(std::int64_t{g.percent_digits}));
    g.comment_forbidden = (*t)["comment_forbidden"].value_or(g.comment_forbidden);
    g.block_length = static_cast<std::uint32_t>((*t)["block_length"].value_or(std::int64_t{g.block_length}));
    g.variables = static_cast<std::uint32_t>((*t)["variables"].value_or(std::int64_t{g.variables}));
    g.parameter_address = first_letter(*t, "formal_parameter");
    g.label_address = first_letter(*t, "label");
    g.section_address = first_letter(*t, "section");
    if ((*t)["end_of_block"].value_or(std::string("line")) == "line_only") g.end_of_block = EndOfBlock::line_only;
    for (const char letter : (*t)["parameters_in"].value_or(std::string())) g.word(letter).parameter = true;
    if (const toml::table* const most = (*t)["most_codes"].as_table())
      for (const auto& [letter, count] : *most) most_codes_[letter.str()[0]] = static_cast<std::uint8_t>(count.value_or(std::int64_t{0}));
    return {};
  }

  static char first_letter(const toml::table& t, std::string_view key) {
    const std::string text = t[key].value_or(std::string());
    return text.empty() ? '\0' : text[0];
  }

  Done behaviour() {
    const toml::table* const t = section("behaviour");
    if (t == nullptr) return {};
    Behaviour& b = def_.behaviour;
    std::set<std::string_view> known = {"arc_centers", "length_offset"};
    const auto flag = [&](const char* key, bool& to) { known.insert(key); to = (*t)[key].value_or(to); };
    const auto number = [&](const char* key, double& to) { known.insert(key); to = (*t)[key].value_or(to); };
    const auto count = [&](const char* key, std::uint32_t& to) {
      known.insert(key);
      to = static_cast<std::uint32_t>((*t)[key].value_or(std::int64_t{to}));
    };
    flag("arc_radius_word", b.arc_radius_word);
    number("arc_radius_difference", b.arc_radius_difference);
    flag("helix_by_lead", b.helix_by_lead);
    number("feed_most", b.feed_most);
    flag("feed_required", b.feed_required);
    number("reference_feed", b.reference_feed);
    number("return_chip_break", b.return_chip_break);
    number("return_near", b.return_near);
    number("probe_least_distance", b.probe_least_distance);
    flag("speed_needs_direction", b.speed_needs_direction);
    flag("tool_and_corrector", b.tool_and_corrector);
    flag("zero_change_checked", b.zero_change_checked);
    flag("subprogram_zero_local", b.subprogram_zero_local);
    flag("subprograms_by_section", b.subprograms_by_section);
    flag("ends_reading", b.ends_reading);
    flag("delayed_assignment", b.delayed_assignment);
    flag("correctors", b.correctors);
    count("call_depth", b.call_depth);
    count("offsets", b.offsets);
    count("fixtures", b.fixtures);
    const std::string centers = (*t)["arc_centers"].value_or(std::string("incremental"));
    if (centers == "by_code") b.arc_centers = ArcCenters::by_code;
    else if (centers == "as_distance") b.arc_centers = ArcCenters::as_distance;
    else if (centers != "incremental") return Failed(place(name_, *t) + "arc_centers: incremental, as_distance or by_code");
    b.length_offset = (*t)["length_offset"].value_or(std::string()) == "at_once" ? LengthOffset::at_once : LengthOffset::next_motion;
    for (const auto& [key, node] : *t)
      if (!known.contains(key.str())) return Failed(place(name_, node) + "unknown behaviour '" + std::string(key.str()) + "'");
    return {};
  }

  Done axes() {
    const toml::table* const t = section("axes");
    const toml::array* const names = t == nullptr ? nullptr : (*t)["names"].as_array();
    if (names == nullptr || names->empty() || names->size() > max_axes) return Failed(name_ + ": [axes] names: 1 to 16 axes");
    for (const auto& name : *names) def_.axes.push_back(name.value_or(std::string()));
    if (const toml::array* const rotary = (*t)["rotary"].as_array())
      for (const auto& name : *rotary) {
        const int axis = axis_named(name.value_or(std::string()));
        if (axis < 0) return Failed(place(name_, name) + "rotary: no such axis");
        def_.rotary |= 1u << axis;
      }
    return {};
  }

  int axis_named(const std::string& name) const {
    const auto found = std::find(def_.axes.begin(), def_.axes.end(), name);
    return found == def_.axes.end() ? -1 : static_cast<int>(found - def_.axes.begin());
  }

  Done order() {
    const toml::table* const t = section("order");
    const toml::array* const phases = t == nullptr ? nullptr : (*t)["phases"].as_array();
    if (phases == nullptr) return Failed(name_ + ": [order] phases is missing");
    for (const auto& node : *phases) {
      const Phase phase = phase_named(node.value_or(std::string()));
      if (phase == Phase::count) return Failed(place(name_, node) + "unknown phase '" + node.value_or(std::string()) + "'");
      if (def_.order[static_cast<std::size_t>(phase)] != 0) return Failed(place(name_, node) + "phase twice");
      def_.order_list.push_back(phase);
      def_.order[static_cast<std::size_t>(phase)] = static_cast<std::uint8_t>(def_.order_list.size());
    }
    return {};
  }

  /// `phase` of the row, or the function's own; it must stand in the control's order.
  tl::expected<Phase, std::string> phase_of(const toml::table& row, Function function) const {
    Phase phase = traits_of(function).phase;
    if (const auto named = row["phase"].value<std::string>()) phase = phase_named(*named);
    if (phase == Phase::count) return Failed(place(name_, row) + "unknown phase");
    if (phase != Phase::none && def_.order[static_cast<std::size_t>(phase)] == 0)
      return Failed(place(name_, row) + "phase '" + std::string(name_of(phase)) + "' is not in [order]");
    return phase;
  }

  tl::expected<Function, std::string> function_of(const toml::table& row) const {
    const std::string name = row["does"].value_or(std::string());
    const Function function = function_named(name);
    if (function == Function::count) return Failed(place(name_, row) + "unknown function '" + name + "'");
    return function;
  }

  Done addresses() {
    const toml::table* const t = section("address");
    if (t == nullptr) return Failed(name_ + ": [address] is missing");
    for (const auto& [key, node] : *t) {
      const toml::table* const row = node.as_table();
      if (key.str().size() != 1 || key.str()[0] < 'A' || key.str()[0] > 'Z' || row == nullptr)
        return Failed(place(name_, node) + "an address is a letter A to Z with a table");
      KADR_LOAD(address(key.str()[0], *row));
    }
    return {};
  }

  Done address(char letter, const toml::table& row) {
    KADR_LOAD(known_keys(row, {"does", "axis", "unit", "scale", "least", "most", "whole", "format", "phase", "second", "many", "en", "ru", "manual"}));
    AddressRow& a = def_.addresses[static_cast<std::size_t>(letter - 'A')];
    a.letter = letter;
    const auto function = function_of(row);
    if (!function) return Failed(function.error());
    a.function = *function;
    const auto phase = phase_of(row, *function);
    if (!phase) return Failed(phase.error());
    a.phase = *phase;
    if (const auto axis = row["axis"].value<std::string>()) {
      const int index = axis_named(*axis);
      if (index < 0) return Failed(place(name_, row) + "no axis '" + *axis + "'");
      a.axis = static_cast<std::uint8_t>(index);
    }
    const std::string unit = row["unit"].value_or(std::string());
    a.unit = unit == "length" ? WordUnit::length : unit == "angle" ? WordUnit::angle : WordUnit::none;
    a.scale = row["scale"].value_or(1.0);
    a.least = row["least"].value_or(a.least);
    a.most = row["most"].value_or(a.most);
    a.whole = row["whole"].value_or(false);
    a.text = text_of(row);
    a.manual = row["manual"].value_or(std::string());
    a.format = row["format"].value_or(std::string());
    return word_format(letter, row, a);
  }

  Done word_format(char letter, const toml::table& row, const AddressRow& a) {
    WordFormat& w = def_.grammar.word(letter);
    const bool parameter = w.parameter;
    if (a.format == "free" || a.format == "+free") {
      w = {};
      w.known = w.drop_zeros = w.point = true;
      w.sign = a.format[0] == '+';
    } else if (!a.format.empty()) {
      auto parsed = parse_word_format(a.format, false);
      if (!parsed) return Failed(place(name_, row) + parsed.error());
      w = *parsed;
    }
    w.known = true;
    w.parameter = parameter;
    w.second_number = row["second"].value_or(false);
    w.code = a.function == Function::code;
    if (w.code && w.at_most == 1) w.at_most = 0;
    if (most_codes_.contains(letter)) w.at_most = most_codes_[letter];
    if (row["many"].value_or(false)) w.at_most = 0;
    return {};
  }

  Done groups() {
    def_.groups.push_back({"", false, -1, {}});
    const toml::table* const t = section("groups");
    if (t == nullptr) return {};
    for (const auto& [key, node] : *t) {
      const toml::table* const row = node.as_table();
      if (row == nullptr) return Failed(place(name_, node) + "a group is a table");
      KADR_LOAD(known_keys(*row, {"modal", "initial", "en", "ru"}));
      def_.groups.push_back({std::string(key.str()), (*row)["modal"].value_or(true), -1, text_of(*row)});
      initial_.push_back((*row)["initial"].value_or(std::string()));
    }
    return {};
  }

  int group_named(std::string_view name) const {
    for (std::size_t i = 1; i < def_.groups.size(); ++i)
      if (def_.groups[i].name == name) return static_cast<int>(i);
    return -1;
  }

  /// "XYZ" → bits; every letter must be an address of this control (checked when all is read).
  static std::uint32_t letters(const std::string& text) {
    std::uint32_t bits = 0;
    for (const char c : text)
      if (c >= 'A' && c <= 'Z') bits |= letter_bit_of(c);
    return bits;
  }
  static std::uint32_t letter_bit_of(char c) { return 1u << (c - 'A'); }

  Done codes(std::string_view key, char letter) {
    const toml::table* const t = section(key);
    if (t == nullptr) return {};
    std::vector<std::pair<double, const toml::table*>> rows;
    for (const auto& [code, node] : *t) {
      const toml::table* const row = node.as_table();
      if (row == nullptr) return Failed(place(name_, node) + "a code is a table");
      if (code.str() == "other") {
        KADR_LOAD(other_codes(*row, letter));
        continue;
      }
      char* end = nullptr;
      const std::string digits(code.str());
      const double number = std::strtod(digits.c_str(), &end);
      if (end == digits.c_str() || *end != '\0' || number < 0 || number * 10 >= ControlDef::most_tenths)
        return Failed(place(name_, node) + "'" + digits + "' is no code number");
      rows.emplace_back(number, row);
    }
    std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [number, row] : rows) KADR_LOAD(code(letter, number, *row));
    return {};
  }

  Done code(char letter, double number, const toml::table& row) {
    KADR_LOAD(known_keys(row, {"group", "does", "arg", "takes", "needs", "needs_axis", "own_block", "modal", "phase", "with", "en", "ru", "manual", "from", "to"}));
    CodeRow c;
    c.letter = letter;
    c.tenth = static_cast<std::int32_t>(number * 10 + 0.5);
    c.code = letter + std::to_string(c.tenth / 10) + (c.tenth % 10 != 0 ? "." + std::to_string(c.tenth % 10) : "");
    const auto function = function_of(row);
    if (!function) return Failed(function.error());
    c.function = *function;
    const auto phase = phase_of(row, *function);
    if (!phase) return Failed(phase.error());
    c.phase = *phase;
    c.arg = static_cast<int>(row["arg"].value_or(std::int64_t{0}));
    if (const auto group = row["group"].value<std::string>()) {
      const int index = group_named(*group);
      if (index < 0) return Failed(place(name_, row) + "no group '" + *group + "'");
      c.group = static_cast<std::uint8_t>(index);
    }
    c.modal = row["modal"].value_or(c.group != 0 && def_.groups[c.group].modal);
    c.own_block = row["own_block"].value_or(false);
    c.takes = letters(row["takes"].value_or(std::string()));
    c.needs = letters(row["needs"].value_or(std::string()));
    c.needs_axis = row["needs_axis"].value_or(false);
    if (const toml::array* const with = row["with"].as_array(); with != nullptr && !with->empty())
      c.with = static_cast<std::int32_t>(std::strtod((*with)[0].value_or(std::string(" 0")).c_str() + 1, nullptr) * 10 + 0.5);
    for (int i = 0; i < 26; ++i)
      if ((c.takes >> i & 1u) != 0 && !def_.grammar.words[static_cast<std::size_t>(i)].known && !(def_.grammar.zero_between_slashes && i == 0))
        return Failed(place(name_, row) + "takes: no address " + static_cast<char>('A' + i));
    c.text = text_of(row);
    c.manual = row["manual"].value_or(std::string());
    if (c.function == Function::cycle) {
      c.cycle = cycle_named(c.code);
      if (c.cycle == 0) return Failed(place(name_, row) + "no [cycle." + c.code + "]");
    }
    auto& index = letter == 'G' ? def_.g_rows : def_.m_rows;
    index[static_cast<std::size_t>(c.tenth)] = static_cast<std::int16_t>(def_.codes.size());
    def_.codes.push_back(std::move(c));
    return {};
  }

  /// "other": the numbers that have no row of their own go to the machine.
  Done other_codes(const toml::table& row, char letter) {
    if (letter != 'M') return Failed(place(name_, row) + "only M codes may have 'other'");
    const auto from = row["from"].value_or(std::int64_t{0});
    const auto to = row["to"].value_or(std::int64_t{99999});
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

  std::uint16_t cycle_named(std::string_view name) const {
    for (std::size_t i = 0; i < def_.cycles.size(); ++i)
      if (def_.cycles[i].name == name) return static_cast<std::uint16_t>(i + 1);
    return 0;
  }

  Done cycles() {
    const toml::table* const t = section("cycle");
    if (t == nullptr) return {};
    for (const auto& [key, node] : *t) {
      const toml::table* const row = node.as_table();
      if (row == nullptr) return Failed(place(name_, node) + "a cycle is a table");
      KADR_LOAD(known_keys(*row, {"steps", "body", "needs", "needs_spindle", "needs_spindle_cw", "needs_override_off", "en", "ru", "manual"}));
      CycleRow c;
      c.name = std::string(key.str());
      if (const toml::array* const steps = (*row)["steps"].as_array())
        for (const auto& step : *steps) {
          const auto* const found = std::find(std::begin(step_names), std::end(step_names), step.value_or(std::string()));
          if (found == std::end(step_names)) return Failed(place(name_, step) + "unknown step");
          c.steps.push_back(static_cast<CycleStep>(found - std::begin(step_names)));
        }
      if (const toml::array* const body = (*row)["body"].as_array())
        for (const auto& line : *body) c.body += line.value_or(std::string()) + "\n";
      if (c.steps.empty() == c.body.empty()) return Failed(place(name_, node) + "a cycle has steps or a body");
      c.needs = letters((*row)["needs"].value_or(std::string()));
      c.needs_spindle = (*row)["needs_spindle"].value_or(false);
      c.needs_spindle_cw = (*row)["needs_spindle_cw"].value_or(false);
      c.needs_override_off = (*row)["needs_override_off"].value_or(false);
      c.text = text_of(*row);
      c.manual = (*row)["manual"].value_or(std::string());
      def_.cycles.push_back(std::move(c));
    }
    return {};
  }

  std::int32_t row_named(const std::string& code) const {
    for (std::size_t i = 0; i < def_.codes.size(); ++i)
      if (def_.codes[i].code == code) return static_cast<std::int32_t>(i);
    return -1;
  }

  Done initial_codes() {
    for (std::size_t i = 1; i < def_.groups.size(); ++i) {
      const std::string& code = initial_[i - 1];
      if (code.empty()) continue;
      const std::int32_t row = row_named(code);
      if (row < 0 || def_.codes[static_cast<std::size_t>(row)].group != i) return Failed(name_ + ": [groups] \"" + def_.groups[i].name + "\": initial code " + code + " is not of this group");
      def_.groups[i].power_on = row;
    }
    const toml::table* const t = section("defaults");
    const toml::array* const end = t == nullptr ? nullptr : (*t)["end"].as_array();
    if (end == nullptr) return {};
    for (const auto& node : *end) {
      const std::int32_t row = row_named(node.value_or(std::string()));
      if (row < 0) return Failed(place(name_, node) + "unknown code");
      def_.end_codes.push_back(row);
    }
    return {};
  }

  Done variables() {
    const toml::array* const rows = file_["variables"].as_array();
    if (rows == nullptr) return {};
    for (const auto& node : *rows) {
      const toml::table* const row = node.as_table();
      if (row == nullptr) return Failed(place(name_, node) + "a variable is a table");
      VariableRow v;
      const std::string kind = (*row)["is"].value_or(std::string());
      const auto* const found = std::find(std::begin(variable_kinds), std::end(variable_kinds), kind);
      if (found == std::end(variable_kinds)) return Failed(place(name_, node) + "unknown kind '" + kind + "'");
      v.kind = static_cast<VariableKind>(found - std::begin(variable_kinds));
      const auto number = [&](const char* key, std::uint32_t otherwise) { return static_cast<std::uint32_t>((*row)[key].value_or(std::int64_t{otherwise})); };
      v.from = number("from", 0);
      v.count = number("count", 1);
      v.stride = number("stride", 0);
      v.repeat = number("repeat", 1);
      v.text = text_of(*row);
      v.manual = (*row)["manual"].value_or(std::string());
      def_.variables.push_back(std::move(v));
    }
    return {};
  }

  Done alarms() {
    const toml::table* const t = section("alarms");
    if (t == nullptr) return {};
    for (const auto& [key, node] : *t) {
      const toml::table* const row = node.as_table();
      const AlarmId id = alarm_named(key.str());
      if (row == nullptr || id == AlarmId::count) return Failed(place(name_, node) + "unknown alarm '" + std::string(key.str()) + "'");
      AlarmText text;
      if (const auto number = (*row)["number"].value<std::int64_t>()) text.number = std::to_string(*number);
      else text.number = (*row)["number"].value_or(std::string());
      text.text = text_of(*row);
      text.hint = {(*row)["hint_en"].value_or(std::string()), (*row)["hint_ru"].value_or(std::string())};
      def_.alarms[id] = std::move(text);
    }
    return {};
  }

  void code_table(std::string_view key, std::map<std::int32_t, double>& to) const {
    if (const toml::table* const t = section(key))
      for (const auto& [code, value] : *t) to[std::atoi(std::string(code.str()).c_str())] = value.value_or(0.0);
  }

  const toml::table& file_;
  std::string name_;
  ControlDef def_;
  std::map<char, std::uint8_t> most_codes_;
  std::vector<std::string> initial_;
};

/// The table of a file with what it extends laid under it; `lineage` collects the ids below.
tl::expected<toml::table, std::string> merged(std::string_view text, const std::string& file, std::vector<std::string>& lineage) {
  constexpr std::size_t deepest = 8;   // a file that extends itself would never end
  toml::table table;
  try {
    table = toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    return Failed(file + ":" + std::to_string(error.source().begin.line) + ": " + std::string(error.description()));
  }
  const auto base = table["extends"].value<std::string>();
  if (!base) return table;
  if (lineage.size() == deepest) return Failed(file + ": extends itself");
  lineage.push_back(*base);
  const std::string name = "controls/" + *base + ".toml";
  const auto base_text = toml_tools::embedded_text(name);
  std::optional<std::string> own_text;
  if (!base_text) {
    const auto slash = file.rfind('/');
    own_text = toml_tools::read_text((slash == std::string::npos ? std::string() : file.substr(0, slash + 1)) + *base);
    if (!own_text) return Failed(file + ": extends '" + *base + "': no such control");
  }
  auto under = merged(base_text ? *base_text : std::string_view(*own_text), base_text ? name : *base, lineage);
  if (!under) return under;
  toml_tools::merge(*under, table);
  return under;
}

}  // namespace

std::int32_t ControlDef::row_of(char letter, std::int32_t tenth) const {
  if (tenth >= 0 && tenth < most_tenths) {
    const std::int16_t row = (letter == 'G' ? g_rows : m_rows)[static_cast<std::size_t>(tenth)];
    if (row >= 0) return row;
  }
  if (letter == 'M' && m_user_row >= 0 && tenth >= m_user_from && tenth <= m_user_to && tenth % 10 == 0) return m_user_row;
  return -1;
}

tl::expected<ControlDef, std::string> parse_control(std::string_view toml, const std::string& file) {
  std::vector<std::string> lineage;
  auto table = merged(toml, file, lineage);
  if (!table) return Failed(table.error());
  auto def = Loader(*table, file).load();
  if (def) def->lineage = std::move(lineage);
  return def;
}

tl::expected<ControlDef, std::string> load_control(const std::string& name) {
  if (name.ends_with(".toml")) {
    const auto text = toml_tools::read_text(name);
    if (!text) return Failed(name + ": cannot be read");
    return parse_control(*text, name);
  }
  const std::string file = "controls/" + name + ".toml";
  const auto text = toml_tools::embedded_text(file);
  if (!text || name == "alarms") {
    std::string known;
    for (const std::string& id : built_in_controls()) known += (known.empty() ? "" : ", ") + id;
    return Failed("no control '" + name + "'; there are: " + known + ", or a file of your own (NAME.toml)");
  }
  return parse_control(*text, file);
}

std::vector<std::string> built_in_controls() {
  std::vector<std::string> ids;
  for (const EmbeddedFile& file : embedded_files()) {
    std::string_view name = file.name;
    if (!name.starts_with("controls/") || name == "controls/alarms.toml") continue;
    name.remove_prefix(9);
    ids.emplace_back(name.substr(0, name.size() - 5));
  }
  return ids;
}

}  // namespace kadr
