// Draws the picture of `kadr run --plot-speed`. It shows, over the time of the least-time planner, the speed along the path with the
// commanded feed, and the axes' accelerations and jerks relative to their limits. This file is used by session/planned.

#include "out/picture/speed_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "out/picture/palette.h"
#include "out/picture/plot/plot_page.h"
#include "out/picture/plot/plot_view.h"
#include "out/picture/text_width.h"
#include "out/text/page_file.h"
#include "out/text/summary.h"
#include "texts/picture.h"
#include "texts/speed_page.h"

namespace kadr {
namespace {

using On = Spent::On;
using Column = SpeedRecord::Column;

constexpr double speed_page_width = 1600, speed_page_height = 984, speed_page_margin = 28, left = 96, top = 112;
constexpr double speed_height = 400, share_height = 130, speed_gap = 42, ribbon_height = 12;
constexpr Colour feed_ink = colour(0xE69F00);
/// Colours of the activities for which time is spent, in the order of the enum Spent::On.
constexpr std::array<unsigned, 4> inks_of_time = {0x0072B2, 0x7A8794, 0xF0C93A, 0xCC79A7};
constexpr std::array<unsigned, 6> inks_of_axes = {0xD55E00, 0x009E73, 0x6A3D9A, 0x56B4E9, 0xB2182B, 0x8C6D31};

/// Names of the activities for which time is spent, in the order of the enum Spent::On.
constexpr std::array<PlainText, 4> names_of_time = {texts::speed_page::cutting, texts::picture::rapid, texts::speed_page::dwell,
                                                    texts::speed_page::tool_change};

Colour ink_of(On on) { return colour(inks_of_time[static_cast<std::size_t>(on)]); }
Colour ink_of_axis(std::size_t axis) { return colour(inks_of_axes[axis % inks_of_axes.size()]); }

class SpeedPage {
 public:
  SpeedPage(const SpeedRecord& record, const std::vector<std::string>& axes, const PlotTitle& title)
      : record_(record), columns_(record.columns()), axes_(axes), title_(title), per_minute_(60 / mm_of(title.unit)) {
    find_top_speed();
  }

  PageText page_text() const { return {name_of_file(title_.file), speed_heading() + ". " + subtitle(), title_.lang}; }

  void draw(Canvas& canvas) const {
    canvas.fill({0, 0, speed_page_width, speed_page_height}, colour(0xFFFFFF));
    draw_title(canvas);
    if (!(record_.seconds() > 0))
      return canvas.text({speed_page_width / 2, speed_page_height / 2}, phrase(texts::picture::no_motion),
                         {22, faint_ink, Align::centre, false});
    draw_speed(canvas, {left, top, width, speed_height});
    const double second = top + speed_height + speed_gap, third = second + share_height + speed_gap, ribbon = third + share_height + 10;
    draw_shares(canvas, {left, second, width, share_height}, phrase(texts::speed_page::acceleration), &Column::acceleration);
    draw_shares(canvas, {left, third, width, share_height}, phrase(texts::speed_page::jerk), &Column::jerk);
    draw_ribbon(canvas, {left, ribbon, width, ribbon_height});
    draw_time(canvas, ribbon + ribbon_height);
    draw_legend(canvas, speed_page_height - 20);
  }

 private:
  static constexpr double width = speed_page_width - left - speed_page_margin;

  const char* phrase(PlainText text) const { return plain_text(text, title_.lang); }
  const char* name_of(On on) const { return phrase(names_of_time[static_cast<std::size_t>(on)]); }

  double x_of(double seconds) const { return left + width * std::min(1.0, seconds / record_.seconds()); }
  double x_of_column(std::size_t i) const { return x_of(static_cast<double>(i) * record_.width()); }

  /// Determines the upper end of the speed scale from the cutting motions. The curve of faster rapid motion is cut off there.
  void find_top_speed() {
    // Two multiples of the greatest cutting speed: the upper end of the speed scale, and the highest commanded feed that is shown.
    constexpr double room = 1.1, max_feed = 4;
    double cutting = 0;
    for (const Column& c : columns_) {
      if (c.on == On::cutting) cutting = std::max(cutting, c.most), feed_ = std::max(feed_, c.feed);
    }
    top_speed_ = room * per_minute_ * (cutting > 0 ? std::max(cutting, std::min(feed_, max_feed * cutting)) : record_.rapid());
    if (!(top_speed_ > 0)) top_speed_ = 1;
  }

  std::string speed_heading() const {
    return translated_in(title_.lang, texts::speed_page::speed, speed_unit_name(title_.unit, title_.lang));
  }

  std::string subtitle() const {
    return translated_in(title_.lang, texts::picture::control, title_.control) + "     " +
           translated_in(title_.lang, texts::speed_page::least_time, duration_text(record_.seconds()));
  }

  void draw_title(Canvas& canvas) const {
    canvas.text({speed_page_margin, 42}, name_of_file(title_.file), {24, ink, Align::left, true});
    canvas.text({speed_page_margin, 64}, subtitle(), {14, faint_ink, Align::left, false});
    canvas.text({speed_page_width - speed_page_margin, 42}, "Kadr", {20, colour(0xA9B4C0), Align::right, true});
  }

  /// Draws a frame with its heading, and horizontal lines with their values. `most`: the value at the upper border.
  static void draw_field(Canvas& canvas, const Area& area, const std::string& heading, double most, double step) {
    canvas.fill(area, paper);
    for (double value = 0; value <= most; value += step) {
      const double y = area.bottom() - area.height * value / most;
      canvas.line({area.x, y}, {area.right(), y}, grid, 1);
      canvas.text({area.x - 8, y + 4}, number_text(value, 3), {12, faint_ink, Align::right, false});
    }
    canvas.text({area.x, area.y - 9}, heading, {14, ink, Align::left, true});
  }

  /// Calls `take` for each run of adjacent columns of the diagram that contain data and for which `same` returns true. The arguments of
  /// `take` are the index of the first column of the run, and the index after the last one.
  template <class Same, class Take>
  void each_run(const Same& same, const Take& take) const {
    for (std::size_t first = 0; first < columns_.size();) {
      std::size_t end = first + 1;
      while (end < columns_.size() && columns_[end].seen == columns_[first].seen && same(columns_[first], columns_[end])) ++end;
      if (columns_[first].seen) take(first, end);
      first = end;
    }
  }

  /// Draws the outline of adjacent columns of the diagram as a line with steps, from left to right, or from right to left if `back` is
  /// true.
  template <class Y>
  void steps(Canvas& canvas, std::size_t first, std::size_t end, bool back, bool begins, const Y& y) const {
    for (std::size_t n = first; n < end; ++n) {
      const std::size_t i = back ? end - 1 - (n - first) : n;
      const double from = x_of_column(back ? i + 1 : i), to = x_of_column(back ? i : i + 1), at = y(columns_[i]);
      if (begins && n == first) canvas.move_to({from, at});
      else canvas.line_to({from, at});
      canvas.line_to({to, at});
    }
  }

  void draw_speed(Canvas& canvas, const Area& area) const {
    constexpr double ticks = 7;
    draw_field(canvas, area, speed_heading(), top_speed_, round_step(top_speed_ / ticks));
    const auto y_of = [&](double speed) { return area.bottom() - area.height * per_minute_ * speed / top_speed_; };
    canvas.clip(area);
    each_run([](const Column& a, const Column& b) { return a.on == b.on; },
             [&](std::size_t first, std::size_t end) {
               Colour light = ink_of(columns_[first].on);
               const Colour full = light;
               light.alpha = 0.14;
               canvas.pen(light, 1);
               steps(canvas, first, end, false, true, [&](const Column& c) { return y_of(c.most); });
               canvas.line_to({x_of_column(end), area.bottom()});
               canvas.line_to({x_of_column(first), area.bottom()});
               canvas.fill_path();
               light.alpha = 0.55;  // the light area of the diagram extends from the least to the greatest speed in each column
               canvas.pen(light, 1);
               steps(canvas, first, end, false, true, [&](const Column& c) { return y_of(c.most); });
               steps(canvas, first, end, true, false, [&](const Column& c) { return y_of(c.least); });
               canvas.fill_path();
               canvas.pen(full, 1.1);
               steps(canvas, first, end, false, true, [&](const Column& c) { return y_of(c.most); });
               canvas.stroke();
             });
    each_run(
        [](const Column& a, const Column& b) { return a.on == b.on && a.feed == b.feed; },
        [&](std::size_t first, std::size_t end) {
          if (columns_[first].on == On::cutting && columns_[first].feed > 0)
            canvas.line({x_of_column(first), y_of(columns_[first].feed)}, {x_of_column(end), y_of(columns_[first].feed)}, feed_ink, 2.2);
        });
    canvas.unclip();
    canvas.frame(area, edge, 1);
    std::string beyond;
    const auto note = [&](const char* name, double speed) {
      if (speed * per_minute_ <= top_speed_) return;
      beyond += beyond.empty() ? "" : "     ";
      beyond += translated_in(title_.lang, texts::speed_page::beyond_picture, name,
                              number_text(speed * per_minute_, per_minute_ < 60 ? 1 : 0), speed_unit_name(title_.unit, title_.lang));
    };
    note(name_of(On::rapid), record_.rapid());
    note(phrase(texts::speed_page::programmed_feed), feed_);
    canvas.text({area.right(), area.y - 9}, beyond, {13, colour(0xB04A00), Align::right, false});
  }

  void draw_shares(Canvas& canvas, const Area& area, const char* heading, LimitUsage::Share Column::*share) const {
    constexpr double most = 1.1;
    draw_field(canvas, area, heading, 100 * most, 50);
    canvas.clip(area);
    each_run([&](const Column& a, const Column& b) { return (a.*share).axis == (b.*share).axis; },
             [&](std::size_t first, std::size_t end) {
               canvas.pen(ink_of_axis((columns_[first].*share).axis), 1);
               steps(canvas, first, end, false, true,
                     [&](const Column& c) { return area.bottom() - area.height * (c.*share).part / most; });
               canvas.line_to({x_of_column(end), area.bottom()});
               canvas.line_to({x_of_column(first), area.bottom()});
               canvas.fill_path();
             });
    canvas.unclip();
    canvas.frame(area, edge, 1);
  }

  void draw_ribbon(Canvas& canvas, const Area& area) const {
    each_run([](const Column& a, const Column& b) { return a.on == b.on; },
             [&](std::size_t first, std::size_t end) {
               const double from = x_of_column(first);
               canvas.fill({from, area.y, x_of_column(end) - from, area.height}, ink_of(columns_[first].on));
             });
    canvas.frame(area, edge, 1);
  }

  /// Draws the axis below the diagrams, with the time and the program line that is executed at that time.
  void draw_time(Canvas& canvas, double y) const {
    // Two values: the least distance between marks of the time axis, units of the page, and the duration of the run, s, above which the
    // axis states minutes.
    constexpr double spacing = 110, in_minutes = 180;
    const bool minutes = record_.seconds() > in_minutes;
    const double least = record_.seconds() * spacing / width;
    const double step = minutes ? round_minutes(least) : round_step(least);
    for (double t = 0; t <= record_.seconds() * (1 + 1e-9); t += step) {
      const double x = x_of(t);
      canvas.line({x, y}, {x, y + 5}, edge, 1);
      canvas.text({x, y + 20}, minutes ? clock_text(t) : number_text(t, 3), {12, faint_ink, Align::centre, false});
      const auto i = std::min(columns_.size() - 1, static_cast<std::size_t>(t / record_.width()));
      if (columns_[i].seen)
        canvas.text({x, y + 37}, translated_in(title_.lang, texts::speed_page::line, columns_[i].line),
                    {11, faint_ink, Align::centre, false});
    }
    canvas.text({left - 28, y + 20}, phrase(minutes ? texts::speed_page::minutes_and_seconds : texts::speed_page::seconds),
                {12, ink, Align::right, true});
  }

  static double round_minutes(double least) {
    for (const double step : {15.0, 30.0, 60.0, 120.0, 300.0, 600.0, 900.0, 1800.0, 3600.0})
      if (step >= least) return step;
    return 3600 * round_step(least / 3600);
  }

  static std::string clock_text(double seconds) {
    const auto whole = static_cast<std::uint64_t>(std::lround(seconds));
    return whole < 3600 ? fmt::format("{}:{:02}", whole / 60, whole % 60)
                        : fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  }

  void draw_legend(Canvas& canvas, double y) const {
    const TextStyle style{13, ink, Align::left, false};
    double x = left;
    const auto entry = [&](Colour patch, const std::string& name, double height) {
      canvas.fill({x, y - 5 - height / 2, 22, height}, patch);
      canvas.text({x + 30, y}, name, style);
      x += 30 + text_width(name, style.size) + 24;
    };
    for (const On on : {On::cutting, On::rapid, On::dwell, On::tool_change}) entry(ink_of(on), name_of(on), 11);
    entry(feed_ink, phrase(texts::speed_page::programmed_feed), 3);
    x += 30;
    const char* const nearest = phrase(texts::speed_page::nearest_axis);
    canvas.text({x, y}, nearest, style);
    x += text_width(nearest, style.size) + 14;
    for (std::size_t axis = 0; axis < axes_.size(); ++axis)
      if (moves(axis)) entry(ink_of_axis(axis), axes_[axis], 11);
  }

  /// True if this axis is at some time nearer to its limit than the other axes.
  bool moves(std::size_t axis) const {
    return std::any_of(columns_.begin(), columns_.end(), [&](const Column& c) {
      return (c.acceleration.axis == axis && c.acceleration.part > 0) || (c.jerk.axis == axis && c.jerk.part > 0);
    });
  }

  const SpeedRecord& record_;
  const std::vector<Column>& columns_;
  const std::vector<std::string>& axes_;
  const PlotTitle& title_;
  const double per_minute_;  // factor that converts mm/s to the speed unit of the page
  double feed_ = 0;          // the greatest commanded feed, mm/s
  double top_speed_ = 1;     // upper end of the speed scale, mm/min or in/min
};

}  // namespace

tl::expected<void, std::string> draw_speed_page(const ResultFile& file, const SpeedRecord& record, const std::vector<std::string>& axes,
                                                const PlotTitle& title) {
  const SpeedPage page(record, axes, title);
  return write_page(file, speed_page_width, speed_page_height, page.page_text(), [&](Canvas& canvas) { page.draw(canvas); });
}

}  // namespace kadr
