// FeedWatch: finds feeds and spindle speeds that the programmer cannot have intended. It is used by session/checklist and tested by
// tests/checklist.py.

#include "session/checklist/feed_watch.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "action/by_kind.h"

namespace kadr {
namespace {

constexpr std::size_t max_tools = 1000;

/// Standard thread pitches of ISO 261 in mm, and standard threads per inch of ASME B1.1, B1.20.1 and ISO 228.
constexpr std::array pitches{0.2,  0.225, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.6, 0.7, 0.75, 0.8, 1.0,
                             1.25, 1.5,   1.75, 2.0, 2.5,  3.0, 3.5,  4.0, 4.5, 5.0, 5.5,  6.0};
constexpr std::array threads_an_inch{80.0, 72.0, 64.0, 56.0, 48.0, 44.0, 40.0, 36.0, 32.0, 28.0, 27.0, 24.0, 20.0, 19.0, 18.0,
                                     16.0, 14.0, 13.0, 12.0, 11.5, 11.0, 10.0, 9.0,  8.0,  7.0,  6.0,  5.0,  4.5,  4.0};

/// True if `mm` is a standard thread pitch. `near`: relative tolerance, needed because F and S are rounded in programs.
bool is_pitch(double mm, double near) {
  const auto fits = [mm, near](double pitch) { return std::fabs(mm / pitch - 1) < near; };
  for (const double pitch : pitches)
    if (fits(pitch)) return true;
  for (const double threads : threads_an_inch)
    if (fits(25.4 / threads)) return true;
  return false;
}

}  // namespace

void FeedWatch::take_tap(const Motion& motion, const Origin& origin, Advices& to) {
  const double pitch = motion.unit == FeedUnit::mm_per_rev ? motion.feed : rpm_ > 0 ? motion.feed / rpm_ : 0;
  const double inch = 25.4;
  const double written = motion.inch ? motion.feed / inch : motion.feed;
  // relative tolerance of the pitch, sufficient for an F that is rounded to one decimal place
  const double near = 0.004 + std::min(0.05 / std::max(written, 1.0), 0.01);
  // A program that does not state its unit may use inches or mm, so the pitch is compared in both units.
  if (pitch <= 0 || pitch == tap_reported_ || is_pitch(pitch, near) || is_pitch(pitch * inch, near)) return;
  tap_reported_ = pitch;
  to.add(AlarmId::tap_feed, origin, 'F', pitch, rpm_);
}

void FeedWatch::take_motion(const Step& step, const Motion& motion, Advices& to) {
  const Origin& origin = step.action.origin;
  if (motion.in_hole == HoleWork::taps && motion.kind == MotionKind::feed) return take_tap(motion, origin, to);
  const Ends ends(step.roles, step.from, motion);
  const bool moves = ends.sideways() || std::fabs(ends.to.z - ends.from.z) > Ends::least_travel;
  if (!is_cut(motion) || motion.kind == MotionKind::thread || !moves || motion.feed <= 0) return;
  // Limits of plausible feeds: the least and the greatest feed in mm/min, and the greatest feed in mm/rev.
  constexpr double least = 1, most = 100'000, most_a_turn = 5;
  const char* const unit = motion.unit == FeedUnit::mm_per_rev ? "mm/rev" : "mm/min";
  const bool per_minute = motion.unit == FeedUnit::mm_per_min, per_turn = motion.unit == FeedUnit::mm_per_rev;
  if (per_minute && motion.feed < least && !small_reported_) {
    small_reported_ = true;
    to.add(AlarmId::feed_too_small, origin, 'F', motion.feed, unit);
  }
  if (((per_minute && motion.feed > most) || (per_turn && motion.feed > most_a_turn)) && !large_reported_) {
    large_reported_ = true;
    to.add(AlarmId::feed_too_large, origin, 'F', motion.feed, unit);
  }
  const double advance = per_turn ? motion.feed : per_minute && rpm_ > 0 ? motion.feed / rpm_ : 0;
  if (advance <= 0 || tool_ == 0 || (advances_.size() >= max_tools && !advances_.contains(tool_))) return;
  Advance& of = advances_[tool_];
  if (advance < of.least) of.least = advance, of.at_least = origin;
  if (advance > of.most) of.most = advance, of.at_most = origin;
}

void FeedWatch::take(const Step& step, Advices& to) {
  by_kind(
      step.action, [&](const Motion& motion) { take_motion(step, motion, to); },
      [&](const Spindle& spindle) {
        const bool turns = spindle.dir == SpindleDir::cw || spindle.dir == SpindleDir::ccw;
        if (turns) rpm_ = spindle.rpm;
      },
      [&](const Speed& speed) { rpm_ = speed.surface ? speed.rpm : speed.value; }, [&](const ToolChange& change) { tool_ = change.tool; },
      ignores<Dwell, CoolantSwitch, ToolSelect, MachineFunction, AuxiliaryFunction, Stop, Message, FrameChange, SurfaceSpeed, Sync,
              ZoneChange, Couple, Uncouple, CompensationBreak, CompensationCorner, CompensationCheck>);
}

void FeedWatch::finish(const std::map<std::uint32_t, int>& teeth, Advices& to) {
  constexpr double least = 0.0005, most = 1;  // limits of a plausible feed per tooth, mm
  for (const auto& [tool, advance] : advances_) {
    const auto known = teeth.find(tool);
    if (known == teeth.end() || known->second <= 0) continue;
    const double of = known->second;
    if (advance.most / of > most) to.add(AlarmId::feed_per_tooth, advance.at_most, 0, advance.most / of, of);
    else if (advance.least / of < least) to.add(AlarmId::feed_per_tooth, advance.at_least, 0, advance.least / of, of);
  }
}

}  // namespace kadr
