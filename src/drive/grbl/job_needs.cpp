// What a program needs of a machine with Grbl. Used by grbl_job and the page, tested by tests/drive.py and tests/panel_drive.py.

#include "drive/grbl/job_needs.h"

#include <fmt/core.h>

#include <algorithm>

#include "drive/grbl/grbl_writer.h"

namespace kadr::drive {
namespace {

constexpr double path_chord = 0.01;  // greatest distance of an arc from the chords by which its path is stored, mm
constexpr const char* names_of_axes[] = {"X", "Y", "Z"};

GrblPoint first_three(const Axes& axes) { return {axes[0], axes[1], axes[2]}; }

}  // namespace

void note_speeds(JobNeeds& needs, const Step& step) {
  if (const auto* const spindle = std::get_if<Spindle>(&step.action.what)) {
    const bool turns = spindle->dir == SpindleDir::cw || spindle->dir == SpindleDir::ccw;
    needs.turns_spindle = needs.turns_spindle || turns;
    if (turns) needs.speed = std::max(needs.speed, spindle->rpm);
  } else if (const auto* const speed = std::get_if<Speed>(&step.action.what)) {
    needs.speed = std::max(needs.speed, speed->surface ? speed->rpm : speed->value);
  } else if (step.motion() != nullptr) {
    needs.feed = std::max(needs.feed, step.time.feed);
  }
}

bool note_path(JobNeeds& needs, const std::vector<GrblPoint>& path, std::uint32_t line) {
  const bool is_first = !needs.first_target && path.front() != path.back();
  if (is_first) {
    needs.start = path.front();
    needs.first_target = path.back();
    needs.first_line = line;
  }
  if (path.size() == 1) return is_first;
  for (const GrblPoint& point : path) {
    if (!needs.least) needs.least = needs.most = point;
    for (std::size_t a = 0; a < grbl_axes; ++a) {
      (*needs.least)[a] = std::min((*needs.least)[a], point[a]);
      (*needs.most)[a] = std::max((*needs.most)[a], point[a]);
    }
  }
  return is_first;
}

std::vector<GrblPoint> path_of(const Step& step, const Motion& motion) {
  std::vector<GrblPoint> path = {first_three(step.from.machine)};
  const GrblPoint to = first_three(motion.machine);
  const Curve& curve = step.curve();
  const int pieces = curve.straight() ? 1 : curve.pieces(path_chord);
  if (path.front() == to && pieces == 1) return path;
  for (int i = 1; i <= pieces; ++i) {
    const double part = double(i) / pieces;
    path.push_back(i == pieces ? to : first_three(machine_along(step.roles, step.from, motion, curve.at(part), part)));
  }
  return path;
}

JobNeeds needs_of(Session& session, const GrblSettings& settings, const StopToken& stop) {
  JobNeeds needs;
  GrblWriter writer(settings);
  Outlets& outlets = session.outlets();
  outlets.wants_times = true;
  outlets.stop = stop;
  outlets.warning = [](const AlarmReport&) {};
  outlets.alarm = [&](const AlarmReport& report) {
    needs.alarm = report;
    return false;
  };
  const auto take = [&](const Step& step, double longer) {
    const std::uint32_t line = step.action.origin.line;
    note_speeds(needs, step);
    needs.seconds += step.motion() != nullptr ? step.time.seconds + longer : step.pause;
    if (const Motion* const motion = step.motion()) {
      needs.probes = needs.probes || motion->kind == MotionKind::probe;
      if (note_path(needs, path_of(step, *motion), line)) needs.first_text = session.settled_control().line_at(step.action.origin).text;
    }
    const auto lines = writer.write(step, 0);
    if (lines) needs.lines += lines->size();
    else if (needs.impossible.empty()) needs.impossible = lines.error(), needs.impossible_line = line;
  };
  if (session.look_ahead()) outlets.timed = take;
  else outlets.step = [&](const Step& step) { take(step, 0); };
  session.control().set_waiting(Control::Waiting::pass);
  (void)session.run();
  needs.stops = writer.stops();
  return needs;
}

Setup setup_with_controller(Setup setup, const GrblSettings& settings, const ControlDef* own) {
  constexpr int first_rate = 110, first_acceleration = 120;
  for (int a = 0; a < static_cast<int>(grbl_axes); ++a) {
    AxisLimits& axis = setup.machine[names_of_axes[a]];
    if (const double rate = settings.value(first_rate + a, 0); rate > 0) axis.rapid = rate;
    if (const double acceleration = settings.value(first_acceleration + a, 0); acceleration > 0) axis.acceleration = acceleration;
  }
  if (own == nullptr) return setup;
  for (const auto& [name, point] : settings.offsets)
    if (name.starts_with("G5"))
      for (std::size_t a = 0; a < grbl_axes; ++a) setup.work_offsets[name].emplace(names_of_axes[a], point[a]);
  for (const auto& [number, value] : settings.values) {
    const bool is_known =
        std::any_of(own->parameters.begin(), own->parameters.end(), [n = number](const ParameterRow& row) { return row.number == n; });
    if (is_known) setup.parameters.emplace(ParameterKey{fmt::format("{:04}", number), {}, {}}, value);
  }
  return setup;
}

}  // namespace kadr::drive
