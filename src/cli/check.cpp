// kadr check: every fault of every program, its channels included, and how many.

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <tuple>

#include "cli/channels.h"
#include "cli/progress.h"
#include "cli/stop.h"
#include "out/alarm_print.h"

namespace kadr::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_faults = 1000;  // of one program: beyond, it is no program of this control
constexpr const char* program_endings[] = {".nc",    ".ngc", ".tap", ".txt", ".iso", ".prg", ".nct",
                                           ".gcode", ".cnc", ".mpf", ".up",  ".eia", ".ptp", ".tape"};

bool is_program(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::find(std::begin(program_endings), std::end(program_endings), ending) != std::end(program_endings);
}

/// Files as named; of a folder those that look like programs, in the order of their names.
std::vector<std::string> files_of(const std::vector<std::string>& names) {
  std::vector<std::string> files;
  for (const std::string& name : names) {
    std::error_code error;
    if (!fs::is_directory(name, error)) {
      files.push_back(name);
      continue;
    }
    std::vector<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(name, fs::directory_options::skip_permission_denied, error))
      if (entry.is_regular_file(error) && is_program(entry.path())) found.push_back(entry.path().string());
    std::sort(found.begin(), found.end());
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

/// Takes the faults of one program, each once however often its block is carried out.
class Collector {
 public:
  Collector(const Job& job, const Options& options, std::vector<Finding>& findings) : job_(job), options_(options), findings_(findings) {}

  bool take(AlarmReport report) {
    // One pass is looked at of a main program that begins again (M99, M47), unless --max-passes asks for more.
    const bool begins_again = report.alarm.id == AlarmId::program_begins_again || report.alarm.id == AlarmId::passes_done;
    if (begins_again && one_pass) return true;
    if (!seen_.insert({report.origin.line, report.origin.column, report.alarm.id}).second) return ++again_ < most_again;
    if (report.alarm.severity != Severity::note) ++(report.alarm.severity == Severity::alarm ? faults : warnings);
    findings_.push_back(finding_of(report, job_.texts(), language(options_)));
    if (options_.format == "text") fmt::print(stderr, "{}", alarm_text(report, job_.texts(), language(options_)));
    return report.alarm.id != AlarmId::interrupted && faults + warnings < most_faults;
  }

  std::size_t faults = 0;
  std::size_t warnings = 0;
  bool one_pass = false;

 private:
  static constexpr std::size_t most_again = 100'000;  // repetitions of known faults: a loop that only fails
  const Job& job_;
  const Options& options_;
  std::vector<Finding>& findings_;
  std::set<std::tuple<std::uint32_t, std::uint32_t, AlarmId>> seen_;
  std::size_t again_ = 0;
};

enum class Checked { clean, faulty, unreadable };

struct Count {
  std::size_t faults = 0, warnings = 0;
};

/// What is found goes to the collector of its channel.
Outlets outlets_of(Collector& collector, Progress& progress) {
  const auto take = [&collector](const AlarmReport& report) { return collector.take(report); };
  return {.action = [](const Action&) {},
          .warning = [take](const AlarmReport& report) { (void)take(report); },
          .alarm = take,
          .progress = &progress,
          .stop = stop_token()};
}

Checked check_file(const Options& options, const std::string& file, Count& count, std::vector<Finding>& findings) {
  auto job = make_job(options, file);
  if (!job) return Checked::unreadable;
  auto program = open_program(*job);
  if (!program) return Checked::unreadable;
  RunLimits limits = options.limits;
  const bool one_pass = limits.restarts == RunLimits{}.restarts;
  if (one_pass) limits.restarts = 0;
  auto channels = make_channels(*job, std::move(*program), limits);
  if (!channels) return Checked::unreadable;
  Progress progress(options.quiet);
  std::deque<Collector> collectors;
  ChannelOutlets outlets;
  outlets.stop_together = false;
  for (std::size_t i = 0; i < channels->size(); ++i) {
    collectors.emplace_back(*job, options, findings);
    collectors.back().one_pass = one_pass;
    outlets.own.push_back(outlets_of(collectors.back(), progress));
  }
  if (channels->size() == 1) {
    channels->front().control->set_waiting(Control::Waiting::pass);  // the other channels' programs are not here
    (void)carry_out(*channels->front().control, *job, outlets.own.front());
  } else {
    (void)Channels(*channels, *job, outlets).run();
  }
  bool clean = true;
  for (std::size_t i = 0; i < channels->size(); ++i) {
    if (!interrupted()) (*channels)[i].control->check_uncalled([&](const AlarmReport& r) { (void)collectors[i].take(r); });
    count.faults += collectors[i].faults;
    count.warnings += collectors[i].warnings;
    clean = clean && collectors[i].faults == 0;
  }
  return clean ? Checked::clean : Checked::faulty;
}

void print_count(const Options& options, std::size_t files, Count count) {
  const auto [faults, warnings] = count;
  if (options.format != "text") return;
  if (language(options) == Lang::ru) fmt::print("Проверено программ: {}. Ошибок: {}, предупреждений: {}.\n", files, faults, warnings);
  else
    fmt::print("{} program{} checked: {} error{}, {} warning{}.\n", files, files == 1 ? "" : "s", faults, faults == 1 ? "" : "s", warnings,
               warnings == 1 ? "" : "s");
}

}  // namespace

int check(const Options& options) {
  const std::vector<std::string> files = files_of(options.programs);
  if (files.empty()) {
    complain("no program to check there");
    return wrong_usage;
  }
  std::vector<Finding> findings;
  Count count;
  std::size_t checked = 0;
  int status = ok;
  for (const std::string& file : files) {
    const Checked result = check_file(options, file, count, findings);
    checked += result != Checked::unreadable;
    status = std::max<int>(status, result == Checked::clean ? ok : result == Checked::faulty ? alarms : wrong_usage);
    if (interrupted()) break;
    if (options.format == "text") findings.clear();
  }
  if (options.format == "json") fmt::print("{}", findings_json(findings));
  if (options.format == "sarif") fmt::print("{}", findings_sarif(findings, KADR_VERSION));
  print_count(options, checked, count);
  return interrupted() ? interrupted_status() : status;
}

}  // namespace kadr::cli
