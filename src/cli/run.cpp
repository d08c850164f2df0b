// kadr run: carry a program out; trace, summary, plot.

#include <fmt/core.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "cli/pipeline.h"
#include "cli/progress.h"
#include "cli/state.h"
#include "config/state_json.h"
#include "out/alarm_print.h"
#include "out/plot.h"
#include "out/summary.h"
#include "out/trace.h"

namespace kadr::cli {
namespace {

/// A file for the trace; closes it unless it is stdout.
class TraceFile {
 public:
  explicit TraceFile(const std::string& name) {
    if (name.empty()) return;
    file_ = name == "-" ? stdout : std::fopen(name.c_str(), "wb");
    if (file_ == nullptr) complain(fmt::format("{}: {}", name, std::strerror(errno)));
    failed_ = file_ == nullptr;
  }
  ~TraceFile() {
    if (file_ != nullptr && file_ != stdout) std::fclose(file_);
  }
  TraceFile(const TraceFile&) = delete;
  TraceFile& operator=(const TraceFile&) = delete;
  std::FILE* get() const { return file_; }
  bool failed() const { return failed_; }

 private:
  std::FILE* file_ = nullptr;
  bool failed_ = false;
};

bool plot_name_is_known(const std::string& name) {
  if (name.empty() || name.ends_with(".svg") || name.ends_with(".png")) return true;
  complain(fmt::format("--plot {}: the name must end in .svg or .png", name));
  return false;
}

}  // namespace

int run(const Options& options) {
  const std::string& file = options.programs.front();
  if (!plot_name_is_known(options.plot)) return wrong_usage;
  auto job = make_job(options, file);
  if (!job) return wrong_usage;
  std::optional<StateFile> state_file;
  if (!options.state.empty() && !(state_file = open_state(options.state, *job))) return wrong_usage;
  auto program = open_program(*job);
  if (!program) return wrong_usage;
  TraceFile trace_file(options.trace);
  if (trace_file.failed()) return wrong_usage;
  const Lang lang = language(options);
  RunLimits limits = options.limits;
  limits.writes_files = true;
  Control control(*job->def, job->setup, std::move(*program), limits);
  if (!control.setup_error().empty()) {
    complain(fmt::format("{}: the control {} has no {}", options.setup, job->def->id, control.setup_error()));
    return wrong_usage;
  }
  std::string state_fault;
  if (state_file)
    control.on_changes = [&](const StateChanges& changes) {
      const auto saved = state_file->save(changes);
      if (!saved && state_fault.empty()) complain(state_fault = saved.error());
    };
  const Ending start = control.ending();
  const ToolPosition stand{start.position, start.machine_position};
  Statistics statistics(control.axes(), control.rotary(), rates_of(job->profile, job->setup, control.axes()), stand);
  statistics.start_with(job->setup.spindle().rpm, static_cast<std::uint32_t>(std::max(job->setup.tool, 0)));
  std::optional<TraceWriter> trace;
  if (trace_file.get() != nullptr) trace.emplace(trace_file.get(), control.axes(), control.rotary(), stand, job->setup.points);
  std::optional<Plot> plot;
  if (!options.plot.empty()) plot.emplace(control.axes(), control.rotary(), stand);
  Progress progress(options.quiet);
  catch_interrupts();

  const auto say = [&](const AlarmReport& report) {
    statistics.count(report.alarm.severity);
    fmt::print(stderr, "{}", alarm_text(report, *job->texts, lang));
  };
  const auto stopped =
      carry_out(control, *job,
                {[&](const Action& action) {
                   const MotionTime time = statistics.take(action);
                   if (trace) trace->write(action, time);
                   if (plot) plot->take(action);
                 },
                 say, [&](const AlarmReport& report) { return say(report), false; }, [&](const Control& c) { progress.show(c); }});
  bool written = true;
  if (trace) {
    Ending ending = control.ending();
    if (stopped.machine_stood) {
      ending.position = stopped.machine_stood->work;
      ending.machine_position = stopped.machine_stood->machine;
    }
    TraceWriter::LastLine more;
    const std::optional<RunState> state = control.run_state();
    const std::string state_text = state ? state_json(*state) : std::string();
    more.state = state_text;
    if (!job->setup.channels.empty()) more.channel = job->setup.channel;
    if (stopped.report) trace->finish(ending, *stopped.report, *job->texts, lang, more);
    else trace->finish(ending, more);
    written = trace->ok();
    if (!written) complain(fmt::format("{}: {}", options.trace, std::strerror(errno)));
  }
  if (plot) {
    const auto drawn = plot->write(options.plot, {file, lang == Lang::ru ? job->def->name.ru : job->def->name.en, lang});
    if (!drawn) complain(drawn.error());
    written = written && drawn.has_value();
  }
  if (!options.quiet) fmt::print("{}", statistics.text(control.blocks(), lang));
  if (!written || !state_fault.empty()) return wrong_usage;
  return stopped.report ? alarms : ok;
}

}  // namespace kadr::cli
