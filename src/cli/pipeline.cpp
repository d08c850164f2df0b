// The rooms in a row: program → control → machine → Steps → trace, summary, plot. For the rest of cli.

#include "cli/pipeline.h"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "cli/program_files.h"
#include "cli/setup_options.h"
#include "config/control_file.h"
#include "config/guess.h"
#include "config/read_file.h"
#include "lang/text/utf16.h"

namespace kadr::cli {
namespace {

constexpr unsigned shown_each = 64;  // batches between two looks at the progress

/// The set-up file, over it what the options state; complains of what is wrong.
bool take_setup(Job& job, const Options& options) {
  std::vector<SetupSource> sources;
  if (!options.setup.empty()) {
    auto file = setup_source(options.setup);
    if (!file) return complain(file.error()), false;
    sources.push_back(std::move(*file));
  }
  auto stated = setup_of_options(options, *job.def, job.lang);
  if (!stated) return complain(stated.error()), false;
  sources.insert(sources.end(), stated->begin(), stated->end());
  if (sources.empty()) return true;
  auto read = read_setup(sources, job.def.get(), job.lang);
  if (!read) return complain(read.error()), false;
  job.setup = std::move(read->setup);
  job.stated = std::move(read->stated);
  if (!options.setup.empty()) job.setup_lines = std::move(read->lines);
  return true;
}

/// What the corners of `path` may expect after a batch.
ContourCorners::Follows behind(Control::State state) {
  switch (state) {
    case Control::State::running: return ContourCorners::Follows::more;
    case Control::State::stopped: return ContourCorners::Follows::alarm;
    default: return ContourCorners::Follows::nothing;
  }
}

}  // namespace

const AlarmTexts& Job::texts() const {
  if (texts_) return *texts_;
  auto texts = AlarmTexts::load(def.get());
  if (!texts) complain(texts.error());
  texts_ = std::make_unique<AlarmTexts>(texts ? std::move(*texts) : AlarmTexts());
  return *texts_;
}

namespace {

/// The beginning of a program as text.
std::optional<std::string> sample_of(const std::string& file, const std::string& encoding_name) {
  SaidEncoding said;
  (void)read_encoding(encoding_name, said);  // a name that nobody knows is refused later
  OpenedText opened = open_text(file, said);
  if (!opened.source) return std::nullopt;
  LineReader reader(std::move(opened.source));
  const std::string_view sample = reader.sample();
  const auto encoding = opened.encoding ? opened.encoding : detect_encoding(sample);
  std::string text;
  if (encoding) (void)append_utf8(sample, *encoding, text);  // up to the first damaged byte
  else text = sample;
  return text;
}

}  // namespace

std::string control_by_pattern(const Options& options, const std::string& file) {
  for (const std::string& rule : options.control_for) {
    const std::size_t equals = rule.rfind('=');
    if (equals != std::string::npos && is_like(file, rule.substr(0, equals))) return rule.substr(equals + 1);
  }
  return options.control;
}

std::optional<std::string> control_of(const Options& options, const std::string& file) {
  if (std::string named = control_by_pattern(options, file); !named.empty()) return named;
  const auto text = sample_of(file, options.encoding);
  if (!text) return complain(fmt::format("{}: {}", file, told_errno(errno))), std::nullopt;
  const Guess guess = guess_control(*text);
  const bool ru = language(options) == Lang::ru;
  if (guess.control.empty())
    complain(ru ? fmt::format("{}: УЧПУ неизвестно ({}); если это УП: --control", file, guess.reason_ru)
                : fmt::format("{}: unknown, no program of a control that Kadr knows ({}); if it is one: --control", file, guess.reason_en));
  else if (!options.guesses_silently)
    complain(ru ? fmt::format("{}: похоже на {} ({}); иначе: --control", file, guess.control, guess.reason_ru)
                : fmt::format("{}: looks like {} ({}); otherwise: --control", file, guess.control, guess.reason_en));
  return guess.control;
}

std::string Job::place_of(const std::string& key) const {
  const std::uint32_t line = line_of(setup_lines, key);
  return line == 0 ? setup_file : fmt::format("{}:{}", setup_file, line);
}

std::string no_encoding(const std::string& name, bool ru) {
  return fmt::format(fmt::runtime(ru ? "кодировки «{}» нет; есть: {}" : "no encoding '{}': {}"), name,
                     "utf-8, cp1251, koi8-r, cp866, utf-16, utf-16le, utf-16be, iso7, eia");
}

std::optional<Job> make_job(const Options& options, const std::string& file) {
  const auto control = control_of(options, file);
  if (!control || control->empty()) return std::nullopt;
  return make_job(options, file, *control);
}

std::optional<Job> make_job(const Options& options, const std::string& file, const std::string& control) {
  Job job;
  job.file = file;
  job.setup_file = options.setup;
  job.lang = language(options);
  job.program = options.program;
  auto def = load_control(control);
  if (!def) return complain(def.error()), std::nullopt;
  job.def = std::make_unique<ControlDef>(std::move(*def));
  auto profile = load_machine(options.machine.empty() ? "generic" : options.machine);
  if (!profile) return complain(profile.error()), std::nullopt;
  job.profile = std::move(*profile);
  if (!take_setup(job, options)) return std::nullopt;
  if (const std::string error = Plc(job.setup.events).error(); !error.empty()) return complain(options.setup + ": " + error), std::nullopt;
  job.setup.skip.insert(job.setup.skip.end(), options.skip.begin(), options.skip.end());
  job.setup.optional_stop = job.setup.optional_stop || options.optional_stop;
  if (!read_encoding(options.encoding, job.encoding)) return complain(no_encoding(options.encoding, job.lang == Lang::ru)), std::nullopt;
  return job;
}

VirtualTime virtual_time(const TimeSplit& split) { return {split.total(), split.cutting}; }

ChannelRun::ChannelRun(Control& control, const MachineProfile& profile, const Setup& setup, const Outlets& outlets, Logic& logic)
    : control_(control),
      setup_(setup),
      outlets_(outlets),
      logic_(logic),
      corners_(control.tool_position()),
      compensation_(control.tool_position()),
      machine_(control.axes(), control.rotary(), profile, setup, control.tool_position()),
      rates_(rates_of(profile, setup, control.axes())),
      least_most_(rates_.least_most()),
      clock_(outlets.clock) {
  control.on_warning = [this](const AlarmReport& warning) {
    if (!(ahead_ && ahead_->keep(warning))) outlets_.warning(warning);
  };
  if (control.has_machine_parameters()) machine_.obey_parameters(setup);
  control.on_signal = [this](const std::string& name, bool on) { machine_.set_signal(name, on); };
  const bool answers = machine_.has_limits() || !logic.plc.idle();
  if (answers) control.hand_over_each_block();
  if (!answers && logic.channels.size() == 1 && !control.on_changes) ahead_.emplace(control);
  if (logic.plc.idle()) return;
  control.on_block = [this](const Origin& origin, bool at_end) { apply(logic_.plc.block(origin, at_end), control_, logic_.channels); };
}

ChannelRun::~ChannelRun() {
  ahead_.reset();  // before what the control calls goes
  control_.on_block = nullptr;
  control_.on_signal = nullptr;
  control_.on_warning = nullptr;
}

/// Beside a compensated contour the control knows the programmed point only.
void ChannelRun::note_place() {
  if (compensation_.beside()) stopped_.machine_stood = machine_.position();
}

ChannelRun::State ChannelRun::stop(const AlarmReport& report) {
  note_place();
  stopped_.report = report;
  return State::stopped;
}

/// lang, control: blocks → actions.
Control::State ChannelRun::next_batch() {
  if (ahead_ && ahead_->is_going()) {
    const Control::State state = ahead_->take(batch_, early_warnings_);
    for (const AlarmReport& warning : early_warnings_) outlets_.warning(warning);
    return state;
  }
  constexpr double ms = 1000;
  if (control_.reads_clock()) control_.set_time(now() * ms, spent().cutting * ms);
  const Control::State state = control_.run(batch_);
  // It pays only where the rooms after the control have about as much to do: else handing over costs more than it saves.
  const bool pays = outlets_.works_long || compensation_.at_work();
  if (ahead_ && pays && state == Control::State::running && !control_.hands_over_each_block()) ahead_->start();
  return state;
}

/// The control, to be asked for something.
Control& ChannelRun::settled() {
  if (ahead_) ahead_->settle();
  return control_;
}

ChannelRun::State ChannelRun::step() {
  const Control::State state = next_batch();
  const bool is_ahead = ahead_ && ahead_->is_going();              // then control_ is settled() only
  const auto corner_fault = corners_.take(batch_, behind(state));  // path: calculated corners, roundings
  if (outlets_.programmed)
    for (const Action& action : batch_) outlets_.programmed(action);
  const auto fault = compensation_.take(batch_, corner_fault || state != Control::State::running);  // path: the tool's radius
  ToolPosition before = machine_.position();
  const auto follows = state == Control::State::running ? VirtualMachine::Follows::more : VirtualMachine::Follows::nothing;
  const auto taken =
      machine_.take(batch_, follows, [this](const ProbeAnswer& touched) { control_.answer(touched); });  // limits, zones, probes
  batch_.cut(taken.done);
  hand_out(std::move(before));
  if (!logic_.plc.idle())
    for (const Action& action : batch_) apply(logic_.plc.action(action), control_, logic_.channels);
  if (taken.alarm) {
    const AlarmReport report = settled().report_for(*taken.alarm, taken.origin);
    if (taken.refused) control_.refused();  // it hands over each block then: it is not ahead
    if (!outlets_.alarm(report)) {
      stopped_.machine_stood = machine_.position();
      return stop(report);
    }
    if (taken.refused) return State::running;
  }
  for (const CompensationFault& cut : compensation_.warnings()) {
    AlarmReport report = settled().report_for(cut.alarm, cut.origin);
    report.other = settled().line_at(cut.other);
    outlets_.warning(report);
  }
  if (!goes_on_after(fault) || !goes_on_after(corner_fault)) return State::stopped;
  if (state == Control::State::stopped || (!is_ahead && control_.is_stopped())) {
    const AlarmReport report = control_.report();
    if (!outlets_.alarm(report)) return stop(report);
    control_.go_on();
  }
  if (state == Control::State::ended) {
    constexpr double ms = 1000;
    if (control_.reads_clock()) control_.set_time(now() * ms, spent().cutting * ms);
    note_place();
    return State::ended;
  }
  if (outlets_.writable && !outlets_.writable()) return State::stopped;
  if (outlets_.stop.asked()) {
    const AlarmReport report = settled().report_for(alarm(AlarmId::interrupted, {}), batch_.empty() ? Origin() : batch_.back().origin);
    (void)outlets_.alarm(report);
    return stop(report);
  }
  if (outlets_.progress != nullptr && ++steps_ % shown_each == 0 && outlets_.progress->is_due()) outlets_.progress->show(settled());
  return state == Control::State::waiting ? State::waiting : State::running;
}

/// An alarm of `path`: the control was ahead of it.
bool ChannelRun::goes_on_after(const std::optional<CompensationFault>& fault) {
  if (!fault) return true;
  const AlarmReport report = settled().report_for(fault->alarm, fault->origin);
  if (outlets_.alarm(report)) return true;
  stopped_.machine_stood = machine_.position();
  stopped_.report = report;
  return false;
}

TimeEstimate& ChannelRun::clock() {
  if (clock_ == nullptr) {
    clock_ = &own_clock_.emplace(machine_.roles(), rates_);
    clock_->spindle(setup_.spindle().rpm);
  }
  return *clock_;
}

double ChannelRun::now() { return goes_on_at_ + (spent().now - spent_then_); }

void ChannelRun::wait_until(double at) {
  const double from = now();
  if (!(at > from)) return;
  waited_ += at - from;
  goes_on_at_ = at;
  spent_then_ = spent().now;
}

/// out: trace, summary, plot; here alone it is told where the tool stands before each action, and when that happens.
///   from  before the batch
void ChannelRun::hand_out(ToolPosition from) {
  const auto watched = [this](const Action& action) { return is_suspect(action); };
  const bool looks_on = outlets_.step || clock_ != nullptr;
  if (!looks_on && (too_fast_told_ || std::none_of(batch_.begin(), batch_.end(), watched))) return;
  Steps steps(machine_.roles(), std::move(from), clock_);
  for (const Action& action : batch_) give(steps, action);
}

void ChannelRun::show(const Action& action) {
  Steps steps(machine_.roles(), machine_.position(), clock_);
  give(steps, action);
}

void ChannelRun::give(Steps& steps, const Action& action) {
  const double begins = outlets_.step && clock_ != nullptr ? now() : 0;
  steps.give(action, begins, [this](const Step& step) {
    if (outlets_.step) outlets_.step(step);
    if (!too_fast_told_ && is_suspect(step.action)) watch_feed(step);
  });
}

/// A motion whose feed some axis may not reach.
bool ChannelRun::is_suspect(const Action& action) const {
  const auto* const motion = std::get_if<Motion>(&action.what);
  return motion != nullptr && motion->feed > least_most_ && motion->unit == FeedUnit::mm_per_min;
}

/// motion: a feed that an axis cannot do is told once; the motion takes what it takes at rapid.
void ChannelRun::watch_feed(const Step& step) {
  constexpr double rounding = 1e-9;
  const Motion& motion = *step.motion();
  const SlowestAxis slowest = slowest_axis(step.roles, step.curve(), motion, rates_.most);
  if (!(slowest.minutes > step.curve().length(motion.along) / motion.feed * (1 + rounding))) return;
  const Alarm told = warning(AlarmId::feed_above_rapid, {}, motion.feed, control_.axes()[slowest.axis], rates_.most[slowest.axis]);
  outlets_.warning(settled().report_for(told, step.action.origin));
  too_fast_told_ = true;
}

Stopped carry_out(Control& control, const Job& job, const Outlets& outlets) {
  Logic logic{Plc(job.setup.events), {&control}};
  ChannelRun run(control, job.profile, job.setup, outlets, logic);
  for (;;) {
    const ChannelRun::State state = run.step();
    if (state == ChannelRun::State::stopped) return run.stopped();
    if (state != ChannelRun::State::ended) continue;
    apply(logic.plc.program_end(), control, logic.channels);
    return run.stopped();
  }
}

}  // namespace kadr::cli
