// Reads values of the set-up file; error sentences name the key. Used by the rest of config.

#include "config/setup/setup_reader.h"

#include <cmath>

#include "texts/setup_check.h"

namespace kadr::setup_reader {

void wrong(const std::string& key, const std::string& form) { throw Wrong{key, translated(texts::setup_check::must_be, key, form)}; }

double number(const Json& value, const std::string& key) {
  if (!value.is_number() || !std::isfinite(value.get<double>())) wrong(key, "a number");
  return value.get<double>();
}

double within(const Json& value, const std::string& key, const NumberRange& range) {
  const double n = number(value, key);
  if (!is_within(n, range)) wrong(key, range_in_words(range));
  return n;
}

int whole(const Json& value, const std::string& key) {
  const double n = number(value, key);
  if (n != std::floor(n) || std::abs(n) > 1e9) wrong(key, "a whole number");
  return static_cast<int>(n);
}

int whole_within(const Json& value, const std::string& key, std::pair<int, int> range) {
  const int n = whole(value, key);
  if (n < range.first || n > range.second)
    wrong(key, "a whole number, " + std::to_string(range.first) + " to " + std::to_string(range.second));
  return n;
}

std::uint32_t bits(const Json& value, const std::string& key) {
  const double n = number(value, key);
  if (n != std::floor(n) || n < 0 || n > UINT32_MAX) wrong(key, "a whole number, 0 to 4294967295");
  return static_cast<std::uint32_t>(n);
}

bool flag(const Json& value, const std::string& key) {
  if (!value.is_boolean()) wrong(key, "true or false");
  return value.get<bool>();
}

std::string word(const Json& value, const std::string& key) {
  if (!value.is_string()) wrong(key, "a text");
  return value.get<std::string>();
}

const Json& table(const Json& value, const std::string& key) {
  if (!value.is_object()) wrong(key, "a table { … }");
  return value;
}

AxisValues axis_values(const Json& value, const std::string& key) {
  constexpr double farthest = 1e7;  // greatest absolute value of a position, mm: 10 km, as in programs
  AxisValues axes;
  for (const auto& [axis, position] : table(value, key).items()) {
    axes[axis] = number(position, key + "." + axis);
    if (std::abs(axes[axis]) > farthest) wrong(key + "." + axis, "at most ten million");
  }
  return axes;
}

std::pair<double, double> limit_pair(const Json& value, const std::string& key) {
  constexpr const char* form = "[least, most]";
  if (!value.is_array() || value.size() != 2) wrong(key, form);
  const std::pair<double, double> span = {number(value[0], key), number(value[1], key)};
  if (span.first > span.second) wrong(key, form);
  return span;
}

std::optional<double> number_or_vacant(const Json& value, const std::string& key) {
  return value.is_null() ? std::nullopt : std::optional(number(value, key));
}

int row_number(const std::string& name, const std::string& key, std::pair<int, int> range) {
  const bool digits = !name.empty() && name.size() <= 9 && name.find_first_not_of("0123456789") == std::string::npos;
  const int n = digits ? std::stoi(name) : -1;
  if (n < range.first || n > range.second)
    wrong(key + "." + name, "named by a whole number" +
                                (range == any_number ? "" : ", " + std::to_string(range.first) + " to " + std::to_string(range.second)));
  return n;
}

void read_table(const Json& value, const std::string& inside, const Readers& readers) {
  for (const auto& [key, item] : table(value, inside.empty() ? "setup" : inside).items()) {
    const std::string name = inside.empty() ? key : inside + "." + key;
    const auto found = readers.find(key);
    if (found == readers.end()) wrong(name, "a key that has a reader");
    found->second(item, name);
  }
}

Reader to_number(double& to) {
  return [&to](const Json& value, const std::string& key) { to = number(value, key); };
}

Reader to_range(double& to, const NumberRange& range) {
  return [&to, &range](const Json& value, const std::string& key) { to = within(value, key, range); };
}

Reader to_count(double& to) {
  return [&to](const Json& value, const std::string& key) { to = whole_within(value, key, {0, 99'999'999}); };
}

Reader to_whole(int& to, int least, int most) {
  return [&to, least, most](const Json& value, const std::string& key) { to = whole_within(value, key, {least, most}); };
}

Reader to_flag(bool& to) {
  return [&to](const Json& value, const std::string& key) { to = flag(value, key); };
}

Reader to_word(std::string& to) {
  return [&to](const Json& value, const std::string& key) { to = word(value, key); };
}

Reader to_one_of(std::string& to, std::initializer_list<std::string_view> words) {
  return [&to, known = std::vector<std::string>(words.begin(), words.end())](const Json& value, const std::string& key) {
    if (value.is_string() && std::find(known.begin(), known.end(), value.get_ref<const std::string&>()) != known.end()) {
      to = value.get<std::string>();
      return;
    }
    std::string form;
    for (std::size_t i = 0; i < known.size(); ++i) form += (i == 0 ? "\"" : i + 1 < known.size() ? ", \"" : " or \"") + known[i] + "\"";
    wrong(key, form);
  };
}

Reader or_null(Reader reader) {
  return [reader = std::move(reader)](const Json& value, const std::string& key) {
    if (!value.is_null()) reader(value, key);
  };
}

}  // namespace kadr::setup_reader
