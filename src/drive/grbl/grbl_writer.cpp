// Writes actions as lines for a controller of the Grbl family. Used by panel/grbl_axes, tested by tests/drive/grbl_writer_test.cpp.

#include "drive/grbl/grbl_writer.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "action/by_kind.h"
#include "base/units.h"
#include "config/texts.h"
#include "texts/grbl_machine.h"

namespace kadr::drive {
namespace {

constexpr double parts_of_mm = 10'000;   // lengths are written with four decimals; a float of Grbl has no more at 1000 mm
constexpr double same_shift = 1e-7;      // mm; a smaller difference of work and machine coordinates is a rounding error
constexpr double shortest_chord = 0.05;  // mm; Grbl takes an arc whose rounded ends coincide for a full circle, so shorter ones are lines
constexpr double longest_arc = 0.999;    // revolutions; Grbl's G2 and G3 sweep one revolution at most
constexpr double same_radius = 0.004;    // mm; Grbl refuses an arc whose radii differ by more than 0.005 mm (error:33)
constexpr double minute = 60;

/// Returns a number with four decimals, without the zeros at its end.
std::string decimals(double value) {
  std::string text = fmt::format("{:.4f}", std::round(value * parts_of_mm) / parts_of_mm + 0.0);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

GrblPoint machine_point(const Axes& axes) { return {axes[0], axes[1], axes[2]}; }

bool moves_further_axes(const Step& step, const Motion& motion) {
  for (std::size_t a = grbl_axes; a < step.roles.count; ++a)
    if (step.from.machine[a] != motion.machine[a]) return true;
  return false;
}

tl::unexpected<std::string> no_such(const std::string& what) { return tl::unexpected(translated(texts::grbl_machine::not_possible, what)); }

}  // namespace

GrblWriter::GrblWriter(const GrblSettings& settings) {
  const double unit = settings.value(13, 0) != 0 ? mm_per_inch : 1;
  for (const char* const name : {"G54", "G92"})
    if (const auto found = settings.offsets.find(name); found != settings.offsets.end())
      for (std::size_t a = 0; a < grbl_axes; ++a) shift_[a] += found->second[a] * unit;
  constexpr int first_rate = 110, first_acceleration = 120;
  constexpr double usual_rate = 500, usual_acceleration = 10;  // Grbl's defaults
  for (int a = 0; a < int(grbl_axes); ++a) {
    rate_[std::size_t(a)] = settings.value(first_rate + a, usual_rate);
    const double its = settings.value(first_acceleration + a, usual_acceleration);
    acceleration_ = a == 0 ? its : std::min(acceleration_, its);
  }
}

void GrblWriter::forget() {
  at_.reset();
  has_modes_ = false;
  motion_ = -1;
  plane_ = 0;
  feed_.clear();
  speed_.clear();
}

tl::expected<std::vector<JobLine>, std::string> GrblWriter::write(const Step& step, std::uint32_t number) {
  lines_.clear();
  number_ = number;
  const Written done = by_kind(
      step.action, [&](const Motion& one) { return motion(step, one); },
      [&](const Dwell& dwell) -> Written {
        if (dwell.seconds > 0) add_plain("G4P" + decimals(dwell.seconds), dwell.seconds);
        return {};
      },
      [&](const Spindle& one) { return spindle(one, step.pause); },
      [&](const Speed& speed) -> Written {
        const std::string word = "S" + decimals(speed.surface ? speed.rpm : speed.value);
        if (word != speed_) add_plain(speed_ = word, 0);
        if (!spindle_.empty()) spindle_ = spindle_.substr(0, 2) + word;
        return {};
      },
      [&](const CoolantSwitch& one) -> Written {
        coolant(one.what);
        return {};
      },
      [&](const ToolChange& change) -> Written {
        if (change.there) return {};
        ++stops_;
        changes_tool_ = step.action.origin.number;
        stop_for_tool();
        return {};
      },
      [&](const Stop&) -> Written {
        ++stops_;
        return {};
      },
      [&](const Couple&) -> Written { return no_such(plain_text(texts::grbl_machine::coupled_axes)); },
      same<Written, ToolSelect, MachineFunction, AuxiliaryFunction, Message, FrameChange, SurfaceSpeed, Sync, ZoneChange, Uncouple,
           CompensationBreak, CompensationCorner, CompensationCheck>(Written()));
  if (!done) return tl::unexpected(done.error());
  return std::move(lines_);
}

std::vector<JobLine> GrblWriter::probe(const GrblPoint& from, std::size_t axis, double end, double feed) {
  lines_.clear();
  number_ = 0;
  GrblPoint to = from;
  to[axis] = end;
  std::vector<GrblPoint> path = {from, to};
  const double seconds = seconds_of(path, feed);
  add(fmt::format("G38.2{}{}F{:.1f}", "XYZ"[axis], decimals(end - shift_[axis]), feed), seconds, std::move(path));
  lines_.back().kind = LineKind::alone;
  lines_.back().probes = true;
  forget();
  return std::move(lines_);
}

GrblWriter::Written GrblWriter::motion(const Step& step, const Motion& motion) {
  if (changes_tool_ != 0 && changes_tool_ == step.action.origin.number) return no_such(plain_text(texts::grbl_machine::tool_and_motion));
  if (moves_further_axes(step, motion)) return no_such(plain_text(texts::grbl_machine::further_axis));
  if (motion.kind == MotionKind::thread) return no_such(plain_text(texts::grbl_machine::thread));
  if (motion.kind == MotionKind::probe) return no_such(plain_text(texts::grbl_machine::probe_motion));
  if (spindle_waits_ && restores_spindle_) switch_spindle();
  const bool rapid = motion.kind == MotionKind::rapid || motion.kind == MotionKind::home;
  if (!rapid && !(feed_of(step, motion) > 0)) return no_such(plain_text(texts::grbl_machine::no_feed));
  if (step.curve().straight() && !controls_tip(step.from, motion)) line(step, motion);
  else if (!arc(step, motion)) chords(step, motion);
  return {};
}

void GrblWriter::add(std::string text, double seconds, std::vector<GrblPoint> path) {
  if (!std::exchange(has_modes_, true)) lines_.push_back({"G21G90G94G17G49G54", number_, LineKind::plain, 0, {}});
  lines_.push_back({std::move(text), number_, LineKind::plain, seconds, std::move(path)});
}

/// Returns the words of the axes that move; all axes if it is not known where they are.
std::string GrblWriter::to(const GrblPoint& end) {
  std::string words;
  for (std::size_t a = 0; a < grbl_axes; ++a)
    if (const std::string value = decimals(end[a] - shift_[a]); !at_ || value != decimals((*at_)[a] - shift_[a])) words += "XYZ"[a] + value;
  at_ = end;
  return words;
}

/// Returns the feed along the path, mm/min. A feed that counts another length is what gives the same time.
double GrblWriter::feed_of(const Step& step, const Motion& motion) const {
  if (dry_feed_ > 0) return dry_feed_;
  const MotionTime& time = step.time;
  if (motion.along == FeedAlong::path || step.curve().measures_path(motion.along)) return time.feed;
  return time.seconds > 0 ? time.length / time.seconds * minute : time.feed;
}

std::string GrblWriter::feed_word(double feed) {
  const std::string word = "F" + fmt::format("{:.1f}", std::max(feed, 0.1));
  return word == feed_ ? std::string() : feed_ = word;
}

/// Returns the time of a path that begins and ends at rest, s: it is longer than that of a path whose neighbours continue it.
double GrblWriter::seconds_of(const std::vector<GrblPoint>& path, double feed) const {
  double length = 0, least = 0;  // `least`: time that the axes' greatest feeds permit
  for (std::size_t i = 1; i < path.size(); ++i) {
    double square = 0, longest = 0;
    for (std::size_t a = 0; a < grbl_axes; ++a) {
      const double way = std::fabs(path[i][a] - path[i - 1][a]);
      square += way * way;
      longest = std::max(longest, way / rate_[a]);
    }
    length += std::sqrt(square);
    least += longest * minute;
  }
  const double even = feed > 0 ? std::max(length / feed * minute, least) : least;
  if (!(even > 0)) return 0;
  return std::min(even + length / even / acceleration_, 2 * std::sqrt(length / acceleration_) + even);
}

void GrblWriter::line(const Step& step, const Motion& motion) {
  const bool rapid = motion.kind == MotionKind::rapid || motion.kind == MotionKind::home;
  std::vector<GrblPoint> path = {at_.value_or(machine_point(step.from.machine)), machine_point(motion.machine)};
  const std::string words = to(path.back());
  if (words.empty()) return;
  const int code = rapid ? 0 : 1;
  std::string text = motion_ == code ? std::string() : fmt::format("G{}", code);
  motion_ = code;
  const double feed = rapid ? 0 : feed_of(step, motion);
  text += words;
  if (!rapid) text += feed_word(feed);
  const double seconds = seconds_of(path, feed);
  add(std::move(text), seconds, std::move(path));
}

/// Writes a curve as chords in machine coordinates.
void GrblWriter::chords(const Step& step, const Motion& motion) {
  const Curve& curve = step.curve();
  const int pieces = std::max(curve.pieces(chord), controls_tip(step.from, motion) ? 100 : 1);
  const double feed = feed_of(step, motion);
  for (int i = 1; i <= pieces; ++i) {
    const double part = double(i) / pieces;
    std::vector<GrblPoint> path = {at_.value_or(machine_point(step.from.machine))};
    path.push_back(i == pieces ? machine_point(motion.machine)
                               : machine_point(machine_along(step.roles, step.from, motion, curve.at(part), part)));
    const std::string words = to(path.back());
    if (words.empty()) continue;
    std::string text = (motion_ == 1 ? "" : "G1") + words + feed_word(feed);
    motion_ = 1;
    const double seconds = seconds_of(path, feed);
    add(std::move(text), seconds, std::move(path));
  }
}

/// Writes an arc or a helix as G2 or G3. Returns false if the controller does not have this curve, or would take it for another one.
bool GrblWriter::arc(const Step& step, const Motion& motion) {
  if (!is_arc(motion.kind) || step.curve().surface() != PathSurface::plane || step.from.turn || step.from.space ||
      motion.turns > longest_arc || (motion.detail && (!motion.detail->followers.empty() || motion.detail->parked != 0)))
    return false;
  const std::size_t first = motion.first, second = motion.second;
  if (first >= grbl_axes || second >= grbl_axes) return false;
  for (std::size_t a = 0; a < grbl_axes; ++a)
    if (std::fabs(step.from.machine[a] - step.from.work[a] - motion.machine[a] + motion.to[a]) > same_shift) return false;
  const Axes &from = step.from.work, &end = motion.to;
  const double i = motion.center.x - from[first], j = motion.center.y - from[second];
  const double radius_at_end = std::hypot(end[first] - motion.center.x, end[second] - motion.center.y);
  if (std::fabs(std::hypot(i, j) - radius_at_end) > same_radius) return false;
  if (std::hypot(end[first] - from[first], end[second] - from[second]) < shortest_chord) return false;
  // G18 of Grbl turns from Z to X, as the plane ZX of the actions does if its first axis is Z.
  const bool swapped = (first + 1) % grbl_axes != second;
  const int plane = first + second == 1 ? 17 : first + second == 2 ? 18 : 19;
  const int code = (motion.kind == MotionKind::arc_cw) != swapped ? 2 : 3;
  const Curve& curve = step.curve();
  std::vector<GrblPoint> path = {machine_point(step.from.machine)};
  const int pieces = curve.pieces(chord);
  for (int n = 1; n <= pieces; ++n) {
    const double part = double(n) / pieces;
    path.push_back(n == pieces ? machine_point(motion.machine)
                               : machine_point(machine_along(step.roles, step.from, motion, curve.at(part), part)));
  }
  const double feed = feed_of(step, motion);
  std::string text;
  if (plane != plane_) text += fmt::format("G{}", plane_ = plane);
  if (motion_ != code) text += fmt::format("G{}", motion_ = code);
  text += to(path.back());
  constexpr const char* offsets = "IJK";
  text += fmt::format("{}{}{}{}", offsets[first], decimals(i), offsets[second], decimals(j)) + feed_word(feed);
  const double seconds = seconds_of(path, feed);
  add(std::move(text), seconds, std::move(path));
  return true;
}

/// Grbl does not wait until the spindle is at its speed: the dwell does.
void GrblWriter::switch_spindle() {
  spindle_waits_ = false;
  add_plain(spindle_, 0);
  if (spin_up_ > 0) add_plain("G4P" + decimals(spin_up_), spin_up_);
}

/// Nobody changes a tool in a spindle that turns.
void GrblWriter::stop_for_tool() {
  if (spindle_.empty() || spindle_waits_) return;
  add_plain("M5", 0);
  spindle_waits_ = true;
}

GrblWriter::Written GrblWriter::spindle(const Spindle& spindle, double pause) {
  switch (spindle.dir) {
    case SpindleDir::stop:
      spindle_.clear();
      spindle_waits_ = false;
      add_plain("M5", 0);
      return {};
    case SpindleDir::cw:
    case SpindleDir::ccw:
      speed_ = "S" + decimals(spindle.rpm);
      spindle_ = (spindle.dir == SpindleDir::cw ? "M3" : "M4") + speed_;
      spin_up_ = pause;
      switch_spindle();
      return {};
    case SpindleDir::orient:
    case SpindleDir::position: return no_such(plain_text(texts::grbl_machine::oriented_spindle));
  }
  return {};
}

void GrblWriter::coolant(Coolant what) { add_plain(what == Coolant::off ? "M9" : what == Coolant::mist ? "M7" : "M8", 0); }

}  // namespace kadr::drive
