// Decides which keys and names of a set-up exist on a control, by the control's file. Used by cli, config, control, out.

#include "config/setup/setup_names.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/ascii.h"
#include "base/code_literals.h"
#include "config/setup/setup.h"
#include "lang/block/block.h"
#include "texts/setup_names.h"

namespace kadr {
namespace {

constexpr int max_row = 999'999'999;  // greatest number that a row of a table may have as its name
constexpr int turning_zeros = 9;      // number of zeros (work offsets) of the 2С42 on a turning machine: G92 /A/
constexpr int dynamic_systems = 8;    // number of dynamic work offsets: G54.2 P1 … P8 (nct 25.4)
// First and last code, in tenths, of the usual work offsets: G54 … G59, G59.3
constexpr std::int32_t first_system = 54_g, last_system = 59.3_g;

/// Returns true if the name has the form of a macro variable: "#100", "#_ALM", "#_FOFS1[1]".
bool names_macro_variable(std::string_view name) {
  constexpr std::size_t longest_number = 7, longest_symbol = 31;
  if (name.size() < 2 || name[0] != '#') return false;
  std::string_view rest = name.substr(1);
  if (rest[0] != '_') return rest.size() <= longest_number && all_are(rest, is_digit);
  if (const std::size_t open = rest.find('['); open != std::string_view::npos) {
    if (rest.back() != ']' || !all_are(rest.substr(open + 1, rest.size() - open - 2), is_digit)) return false;
    rest = rest.substr(0, open);
  }
  const auto is_symbol = [](char c) { return is_digit(c) || is_capital(c) || c == '_'; };
  return rest.size() >= 2 && rest.size() <= longest_symbol && all_are(rest, is_symbol);
}

bool names_formal_parameter(std::string_view name) { return name.size() == 2 && name[0] == 'R' && is_digit(name[1]); }

/// Returns true for a variable of a control with named blocks: #R10, #COUNT, the name as the program writes it.
bool names_own_variable(std::string_view name) {
  const auto fits = [](char c) { return is_digit(c) || is_letter(c) || c == '_'; };
  return name.size() > 2 && name[0] == '#' && !is_digit(name[1]) && std::all_of(name.begin() + 1, name.end(), fits);
}

/// Returns true if the name has the form of a magazine pocket, magazine/pocket: "10/1".
bool names_pocket(std::string_view name) {
  constexpr std::size_t max_digits = 9;
  const std::size_t slash = name.find('/');
  if (slash == std::string_view::npos) return false;
  const std::string_view magazine = name.substr(0, slash), pocket = name.substr(slash + 1);
  return all_are(magazine, is_digit) && all_are(pocket, is_digit) && std::max(magazine.size(), pocket.size()) <= max_digits;
}

/// Returns true if the name has the form of a work offset on any control: "common", "G54", "G54.1 P2".
bool is_like_work_offset(std::string_view name) {
  if (name == "common") return true;
  if (!name.starts_with("G")) return false;
  const std::size_t blank = name.find(' ');
  const auto digit_or_point = [](char c) { return is_digit(c) || c == '.'; };
  if (!all_are(name.substr(1, blank == std::string_view::npos ? blank : blank - 1), digit_or_point)) return false;
  return blank == std::string_view::npos || (name.substr(blank).starts_with(" P") && all_are(name.substr(blank + 2), is_digit));
}

/// Returns true if the control numbers its work offsets in an order other than that of their codes: on the 2С42, G55 is zero 3.
bool numbers_zeros_itself(const ControlDef& def) {
  return std::any_of(def.codes.begin(), def.codes.end(), [](const CodeRow& row) {
    return row.function == Function::work_zero && row.arg > 0 && row.tenth <= last_system &&
           row.arg != row.tenth / 10 - first_system / 10 + 1;
  });
}

bool has_function(const ControlDef& def, std::initializer_list<Function> functions) {
  return std::any_of(def.codes.begin(), def.codes.end(),
                     [&](const CodeRow& row) { return std::find(functions.begin(), functions.end(), row.function) != functions.end(); });
}

bool has_variable(const ControlDef& def, VariableKind kind) {
  return std::any_of(def.variables.begin(), def.variables.end(), [&](const VariableRow& row) { return row.kind == kind; });
}

}  // namespace

bool has(const ControlDef& def, SetupNeeds needs) {
  switch (needs) {
    case SetupNeeds::nothing: return true;
    case SetupNeeds::work_offsets:
      return has_function(def, {Function::work_zero, Function::fixture, Function::work_system, Function::table_system}) &&
             !numbers_zeros_itself(def);
    case SetupNeeds::zeros: return numbers_zeros_itself(def);
    case SetupNeeds::correctors: return def.has_correctors();
    case SetupNeeds::variables:
      return def.grammar.variables > 0 || def.grammar.parameter_address != 0 || def.grammar.named_blocks || def.grammar.klartext_blocks;
    case SetupNeeds::parameters: return !def.parameters.empty();
    case SetupNeeds::corner_radius: return has_variable(def, VariableKind::offset_corner);
    case SetupNeeds::turning_lengths: return has_variable(def, VariableKind::offset_x) || def.has_parameter_file();
    case SetupNeeds::lathe_offsets: return def.behaviour.lathe != Lathe::none;
    case SetupNeeds::tool_management: return has_variable(def, VariableKind::tool_data);
    case SetupNeeds::ini: return def.has_parameter_file();
    case SetupNeeds::clock: return has_variable(def, VariableKind::date);
    case SetupNeeds::diameters: return def.machine_axes() || def.diameter_by_setup;
    case SetupNeeds::turning: return has(def, SetupNeeds::diameters) || def.has_parameter_file();
    case SetupNeeds::probe:
      return def.grammar.named_blocks ||
             has_function(def, {Function::probe, Function::probe_move, Function::measure, Function::measure_length});
    case SetupNeeds::skip_question: return def.behaviour.skip_asks;
    case SetupNeeds::machine_axes: return def.machine_axes();
    case SetupNeeds::kinematics: return def.machine_axes() || def.grammar.klartext_blocks || def.grammar.named_blocks;
  }
  return true;
}

std::vector<WorkSystem> work_systems(const ControlDef& def) {
  std::vector<WorkSystem> systems;
  const auto add = [&](const CodeRow& row, int from, int to, std::uint32_t number_before) {
    for (int p = from; p <= to; ++p)
      systems.push_back({fmt::format("{} P{}", row.code, p), number_before + static_cast<std::uint32_t>(p), row.works});
  };
  std::uint32_t plain = 0;
  for (const CodeRow& row : def.codes) {
    const bool usual = row.tenth >= first_system && row.tenth <= last_system;
    // G110 of the Haas is not between G54 and G59.3, but it has Function::work_system, so the condition includes it.
    // G505 to G599 of the Sinumerik are beyond G59.3 too.
    const bool further = row.function == Function::work_system || row.function == Function::work_zero;
    if (row.letter != 'G' || row.arg <= 0 || !(usual || further)) continue;
    const bool is_plain = row.function == Function::work_zero || row.function == Function::fixture ||
                          row.function == Function::work_system || row.function == Function::table_system;
    if (!is_plain) continue;
    systems.push_back({row.code, static_cast<std::uint32_t>(row.arg), row.works});
    if (usual) plain = std::max(plain, static_cast<std::uint32_t>(row.arg));
  }
  for (const CodeRow& row : def.codes) {
    const bool usual = row.tenth >= first_system && row.tenth <= last_system;
    if (row.letter != 'G' || (row.takes & letter_bit('P')) == 0 || !(usual || row.function == Function::work_system_extended)) continue;
    if (row.function == Function::fixture) add(row, 1, static_cast<int>(def.behaviour.fixtures), 0);
    if (row.function == Function::work_system_extended) add(row, 1, static_cast<int>(def.behaviour.further_systems), plain);
    if (row.function == Function::dynamic_zero) add(row, 1, dynamic_systems, plain + max_further_systems);
  }
  return systems;
}

std::vector<std::string> system_names(const ControlDef& def) {
  std::vector<std::string> names(1);
  for (const CodeRow& row : def.codes)
    if (row.function == Function::work_zero && row.arg == 0) names[0] = row.code;
  for (const WorkSystem& system : work_systems(def)) {
    if (!system.works) continue;
    if (names.size() <= system.row) names.resize(system.row + 1);
    if (names[system.row].empty()) names[system.row] = system.name;
  }
  return names;
}

std::string alternatives(const std::vector<std::string>& all, Lang lang) {
  if (all.empty()) return {};
  std::string text = all.front();
  for (std::size_t i = 1; i + 1 < all.size(); ++i) text += ", " + all[i];
  return all.size() == 1 ? text : translated_in(lang, texts::setup_names::one_or_the_last, text, all.back());
}

SetupNamesOf::SetupNamesOf(const ControlDef* def, std::vector<std::string> axes, std::vector<std::string> all_axes)
    : def_(def), axes_(std::move(axes)), all_axes_(std::move(all_axes)) {
  if (def_ != nullptr && has(*def_, SetupNeeds::work_offsets)) systems_ = work_systems(*def_);
}

SetupNamesOf::Numbers SetupNamesOf::numbers(SetupNames kind) const {
  const int offsets = def_ == nullptr ? max_row : static_cast<int>(def_->behaviour.offsets);
  switch (kind) {
    case SetupNames::offset:
    case SetupNames::corrector: return {1, offsets};
    case SetupNames::zero: return {1, turning_zeros};
    case SetupNames::reference_point: return {1, 4};
    case SetupNames::spindle: return {1, def_ == nullptr || def_->machine_axes() ? 16 : 1};
    case SetupNames::probe_input:
    case SetupNames::channel: return {1, 8};
    case SetupNames::tool_row:
    case SetupNames::tool_form: return {0, max_row};
    default: return {0, -1};
  }
}

bool SetupNamesOf::allows(SetupNames kind, std::string_view name) const {
  const auto among = [&](const std::vector<std::string>& names) { return std::find(names.begin(), names.end(), name) != names.end(); };
  switch (kind) {
    case SetupNames::fixed:
    case SetupNames::any: return true;
    case SetupNames::axis: return def_ == nullptr || among(axes_);
    case SetupNames::axis_of_any: return def_ == nullptr || among(all_axes_);
    case SetupNames::axis_or_all: return def_ == nullptr || name == "*" || among(all_axes_);
    case SetupNames::axis_or_plane:
    case SetupNames::work_offset:
      if (def_ == nullptr) return kind == SetupNames::axis_or_plane || is_like_work_offset(name);
      return among(all(kind));
    case SetupNames::variable: {
      if (def_ != nullptr && (def_->grammar.named_blocks || def_->grammar.klartext_blocks)) return names_own_variable(name);
      const bool macro = def_ == nullptr || def_->grammar.variables > 0;
      const bool formal = def_ == nullptr || def_->grammar.parameter_address != 0;
      if (!(macro && names_macro_variable(name)) && !(formal && names_formal_parameter(name))) return false;
      // Every name in the form of a variable is accepted here; the control itself checks which variables exist
      if (def_ == nullptr || def_->grammar.has_vacant_variables() || formal) return true;
      const int number = name[1] == '_' ? 0 : std::atoi(std::string(name.substr(1)).c_str());
      return number >= 1 && static_cast<std::uint32_t>(number) <= def_->grammar.variables;
    }
    case SetupNames::parameter: {
      const auto key = parameter_key(name);
      if (!key || def_ == nullptr) return key.has_value();
      return std::any_of(def_->parameters.begin(), def_->parameters.end(), [&](const ParameterRow& row) { return row.name == key->name; });
    }
    case SetupNames::place: return names_pocket(name);
    case SetupNames::signal: return among(all(kind)) || ((def_ == nullptr || all_axes_.empty()) && !axis_signal(name).axis.empty());
    case SetupNames::shift: return among(all(kind));
    default: {
      const auto [least, most] = numbers(kind);
      const bool digits = all_are(name, is_digit) && name.size() <= 9 && (name.size() == 1 || name[0] != '0');
      const int number = digits ? std::atoi(std::string(name).c_str()) : -1;
      return number >= least && number <= most;
    }
  }
}

std::vector<std::string> SetupNamesOf::all(SetupNames kind) const {
  std::vector<std::string> names;
  switch (kind) {
    case SetupNames::axis: return axes_;
    case SetupNames::axis_of_any: return all_axes_;
    case SetupNames::axis_or_all:
      names = all_axes_;
      names.emplace_back("*");
      return names;
    case SetupNames::axis_or_plane:
      names = axes_;
      if (def_ == nullptr || def_->has_parameter_file() || has_variable(*def_, VariableKind::rotation))
        names.insert(names.end(), {"G17", "G18", "G19"});
      return names;
    case SetupNames::work_offset:
      for (const WorkSystem& system : systems_) names.push_back(system.name);
      names.emplace_back("common");
      return names;
    case SetupNames::parameter:
      if (def_ == nullptr) return {};
      for (const ParameterRow& row : def_->parameters) names.push_back(text_of({row.name, "", ""}));
      return names;
    case SetupNames::signal:
      for (const SetupSignal& signal : setup_signals()) {
        if (!signal.of_axis) names.emplace_back(signal.name);
        for (std::size_t a = 0; signal.of_axis && a < all_axes_.size(); ++a) names.push_back(std::string(signal.name) + "." + all_axes_[a]);
      }
      return names;
    case SetupNames::shift: return {"G92", "G52"};
    default: return names;
  }
}

std::vector<std::string> SetupNamesOf::forms_of_parameters() const {
  if (def_ == nullptr) return {"N0308", "N0306#0", "N0402.X", "N0106.X#1"};
  std::vector<std::string> forms;
  const auto add_first = [&](bool of_axis, bool bits) {
    const auto row = std::find_if(def_->parameters.begin(), def_->parameters.end(), [&](const ParameterRow& parameter) {
      return parameter.used && parameter.type != ParameterType::text && (parameter.scope == ParameterScope::axis) == of_axis &&
             (parameter.type == ParameterType::bits) == bits;
    });
    if (row == def_->parameters.end()) return;
    std::size_t bit = 0;
    while (bits && bit + 1 < row->bits.size() && row->bits[bit].empty()) ++bit;
    forms.push_back(text_of({row->name, of_axis ? def_->axes.front() : "", bits ? std::to_string(bit) : ""}));
  };
  for (const bool of_axis : {false, true})
    for (const bool bits : {false, true}) add_first(of_axis, bits);
  return forms;
}

std::string SetupNamesOf::form(SetupNames kind, Lang lang) const {
  namespace id = texts::setup_names;
  switch (kind) {
    case SetupNames::variable: {
      if (def_ != nullptr && (def_->grammar.named_blocks || def_->grammar.klartext_blocks)) return plain_text(id::own_variable, lang);
      const bool formal = def_ == nullptr || def_->grammar.parameter_address != 0;
      const bool macro = def_ == nullptr || def_->grammar.variables > 0;
      if (!macro) return plain_text(id::formal_parameter, lang);
      if (!formal && !def_->grammar.has_vacant_variables()) return translated_in(lang, id::variable_up_to, def_->grammar.variables);
      return plain_text(formal ? id::variable_or_formal_parameter : id::variable, lang);
    }
    case SetupNames::parameter: return translated_in(lang, id::parameter, alternatives(forms_of_parameters(), lang));
    case SetupNames::place: return plain_text(id::place, lang);
    case SetupNames::work_offset: return plain_text(id::work_offset, lang);
    case SetupNames::shift: return plain_text(id::shift, lang);
    default: break;
  }
  const auto [least, most] = numbers(kind);
  if (least == most) return translated_in(lang, id::this_number, most);
  if (most == max_row) return plain_text(least == 0 ? id::any_number : id::number_from_1, lang);
  return translated_in(lang, id::number_within, least, most);
}

bool SetupNamesOf::unsupported(SetupNames kind, std::string_view name) const {
  return kind == SetupNames::work_offset &&
         std::any_of(systems_.begin(), systems_.end(), [&](const WorkSystem& system) { return system.name == name && !system.works; });
}

std::optional<std::string> SetupNamesOf::parameter_fault(std::string_view name, double value, bool text, Lang lang) const {
  namespace id = texts::setup_names;
  const auto key = parameter_key(name);
  if (!key || def_ == nullptr) return std::nullopt;
  const auto row =
      std::find_if(def_->parameters.begin(), def_->parameters.end(), [&](const ParameterRow& r) { return r.name == key->name; });
  if (row == def_->parameters.end()) return std::nullopt;
  const bool whole = value == std::floor(value);
  if (text) {
    if (row->type != ParameterType::text) return plain_text(id::value_number, lang);
    return std::nullopt;  // the text is accepted here, because the control checks its characters when it reads the parameter
  }
  if (!key->bit.empty()) {
    const bool number = key->bit.size() == 1 && key->bit[0] >= '0' && key->bit[0] <= '7';
    const bool known = number || std::find(row->bits.begin(), row->bits.end(), key->bit) != row->bits.end();
    if (row->type != ParameterType::bits || !known) return plain_text(id::known_bit, lang);
    if (value != 0 && value != 1) return plain_text(id::value_of_bit, lang);
    return std::nullopt;
  }
  const bool counts = row->type == ParameterType::whole || row->type == ParameterType::real;
  if (!counts || (value >= row->least && value <= row->most && (whole || row->type == ParameterType::real))) return std::nullopt;
  return translated_in(lang, row->type == ParameterType::whole ? id::value_whole_within : id::value_within, row->least, row->most);
}

SetupRange SetupNamesOf::range(const SetupKey& row) const {
  if (row.path != "skip" || def_ == nullptr || def_->grammar.named_blocks) return row.range;  // `/` is switch 0 of the Sinumerik
  return def_->grammar.skip_levels ? SetupRange{1, 9} : SetupRange{1, 1};
}

}  // namespace kadr
