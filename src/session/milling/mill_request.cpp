// Translates a user's request for milling into a job of path/pocketing. This file is used by session/milling, cli/options/mill_command and
// view/page/page_making, and tested by tests/mill.py and tests/serve_making.py.

#include "session/milling/mill_request.h"

#include <cmath>
#include <cstdlib>
#include <optional>

#include "config/drawing/drawing.h"
#include "config/nearest.h"

namespace kadr {
namespace {

using area::Direction;
using area::Plunge;
using area::Scheme;

// greatest stepover in % of the tool diameter; a larger stepover would leave material between the passes
constexpr double max_stepover = 100;

/// A name in three forms: as a user enters it, as the Russian source prints it, and as the source prints it but in lower case. Blanks
/// inside a name are ignored.
template <class T>
struct Name {
  std::string_view name, source, small;
  T value;
};
constexpr Name<Scheme> schemes[] = {
    {"zigzag", "ЗИГЗАГ", "зигзаг", Scheme::zigzag},
    {"1zigzag", "1 ЗИГЗАГ", "1 зигзаг", Scheme::zigzag_then_contour},
    {"2zigzag", "2 ЗИГЗАГ", "2 зигзаг", Scheme::contour_then_zigzag},
    {"spiral-out", "СПИР", "спир", Scheme::spiral_out},
    {"spiral-in", "АСПИР", "аспир", Scheme::spiral_in},
    {"comb", "ШТИП", "штип", Scheme::comb},
    {"1comb", "1 ШТИП", "1 штип", Scheme::comb_then_contour},
    {"2comb", "2 ШТИП", "2 штип", Scheme::contour_then_comb},
};
constexpr Name<Direction> directions[] = {{"ccw", "ПЧС", "пчс", Direction::ccw}, {"cw", "ЧС", "чс", Direction::cw}};
constexpr Name<Plunge> plunges[] = {
    {"hole", "ЗАСВ", "засв", Plunge::hole}, {"tangential", "КАС", "кас", Plunge::tangential}, {"ramp", "СПУСК", "спуск", Plunge::ramp}};

std::string without_blanks(std::string_view text) {
  std::string rest;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.substr(i).starts_with("\u00A0")) ++i;
    else if (text[i] != ' ') rest += text[i];
  }
  return rest;
}

template <class T, std::size_t n>
bool find(const Name<T> (&names)[n], std::string_view text, T& value) {
  const std::string wanted = without_blanks(in_small_letters(text));
  for (const Name<T>& name : names)
    for (const std::string_view known : {name.name, name.source, name.small})
      if (wanted == without_blanks(known)) {
        value = name.value;
        return true;
      }
  return false;
}

template <class T, std::size_t n>
std::vector<std::string> names_of(const Name<T> (&names)[n]) {
  std::vector<std::string> list;
  for (const Name<T>& name : names) list.emplace_back(name.name);
  for (const Name<T>& name : names) list.emplace_back(name.source);
  return list;
}

/// Finds a milling scheme by its name. A name from the Russian source may end with a direction, which is stored too: СПИР ПЧС, АСПИР ЧС.
bool find_scheme(std::string_view text, Scheme& scheme, std::optional<Direction>& direction) {
  if (find(schemes, text, scheme)) return true;
  for (const Name<Direction>& name : directions)
    for (const std::string_view ending : {name.source, name.small})
      if (text.ends_with(ending) && find(schemes, text.substr(0, text.size() - ending.size()), scheme)) {
        direction = name.value;
        return true;
      }
  return false;
}

/// Returns the direction in which the tool climb-mills with this scheme, that is, with the uncut material on its right.
Direction climb(Scheme scheme) { return scheme == Scheme::spiral_in ? Direction::cw : Direction::ccw; }

/// Returns the stepover that the request states, in mm.
Result<double> step_of(const MillRequest& o) {
  const std::string text = !o.stepover.empty() ? o.stepover : o.task == "face" ? "70%" : "50%";
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const std::string_view rest(end);
  if (end == text.c_str() || (!rest.empty() && rest != "%")) return fail(alarm(AlarmId::mill_value, {}, "stepover", text));
  const double percent = rest == "%" ? value : 100 * value / o.tool_diameter;
  if (!(percent > 0 && percent <= max_stepover)) return fail(alarm(AlarmId::mill_stepover, {}, percent, max_stepover));
  return percent / 100 * o.tool_diameter;
}

struct Range {
  const char* option;
  double value, least, most;
};

Status check_ranges(const MillRequest& o) {
  constexpr double tiny = 0.01, far = limits::contour_reach, fast = 1e6;
  const Range ranges[] = {
      {"tool-diameter", o.tool_diameter, 0.05, 1000},
      {"depth", std::abs(o.depth), tiny, 10'000},
      {"pass", o.pass < 0 ? tiny : o.pass, tiny, 10'000},
      {"allowance", o.allowance, 0, 100},
      {"top", o.top, -far, far},
      {"clearance", o.clearance, tiny, 10'000},
      {"overrun", o.overrun, 0, 1000},
      {"angle", o.angle, -360, 360},
      {"ramp-angle", o.ramp_angle, 0.1, 45},
      {"width", o.width < 0 ? o.tool_diameter : o.width, o.tool_diameter, far},
      {"feed", o.feed, tiny, fast},
      {"plunge-feed", o.plunge_feed < 0 ? o.feed : o.plunge_feed, tiny, fast},
      {"speed", o.speed, 0, fast},
  };
  for (const Range& r : ranges)
    if (!(r.value >= r.least && r.value <= r.most)) return fail(alarm(AlarmId::mill_value, {}, r.option, r.value));
  constexpr double max_layers = 1000;
  if (o.pass > 0 && std::abs(o.depth) / o.pass > max_layers) return fail(alarm(AlarmId::mill_value, {}, "pass", o.pass));
  for (const double value : o.hole)
    if (!(std::abs(value) <= far)) return fail(alarm(AlarmId::mill_value, {}, "hole", value));
  return {};
}

}  // namespace

Result<area::Job> mill_job(const MillRequest& o) {
  KADR_TRY(check_ranges(o));
  area::Job job;
  std::optional<Direction> named;
  if (o.scheme.empty()) job.scheme = o.task == "face" ? Scheme::zigzag : job.scheme;
  else if (!find_scheme(o.scheme, job.scheme, named)) return fail(alarm(AlarmId::mill_value, {}, "scheme", o.scheme));
  job.direction = named.value_or(climb(job.scheme));
  if (!o.direction.empty() && (!find(directions, o.direction, job.direction) || job.direction != named.value_or(job.direction)))
    return fail(alarm(AlarmId::mill_value, {}, "direction", o.direction));
  if (!find(plunges, o.plunge, job.plunge)) return fail(alarm(AlarmId::mill_value, {}, "plunge", o.plunge));
  const auto step = step_of(o);
  if (!step) return fail(step.error());
  job.radius = o.tool_diameter / 2;
  job.step = *step;
  job.allowance = o.allowance;
  job.depth = std::abs(o.depth);
  job.layer = o.pass < 0 ? job.depth : o.pass;
  job.top = o.top;
  job.clearance = o.clearance;
  job.overrun = o.overrun;
  job.angle = o.angle;
  job.ramp_deg = o.ramp_angle;
  if (o.hole.size() == 2) job.hole = Vec2{o.hole[0], o.hole[1]};
  return job;
}

bool is_scheme(std::string_view name) {
  Scheme scheme;
  std::optional<Direction> direction;
  return find_scheme(name, scheme, direction);
}

bool is_direction(std::string_view name) {
  Direction direction;
  return find(directions, name, direction);
}

bool is_plunge(std::string_view name) {
  Plunge plunge;
  return find(plunges, name, plunge);
}

std::vector<std::string> scheme_names() { return names_of(schemes); }
std::vector<std::string> direction_names() { return names_of(directions); }
std::vector<std::string> plunge_names() { return names_of(plunges); }

std::string_view russian_name(area::Scheme scheme) {
  for (const auto& name : schemes)
    if (name.value == scheme) return name.source;
  return {};
}

std::string_view russian_name(area::Direction direction) {
  for (const auto& name : directions)
    if (name.value == direction) return name.source;
  return {};
}

std::string_view russian_name(area::Plunge plunge) {
  for (const auto& name : plunges)
    if (name.value == plunge) return name.source;
  return {};
}

}  // namespace kadr
