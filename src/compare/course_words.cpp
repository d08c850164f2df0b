// Describes states and acts of a course in words. Used by compare/comparison; tested by tests/russian_units.py and tests/run_diff.py.

#include "compare/course_words.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "config/language.h"

namespace kadr {

std::string words_of_state(const CourseState& s, CourseDifference::Kind of) {
  using Words = std::pair<const char*, const char*>;  // English, Russian
  constexpr std::array<Words, 4> moves = {
      {{"rapid", "быстрый ход"}, {"feed", "рабочая подача"}, {"thread", "резьба"}, {"probe", "касание щупа"}}};
  constexpr std::array<Words, 3> units = {{{"mm/min", "мм/мин"}, {"mm/rev", "мм/об"}, {"1/min", "1/мин"}}};
  const auto in_words = [](const Words& one) { return told(one.first, one.second); };
  constexpr std::array spindles = {"M5", "M3", "M4", "M19", "M19"};
  constexpr std::array coolants = {"M9", "M7", "M8"};
  constexpr std::array speeds = {"G64", "G62", "G63"};
  using Kind = CourseDifference::Kind;
  switch (of) {
    case Kind::move: return in_words(moves[std::size_t(s.move)]);
    case Kind::feed:
      return s.move == CourseMove::thread ? fmt::format("{} {:.6g}", told("lead", "ход"), s.lead)
                                          : fmt::format("F{:.6g} {}", s.feed, in_words(units[std::size_t(s.unit)]));
    case Kind::tool: return fmt::format("T{}", s.tool);
    case Kind::spindle:
      return s.speed == 0
                 ? spindles[std::size_t(s.spindle)]
                 : fmt::format("S{:.6g}{} {}", s.speed, s.surface ? told(" m/min", " м/мин") : "", spindles[std::size_t(s.spindle)]);
    case Kind::corners:
      if (s.smoothing != 0) return fmt::format("G5.1 Q{}", s.smoothing);
      return s.tolerance > 0 ? fmt::format("G64 P{:.6g}", s.tolerance) : speeds[std::size_t(s.corners)];
    default: return coolants[std::size_t(s.coolant)];
  }
}

std::string text_of(const CourseEvent& act) {
  using Act = CourseEvent::Kind;
  switch (act.kind) {
    case Act::tool: return fmt::format("M6 T{:g}", act.value);
    case Act::dwell: return fmt::format("G4 {:.6g} {}", act.value, told("s", "с"));
    case Act::stop: return "M0";
    case Act::optional_stop: return "M1";
    case Act::message: return act.text;
    case Act::function: return fmt::format("M{:.0f}", act.value >= not_of_b ? act.value - not_of_b : act.value);
    case Act::exact_stop: return "G9";
    default: return fmt::format("{} {:.6g}", act.text, act.value);
  }
}

}  // namespace kadr
