// A program for Grbl as the lines of a job. Used by kadr drive, tested by tests/drive.py.

#include "drive/grbl/grbl_job.h"

#include <fmt/core.h>

#include <algorithm>

#include "drive/grbl/grbl_words.h"

namespace kadr::drive {
namespace {

/// Returns the line without the words M0 and M1, which Kadr executes itself.
std::string without_stop(std::string_view text) {
  std::string rest;
  each_word(text, [&](char letter, double value, std::size_t begin, std::size_t end) {
    if (letter != 'M' || (value != 0 && value != 1)) rest += text.substr(begin, end - begin);
  });
  const bool has_more = std::any_of(rest.begin(), rest.end(), [](char c) { return c >= 'A' && c <= 'Z' && c != 'N'; });
  return has_more ? rest : std::string();
}

}  // namespace

GrblJob::GrblJob(std::unique_ptr<Session> session, GrblText text, std::set<std::uint32_t> tools)
    : text_(std::move(text)), tools_(std::move(tools)), reader_(text_.text), session_(std::move(session)) {
  Outlets& outlets = session_->outlets();
  outlets.wants_times = true;
  outlets.warning = [](const AlarmReport&) {};
  outlets.alarm = [this](const AlarmReport& report) {
    needs_.alarm = report;
    alarm_line_ = report.origin.line;
    needs_.alarm->origin.line = text_.line_in_program(alarm_line_);
    return false;
  };
  if (session_->look_ahead()) outlets.timed = [this](const Step& step, double longer) { take(step, longer); };
  else outlets.step = [this](const Step& step) { take(step, 0); };
}

void GrblJob::take(const Step& step, double longer) {
  const std::uint32_t number = step.action.origin.line;
  executed_ = std::max(executed_, number);
  OfLine& line = steps_[number];
  if (std::holds_alternative<Stop>(step.action.what)) {
    line.stops = true;
    return;
  }
  line.seconds += step.motion() != nullptr ? step.time.seconds + longer : step.pause;
  note_speeds(needs_, step);
  if (const Motion* const motion = step.motion()) {
    line.probes = line.probes || motion->kind == MotionKind::probe;
    add_path(step, *motion, line);
  }
}

void GrblJob::add_path(const Step& step, const Motion& motion, OfLine& line) {
  std::vector<GrblPoint> path = path_of(step, motion);
  if (note_path(needs_, path, text_.line_in_program(step.action.origin.line))) first_at_ = step.action.origin.line;
  if (path.size() == 1) return;
  line.path.insert(line.path.end(), path.begin() + (line.path.empty() ? 0 : 1), path.end());
}

/// Executes the program until a step of a later line than `line` has come, so that `line` is complete.
void GrblJob::run_past(std::uint32_t line) {
  while (!ended_ && executed_ <= line) ended_ = session_->go_on() != Session::State::running;
}

void GrblJob::push(JobLine line) {
  ++(line.kind == LineKind::stop ? needs_.stops : needs_.lines);
  needs_.seconds += line.seconds;
  ready_.push_back(std::move(line));
}

std::optional<JobLine> GrblJob::next() {
  Line source;
  std::vector<std::uint32_t> place;
  while (ready_.empty() && !needs_.refused && !continues_at_ && reader_.next(source)) {
    const std::uint32_t number = text_.line_in_program(source.number);
    const std::string text = filtered(source.bytes, place);
    if (text.empty() || text == "%") continue;  // senders leave `%` out (spec/grbl 1.1)
    run_past(source.number);
    if (needs_.alarm && alarm_line_ <= source.number) return std::nullopt;
    if (text.front() == '$') {
      needs_.refused = number;
      return std::nullopt;
    }
    if (source.number == first_at_) needs_.first_text = text;
    OfLine done;
    if (const auto found = steps_.find(source.number); found != steps_.end()) {
      done = std::move(found->second);
      steps_.erase(steps_.begin(), std::next(found));
    }
    needs_.probes = needs_.probes || done.probes;
    JobLine line{done.stops ? without_stop(text) : text, number, LineKind::plain, done.seconds, std::move(done.path), done.probes};
    if (done.probes || writes_eeprom(text)) line.kind = LineKind::alone;
    if (!line.text.empty()) push(std::move(line));
    if (done.stops) push({text, number, LineKind::stop, 0, {}, false, tools_.contains(number)});
    if (done.probes && !passes_probes_) continues_at_ = number + 1;
  }
  if (ready_.empty()) return std::nullopt;
  JobLine line = std::move(ready_.front());
  ready_.pop_front();
  return line;
}

JobNeeds needs_of(GrblJob& job, const StopToken& stop) {
  while (!stop.requested() && job.next()) {
  }
  return job.needs();
}

Setup setup_of_controller(Setup setup, const GrblSettings& settings, const std::optional<GrblPoint>& position, const ControlDef& control) {
  constexpr const char* names[] = {"X", "Y", "Z"};
  const auto values_of = [&](const GrblPoint& point) {
    AxisValues values;
    for (std::size_t a = 0; a < grbl_axes; ++a) values[names[a]] = point[a];
    return values;
  };
  if (position) {
    setup.start = values_of(*position);
    setup.start_in_work = false;
  }
  for (const auto& [name, point] : settings.offsets) {
    if (name == "G28" || name == "G30") setup.reference_points[name == "G28" ? 1 : 2] = values_of(point);
    else if (name != "G92") setup.work_offsets[name] = values_of(point);
  }
  for (const auto& [number, value] : settings.values) {
    const bool is_known = std::any_of(control.parameters.begin(), control.parameters.end(),
                                      [n = number](const ParameterRow& row) { return row.number == n; });
    if (is_known) setup.parameters[ParameterKey{fmt::format("{:04}", number), {}, {}}] = value;
  }
  for (int a = 0; a < static_cast<int>(grbl_axes); ++a) {
    AxisLimits& axis = setup.machine[names[a]];
    if (const double rate = settings.value(110 + a, 0); rate > 0) axis.rapid = rate;
    if (const double acceleration = settings.value(120 + a, 0); acceleration > 0) axis.acceleration = acceleration;
  }
  return setup;
}

}  // namespace kadr::drive
