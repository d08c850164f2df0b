#pragma once
// ControlLoader: converts a control file, already merged with the files that it extends, to a ControlDef. It has one method per section.
// Only control_file.cpp uses it.

#include <initializer_list>
#include <map>
#include <string>
#include <vector>

#include "config/control/control_def.h"
#include "config/control/function.h"
#include "config/setup/parameter_table.h"
#include "config/tools/toml_tools.h"
#include "texts/control_file.h"

namespace kadr {

using Failed = tl::unexpected<std::string>;
using Done = tl::expected<void, std::string>;

/// Returns from the enclosing function with the error sentence of `expression`, if `expression` has failed.
#define KADR_LOAD(expression)                                            \
  do {                                                                   \
    if (auto done_ = (expression); !done_) return Failed(done_.error()); \
  } while (false)

/// Returns the end of an error sentence about an unknown name, which suggests the nearest known name; empty if `near` is empty.
inline std::string nearest_hint(std::string_view near) {
  return near.empty() ? std::string() : translated(texts::control_file::nearest, near);
}

/// Translates an error of lang/block/format, for example `format "3G2X" is not understood: the address stands twice`, or only its reason.
std::string format_fault_message(const std::string& fault);

inline constexpr std::uint32_t max_variables = first_unwritten_variable;

class ControlLoader {
 public:
  ControlLoader(const toml::table& file, std::string name) : file_(file), name_(std::move(name)) {}
  tl::expected<ControlDef, std::string> load();

 private:
  Done sections();
  Done names();
  Done known_keys(const toml::table& table, const std::vector<std::string_view>& known) const;
  /// Returns the error for a key that is not in `known`. The error sentence suggests the nearest known key.
  tl::unexpected<std::string> unknown_key(const toml::node& node, std::string_view key, const std::vector<std::string_view>& known,
                                          TextId<1> what = texts::control_file::unknown_key) const;
  /// Returns the table of the file under a key. If the value is not a table, load() fails.
  const toml::table* section(std::string_view key);
  /// Returns the list under a key of a row. If the value is not a list, load() fails.
  const toml::array* list(const toml::table& row, std::string_view key);
  /// Returns the text of a key. If the value is not a text, load() fails.
  std::string text(const toml::table& row, std::string_view key);
  /// Fails if the user's own file has this key, which has no effect. The key is accepted if it is inherited, because it may have an effect
  /// in the base control.
  Done no_effect(const toml::table& row, std::string_view key, const std::string& why) const;
  bool is_own(const toml::node& node) const;
  /// Returns the whole number of a key, 0 to `most`. If the value is anything else, load() fails.
  std::uint32_t whole(const toml::table& row, std::string_view key, std::uint32_t otherwise, std::uint32_t most);
  /// Returns the value of a key, which must have type T. If the value has another type, load() fails.
  template <class T>
  T typed(const toml::table& row, std::string_view key, T otherwise) {
    const toml::node* const node = row.get(key);
    if (node == nullptr) return otherwise;
    if (const auto value = node->value<T>(); value && node->is_boolean() == std::is_same_v<T, bool>) return *value;
    if (bad_value_.empty()) bad_value_ = toml_tools::place(name_, *node) + translated(texts::control_file::must_be_flag, key);
    return otherwise;
  }
  /// Reads the number of a key into `to`. If the number is outside the range, load() fails.
  void ranged(const toml::table& row, std::string_view key, const NumberRange& range, double& to);
  Done dialect();
  Done grammar();
  // ---- [expressions] (control_loader_expressions.cpp)
  Done expressions();
  Done expression_rows(const toml::table& of, std::string_view key, ExpressionRows& to);
  tl::expected<ExpressionRow, std::string> expression_row(std::string_view key, std::string_view written, const toml::node& node);
  char first_letter(const toml::table& t, std::string_view key);
  // ---- [behaviour] (control_loader_behaviour.cpp)
  Done behaviour();
  template <class Choice>
  Done choice(const toml::table& row, std::string_view key, std::initializer_list<std::string_view> words, Choice& to);
  Done choices(const toml::table& t);
  Done arc_difference(const toml::table& t);
  void figures();
  Done axes();
  int axis_named(const std::string& name) const;
  Done order();
  /// Returns the phase of a row: its key `phase`, or else the phase of its function. The control's order must list this phase.
  tl::expected<Phase, std::string> phase_of(const toml::table& row, Function function);
  // Functions of the engine. Their code is in control_loader_functions.cpp.

  /// Returns the function in the key `does` of a row, if the engine can execute it on this control. `name_of_row` is used in messages.
  tl::expected<Function, std::string> function_of(const toml::table& row, CalledBy by, const std::string& name_of_row);
  std::string nearest_function(std::string_view name, CalledBy by) const;
  bool has(Needs needs) const;
  Done check_address(char letter, const toml::table& row, const AddressRow& a) const;
  Done check_code(const toml::table& row, const CodeRow& c) const;
  // Checks of settings that need or exclude each other. Their code is in control_loader_rules.cpp.
  Done check_machine();
  Done check_behaviour();
  Done check_grammar();
  Done check_axes() const;
  Done check_functions();
  Done check_cycle(const toml::table& row, const CycleRow& c) const;
  Done check_variable(const toml::table& row, const VariableRow& v) const;
  Done check_end_code(const toml::node& node, const CodeRow& c) const;
  bool does(std::initializer_list<Function> functions) const;
  Done addresses();
  bool sign_address(std::string_view text);
  Done address(char letter, const toml::table& row);
  Done word_format(char letter, const toml::table& row, const AddressRow& a);
  Done groups();
  int group_named(std::string_view name) const;
  /// Converts letters such as "XYZ" to a letter mask. Every letter must be an address of this control; this is checked when all sections
  /// have been read.
  std::uint64_t letters(const std::string& text) const;
  /// Converts the text of a key to a letter mask. If a character is neither a letter nor in `also_allowed`, load() fails.
  std::uint64_t letters(const toml::table& row, std::string_view key, std::string_view also_allowed = "");
  static std::uint64_t letter_bit_of(char c) { return std::uint64_t{1} << (c - 'A'); }
  Done codes(std::string_view key, char letter);
  Done code(char letter, double number, const toml::table& row);
  /// Reads the key "other": the range of M codes without rows of their own that go to the machine.
  Done other_codes(const toml::table& row, char letter);
  std::uint16_t cycle_named(std::string_view name) const;
  Done cycles();
  Done cycle_parameters(const toml::table& to, CycleRow& cycle) const;
  std::int32_t row_named(const std::string& code) const;
  Done initial_codes();
  Done variables();
  /// Reads the key "parameters", the name of the file of controls/ that contains the parameter table.
  Done parameters();
  Done systems();
  Done variable(const toml::table& row);
  tl::expected<VariableRange, std::string> variable_range(const toml::node& node) const;
  Done alarms();
  // ---- [convert], encoding (control_loader_convert.cpp)
  Done encoding();
  Done machine_codes();
  Done machine_code(std::uint32_t code, const std::string& control, const toml::node& node);
  static std::map<std::int32_t, double> coded_progression();
  Done code_table(std::string_view key, std::map<std::int32_t, double>& to);
  const toml::table& file_;
  std::string name_;
  ControlDef def_;
  std::map<char, std::uint8_t> most_codes_;
  std::vector<std::string> initial_;
  std::string bad_value_;  // message of the first fault that whole(), text(), section() … have found
};

}  // namespace kadr
