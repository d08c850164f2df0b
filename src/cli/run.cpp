// kadr run: executes a program, or the programs of several channels. The command also writes the trace, the summary and the pictures.

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "cli/job/drive.h"
#include "cli/job/found.h"
#include "cli/job/job.h"
#include "cli/job/outputs.h"
#include "cli/job/progress.h"
#include "cli/job/state.h"
#include "cli/job/stop_signals.h"
#include "cli/job/terminal.h"
#include "cli/job/written_files.h"
#include "cli/run_view.h"
#include "config/read_file.h"
#include "config/setup/setup_names.h"
#include "config/state/state_json.h"
#include "out/picture/plot/plot_page.h"
#include "out/text/alarm_print.h"
#include "out/text/page_file.h"
#include "out/text/summary_json.h"
#include "session/unstated.h"
#include "texts/job.h"

namespace kadr::cli {
namespace {

/// Checks that the picture of the option can be drawn. Prints an error and returns false otherwise.
bool can_draw(const char* option, const std::string& name) {
  const std::string fault = name.empty() ? "" : page_fault(name);
  if (!fault.empty()) complain(fmt::format("{} {}", option, fault));
  return fault.empty();
}

/// True if an output needs the least-time planner.
bool needs_planner(const Options& options, const MachineProfile& profile) {
  const bool counts = profile.planner == PlannerMode::optimal && (!options.quiet || options.json);
  return counts || !options.samples.empty() || options.why || !options.plot_speed.empty() || !options.colour.empty();
}

/// True if only the samples need the least-time planner. Then the summary shows the planner's time in addition to the machining time.
bool is_for_samples_alone(const Options& options, const MachineProfile& profile) {
  const bool counts = profile.planner == PlannerMode::optimal && (!options.quiet || options.json);
  return !counts && !options.why && options.plot_speed.empty() && options.colour.empty();
}

/// True if the control can move axes synchronously with the spindle (threads).
bool has_threads(const ControlDef& def) {
  return std::any_of(def.codes.begin(), def.codes.end(), [](const CodeRow& row) { return row.function == Function::thread; });
}

/// True if the trace or the samples go to the terminal. Then no progress bar is shown, since the bar would make the lines of the trace or
/// of the samples unreadable.
bool writes_to_terminal(const Options& options) { return (options.trace == "-" || options.samples == "-") && ::isatty(STDOUT_FILENO) != 0; }

class RunCommand {
 public:
  RunCommand(const Options& options, const Job& job, Session& session, Drive& drive, const Outputs& outputs)
      : options_(options),
        job_(job),
        lang_(language(options)),
        session_(session),
        drive_(drive),
        channels_(session.channels()),
        outputs_(outputs),
        progress_(options.quiet || writes_to_terminal(options)),
        found_(job.texts(), lang_, stderr, options.every) {
    std::FILE* const trace = outputs.stream("--trace");
    std::FILE* const samples = outputs.stream("--samples");
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      const Channel& channel = channels_[i];
      const auto& axes = channel.control->axes();
      const Rates rates = rates_of(job.profile, channel.setup, axes);
      View& view = *views_.emplace_back(std::make_unique<View>(channel, rates));
      const AxisMask rotary = channel.control->rotary();
      if (trace != nullptr) view.trace.emplace(trace, axes, rotary, channel.setup.points);
      if (view.trace && channels_.size() > 1) view.trace->set_channel(channel.number, channel.number == job_.setup.channel);
      if (const auto rules = session.look_ahead())
        view.statistics.count_by(rules->accelerates() ? TimeBasis::accelerated : TimeBasis::limited);
      if (i != session.own()) continue;
      if (!options.plot.empty()) view.plot.emplace(axes, rotary, channel.control->tool_position());
      if (needs_planner(options, job.profile)) {
        view.planned = &session.plan(i, options.limits.stop);
        view.planned->work_in_background();
      }
      if (samples != nullptr)
        view.planned->write_samples(samples, {options.rate, options.overrides, has_threads(*job.def), options.max_time});
      if (samples != nullptr && is_for_samples_alone(options, job.profile)) view.planned->end_with_samples();
      if (std::FILE* const tips = outputs.stream("--samples-tip"); tips != nullptr) view.planned->write_tips(tips);
      if (!options.plot_speed.empty()) view.planned->record_speed();
      if (!options.colour.empty()) {
        view.plot->colour_by(options.colour == "speed" ? PlotColour::speed : PlotColour::limit);
        view.planned->colour(*view.plot);
      }
      if (options.why) view.planned->record_lost_time();
    }
  }

  Exit run() {
    if (channels_.size() == 1) run_alone();
    else run_together();
    std::vector<Stopped> stopped;
    for (std::size_t i = 0; i < channels_.size(); ++i) stopped.push_back(session_.stopped(i));
    warn_unstated();
    found_.finish();
    for (const auto& view : views_)
      if (view->statistics.extents().systems().size() > 1) view->statistics.name_systems(system_names(*job_.def));
    for (std::size_t i = 0; i < views_.size(); ++i) mark_stop(*views_[i], stopped[i]);
    bool written = write_last_lines(stopped);
    if (needs_planner(options_, job_.profile)) written = finish_planned() && written;
    written = draw() && written;
    erase_bar();  // the progress bar is erased, since it may be on the terminal to which the summary goes
    if (!options_.quiet && !options_.json && drive_.wants_summary()) print_summary();
    if (options_.why) print_why();
    if (!written) return wrong_usage;
    if (std::FILE* const json = outputs_.stream("--json"); json != nullptr) write_data(json, json_of(stopped));
    const bool stood = std::any_of(stopped.begin(), stopped.end(), [](const Stopped& s) { return s.report.has_value(); });
    return stood || plan_failed_ ? alarms : ok;
  }

 private:
  /// Returns the functions that observe one channel, except the function that observes its steps.
  Outlets outlets_of(View& view) {
    const auto warn = [this, &view](const AlarmReport& report) {
      view.statistics.count(report.alarm.severity);
      found_.print_report(report);
    };
    return {.step = {},
            .warning = warn,
            .alarm =
                [warn](const AlarmReport& report) {
                  warn(report);
                  return false;
                },
            .progress_display = &progress_,
            .clock = &view.statistics.clock(),
            .programmed = view.programmed(),
            .writable = [&view] { return (!view.trace || view.trace->ok()) && (!view.planned || view.planned->ok()); },
            .stop = options_.limits.stop};
  }

  void run_alone() {
    View& view = *views_.front();
    Outlets& outlets = session_.outlets();
    outlets = outlets_of(view);
    outlets.works_long = view.trace || view.plot || view.planned;
    if (!options_.quiet || options_.json || outlets.works_long) {
      outlets.step = [&view](const Step& step) { view.show(step); };
      outlets.timed = [&view](const Step& step, double longer) { view.show_timed(step, longer); };
    } else if (!channels_.front().control->may_read_clock()) {
      outlets.clock = nullptr;  // the times of steps are not computed, since without a summary no output needs them
    }
    session_.change_outlets();
    drive_.execute(session_);
  }

  void run_together() {
    std::size_t writes = 0;
    session_.together().in_order = [&](std::size_t i, const Step& step) {
      if (!views_[i]->trace) return;
      if (i != writes) views_[writes]->trace->flush();
      views_[writes = i]->trace->write(step);
    };
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      View& view = *views_[i];
      session_.outlets(i) = outlets_of(view);
      session_.outlets(i).step = [this, &view, i](const Step& step) {
        session_.show(i, step);
        view.show(step);
      };
    }
    drive_.execute(session_);
    for (std::size_t i = 0; i < channels_.size(); ++i) views_[i]->waited = session_.waited(i);
    if (views_[writes]->trace) views_[writes]->trace->flush();
  }

  /// Marks the position of the stop in the picture. If the alarm is in another channel, no line is marked, since its line is not in this
  /// program.
  static void mark_stop(View& view, const Stopped& stopped) {
    if (!view.plot || !stopped.report) return;
    const Origin& origin = stopped.report->origin;
    view.plot->stop(stopped.channel == 0 ? ProgramLine{origin.line, origin.file} : ProgramLine{});
  }

  void warn_unstated() {
    for (const Channel& channel : channels_) {
      if (channel.number != job_.setup.channel) continue;
      if (const auto note = unstated(*channel.control, *job_.def, job_.setup, job_.stated)) found_.print_report(*note);
    }
  }

  bool write_last_lines(const std::vector<Stopped>& stopped) {
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      if (!views_[i]->trace) continue;
      TraceWriter& trace = *views_[i]->trace;
      FinalState ending = channels_[i].control->ending();
      if (stopped[i].machine_stood) {
        ending.position = stopped[i].machine_stood->work;
        ending.machine_position = stopped[i].machine_stood->machine;
      }
      const std::optional<RunState> state = channels_[i].control->run_state();
      const std::string state_text = state ? state_json(*state) : std::string();
      const LastLine more{state_text, stopped[i].channel};
      if (stopped[i].report) trace.finish(ending, *stopped[i].report, job_.texts(), lang_, more);
      else trace.finish(ending, more);
      if (trace.ok()) continue;
      complain_of_writing(options_.trace, trace.error());
      return false;
    }
    return true;
  }

  bool finish_planned() {
    for (std::size_t i = 0; i < views_.size(); ++i) {
      View* const view = views_[i].get();
      if (!view->planned) continue;
      const bool written = view->planned->finish();
      for (const AlarmReport& report : view->planned->reports(*channels_[i].control)) {
        plan_failed_ = plan_failed_ || report.alarm.severity == Severity::alarm;
        outlets_of(*view).warning(report);
      }
      if (written) continue;
      complain_of_writing(options_.samples, view->planned->error());
      return false;
    }
    return true;
  }

  bool draw() {
    tl::expected<void, std::string> drawn;
    for (std::size_t i = 0; i < views_.size(); ++i) {
      const auto& view = views_[i];
      PlotTitle title{job_.file,
                      lang_ == Lang::ru ? job_.def->name.ru : job_.def->name.en,
                      lang_,
                      view->statistics.caption(lang_),
                      view->statistics.extents().unit(),
                      {},
                      view->statistics.extents().x_is_diameter()};
      for (const std::uint16_t file : view->plot ? view->plot->files() : std::set<std::uint16_t>())
        title.files[file] = name_of_file(channels_[i].control->file_name(file));
      if (view->plot) drawn = view->plot->write(*outputs_.file("--plot"), title);
      if (drawn && view->planned && !options_.plot_speed.empty()) drawn = view->planned->draw_speed(*outputs_.file("--plot-speed"), title);
      if (!drawn) {
        complain(drawn.error());
        return false;
      }
    }
    return true;
  }

  std::string summary_of(std::size_t i) const {
    const View& view = *views_[i];
    return view.statistics.text(channels_[i].control->blocks(), lang_, view.planned ? view.planned->time() : nullptr, job_.profile.planner);
  }

  /// Prints the lines that lose the most time. With several channels, only lines of the program's own channel are printed, as for the
  /// samples.
  void print_why() const {
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      if (!views_[i]->planned) continue;
      if (channels_.size() > 1) type_into(text_goes_to(), channel_heading(channels_[i].number, lang_));
      type_into(text_goes_to(), views_[i]->planned->why(*channels_[i].control, lang_));
    }
  }

  /// Returns the stream for the summary. It is standard error if standard output receives data for programs, since the two must not be
  /// mixed; otherwise it is standard output.
  std::FILE* text_goes_to() const {
    const auto is_data = [](const std::string& name) { return name == "-"; };
    return options_.json || is_data(options_.trace) || is_data(options_.samples) || is_data(options_.samples_tip) ? stderr : stdout;
  }

  std::string json_of(const std::vector<Stopped>& stopped) const {
    RunSummary run{job_.file, job_.def->id, true, job_.profile.planner, {}};
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      const View& view = *views_[i];
      const PlannedTime* const planned = view.planned ? view.planned->time() : nullptr;
      run.channels.push_back({channels_[i].number, &view.statistics, channels_[i].control->blocks(), view.waited, planned});
      run.complete = run.complete && !stopped[i].report.has_value();
    }
    return summary_json(run);
  }

  void print_summary() const {
    std::FILE* const to = text_goes_to();
    if (channels_.size() == 1) return type_into(to, summary_of(0));
    std::vector<ChannelTime> times;
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      const View& view = *views_[i];
      times.push_back({channels_[i].number, view.statistics.time().total(), view.waited});
      type_into(to, fmt::format("{}{}\n", channel_heading(channels_[i].number, lang_), summary_of(i)));
    }
    type_into(to, channels_text(times, lang_));
  }

  const Options& options_;
  const Job& job_;
  const Lang lang_;
  Session& session_;
  Drive& drive_;
  const std::vector<Channel>& channels_;
  const Outputs& outputs_;
  Progress progress_;
  Found found_;
  std::vector<std::unique_ptr<View>> views_;
  bool plan_failed_ = false;  // true: there is no plan, or the samples ended early (exit status 1)
};

/// Stores every change of the tables and variables in the state file from now on.
///   fault  receives the first error
void save_changes(StateFile& file, Control& control, std::string& fault) {
  control.on_changes = [&](const StateChanges& changes) {
    const auto saved = file.save(changes);
    if (!saved && fault.empty()) complain(fault = saved.error());
  };
}

/// Returns the output files of the command. They are not open yet.
Outputs outputs_of(const Options& options, const Job& job) {
  Outputs outputs(language(options));
  outputs.reads(job.file);
  outputs.reads(job.setup_file);
  if (options.control.ends_with(".toml")) outputs.reads(options.control);
  if (options.machine.ends_with(".toml")) outputs.reads(options.machine);
  outputs.writes("--state", options.state, Outputs::Opened::by_its_owner);
  outputs.writes("--trace", options.trace);
  outputs.writes("--samples", options.samples);
  outputs.writes("--samples-tip", options.samples_tip);
  if (options.json) outputs.writes("--json", "-");
  outputs.writes("--plot", options.plot);
  outputs.writes("--plot-speed", options.plot_speed);
  return outputs;
}

}  // namespace

int run_by(const Options& options, Drive& drive) {
  const std::string& file = options.programs.front();
  if (!can_draw("--plot", options.plot) || !can_draw("--plot-speed", options.plot_speed)) return wrong_usage;
  if (!options.colour.empty() && options.plot.empty()) {
    complain(translated(texts::job::colour_without_plot));
    return wrong_usage;
  }
  auto job = make_job(options, file);
  if (!job) return wrong_usage;
  Outputs outputs = outputs_of(options, *job);
  if (!outputs.check()) return wrong_usage;
  std::optional<StateFile> state_file;
  if (!options.state.empty() && !(state_file = open_state(options.state, *job))) return wrong_usage;
  auto program = open_program(*job);
  if (!program || !make_folder(options.files)) return wrong_usage;
  RunLimits limits = options.limits;
  limits.writes_files = !options.files.empty();
  if (limits.writes_files) limits.files = options.files;
  limits.untouched = outputs.all();
  const auto session = make_session(*job, std::move(*program), limits);
  if (!session || !outputs.open()) return wrong_usage;
  // The destructor of this object calls Drive::leave(). The object is destroyed before the session, since leave() needs the session.
  const std::unique_ptr<Drive, void (*)(Drive*)> leaves(&drive, [](Drive* left) { left->leave(); });
  std::string state_fault;
  if (state_file) save_changes(*state_file, session->control(), state_fault);
  if (const auto nothing = drive.begin(*session, *job)) return interrupted() ? interrupted_status() : *nothing;
  const Exit exit = RunCommand(options, *job, *session, drive, outputs).run();
  print_unwritten(options, session->channels());
  if (interrupted()) return interrupted_status();
  if (exit == wrong_usage || !state_fault.empty() || !outputs.keep(files_read(session->channels()))) return wrong_usage;
  return exit;
}

int run(const Options& options) {
  auto drive = drive_of(options);
  return drive ? run_by(options, *drive) : wrong_usage;
}

}  // namespace kadr::cli
