// Faults, picture and samples of a program. Used by module.cpp; tested by tests/python_binding.py.

#include "views.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <system_error>
#include <tuple>
#include <utility>

#include "interrupt.h"

namespace kadr::python {
namespace {

/// The same limit as in `kadr check` (cli/check.cpp).
constexpr std::size_t max_faults = 1000;
constexpr std::size_t most_again = 100'000;  // limit for repetitions of known faults, which a loop may produce endlessly

/// Collects the faults of a run; a fault in a block that is executed several times is stored once.
class Faults {
 public:
  explicit Faults(const ProgramSpec& spec) : spec_(spec) {}
  /// Returns false if enough faults were found, to end the run.
  bool take(const AlarmReport& report) {
    const AlarmId id = report.alarm.id;
    if (id == AlarmId::program_begins_again || id == AlarmId::passes_done) return true;  // not faults: one pass of the program is checked
    if (id == AlarmId::interrupted) return false;
    if (!seen_.insert({report.origin.file, report.origin.line, report.origin.column, id}).second) return ++again_ < most_again;
    found.push_back(spec_.finding(report));
    return found.size() < max_faults;
  }
  std::vector<Finding> found;

 private:
  const ProgramSpec& spec_;
  std::set<std::tuple<std::uint16_t, std::uint32_t, std::uint32_t, AlarmId>> seen_;
  std::size_t again_ = 0;
};

void run(Session& session, std::atomic<bool>& stop) {
  const CatchInterrupt interrupt(stop);
  (void)session.run();
}

/// A temporary folder that is deleted with its contents.
class OwnFolder {
 public:
  OwnFolder() : path_((std::filesystem::temp_directory_path() / "kadr-XXXXXX").string()) {
    if (::mkdtemp(path_.data()) == nullptr) throw FileFailed{errno, path_};
  }
  ~OwnFolder() {
    std::error_code passed_over;
    std::filesystem::remove_all(path_, passed_over);
  }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// A stream that receives the CSV text of a SampleWriter and stores its values as doubles.
class Samples {
 public:
  Samples() {
    file_ = ::fopencookie(this, "w", {.read = nullptr, .write = write, .seek = nullptr, .close = nullptr});
    if (file_ == nullptr) throw FileFailed{errno, "samples"};
  }
  ~Samples() { (void)std::fclose(file_); }
  Samples(const Samples&) = delete;
  Samples& operator=(const Samples&) = delete;
  std::FILE* file() const { return file_; }
  /// Flushes the stream and returns all rows.
  std::string take() {
    (void)std::fflush(file_);
    return std::move(rows_);
  }

 private:
  static ssize_t write(void* to, const char* text, std::size_t size) {
    auto& samples = *static_cast<Samples*>(to);
    for (std::size_t i = 0; i < size; ++i) samples.take(text[i]);
    return static_cast<ssize_t>(size);
  }
  /// Parses the CSV character by character: the heading "t,X,Y,Z", then lines of numbers.
  void take(char c) {
    if (c != ',' && c != '\n') return number_.push_back(c);
    if (heading_) {
      heading_ = c != '\n';
    } else {
      double value = 0;
      std::from_chars(number_.data(), number_.data() + number_.size(), value);
      rows_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    number_.clear();
  }

  std::FILE* file_;
  std::string number_, rows_;
  bool heading_ = true;
};

}  // namespace

std::vector<Finding> check(const ProgramSpec& spec) {
  std::atomic<bool> stop = false;
  RunLimits limits;
  limits.restarts = 0;
  const auto session = spec.open(stop, limits);
  Faults faults(spec);
  session->together().stop_together = false;
  auto& channels = session->channels();
  for (std::size_t i = 0; i < channels.size(); ++i) {
    session->outlets(i).warning = [&](const AlarmReport& report) { (void)faults.take(report); };
    session->outlets(i).alarm = [&](const AlarmReport& report) { return faults.take(report); };
  }
  if (channels.size() == 1) session->control().set_waiting(Control::Waiting::pass);  // the other channels' programs are missing
  run(*session, stop);
  if (stop) throw Interrupted{};
  for (const Channel& channel : channels) channel.control->check_uncalled([&](const AlarmReport& report) { (void)faults.take(report); });
  return std::move(faults.found);
}

std::string picture(const ProgramSpec& spec, const std::string& kind) {
  std::atomic<bool> stop = false;
  const auto session = spec.open(stop);
  const Channel& own = session->channels()[session->own()];
  const Control& control = *own.control;
  Statistics statistics(control.axes(), control.rotary(), rates_of(spec.machine(), own.setup, control.axes()));
  statistics.start_with(own.setup);
  Plot plot(control.axes(), control.rotary(), control.tool_position());
  Outlets& outlets = session->outlets();
  outlets.clock = &statistics.clock();
  outlets.programmed = [&](const Action& action) { plot.follow_programmed(action); };
  outlets.step = [&](const Step& step) { statistics.consume(step), plot.consume(step); };
  outlets.works_long = true;
  run(*session, stop);
  if (stop) throw Interrupted{};
  if (const auto& report = session->stopped().report)
    plot.stop(session->stopped().channel == 0 ? ProgramLine{report->origin.line, report->origin.file} : ProgramLine{});
  const ControlDef& def = spec.control();
  PlotTitle title{spec.file(),
                  spec.lang() == Lang::ru ? def.name.ru : def.name.en,
                  spec.lang(),
                  statistics.caption(spec.lang()),
                  statistics.extents().unit(),
                  {}};
  for (const std::uint16_t file : plot.files()) title.files[file] = std::filesystem::path(control.file_name(file)).filename().string();
  const OwnFolder folder;
  const std::string name = folder.path() + "/path" + kind;
  auto file = ResultFile::open(name);
  if (!file) throw Failed{file.error()};
  if (const auto written = plot.write(*file, title); !written) throw Failed{written.error()};
  if (const auto kept = file->keep(); !kept) throw Failed{kept.error()};
  std::ifstream made(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(made), {}};
}

AxesInTime axes_in_time(const ProgramSpec& spec, double rate, double longest) {
  std::atomic<bool> stop = false;
  const auto session = spec.open(stop);
  TimeEstimate clock = clock_of(*session, session->own());
  session->outlets().clock = &clock;
  session->outlets().works_long = true;
  Samples samples;
  Planned& planned = session->plan(session->own(), StopToken(stop));
  if (rate > 0)
    planned.write_samples(samples.file(), {.rate = rate, .changes = {}, .spindle = false, .max_time = longest, .stop = StopToken(stop)});
  {
    const CatchInterrupt interrupt(stop);
    (void)session->run();
    (void)planned.finish();
  }
  if (stop) throw Interrupted{};
  if (const auto& report = session->stopped().report) throw Alarmed{spec.finding(*report)};
  for (const AlarmReport& report : planned.reports(session->control()))
    if (report.alarm.severity == Severity::alarm) throw Alarmed{spec.finding(report)};
  AxesInTime made{session->control().axes(), samples.take(), {}};
  if (const PlannedTime* const time = planned.time())
    made.seconds = {{"cutting", time->cutting.all}, {"rapid", time->rapid.all}, {"dwell", time->dwell}, {"tool_change", time->tool_change}};
  return made;
}

}  // namespace kadr::python
