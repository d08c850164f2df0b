#pragma once
// Reads values of the set-up file; error sentences name the key. Only setup*.cpp use it.

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/range.h"
#include "config/setup/setup.h"

namespace kadr::setup_reader {

using Json = nlohmann::json;

inline constexpr int max_number = 999'999'999;  // greatest number that a row of a table may have as its name
inline constexpr int max_channels = 8;
inline constexpr int max_spindles = 16;
inline constexpr int max_inputs = 8;  // greatest number of probe inputs

/// Exception inside the reader for a key or value that is wrong. read_setup() catches it and returns its error sentence.
struct Wrong {
  std::string key;
  std::string sentence;
};

[[noreturn]] void wrong(const std::string& key, const std::string& form);

/// Readers of one value each. `key` is the full name of the key, "machine.X.rapid", for the error sentence.
double number(const Json& value, const std::string& key);
double within(const Json& value, const std::string& key, const NumberRange& range);
int whole(const Json& value, const std::string& key);
int whole_within(const Json& value, const std::string& key, std::pair<int, int> range);
std::uint32_t bits(const Json& value, const std::string& key);  // reads a whole number from 0 to 4294967295
bool flag(const Json& value, const std::string& key);
std::string word(const Json& value, const std::string& key);
const Json& table(const Json& value, const std::string& key);
AxisValues axis_values(const Json& value, const std::string& key);
std::pair<double, double> limit_pair(const Json& value, const std::string& key);
std::optional<double> number_or_vacant(const Json& value, const std::string& key);

inline constexpr std::pair<int, int> any_number = {0, max_number};

/// Converts a key that is the number of a row, such as "3", to an integer.
int row_number(const std::string& name, const std::string& key, std::pair<int, int> range = any_number);

template <class T>
std::vector<T> list(const Json& value, const std::string& key, T (*read)(const Json&, const std::string&)) {
  if (!value.is_array()) wrong(key, "a list [ … ]");
  std::vector<T> items;
  for (const Json& item : value) items.push_back(read(item, key));
  return items;
}

template <class T>
void numbered(const Json& value, const std::string& key, std::map<int, T>& to, T (*read)(const Json&, const std::string&),
              std::pair<int, int> range = any_number) {
  for (const auto& [name, row] : table(value, key).items()) to[row_number(name, key, range)] = read(row, key + "." + name);
}

using Reader = std::function<void(const Json&, const std::string&)>;
using Readers = std::map<std::string, Reader>;

/// Calls the reader of each key of a table. `inside` is the name of the table; empty for the set-up itself. The keys have been checked
/// against config/setup/setup_keys already, so a key without a reader is a bug.
void read_table(const Json& value, const std::string& inside, const Readers& readers);

Reader to_number(double& to);
Reader to_range(double& to, const NumberRange& range);
Reader to_count(double& to);  // creates a reader for a whole number, 0 to 99 999 999
Reader to_whole(int& to, int least, int most);
Reader to_flag(bool& to);
Reader to_word(std::string& to);
Reader to_one_of(std::string& to, std::initializer_list<std::string_view> words);
Reader or_null(Reader reader);  // creates a reader that treats null as a missing key

/// Readers for the keys of setup_tables.cpp, setup_machine.cpp and setup_events.cpp.
Readers readers_of_tables(Setup& setup);
Readers readers_of_machine(Setup& setup);
void give_kinematics(Setup& setup);
Readers readers_of_events(Setup& setup);

}  // namespace kadr::setup_reader
