// Adapts a control whose axes depend on the machine (ControlDef::machine_axes()) to one channel of a machine: reads the addresses of axes,
// spindles and auxiliary functions from the set-up (spec/nct/02, 05 5.1, 11 11.1.1, 13 13.2). Used by config, control.

#include "config/machine/machine_axes.h"

#include <algorithm>

#include "lang/block/block.h"
#include "texts/machine_file.h"

namespace kadr {
namespace {

constexpr std::string_view axis_letters = "XYZUVWABC";

/// Creates the addresses one after the other and detects names that are used twice.
class Fitter {
 public:
  Fitter(ControlDef& def, const Setup& setup) : def_(def), setup_(setup) {}

  std::string run() {
    for (const char letter : axis_letters) free_letter(letter);
    // The operator I after R, as in RI0.1, makes R incremental: for data of G10, and for levels of cycles (nct 5.1).
    if (def_.grammar.operator_i) def_.grammar.word('R').increment = true;
    axes();
    auxiliary();
    increments();
    spindles();
    rows_that_take_axes();
    symbols();
    least_increments();
    machine_codes();
    if (is_set("angles_from_minus")) {  // parameter 6004#0 (spec/fanuc 5.3)
      def_.grammar.expression.functions.replace(Op::atan_turn, Op::atan);
      def_.grammar.expression.functions.replace(Op::arc_sine_turn, Op::arc_sine);
    }
    return error_;
  }

 private:
  /// Makes numbers without a decimal point count in units of 0.001 on the addresses of [grammar] least_increments, unless a parameter
  /// selects pocket calculator input (spec/fanuc 1.3).
  void least_increments() {
    constexpr std::uint8_t decimals = 3;
    if (is_set("calculator")) return;
    for (const char letter : def_.grammar.least_increments) {
      if (def_.grammar.word(letter).known) def_.grammar.word(letter).counted = decimals;
      if (const char after_comma = comma_address(letter); after_comma != 0) def_.grammar.word(after_comma).counted = decimals;
    }
  }

  /// Gives the M codes that the machine's file names rows of their own. A code that the control itself executes keeps its row. On a control
  /// that knows only the codes of its list, such as a Haas, a code becomes known by this (spec/fanuc-t 2.4, spec/haas-st 9).
  void machine_codes() {
    constexpr std::uint32_t tenths = 10;
    for (const auto& [number, text] : setup_.machine_codes) {
      const auto tenth = static_cast<std::int32_t>(number * tenths);
      const std::int32_t index = def_.row_of('M', tenth);
      const bool shared = index >= 0 && index == def_.m_user_row;
      if (index >= 0 && !shared && def_.codes[static_cast<std::size_t>(index)].function != Function::machine_function) continue;
      CodeRow row;
      if (index >= 0) row = def_.codes[static_cast<std::size_t>(index)];
      row.code = "M" + std::to_string(number);
      row.letter = 'M';
      row.tenth = tenth;
      row.function = Function::machine_function;
      row.phase = index >= 0 ? row.phase : Phase::machine;
      row.takes |= letter_bit('P') | letter_bit('Q');
      row.text = {text.first, text.second};
      if (index >= 0 && !shared) {
        def_.codes[static_cast<std::size_t>(index)] = std::move(row);
        continue;
      }
      if (def_.m_rows.size() <= static_cast<std::size_t>(tenth)) def_.m_rows.resize(static_cast<std::size_t>(tenth) + 1, -1);
      def_.m_rows[static_cast<std::size_t>(tenth)] = static_cast<std::int16_t>(def_.codes.size());
      def_.codes.push_back(std::move(row));
    }
  }

  /// Returns true if the set-up gives a value other than 0 to a parameter that the engine uses under this name.
  bool is_set(std::string_view meaning) const {
    for (const ParameterRow& row : def_.parameters)
      for (std::size_t k = 0; k < row.means.size(); ++k) {
        if (row.means[k] != meaning) continue;
        for (const auto& [key, value] : setup_.parameters) {
          const double* const number = std::get_if<double>(&value);
          if (key.name != row.name || number == nullptr || *number == 0) continue;
          const bool whole = row.type != ParameterType::bits;
          const bool in_bits = !whole && key.bit.empty() && (static_cast<std::uint64_t>(*number) >> k & 1U) != 0;
          if (whole || in_bits || key.bit == std::to_string(k) || key.bit == row.bits[k]) return true;
        }
      }
    return false;
  }

  void free_letter(char letter) {
    AddressRow& row = address(letter);
    row.letter = letter;
    row.function = Function::argument_only;
    row.phase = Phase::none;
    row.unit = WordUnit::none;
    format(letter);
  }

  /// Gives an address the format of a macro argument: a sign, any number of digits and a decimal point are permitted. A block may have any
  /// number of words with this address.
  WordFormat& format(char at) {
    WordFormat& w = def_.grammar.word(at);
    w = {};
    w.known = w.drop_zeros = w.point = w.sign = true;
    w.at_most = 0;
    return w;
  }

  AddressRow& address(char at) { return def_.addresses[static_cast<std::size_t>(at - 'A')]; }

  /// Returns the address code for a name: its letter; for a longer name, a new code.
  char address_of(const std::string& name) {
    if (name.size() == 1) return name[0];
    for (const AddressName& row : def_.grammar.names)
      if (row.text == name) return row.address;
    const auto next = static_cast<std::size_t>(first_name - 'A') + def_.grammar.names.size();
    if (next >= max_addresses) {
      error_ = translated(texts::machine_file::too_many_names, name);
      return 'X';
    }
    const char code = static_cast<char>('A' + static_cast<int>(next));
    def_.grammar.names.push_back({name, code});
    def_.grammar.named |= 1u << (name[0] - 'A');
    return code;
  }

  void axes() {
    if (!setup_.axes.empty()) def_.axes = setup_.axes;
    else if (def_.behaviour.lathe != Lathe::none) def_.axes = {"X", "Z"};  // the usual axes of a lathe
    if (def_.axes.size() > max_axes) error_ = translated(texts::machine_file::too_many_axes, max_axes);
    def_.axes.resize(std::min(def_.axes.size(), max_axes));
    std::size_t number = 1;
    for (const auto& [channel, other] : setup_.channels)
      if (channel < setup_.channel) number += other.axes.empty() ? 3 : other.axes.size();
    def_.channel = static_cast<std::uint8_t>(setup_.channel);
    def_.rotary = 0;
    for (std::size_t a = 0; a < def_.axes.size(); ++a, ++number) {
      def_.axis_numbers[a] = static_cast<std::uint8_t>(number);
      axis(a, def_.axes[a]);
    }
    def_.grammar.word('R').increment = def_.grammar.operator_i;  // R accepts the operator I in drilling cycles (nct 5.1)
  }

  void axis(std::size_t a, const std::string& name) {
    if (name.empty() || axis_letters.find(name[0]) == std::string_view::npos || name.size() > 3) {
      error_ = translated(texts::machine_file::no_axis_name, name);
      return;
    }
    const char code = address_of(name);
    AddressRow& row = address(code);
    if (row.function == Function::axis) error_ = translated(texts::machine_file::axis_given_twice, name);
    row.letter = code;
    row.function = Function::axis;
    row.axis = static_cast<std::uint8_t>(a);
    const bool letter_turns = name[0] >= 'A' && name[0] <= 'C';
    const std::string index = std::to_string(def_.axis_numbers[a]);
    const bool given = setup_gives(setup_, "0106", name, "1") || setup_gives(setup_, "0106", index, "1");
    const bool turns = given ? setup_number(setup_, "0106", name, "1") != 0 || setup_number(setup_, "0106", index, "1") != 0 : letter_turns;
    if (turns) def_.rotary |= 1u << a;
    row.unit = turns ? WordUnit::angle : WordUnit::length;
    WordFormat& w = format(code);
    w.increment = w.bare = true;
    def_.grammar.axis_numbers[static_cast<std::size_t>(code - 'A')] = def_.axis_numbers[a];
  }

  /// Creates the addresses of auxiliary functions. Parameters N1333 … N1335 select their letters from A, B, C, U, V, W (nct 13.2).
  void auxiliary() {
    constexpr const char* names[] = {"1333", "1334", "1335"};
    for (std::uint8_t i = 0; i < 3; ++i) {
      std::string letter = letter_of(names[i], std::to_string(setup_.channel));
      if (letter.empty()) letter = letter_of(names[i], "");
      if (letter.size() != 1 || axis_letters.find(letter[0]) == std::string_view::npos) continue;
      AddressRow& row = address(letter[0]);
      if (row.function == Function::axis) continue;  // INFERRED: if an axis has the same name, the address is that of the axis
      row.function = Function::auxiliary_word;
      row.phase = Phase::machine;
      row.number = static_cast<std::uint8_t>(i + 1);
      // The value of an auxiliary function must not be negative and has at most eight digits (nct 13.2); INFERRED: it must be whole
      row.least = 0;
      row.most = 99'999'999;
      row.whole = true;
    }
  }

  /// Creates U, V, W as incremental X, Y, Z, if these letters are neither axes nor auxiliary functions (nct 5.1); on a lathe also H as
  /// incremental C (spec/fanuc-t 3.2). Only for lathes, and for controls with the operator I, which makes a single word incremental.
  void increments() {
    const bool lathe = def_.behaviour.lathe != Lathe::none;
    if (!def_.grammar.operator_i && !lathe) return;
    constexpr std::pair<char, char> pairs[] = {{'U', 'X'}, {'V', 'Y'}, {'W', 'Z'}, {'H', 'C'}};
    for (const auto& [letter, of] : pairs) {
      AddressRow& row = address(letter);
      const AddressRow main = address(of);
      const bool free = row.function == Function::argument_only || (letter == 'H' && row.function == Function::word_of_code);
      if (!free || main.function != Function::axis) continue;
      row.letter = letter;
      row.function = Function::increment_axis;
      row.phase = Phase::none;
      row.axis = main.axis;
      row.unit = main.unit;
      row.least = -1e300;
      row.most = 1e300;
      row.whole = false;
      // U, V, W also accept the operator I, which changes nothing (nct 1.1)
      format(letter).increment = def_.grammar.operator_i;
    }
  }

  void spindles() {
    constexpr int most = 16;
    for (int number = 1; number <= most; ++number) {
      const auto given = setup_.spindles.find(number);
      const std::string index = std::to_string(number);
      std::string name = given != setup_.spindles.end() ? given->second.name : "";
      if (name.empty()) name = "S" + letter_of("0605", index) + letter_of("0606", index);
      if (name.size() > 1) spindle_address(name, number, Function::spindle_word, Phase::speed);
      const std::string axis = letter_of("0817", index) + letter_of("0818", index) + letter_of("0819", index);
      if (!axis.empty()) spindle_address(axis, number, Function::spindle_axis_word, Phase::spindle);
    }
  }

  void spindle_address(const std::string& name, int number, Function function, Phase phase) {
    const char code = address_of(name);
    AddressRow& row = address(code);
    if (row.function == Function::axis) error_ = translated(texts::machine_file::spindle_is_axis, name);
    row.letter = code;
    row.function = function;
    row.phase = phase;
    row.number = static_cast<std::uint8_t>(number);
    row.unit = WordUnit::none;
    format(code).increment = function == Function::spindle_axis_word;
  }

  /// Returns the value of a parameter that is a character. The set-up may give it as text or as character code.
  std::string letter_of(const std::string& name, const std::string& index) const {
    const auto found = setup_.parameters.find({name, index, ""});
    if (found == setup_.parameters.end()) return {};
    if (const auto* text = std::get_if<std::string>(&found->second)) return *text == "0" ? std::string() : *text;
    const double code = std::get<double>(found->second);
    return code >= '0' && code <= 'Z' ? std::string(1, static_cast<char>(code)) : std::string();
  }

  void rows_that_take_axes() {
    std::uint64_t mask = 0;
    for (std::size_t i = 0; i < max_addresses; ++i)
      if (def_.addresses[i].function == Function::axis || def_.addresses[i].function == Function::increment_axis)
        mask |= std::uint64_t{1} << i;
    for (CodeRow& row : def_.codes)
      if (row.takes_all_axes) row.takes |= mask | letter_bit(indirect_axis);
  }

  /// Collects the names of the system variables. The members of a family (#_WZP1 … #_WZP99) are listed one by one.
  void symbols() {
    std::vector<VariableName>& all = def_.grammar.symbols;
    all.clear();
    for (const VariableRow& row : def_.variables) {
      if (row.symbol.empty() || row.ranges.empty()) continue;
      const VariableRange& range = row.ranges.back();
      for (std::uint32_t p = 0; p < range.repeat; ++p) {
        const std::string name = row.symbol + (range.repeat > 1 ? std::to_string(p + 1) : "");
        all.push_back({name, range.from + p * range.stride, range.count, row.first_index, range.count > 1});
      }
    }
    std::sort(all.begin(), all.end(), [](const VariableName& a, const VariableName& b) { return a.text < b.text; });
  }

  ControlDef& def_;
  const Setup& setup_;
  std::string error_;
};

}  // namespace

namespace {

void take_figures(ControlDef& def, const Setup& setup) {
  for (const auto& [meaning, figure] : figures_of_machine)
    for (const ParameterRow& row : def.parameters)
      if (!row.means.empty() && row.means.front() == meaning && setup_gives(setup, row.name, "", ""))
        def.behaviour.*figure = setup_number(setup, row.name);
}

}  // namespace

std::string fit_to_machine(ControlDef& def, const Setup& setup) {
  if (!def.machine_axes()) {
    take_figures(def, setup);
    return {};
  }
  return Fitter(def, setup).run();
}

std::string system_of(const ControlDef& def, const Setup& setup) {
  for (const auto& [parameter, control] : def.systems) {
    const std::size_t hash = parameter.find('#');
    const std::string name = parameter.substr(0, hash), bit = hash == std::string::npos ? std::string() : parameter.substr(hash + 1);
    if (setup_number(setup, name, "", bit) != 0) return control;
    // a parameter of bits may also be given as a whole number
    const auto all = static_cast<std::uint64_t>(std::max(setup_number(setup, name), 0.0));
    if (!bit.empty() && (all >> std::stoul(bit) & 1U) != 0) return control;
  }
  return {};
}

double setup_number(const Setup& setup, const std::string& name, const std::string& index, const std::string& bit) {
  const auto found = setup.parameters.find({name, index, bit});
  if (found == setup.parameters.end()) return 0;
  const auto* number = std::get_if<double>(&found->second);
  return number != nullptr ? *number : 0;
}

bool setup_gives(const Setup& setup, const std::string& name, const std::string& index, const std::string& bit) {
  return setup.parameters.contains({name, index, bit});
}

}  // namespace kadr
