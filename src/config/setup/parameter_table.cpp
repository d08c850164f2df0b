// Reads controls/NAME-parameters.toml as rows of parameters (nct 24). Used by the rest of config; tested by
// tests/config/parameter_table_test.cpp.

#include "config/setup/parameter_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "config/tools/toml_tools.h"
#include "texts/control_file.h"

namespace kadr {

namespace {

using Failed = tl::unexpected<std::string>;
using toml_tools::place;

constexpr std::array<std::string_view, 4> scopes = {"global", "channel", "axis", "spindle"};
constexpr std::array<std::string_view, 4> types = {"bits", "whole", "real", "text"};
constexpr std::array<std::string_view, 3> classes = {"run_time", "restart", "emergency"};
constexpr std::array<std::string_view, 12> keys_of_row = {"scope", "type", "when", "least", "most",   "initial",
                                                          "bits",  "used", "en",   "ru",    "manual", "as"};
constexpr std::size_t bits_with_number = 8;  // number of bits of a parameter that have a bit number (nct 24.0)
// Greatest number of bits of a parameter. The value is a double, which represents whole numbers up to 2^53 exactly.
constexpr std::size_t max_bits = 48;
constexpr double whole_least = -2147483648.;  // least whole number that a parameter may have: nct 24.0 has 32 bits, signed or unsigned
constexpr double whole_most = 4294967295.;

/// Reads one row of the table and stores the first fault that it finds.
class RowReader {
 public:
  RowReader(const std::string& file, const toml::table& table) : file_(file), table_(table) {}

  ParameterRow row(std::string_view key) {
    for (const auto& [name, node] : table_)
      if (std::find(keys_of_row.begin(), keys_of_row.end(), name.str()) == keys_of_row.end())
        fault_at(name.str(), "unknown key '" + std::string(name.str()) + "'");
    ParameterRow row;
    row.name = key;
    row.number = number_of(key);
    row.scope = static_cast<ParameterScope>(one_of("scope", scopes, scopes.size()));
    row.type = static_cast<ParameterType>(one_of("type", types, types.size()));
    row.when = static_cast<ParameterClass>(one_of("when", classes, 0));
    const bool whole = row.type == ParameterType::whole;
    row.least = number("least", whole ? whole_least : row.least);
    row.most = number("most", whole ? whole_most : row.most);
    row.initial = number("initial", 0);
    if (row.least > row.most) fault_at("least", "least is above most");
    if (row.type != ParameterType::real && row.initial != std::floor(row.initial)) fault_at("initial", "initial must be a whole number");
    row.used = value("used", false, "true or false");
    bits(row);
    row.text = toml_tools::text_of(table_);
    if (row.text.en.empty()) fault_at("en", "en is missing");
    row.manual = value("manual", std::string(), "a text");
    std::istringstream meanings(value("as", std::string(), "a text"));
    for (std::string meaning; meanings >> meaning;) row.means.push_back(meaning);
    if (row.type == ParameterType::bits && row.means.size() > row.bits.size()) fault_at("as", "as: more words than bits");
    return row;
  }
  const std::string& fault() const { return fault_; }

 private:
  void fault_at(std::string_view key, const std::string& sentence) {
    if (fault_.empty()) fault_ = place(file_, table_, key) + sentence;
  }

  template <class T>
  T value(std::string_view key, T otherwise, const std::string& form) {
    const toml::node* const node = table_.get(key);
    if (node == nullptr) return otherwise;
    if (const auto value = node->value<T>(); value && node->is_boolean() == std::is_same_v<T, bool>) return *value;
    fault_at(key, std::string(key) + " must be " + form);
    return otherwise;
  }

  double number(std::string_view key, double otherwise) {
    const double number = value(key, otherwise, "a number");
    if (std::isfinite(number)) return number;
    fault_at(key, std::string(key) + " must be a number");
    return otherwise;
  }

  /// Converts "0107" to 107; returns -1 for letters, which are the name of a parameter whose number the manual does not give.
  std::int32_t number_of(std::string_view key) {
    const bool digits = key.find_first_not_of("0123456789") == std::string_view::npos;
    const bool letters = key.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ") == std::string_view::npos;
    if ((digits && key.size() != 4) || !(digits || letters) || key.empty())
      fault_at("", "'" + std::string(key) + "': a parameter is named by four digits, or by capital letters");
    return digits && key.size() == 4 ? std::stoi(std::string(key)) : -1;
  }

  /// Returns the index, in `words`, of the word that is the key's value.
  template <std::size_t N>
  std::size_t one_of(std::string_view key, const std::array<std::string_view, N>& words, std::size_t otherwise) {
    const toml::node* const node = table_.get(key);
    const auto* const found = std::find(words.begin(), words.end(), node == nullptr ? "" : node->value_or(std::string_view()));
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    if (node == nullptr && otherwise < N) return otherwise;
    std::string list;
    for (const std::string_view word : words) list += (list.empty() ? "" : ", ") + std::string(word);
    fault_at(key, std::string(key) + " must be one of " + list);
    return 0;
  }

  /// Reads a text such as "REN ASH - ABS | cut": names of the bits from bit 0 on. Names after the bar have no known bit number, and are
  /// stored from the ninth element on.
  void bits(ParameterRow& row) {
    const std::string text = value("bits", std::string(), "a text");
    if (!text.empty() && row.type != ParameterType::bits) fault_at("bits", "bits, but the type is not bits");
    std::istringstream words(text);
    bool bar = false;
    for (std::string word; words >> word;) {
      if (word == "|") {
        if (bar || row.bits.size() > bits_with_number) fault_at("bits", "bits: at most eight names, a bar, the others");
        bar = true;
        row.bits.resize(bits_with_number);
        continue;
      }
      if (word == "-") word.clear();
      if (!word.empty() && std::find(row.bits.begin(), row.bits.end(), word) != row.bits.end())
        fault_at("bits", "bits: '" + word + "' twice");
      row.bits.push_back(word);
    }
    if (row.bits.size() > max_bits) fault_at("bits", "bits: at most " + std::to_string(max_bits));
  }

  const std::string& file_;
  const toml::table& table_;
  std::string fault_;
};

using Rows = tl::expected<std::vector<ParameterRow>, std::string>;

/// Returns the rows of the table `name` that the key `extends` names; no rows if the table extends none. A row of a table that has the
/// value `false` removes the row of the extended table.
Rows extended_rows(const toml::table& table, const std::string& file) {
  const toml::node* const name = table.get("extends");
  if (name == nullptr) return std::vector<ParameterRow>();
  auto rows = load_parameters(name->value_or(std::string()));
  if (!rows) return Failed(place(file, *name) + rows.error());
  std::erase_if(*rows, [&](const ParameterRow& row) { return table.contains(row.name); });
  return rows;
}

Rows rows_of(const toml::table& table, const std::string& file) {
  auto extended = extended_rows(table, file);
  if (!extended) return extended;
  std::vector<ParameterRow> rows = std::move(*extended);
  for (const auto& [key, node] : table) {
    if (key == "extends" || node.value<bool>() == false) continue;
    if (!node.is_table()) return Failed(place(file, node) + translated(texts::control_file::parameter_is_table));
    RowReader reader(file, *node.as_table());
    rows.push_back(reader.row(key.str()));
    if (!reader.fault().empty()) return Failed(reader.fault());
  }
  // Parameters without a number have the number -1. As an unsigned value it is the greatest, so these parameters are sorted last.
  const auto rank = [](const ParameterRow& row) { return static_cast<std::uint32_t>(row.number); };
  std::stable_sort(rows.begin(), rows.end(), [&](const ParameterRow& a, const ParameterRow& b) { return rank(a) < rank(b); });
  return rows;
}

}  // namespace

bool is_parameter_table(std::string_view name) { return name.ends_with("-parameters"); }

Rows parse_parameters(std::string_view toml, const std::string& file) {
  const auto table = toml_tools::parsed(toml, file);
  return table ? rows_of(*table, file) : Failed(table.error());
}

Rows load_parameters(const std::string& name) {
  const std::string file = "controls/" + name + ".toml";
  const auto text = is_parameter_table(name) ? toml_tools::embedded_text(file) : std::nullopt;
  if (!text) return Failed(translated(texts::control_file::no_parameter_table, name));
  auto rows = rows_of(toml_tools::embedded_table(file).value(), file);
  // On failure, the text is parsed again, because only its nodes have line numbers for the message
  return rows ? rows : parse_parameters(*text, file);
}

}  // namespace kadr
