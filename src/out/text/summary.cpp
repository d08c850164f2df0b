// Statistics: collects the totals of a run for the summary on stdout (docs/commands/run.md, "Summary"). Used by cli/run_view and
// out/picture/speed_page; tested by tests/out/summary_test.cpp.

#include "out/text/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace kadr {
namespace {

/// The words of the summary in one language.
struct SummaryWords {
  const char *blocks, *motions, *rapids, *feeds, *arcs, *other;
  const char *units, *mixed, *path, *cutting, *rapid, *all;
  const char *time, *dwell, *tool_change, *unknown;
  std::array<const char*, 3> basis;  // texts by the enum TimeBasis
  const char *least_time, *least_basis, *speeding_up, *slowing_down;
  const char *tools, *alarms, *warnings;
};

constexpr SummaryWords english_summary = {
    "blocks",
    "motions",
    "rapid",
    "feed",
    "arcs",
    "other",
    "units",
    "mm; the program cuts both in inches and in millimetres",
    "path",
    "cutting",
    "rapid",
    "all",
    "time",
    "dwell",
    "tool change",
    "motions without a time (no feed, or the spindle stands)",
    {"from programmed feeds and rapid rates, without acceleration", "as the control limits the speed, without acceleration",
     "as the control limits the speed, with acceleration"},
    "least time",
    "by Kadr's planner, within speed, acceleration and jerk of the axes",
    "speeding up",
    "slowing down",
    "tools",
    "alarms",
    "warnings"};
constexpr SummaryWords russian_summary = {
    "кадров",
    "движений",
    "ускоренных",
    "на подаче",
    "дуг",
    "прочих",
    "единицы",
    "мм; УП режет и в дюймах, и в миллиметрах",
    "путь",
    "резание",
    "быстрый ход",
    "всё",
    "время",
    "выдержка",
    "смена инструмента",
    "движений без времени (нет подачи или шпиндель стоит)",
    {"по программным подачам и быстрым ходам станка, без разгонов", "с ограничениями скорости устройства ЧПУ, без разгонов",
     "с ограничениями скорости устройства ЧПУ, с разгонами"},
    "мин. время",
    "по планировщику Kadr, в пределах скорости, ускорения и рывка осей",
    "разгон",
    "торможение",
    "инструменты",
    "ошибок",
    "предупреждений"};

std::size_t character_count(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string line(std::string_view name, const std::string& value) {
  constexpr std::size_t width = 16;
  const std::size_t pad = width > character_count(name) ? width - character_count(name) : 1;
  return std::string(name) + std::string(pad, ' ') + value + "\n";
}

/// Returns the name followed by the values, one per line.
std::string lines(std::string_view name, const std::vector<std::string>& values) {
  std::string text;
  for (const std::string& value : values) text += line(text.empty() ? name : std::string_view(), value);
  return text;
}

std::string split_text(const SummaryWords& w, double cutting, double rapid, double dwell, double tool_change) {
  return fmt::format("{} ({} {}, {} {}, {} {}, {} {})", duration_text(cutting + rapid + dwell + tool_change), w.cutting,
                     duration_text(cutting), w.rapid, duration_text(rapid), w.dwell, duration_text(dwell), w.tool_change,
                     duration_text(tool_change));
}

/// Returns the time by the planner of least time (docs/planner.md).
std::string planned_text(const SummaryWords& w, const char* heading, const PlannedTime& t) {
  const auto ramps = [&](const char* name, const PlannedTime::Share& share) {
    return fmt::format("{} {} {}, {} {}", name, w.speeding_up, duration_text(share.speeding_up), w.slowing_down,
                       duration_text(share.slowing_down));
  };
  return line(heading, split_text(w, t.cutting.all, t.rapid.all, t.dwell, t.tool_change)) + line("", w.least_basis) +
         line("", ramps(w.cutting, t.cutting) + "; " + ramps(w.rapid, t.rapid));
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

/// Adds the cutting time since the last call to the tool in the spindle.
void Statistics::count_cutting() {
  const double now = estimate_.split().cutting;
  if (in_spindle_ < tools_.size()) tools_[in_spindle_].cutting_s += now - cutting_then_;
  cutting_then_ = now;
}

void Statistics::take_motion(const Step& step, const Motion& motion) {
  const Curve& curve = step.curve();
  count_cutting();
  const bool cutting = cuts(motion);
  ++(curve.arc() ? arcs_ : motion.kind == MotionKind::rapid ? rapids_ : cutting ? feeds_ : others_);
  (cutting || motion.kind == MotionKind::probe ? cutting_mm_ : rapid_mm_) += step.time.length;
  extents_.take(motion, step.from, curve);
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
  constexpr std::size_t most = 2;  // greatest number of work systems in one line
  const std::vector<std::string> texts = extents_.texts(RunExtents::Of::cutting, system_names_);
  std::string caption;
  for (std::size_t i = 0; i < std::min(most, texts.size()); ++i) caption += (i == 0 ? "" : ";   ") + texts[i];
  if (texts.size() > most) caption += fmt::format(";   … (+{})", texts.size() - most);
  if (caption.empty()) return caption;
  return fmt::format("{}, {}:  {}", (lang == Lang::ru ? russian_summary : english_summary).cutting, unit_name(extents_.unit(), lang),
                     caption);
}

std::string Statistics::text(std::uint64_t blocks, Lang lang, const PlannedTime* planned, PlannerMode counts) const {
  const SummaryWords& w = lang == Lang::ru ? russian_summary : english_summary;
  const TimeSplit& t = estimate_.split();
  std::string text = line(w.blocks, fmt::format("{}", blocks));
  std::string motions =
      fmt::format("{} ({} {}, {} {}, {} {}", rapids_ + feeds_ + arcs_ + others_, w.rapids, rapids_, w.feeds, feeds_, w.arcs, arcs_);
  if (others_ > 0) motions += fmt::format(", {} {}", w.other, others_);
  text += line(w.motions, motions + ")");
  const LengthUnit unit = extents_.unit();
  const auto in_unit = [&](const char* name) { return fmt::format("{}, {}", name, unit_name(unit, lang)); };
  if (unit == LengthUnit::mixed) text += line(w.units, w.mixed);
  text +=
      line(in_unit(w.path), fmt::format("{} {}, {} {}", w.cutting, length_text(cutting_mm_, unit), w.rapid, length_text(rapid_mm_, unit)));
  text += lines(in_unit(w.cutting), extents_.texts(RunExtents::Of::cutting, system_names_));
  text += lines(in_unit(w.all), extents_.texts(RunExtents::Of::all, system_names_));
  const bool planned_counts = planned != nullptr && counts == PlannerMode::optimal;
  if (!planned_counts) {
    text += line(w.time, split_text(w, t.cutting, t.rapid, t.dwell, t.tool_change));
    text += line("", w.basis[static_cast<std::size_t>(basis_)]);
  }
  if (planned != nullptr) text += planned_text(w, planned_counts ? w.time : w.least_time, *planned);
  if (t.unknown > 0) text += line("", fmt::format("{}: {}", w.unknown, t.unknown));
  if (!tools_.empty()) {
    std::string tools;
    for (const ToolUse& use : tools_)
      tools += fmt::format("{}T{} ({} {})", tools.empty() ? "" : ", ", use.tool, w.cutting, duration_text(use.cutting_s));
    text += line(w.tools, tools);
  }
  return text + line(w.alarms, fmt::format("{}, {} {}", alarms_, w.warnings, warnings_));
}

std::string channel_heading(int channel, Lang lang) { return fmt::format("{} {}\n", lang == Lang::ru ? "канал" : "channel", channel); }

std::string channels_text(const std::vector<ChannelTime>& times, Lang lang) {
  const bool ru = lang == Lang::ru;
  double longest = 0;
  std::string all;
  for (const ChannelTime& t : times) {
    longest = std::max(longest, t.busy + t.waited);
    all += fmt::format("{}{} {} {}", all.empty() ? "" : ", ", ru ? "канал" : "channel", t.channel, duration_text(t.busy + t.waited));
    if (t.waited > 0) all += fmt::format(" ({} {})", ru ? "ожидание" : "waiting", duration_text(t.waited));
  }
  return line(ru ? "время обработки" : "machining time", fmt::format("{}: {}", duration_text(longest), all));
}

std::string duration_text(double seconds) {
  const auto tenths = static_cast<std::uint64_t>(std::round(std::clamp(seconds, 0.0, 1e15) * 10));
  const std::uint64_t whole = tenths / 10;
  if (whole < 600) return fmt::format("{}:{:02}.{}", whole / 60, whole % 60, tenths % 10);
  return whole < 3600 ? fmt::format("{}:{:02}", whole / 60, whole % 60)
                      : fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace kadr
