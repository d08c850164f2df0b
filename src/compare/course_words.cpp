// Describes states and acts of a course in words. Used by compare/comparison; tested by tests/russian_units.py and tests/run_diff.py.

#include "compare/course_words.h"

#include <fmt/format.h>

#include <array>

#include "texts/comparison.h"

namespace kadr {

std::string words_of_state(const CourseState& s, CourseDifference::Kind of) {
  constexpr std::array<PlainText, 4> moves = {texts::comparison::rapid, texts::comparison::at_feed, texts::comparison::thread,
                                              texts::comparison::probe};
  constexpr std::array<PlainText, 3> units = {texts::comparison::per_minute, texts::comparison::per_revolution,
                                              texts::comparison::inverse_time};
  constexpr std::array spindles = {"M5", "M3", "M4", "M19", "M19"};
  constexpr std::array coolants = {"M9", "M7", "M8"};
  constexpr std::array speeds = {"G64", "G62", "G63"};
  using Kind = CourseDifference::Kind;
  switch (of) {
    case Kind::move: return translated(moves[std::size_t(s.move)]);
    case Kind::feed:
      return s.move == CourseMove::thread ? translated(texts::comparison::lead, s.lead)
                                          : fmt::format("F{:.6g} {}", s.feed, translated(units[std::size_t(s.unit)]));
    case Kind::tool: return fmt::format("T{}", s.tool);
    case Kind::spindle:
      if (s.speed == 0) return spindles[std::size_t(s.spindle)];
      if (s.surface && s.most_rpm != 0)
        return translated(texts::comparison::surface_speed_limited, s.speed, spindles[std::size_t(s.spindle)], s.most_rpm);
      return s.surface ? translated(texts::comparison::surface_speed, s.speed, spindles[std::size_t(s.spindle)])
                       : fmt::format("S{:.6g} {}", s.speed, spindles[std::size_t(s.spindle)]);
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
    case Act::dwell: return translated(texts::comparison::dwell, act.value);
    case Act::stop: return "M0";
    case Act::optional_stop: return "M1";
    case Act::message: return act.text;
    case Act::function: return fmt::format("M{:.0f}", act.value >= not_of_b ? act.value - not_of_b : act.value);
    case Act::exact_stop: return "G9";
    default: return fmt::format("{} {:.6g}", act.text, act.value);
  }
}

}  // namespace kadr
