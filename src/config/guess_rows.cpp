// For config/guess and config/control_loader_words; tested by tests/config/guess_test.cpp.

#include "config/guess_rows.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "config/control_file.h"
#include "config/loader_texts.h"
#include "config/toml_tools.h"

namespace kadr {
namespace {

using loader_texts::say;
using Failed = tl::unexpected<std::string>;

constexpr std::array<TraitText, static_cast<std::size_t>(TextTrait::count)> trait_texts = {{
    {"all_numbered", "all blocks numbered", "все кадры с номерами"},
    {"few_numbered", "few block numbers", "мало номеров кадров"},
    {"decimal_points", "decimal points", "десятичные точки"},
    {"long_integers", "numbers without points", "числа без точки"},
    {"whole_lengths", "short lengths without points", "короткие размеры без точек"},
    {"plus_signs", "plus signs", "знаки «плюс»"},
    {"two_digit_codes", "codes of two digits", "коды из двух цифр"},
    {"program_number", "a program number behind %", "номер программы после %"},
}};

tl::expected<double, std::string> weight_of(const toml::node& node, std::string_view key, const std::string& file) {
  constexpr double most = 20;
  const auto weight = node.value<double>();
  if (weight && !node.is_boolean() && *weight > 0 && *weight <= most) return *weight;
  return Failed(toml_tools::place(file, node) + say("[guess] {}: a weight is a number above 0, {} at most", key, most));
}

}  // namespace

const TraitText& text_of(TextTrait trait) { return trait_texts[static_cast<std::size_t>(trait)]; }

tl::expected<GuessRows, std::string> guess_rows_of(const toml::table& guess, const std::string& file) {
  GuessRows rows;
  for (const auto& [key, node] : guess) {
    if (key.str() == "text" && node.is_table()) continue;
    const auto weight = weight_of(node, key.str(), file);
    if (!weight) return Failed(weight.error());
    rows.marks.push_back({std::string(key.str()), *weight});
  }
  const toml::table* const traits = guess["text"].as_table();
  if (traits == nullptr) return rows;
  for (const auto& [key, node] : *traits) {
    const auto known =
        std::find_if(trait_texts.begin(), trait_texts.end(), [name = key.str()](const TraitText& t) { return t.key == name; });
    if (known == trait_texts.end()) {
      std::vector<std::string_view> keys;
      for (const TraitText& t : trait_texts) keys.push_back(t.key);
      const std::string_view near = toml_tools::nearest(key.str(), keys);
      return Failed(toml_tools::place(file, node) + say("unknown key '{}'", key.str()) +
                    (near.empty() ? "" : say(", nearest: '{}'", near)));
    }
    const auto weight = weight_of(node, key.str(), file);
    if (!weight) return Failed(weight.error());
    rows.traits.emplace_back(static_cast<TextTrait>(known - trait_texts.begin()), *weight);
  }
  return rows;
}

const std::vector<GuessRows>& built_in_guess_rows() {
  static const std::vector<GuessRows> all = [] {
    std::vector<GuessRows> of;
    for (const std::string& id : built_in_controls()) {
      const std::string file = "controls/" + id + ".toml";
      const auto table = toml_tools::embedded_table(file);
      const toml::table* const guess = table ? (*table)["guess"].as_table() : nullptr;
      if (guess == nullptr) continue;
      auto rows = guess_rows_of(*guess, file);
      assert(rows);  // tests/controls_table.py loads each file
      rows->control = id;
      of.push_back(std::move(*rows));
    }
    return of;
  }();
  return all;
}

}  // namespace kadr
