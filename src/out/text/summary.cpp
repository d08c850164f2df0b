// Statistics: collects the totals of a run for the summary on stdout (docs/commands/run.md, "Summary"). It is used by cli/run_view and
// out/picture/speed_page, and tested by tests/out/summary_test.cpp.

#include "out/text/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "texts/summary.h"

namespace kadr {
namespace {

/// Texts in the order of the enum TimeBasis.
constexpr std::array<PlainText, 3> basis_texts = {texts::summary::by_programmed_feeds, texts::summary::by_limited_speed,
                                                  texts::summary::by_acceleration};

std::size_t character_count(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string line(std::string_view name, const std::string& value) {
  constexpr std::size_t width = 16;
  const std::size_t pad = width > character_count(name) ? width - character_count(name) : 1;
  return std::string(name) + std::string(pad, ' ') + value + "\n";
}

/// Returns the values as lines of the summary, one value per line. Only the first line begins with the name of the values.
std::string lines(std::string_view name, const std::vector<std::string>& values) {
  std::string text;
  for (const std::string& value : values) text += line(text.empty() ? name : std::string_view(), value);
  return text;
}

std::string split_text(double cutting, double rapid, double dwell, double tool_change, Lang lang) {
  return translated_in(lang, texts::summary::time_by_use, duration_text(cutting + rapid + dwell + tool_change), duration_text(cutting),
                       duration_text(rapid), duration_text(dwell), duration_text(tool_change));
}

/// Returns the text about the spindle speeds at constant surface speed.
std::string spindle_text(const Range& rpm, Lang lang) {
  if (rpm.most >= SpindleTurning::fastest) return translated_in(lang, texts::summary::spindle_without_limit, number_text(rpm.least, 0));
  return translated_in(lang, texts::summary::spindle_speeds, number_text(rpm.least, 0), number_text(rpm.most, 0));
}

/// Returns the text about the time that the least-time planner computes (docs/planner.md).
std::string planned_text(PlainText heading, const PlannedTime& t, Lang lang) {
  const std::string ramps =
      translated_in(lang, texts::summary::speeding_and_slowing, duration_text(t.cutting.speeding_up), duration_text(t.cutting.slowing_down),
                    duration_text(t.rapid.speeding_up), duration_text(t.rapid.slowing_down));
  return line(plain_text(heading, lang), split_text(t.cutting.all, t.rapid.all, t.dwell, t.tool_change, lang)) +
         line("", plain_text(texts::summary::by_planner, lang)) + line("", ramps);
}

}  // namespace

Statistics::Statistics(const std::vector<std::string>& axes, AxisMask rotary, const Rates& rates)
    : estimate_(AxisRoles::of(axes, rotary), rates), extents_(axes, AxisRoles::of(axes, rotary)) {}

void Statistics::start_with(const Setup& setup) {
  estimate_.spindles(setup);
  const auto tool = static_cast<std::uint32_t>(std::max(setup.tool, 0));
  if (tool != 0) use(tool);
}

void Statistics::use(std::uint32_t tool) {
  const auto found = std::find_if(tools_.begin(), tools_.end(), [&](const ToolUse& use) { return use.tool == tool; });
  in_spindle_ = static_cast<std::size_t>(found - tools_.begin());
  if (found == tools_.end()) tools_.push_back({tool, 0});
}

/// Adds the cutting time since the last call of this function to the tool in the spindle.
void Statistics::count_cutting() {
  const double now = estimate_.split().cutting;
  if (in_spindle_ < tools_.size()) tools_[in_spindle_].cutting_s += now - cutting_then_;
  cutting_then_ = now;
}

/// Records the spindle speeds of a cut at constant surface speed (nct 11.5). They are greatest where the tool is nearest to the centre.
void Statistics::count_spindle(const Motion& motion, const Curve& curve) {
  const SpindleTurning& spindle = estimate_.turning(motion);
  const SurfaceSpeed& surface = spindle.surface;
  if (!spindle.on || !surface.on || surface.axis >= max_axes || curve.surface() != PathSurface::plane) return;
  const Extents extents = curve.extents();
  const double least = extents.least[surface.axis], most = extents.most[surface.axis];
  const auto rpm_at = [&](double radius) {
    Axes at{};
    at[surface.axis] = radius;
    return std::min(surface.rpm(at), spindle.most_rpm);
  };
  const double slowest = rpm_at(std::max(std::fabs(least), std::fabs(most)));
  const double fastest = rpm_at(least * most <= 0 ? 0 : std::min(std::fabs(least), std::fabs(most)));
  if (!surface_speeds_) surface_speeds_ = Range{slowest, fastest};
  surface_speeds_ = Range{std::min(surface_speeds_->least, slowest), std::max(surface_speeds_->most, fastest)};
}

void Statistics::take_motion(const Step& step, const Motion& motion) {
  const Curve& curve = step.curve();
  count_cutting();
  const bool cutting = cuts(motion);
  ++(curve.arc() ? arcs_ : motion.kind == MotionKind::rapid ? rapids_ : cutting ? feeds_ : others_);
  (cutting || motion.kind == MotionKind::probe ? cutting_mm_ : rapid_mm_) += step.time.length;
  extents_.take(motion, step.from, curve);
  if (cutting) count_spindle(motion, curve);
}

void Statistics::consume(const Step& step) {
  if (const Motion* const motion = step.motion()) return take_motion(step, *motion);
  if (std::holds_alternative<FrameChange>(step.action.what)) extents_.lift();
  if (const auto* change = std::get_if<ToolChange>(&step.action.what)) use(change->tool);
}

void Statistics::lengthen(const Motion& motion, double longer) {
  estimate_.lengthen(motion, longer);
  count_cutting();
}

std::string Statistics::caption(Lang lang) const {
  constexpr std::size_t most = 2;  // greatest number of work offsets whose extents are in one line
  const std::vector<std::string> ranges = extents_.texts(RunExtents::Of::cutting, system_names_);
  std::string caption;
  for (std::size_t i = 0; i < std::min(most, ranges.size()); ++i) caption += (i == 0 ? "" : ";   ") + ranges[i];
  if (ranges.size() > most) caption += fmt::format(";   … (+{})", ranges.size() - most);
  if (caption.empty()) return caption;
  if (extents_.x_is_diameter()) caption += ";   " + translated_in(lang, texts::summary::x_is_diameter);
  return translated_in(lang, texts::summary::cutting_range, unit_name(extents_.unit(), lang), caption);
}

std::string Statistics::text(std::uint64_t blocks, Lang lang, const PlannedTime* planned, PlannerMode counts) const {
  const auto named = [&](PlainText name, const std::string& value) { return line(plain_text(name, lang), value); };
  const TimeSplit& t = estimate_.split();
  const std::uint64_t all = rapids_ + feeds_ + arcs_ + others_;
  std::string text = named(texts::summary::blocks, fmt::format("{}", blocks));
  text += named(texts::summary::motions,
                others_ > 0 ? translated_in(lang, texts::summary::motions_by_kind_and_other, all, rapids_, feeds_, arcs_, others_)
                            : translated_in(lang, texts::summary::motions_by_kind, all, rapids_, feeds_, arcs_));
  const LengthUnit unit = extents_.unit();
  const auto in_unit = [&](TextId<1> name) { return translated_in(lang, name, unit_name(unit, lang)); };
  if (unit == LengthUnit::mixed) text += named(texts::summary::units, plain_text(texts::summary::both_units, lang));
  text += line(in_unit(texts::summary::path),
               translated_in(lang, texts::summary::path_lengths, length_text(cutting_mm_, unit), length_text(rapid_mm_, unit)));
  text += lines(in_unit(texts::summary::cutting), extents_.texts(RunExtents::Of::cutting, system_names_));
  text += lines(in_unit(texts::summary::all), extents_.texts(RunExtents::Of::all, system_names_));
  if (extents_.x_is_diameter()) text += line("", plain_text(texts::summary::x_is_diameter, lang));
  if (surface_speeds_) text += named(texts::summary::spindle, spindle_text(*surface_speeds_, lang));
  const bool planned_counts = planned != nullptr && counts == PlannerMode::optimal;
  if (!planned_counts) {
    text += named(texts::summary::time, split_text(t.cutting, t.rapid, t.dwell, t.tool_change, lang));
    text += line("", plain_text(basis_texts[static_cast<std::size_t>(basis_)], lang));
  }
  if (planned != nullptr) text += planned_text(planned_counts ? texts::summary::time : texts::summary::least_time, *planned, lang);
  if (t.unknown > 0) text += line("", translated_in(lang, texts::summary::motions_without_time, t.unknown));
  if (!tools_.empty()) {
    std::string tools;
    for (const ToolUse& use : tools_)
      tools += (tools.empty() ? "" : ", ") + translated_in(lang, texts::summary::tool_cutting_time, use.tool, duration_text(use.cutting_s));
    text += named(texts::summary::tools, tools);
  }
  return text + named(texts::summary::alarms, translated_in(lang, texts::summary::alarms_and_warnings, alarms_, warnings_));
}

std::string channel_heading(int channel, Lang lang) { return translated_in(lang, texts::summary::channel, channel) + "\n"; }

std::string channels_text(const std::vector<ChannelTime>& times, Lang lang) {
  double longest = 0;
  std::string all;
  for (const ChannelTime& t : times) {
    longest = std::max(longest, t.busy + t.waited);
    all += (all.empty() ? "" : ", ") + translated_in(lang, texts::summary::channel_time, t.channel, duration_text(t.busy + t.waited));
    if (t.waited > 0) all += " (" + translated_in(lang, texts::summary::waiting, duration_text(t.waited)) + ")";
  }
  return line(plain_text(texts::summary::machining_time, lang), fmt::format("{}: {}", duration_text(longest), all));
}

std::string duration_text(double seconds) {
  const auto tenths = static_cast<std::uint64_t>(std::round(std::clamp(seconds, 0.0, 1e15) * 10));
  const std::uint64_t whole = tenths / 10;
  if (whole < 600) return fmt::format("{}:{:02}.{}", whole / 60, whole % 60, tenths % 10);
  return whole < 3600 ? fmt::format("{}:{:02}", whole / 60, whole % 60)
                      : fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace kadr
