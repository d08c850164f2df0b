// Describes the steps of a canned cycle in words. The data are those that the engine executes: the control's step list, its operations (nct
// 18.1) or the blocks of the cycle's macro. This file is used by out/text/explain/code_page and out/text/explain/word_text.

#include "out/text/explain/cycle_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "config/control/drill_steps.h"
#include "out/text/explain/asked_code.h"
#include "out/text/in_language.h"
#include "texts/explain_cycle.h"

namespace kadr {
namespace {

namespace cycle_ids = texts::explain_cycle;

// Texts of the steps, in the order of the enum CycleStep.
constexpr std::array<PlainText, static_cast<std::size_t>(CycleStep::count)> step_texts = {
    cycle_ids::feed_to_bottom,
    cycle_ids::rapid_to_bottom,
    cycle_ids::rapid_back,
    cycle_ids::feed_back,
    cycle_ids::dwell,
    cycle_ids::spindle_stop,
    cycle_ids::spindle_reversed,
    cycle_ids::spindle_as_before,
    cycle_ids::spindle_oriented,
    cycle_ids::operator_goes_on,
    cycle_ids::full_pecks,
    cycle_ids::short_pecks,
    cycle_ids::aside_in_plane,
    cycle_ids::back_over_hole,
    cycle_ids::up_to_k,
    cycle_ids::passes_by_parameter,
};

// Texts of the drilling steps, in the order of the enum DrillStep. The steps `end` and `stop` have no text, since they are no motions.
constexpr std::array<std::optional<PlainText>, static_cast<std::size_t>(DrillStep::manual) + 1> drill_texts = {
    std::nullopt,
    cycle_ids::to_level,
    std::nullopt,
    cycle_ids::feed_to_bottom,
    cycle_ids::feed_to_bottom_fixed,
    cycle_ids::short_pecks_by_e,
    cycle_ids::full_pecks_by_e,
    cycle_ids::tap_down,
    cycle_ids::dwell_p,
    cycle_ids::feed_back_to_r,
    cycle_ids::feed_back_to_r_fixed,
    cycle_ids::tap_up,
    cycle_ids::rapid_back_to_point,
    cycle_ids::initial_point_by_g98,
    cycle_ids::to_initial_point,
    cycle_ids::aside_in_space,
    cycle_ids::back_over_hole,
    cycle_ids::spindle_clockwise,
    cycle_ids::spindle_counter_clockwise,
    cycle_ids::spindle_stop_m5,
    cycle_ids::spindle_oriented_m19,
    cycle_ids::position_loop_closed,
    cycle_ids::withdrawal_by_hand,
};

std::string numbered(const std::vector<std::string>& steps, std::string_view head) {
  if (steps.empty()) return {};
  std::string text = fmt::format("  {}:\n", head);
  for (std::size_t i = 0; i < steps.size(); ++i) text += fmt::format("    {}. {}\n", i + 1, steps[i]);
  return text;
}

/// Returns the steps of a drilling cycle in words. `by_e`: true if the word E sets the distance by which the tool retracts between pecks;
/// false if a parameter of the control sets it.
std::vector<std::string> drilling_steps(const DrillCycle& cycle, bool by_e, Lang lang) {
  const auto text_for = [&](DrillStep step) -> std::optional<PlainText> {
    if (!by_e && step == DrillStep::break_chips) return cycle_ids::short_pecks;
    if (!by_e && step == DrillStep::clear_chips) return cycle_ids::full_pecks;
    return drill_texts[static_cast<std::size_t>(step)];
  };
  std::vector<std::string> steps;
  if (cycle.steps[0] == DrillStep::approach || cycle.code == back_boring) steps.emplace_back(plain_text(cycle_ids::over_hole, lang));
  for (const DrillStep step : cycle.steps)
    if (const auto text = text_for(step)) steps.emplace_back(plain_text(*text, lang));
  return steps;
}

/// Describes the blocks of a cycle's macro as motions. The motion code of a block remains in force in the following blocks.
class BodyTeller {
 public:
  BodyTeller(const ControlDef& def, Lang lang) : def_(def), lang_(lang) {}

  std::string block(const std::string& line) {
    pieces_.clear();
    std::string axes;
    std::optional<std::string> feed;
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      if (word.size() < 2) continue;
      if (code(word)) continue;
      const AddressRow& row = def_.address(word[0] >= 'A' && word[0] <= 'Z' ? word[0] : 'A');
      const std::string value = word.substr(word[1] == '+' ? 2 : 1);
      const std::string equals = fmt::format("{} = {}", word[0], value);
      if (row.function == Function::axis) axes += (axes.empty() ? "" : ", ") + equals;
      else if (row.function == Function::feed_word) feed = value;
      else if (row.function != Function::count) add(row.phase, fmt::format("{}: {}", equals, in_language(row.text, lang_)));
    }
    if (!axes.empty()) {
      const std::string motion = translated_in(lang_, motion_, axes);
      add(Phase::motion, feed ? translated_in(lang_, cycle_ids::motion_with_feed, motion, *feed) : motion);
    }
    std::stable_sort(pieces_.begin(), pieces_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::string text;
    for (const auto& [rank, piece] : pieces_) text += (text.empty() ? "" : "; ") + piece;
    return text;
  }

 private:
  void add(Phase phase, std::string piece) { pieces_.emplace_back(def_.order[static_cast<std::size_t>(phase)], std::move(piece)); }

  bool code(const std::string& word) {
    if (word[0] != 'G' && word[0] != 'M') return false;
    const std::string plain = code_named(word);
    const auto row = std::find_if(def_.codes.begin(), def_.codes.end(), [&](const CodeRow& one) { return code_named(one.code) == plain; });
    if (row == def_.codes.end()) return false;
    if (row->function == Function::rapid) motion_ = cycle_ids::rapid_motion;
    else if (row->function == Function::linear) motion_ = cycle_ids::feed_motion;
    else if (row->function != Function::dwell) add(row->phase, fmt::format("{} ({})", in_language(row->text, lang_), plain));
    return true;
  }

  const ControlDef& def_;
  Lang lang_;
  TextId<1> motion_ = cycle_ids::other_motion;
  std::vector<std::pair<std::uint8_t, std::string>> pieces_;
};

std::uint64_t bits(std::string_view letters) {
  std::uint64_t all = 0;
  for (const char c : letters) all |= 1ull << (c - 'A');
  return all;
}

/// True for G87. A bit of the set-up selects whether G87 is boring with manual withdrawal or back boring (nct 18.1.13).
bool may_bore_back(const DrillCycle& cycle) { return cycle.code + 1000 == back_boring; }

std::int32_t drill_code(const CodeRow& row) { return row.arg != 0 ? row.arg : row.tenth; }

}  // namespace

std::string steps_text(const ControlDef& def, const CycleRow& row, Lang lang) {
  std::vector<std::string> steps;
  const bool by_code = row.call_number == 0 && !row.steps.empty();
  if (by_code) steps = {plain_text(cycle_ids::over_hole, lang), plain_text(cycle_ids::to_level, lang)};
  for (const CycleStep step : row.steps) steps.emplace_back(plain_text(step_texts[static_cast<std::size_t>(step)], lang));
  BodyTeller teller(def, lang);
  std::istringstream body(row.body);
  for (std::string line; std::getline(body, line);)
    if (std::string text = teller.block(line); !text.empty()) steps.push_back(std::move(text));
  return numbered(steps, plain_text(cycle_ids::steps, lang));
}

std::string steps_text(const ControlDef& def, const CodeRow& row, Lang lang) {
  if (row.function != Function::drilling) return {};
  const DrillCycle* const cycle = drill_cycle(drill_code(row));
  if (cycle == nullptr) return {};
  const bool by_e = (row.takes & bits("E")) != 0;
  std::string text = numbered(drilling_steps(*cycle, by_e, lang), plain_text(cycle_ids::steps, lang));
  if (!may_bore_back(*cycle)) return text;
  constexpr std::string_view nct_parameter = "N0607 #1 ORI = 1";
  const std::string head = def.lineage.empty() ? translated_in(lang, cycle_ids::steps_if_oriented_by_parameter, nct_parameter)
                                               : translated_in(lang, cycle_ids::steps_if_oriented);
  return text + numbered(drilling_steps(*drill_cycle(back_boring), by_e, lang), head);
}

std::uint64_t words_used(const CodeRow& row) {
  std::uint64_t used = ~bits("QEPIJK");
  const auto take = [&](const DrillCycle& cycle) {
    using enum DrillStep;
    for (const DrillStep step : cycle.steps) {
      if (step == break_chips || step == clear_chips || step == tap_down) used |= bits("QE");
      if (step == pause) used |= bits("P");
      if (step == shift_out) used |= bits("IJK");
    }
  };
  if (row.function != Function::drilling) return ~0ull;
  const DrillCycle* const cycle = drill_cycle(drill_code(row));
  if (cycle == nullptr) return ~0ull;
  take(*cycle);
  if (may_bore_back(*cycle)) take(*drill_cycle(back_boring));
  return used;
}

}  // namespace kadr
