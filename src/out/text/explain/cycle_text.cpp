// Describes the steps of a canned cycle in words, from the data that the engine executes: the control's step list, its operations (nct
// 18.1) or the cycle's macro body. Used by out/text/explain/code_page and out/text/explain/word_text.

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

namespace kadr {
namespace {

constexpr BothLanguages over_hole = {"rapid over the hole", "быстро в точку над отверстием"};
constexpr BothLanguages to_level = {"rapid to R", "быстро на уровень R"};

// Texts in the order of the enum CycleStep.
constexpr std::array<BothLanguages, static_cast<std::size_t>(CycleStep::count)> step_words = {
    {{"feed to the bottom", "рабочая подача до дна"},
     {"rapid to the bottom", "быстро до дна"},
     {"rapid back: to the initial level (G98) or to R (G99)", "быстрый отвод: на исходный уровень (G98) или на R (G99)"},
     {"back at feed: to the initial level (G98) or to R (G99)", "отвод на рабочей подаче: на исходный уровень (G98) или на R (G99)"},
     {"dwell", "выдержка"},
     {"spindle stop", "останов шпинделя"},
     {"spindle reversed", "реверс шпинделя"},
     {"spindle as before", "шпиндель вращается, как до цикла"},
     {"spindle oriented", "ориентация шпинделя"},
     {"programmed stop, the operator goes on", "программируемый останов, продолжает оператор"},
     {"down at feed by Q at a time; after each rapid to R and back to just above the bottom",
      "вниз на рабочей подаче по Q; после каждого прохода быстро на R и обратно, немного не доходя до дна"},
     {"down at feed by Q at a time, a little back at rapid after each",
      "вниз на рабочей подаче по Q, после каждого прохода небольшой быстрый отвод"},
     {"aside by I, J", "смещение на I, J"},
     {"back over the hole", "возврат на ось отверстия"},
     {"up at feed to K", "вверх на рабочей подаче до K"},
     {"passes of R3 from R2 down to R1: feed R0 to the pass level, dwell 0.3 s, rapid to R2",
      "проходы по R3 от R2 до R1: на подаче R0 до уровня прохода, выдержка 0,3 с, быстро на R2"}}};

// Texts in the order of the enum DrillStep; `stop` and `end` are not motions.
constexpr std::array<BothLanguages, static_cast<std::size_t>(DrillStep::manual) + 1> drill_words = {
    {{"", ""},
     to_level,
     {"", ""},
     {"feed to the bottom", "рабочая подача до дна"},
     {"feed to the bottom, overrides at 100 %", "рабочая подача до дна, корректоры 100 %"},
     {"down at feed by Q at a time, back by E at rapid after each",
      "вниз на рабочей подаче по Q, после каждого прохода быстрый отвод на E"},
     {"down at feed by Q at a time; after each rapid to R and back to E above the bottom reached",
      "вниз на рабочей подаче по Q; после каждого прохода быстро на R и обратно, не доходя E до достигнутого дна"},
     {"down together with the spindle, at once or by Q at a time", "вниз синхронно со шпинделем, за один ход или по Q"},
     {"dwell P", "выдержка P"},
     {"back to R at feed", "отвод на R на рабочей подаче"},
     {"back to R at feed, overrides at 100 %", "отвод на R на рабочей подаче, корректоры 100 %"},
     {"back to R together with the spindle, which turns the other way", "отвод на R синхронно со шпинделем, который вращается обратно"},
     {"rapid back: to R (G99) or to the initial point (G98)", "быстрый отвод: на R (G99) или в исходную точку (G98)"},
     {"with G98 rapid to the initial point", "при G98 быстро в исходную точку"},
     {"rapid to the initial point", "быстро в исходную точку"},
     {"aside by I, J, K", "смещение на I, J, K"},
     {"back over the hole", "возврат на ось отверстия"},
     {"spindle clockwise (M3)", "шпиндель по часовой стрелке (M3)"},
     {"spindle counter-clockwise (M4)", "шпиндель против часовой стрелки (M4)"},
     {"spindle stop (M5)", "останов шпинделя (M5)"},
     {"spindle oriented (M19)", "ориентация шпинделя (M19)"},
     {"spindle's position loop closed", "замыкание контура положения шпинделя"},
     {"programmed stop, withdrawal by hand (M0)", "программируемый останов, отвод вручную (M0)"}}};

std::string numbered(const std::vector<std::string>& steps, std::string_view head) {
  if (steps.empty()) return {};
  std::string text = fmt::format("  {}:\n", head);
  for (std::size_t i = 0; i < steps.size(); ++i) text += fmt::format("    {}. {}\n", i + 1, steps[i]);
  return text;
}

///   by_e  word E sets how far the tool retracts between pecks; otherwise a parameter of the control does
std::vector<std::string> drilling_steps(const DrillCycle& cycle, bool by_e, Lang lang) {
  const auto words_for = [&](DrillStep step) {
    if (!by_e && step == DrillStep::break_chips) return in_language(step_words[static_cast<std::size_t>(CycleStep::peck_break)], lang);
    if (!by_e && step == DrillStep::clear_chips) return in_language(step_words[static_cast<std::size_t>(CycleStep::peck_full)], lang);
    return in_language(drill_words[static_cast<std::size_t>(step)], lang);
  };
  std::vector<std::string> steps;
  if (cycle.steps[0] == DrillStep::approach || cycle.code == back_boring) steps.emplace_back(in_language(over_hole, lang));
  for (const DrillStep step : cycle.steps)
    if (const std::string_view text = words_for(step); !text.empty()) steps.emplace_back(text);
  return steps;
}

/// Describes the blocks of a macro body as motions; the motion code in force carries over from block to block.
class BodyTeller {
 public:
  BodyTeller(const ControlDef& def, Lang lang) : def_(def), lang_(lang) {}

  std::string block(const std::string& line) {
    pieces_.clear();
    std::string axes, feed;
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      if (word.size() < 2) continue;
      if (code(word)) continue;
      const AddressRow& row = def_.address(word[0] >= 'A' && word[0] <= 'Z' ? word[0] : 'A');
      const std::string value = word.substr(word[1] == '+' ? 2 : 1);
      const std::string equals = fmt::format("{} = {}", word[0], value);
      if (row.function == Function::axis) axes += (axes.empty() ? "" : ", ") + equals;
      else if (row.function == Function::feed_word) feed = (lang_ == Lang::ru ? ", подача " : ", feed ") + value;
      else if (row.function != Function::count) add(row.phase, fmt::format("{}: {}", equals, in_language(row.text, lang_)));
    }
    if (!axes.empty()) add(Phase::motion, fmt::format("{} {}{}", motion_, axes, feed));
    std::stable_sort(pieces_.begin(), pieces_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::string text;
    for (const auto& [rank, piece] : pieces_) text += (text.empty() ? "" : "; ") + piece;
    return text;
  }

 private:
  void add(Phase phase, std::string piece) { pieces_.emplace_back(def_.order[static_cast<std::size_t>(phase)], std::move(piece)); }

  bool code(const std::string& word) {
    if (word[0] != 'G' && word[0] != 'M') return false;
    const std::string plain = code_asked(word);
    const auto row = std::find_if(def_.codes.begin(), def_.codes.end(), [&](const CodeRow& one) { return code_asked(one.code) == plain; });
    if (row == def_.codes.end()) return false;
    const bool ru = lang_ == Lang::ru;
    if (row->function == Function::rapid) motion_ = ru ? "быстро до" : "rapid to";
    else if (row->function == Function::linear) motion_ = ru ? "рабочий ход до" : "feed to";
    else if (row->function != Function::dwell) add(row->phase, fmt::format("{} ({})", in_language(row->text, lang_), plain));
    return true;
  }

  const ControlDef& def_;
  Lang lang_;
  std::string motion_ = lang_ == Lang::ru ? "ход до" : "move to";
  std::vector<std::pair<std::uint8_t, std::string>> pieces_;
};

std::uint64_t bits(std::string_view letters) {
  std::uint64_t all = 0;
  for (const char c : letters) all |= 1ull << (c - 'A');
  return all;
}

std::string_view head(Lang lang) { return lang == Lang::ru ? "шаги" : "steps"; }

/// True for G87: a bit of the set-up selects boring with manual withdrawal or back boring (nct 18.1.13).
bool may_bore_back(const DrillCycle& cycle) { return cycle.code + 1000 == back_boring; }

std::int32_t drill_code(const CodeRow& row) { return row.arg != 0 ? row.arg : row.tenth; }

}  // namespace

std::string steps_text(const ControlDef& def, const CycleRow& row, Lang lang) {
  std::vector<std::string> steps;
  const bool by_code = row.call_number == 0 && !row.steps.empty();
  if (by_code) steps = {std::string(in_language(over_hole, lang)), std::string(in_language(to_level, lang))};
  for (const CycleStep step : row.steps) steps.emplace_back(in_language(step_words[static_cast<std::size_t>(step)], lang));
  BodyTeller teller(def, lang);
  std::istringstream body(row.body);
  for (std::string line; std::getline(body, line);)
    if (std::string text = teller.block(line); !text.empty()) steps.push_back(std::move(text));
  return numbered(steps, head(lang));
}

std::string steps_text(const ControlDef& def, const CodeRow& row, Lang lang) {
  if (row.function != Function::drilling) return {};
  const DrillCycle* const cycle = drill_cycle(drill_code(row));
  if (cycle == nullptr) return {};
  const bool by_e = (row.takes & bits("E")) != 0;
  std::string text = numbered(drilling_steps(*cycle, by_e, lang), head(lang));
  if (!may_bore_back(*cycle)) return text;
  const std::string_view parameter = def.lineage.empty() ? " (N0607 #1 ORI = 1)" : "";  // a parameter of the NCT
  const std::string_view oriented = lang == Lang::ru ? "шаги, если шпиндель ориентируется" : "steps, where the spindle can be oriented";
  return text + numbered(drilling_steps(*drill_cycle(back_boring), by_e, lang), fmt::format("{}{}", oriented, parameter));
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
