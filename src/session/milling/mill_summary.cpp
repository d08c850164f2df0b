// Describes a milled area for the user. This file is used by cli/mill and view/page/page_making, and tested by tests/mill.py and
// tests/serve_making.py.

#include "session/milling/mill_summary.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "lang/text/encoding.h"
#include "texts/milling.h"

namespace kadr {
namespace {

std::string text_of_line(std::string_view text, std::uint32_t number) {
  for (; number > 1; --number) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  constexpr std::size_t longest = 200;  // greatest number of bytes of a line of the drawing that a message shows
  std::string_view line = text.substr(0, std::min(text.find_first_of("\r\n"), longest));
  std::string utf8;
  return append_utf8(line, Encoding::utf8, utf8) ? utf8 : std::string();
}

std::string scheme_with_direction(const area::Job& job) {
  return fmt::format("{} {}", russian_name(job.scheme), russian_name(job.direction));
}

std::string hole_place(Vec2 p) { return fmt::format("X{} Y{}", number_text(p.x, 3), number_text(p.y, 3)); }

class MillSummary {
 public:
  MillSummary(const Milled& milled, Lang lang) : milled_(milled), job_(milled.job), lang_(lang) {}

  std::vector<MillLine> lines() {
    const area::AreaPath& path = milled_.path.path;
    const area::Outcome& o = milled_.path.outcome;
    line(texts::milling::zone, zone_text());
    line(texts::milling::scheme, text(texts::milling::scheme_and_step, scheme_with_direction(job_), number_text(path.step, 3),
                                      number_text(50 * path.step / job_.radius, 1)));
    line(texts::milling::path, text(texts::milling::length_of_path, number_text(o.length, 1), path.layers, path.lifts));
    if (std::isfinite(o.nearest_wall))
      line(texts::milling::wall, text(texts::milling::nearest_wall, number_text(o.nearest_wall, 3), number_text(o.required, 3)));
    line(texts::milling::uncut, text(texts::milling::uncut_area, number_text(o.uncut, 2), number_text(o.out_of_reach, 2)));
    line(texts::milling::plunge, plunge_text(path.plunges));
    for (const Vec2 hole : path.holes) line(texts::milling::drill_before, hole_place(hole));
    if (path.step < job_.step) line(texts::milling::note, text(texts::milling::step_reduced));
    if (path.fields > milled_.shape.zones.size()) line(texts::milling::note, text(texts::milling::zone_falls_apart));
    const auto blocks = std::count(milled_.program.text.begin(), milled_.program.text.end(), '\n');
    line(texts::milling::program, text(texts::milling::blocks_read_back, blocks));
    return std::move(lines_);
  }

 private:
  template <std::size_t Holes, typename... Args>
  std::string text(TextId<Holes> id, const Args&... args) const {
    return translated_in(lang_, id, args...);
  }
  void line(PlainText name, std::string value) { lines_.push_back({text(name), std::move(value)}); }

  /// Returns the type of the area. INFERRED, since spec/correctors 4 only names the four types: a half-open area has all its walls in one
  /// connected part of the outline. In a combined area walls and open sides alternate, or an outline with open sides contains islands.
  std::string zone_text() const {
    std::size_t islands = 0, walls = 0, open = 0, wall_runs = 0;
    for (const area::Zone& zone : milled_.shape.zones) {
      islands += zone.loops.size() - 1;
      for (const Edges& loop : zone.loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
          ++(loop[i].open ? open : walls);
          if (!loop[i].open && loop[(i + 1) % loop.size()].open) ++wall_runs;
        }
        if (std::none_of(loop.begin(), loop.end(), [](const Edge& e) { return e.open; })) ++wall_runs;
      }
    }
    const bool one_wall_run = wall_runs <= milled_.shape.zones.size();
    const TextId<1> kind = open == 0      ? texts::milling::zone_closed
                           : walls == 0   ? texts::milling::zone_open
                           : one_wall_run ? texts::milling::zone_half_open
                                          : texts::milling::zone_combined;
    return text(kind, islands);
  }

  /// Describes how the tool enters uncut material. Straight plunges are mentioned separately, since not every tool can cut at its centre.
  std::string plunge_text(const area::Plunges& p) const {
    std::string plunge_kinds;
    const auto add = [&](std::size_t count, TextId<1> kind) {
      if (count > 0) plunge_kinds += (plunge_kinds.empty() ? "" : ", ") + text(kind, count);
    };
    add(p.ramps, texts::milling::ramps);
    add(p.helices, texts::milling::helices);
    add(p.straight, texts::milling::straight);
    add(p.drilled, texts::milling::drilled);
    if (plunge_kinds.empty()) return text(texts::milling::beside_material);
    if (p.ramps + p.helices > 0) plunge_kinds += fmt::format("; {}°", number_text(job_.ramp_deg, 3));
    return fmt::format("{}: {}", russian_name(job_.plunge), plunge_kinds);
  }

  const Milled& milled_;
  const area::Job& job_;
  Lang lang_;
  std::vector<MillLine> lines_;
};

}  // namespace

std::vector<MillLine> mill_summary(const Milled& milled, Lang lang) { return MillSummary(milled, lang).lines(); }

std::string warning_of_holes(const Milled& milled, Lang lang) {
  const area::AreaPath& path = milled.path.path;
  if (path.plunges.no_room == 0) return {};
  std::string holes;
  for (const Vec2 hole : path.holes) holes += (holes.empty() ? "" : "; ") + hole_place(hole);
  return translated_in(lang, texts::milling::no_room_for_ramp, holes);
}

AlarmReport report_of(const DrawingFault& fault, std::string_view drawing, const std::string& file) {
  AlarmReport report;
  report.alarm = fault.alarm;
  report.file = file;
  if (fault.line == 0) return report;
  report.origin.line = fault.line;
  report.origin.column = fault.alarm.where.begin + 1;
  report.line_text = text_of_line(drawing, fault.line);
  if (fault.alarm.where.end > report.line_text.size()) report.alarm.where = {};
  return report;
}

MillPicture mill_picture(const Milled& milled, const ControlDef& def, const std::string& title, Lang lang) {
  const std::string subtitle = fmt::format("{}   Ø{}   {}", scheme_with_direction(milled.job), number_text(2 * milled.job.radius),
                                           lang == Lang::ru ? def.name.ru : def.name.en);
  const area::AreaPath& path = milled.path.path;
  return {milled.shape.zones, path.moves, path.holes, milled.job.radius, milled.job.top, title, subtitle, lang};
}

}  // namespace kadr
