// kadr check: every fault of every program, its channels included, and how many.

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>
#include <tuple>

#include "cli/files.h"
#include "cli/found.h"
#include "cli/guessed_control.h"
#include "cli/job.h"
#include "cli/outputs.h"
#include "cli/program_files.h"
#include "cli/progress.h"
#include "cli/stop.h"
#include "cli/sub_file.h"
#include "cli/terminal.h"
#include "config/read_file.h"
#include "config/told.h"
#include "lang/text/utf16.h"
#include "out/text/alarm_print.h"
#include "out/text/baseline.h"
#include "session/checklist/checklist.h"
#include "session/unstated.h"

namespace kadr::cli {
namespace {

constexpr std::size_t most_faults = 1000;  // of one program: beyond, it is no program of this control

struct Count {
  std::size_t faults = 0, warnings = 0, advices = 0;
};

/// Where findings go as they are found, or when all are there.
struct Report {
  std::FILE* text = nullptr;  // of --format text: as they come; else nullptr
  std::vector<Finding> findings;
  std::optional<Baseline> baseline;
  Count count;
  std::vector<Unreadable> unreadable;

  void add(const AlarmReport& report, Finding finding, Found& found) {
    if (text != nullptr) found.tell(report);
    else findings.push_back(std::move(finding));
  }
};

/// Takes the faults of one program, each once however often its block is carried out.
class Collector {
 public:
  using Seen = std::set<std::tuple<std::uint32_t, std::uint32_t, AlarmId>>;

  /// `seen`: of the file so far; what several programs of a tape have in common is told once.
  Collector(const Job& job, const Options& options, Report& report, Found& found, Seen& seen)
      : job_(job), lang_(language(options)), strict_(options.strict), to_(report), found_(found), seen_(seen) {}

  bool take(AlarmReport report) {
    // One pass is looked at of a main program that begins again (M99, M47), unless --max-passes asks for more.
    const bool begins_again = report.alarm.id == AlarmId::program_begins_again || report.alarm.id == AlarmId::passes_done;
    if (begins_again && one_pass) return true;
    if (only_subprograms && report.alarm.id == AlarmId::rs274_program) return true;
    if (!seen_.insert({report.origin.line, report.origin.column, report.alarm.id}).second) return ++again_ < most_again;
    Finding finding = finding_of(report, job_.texts(), lang_);
    if (to_.baseline && to_.baseline->has(finding)) return true;
    switch (report.alarm.severity) {
      case Severity::alarm: ++faults; break;
      case Severity::warning: ++warnings; break;
      case Severity::advice: ++advices; break;
      case Severity::note: break;
    }
    to_.add(report, std::move(finding), found_);
    return report.alarm.id != AlarmId::interrupted && faults + warnings < most_faults;
  }

  std::size_t faults = 0;
  std::size_t warnings = 0;
  std::size_t advices = 0;
  bool one_pass = false;
  bool only_subprograms = false;  // nobody runs the file: it needs no end
  bool clean() const { return faults == 0 && (!strict_ || warnings == 0); }

 private:
  static constexpr std::size_t most_again = 100'000;  // repetitions of known faults: a loop that only fails
  const Job& job_;
  const Lang lang_;
  const bool strict_;
  Report& to_;
  Found& found_;
  Seen& seen_;
  std::size_t again_ = 0;
};

enum class Checked { clean, faulty, unreadable, unknown };  // unknown: no program of a control that Kadr knows

/// What is found goes to the collector of its channel.
Outlets outlets_of(Collector& collector, Progress& progress) {
  const auto take = [&collector](const AlarmReport& report) { return collector.take(report); };
  return {.warning = [take](const AlarmReport& report) { (void)take(report); }, .alarm = take, .onlooker = &progress, .stop = stop_token()};
}

Checked check_program(const Options& options, const Job& job, const ChecklistBasis& basis, Report& report,
                      std::deque<Collector::Seen>& seen) {
  auto program = open_program(job);
  if (!program) return Checked::unreadable;
  RunLimits limits = options.limits;
  const bool one_pass = limits.restarts == RunLimits{}.restarts;
  if (one_pass) limits.restarts = 0;
  const auto session = make_session(job, std::move(*program), limits);
  if (!session) return Checked::unreadable;
  const std::vector<Channel>& channels = session->channels();
  Progress progress(options.quiet);
  const std::shared_ptr<ByteSource> text = job.def->grammar.o_words && job.file != "-" ? open_text(job.file).source : nullptr;
  const bool only_subprograms = text && holds_only_subprograms(LineReader(text));
  std::deque<Collector> collectors;
  std::deque<Checklist> checklists;
  Found found(job.texts(), language(options), report.text, options.every);
  session->together().stop_together = false;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (seen.size() <= i) seen.emplace_back();
    collectors.emplace_back(job, options, report, found, seen[i]);
    collectors.back().one_pass = one_pass;
    collectors.back().only_subprograms = only_subprograms;
    session->outlets(i) = outlets_of(collectors.back(), progress);
    checklists.emplace_back(*session, i, basis).attach();
  }
  if (channels.size() == 1) session->control().set_waiting(Control::Waiting::pass);  // the other channels' programs are not here
  (void)session->run();
  bool clean = true;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (!interrupted()) channels[i].control->check_uncalled([&](const AlarmReport& r) { (void)collectors[i].take(r); });
    // Where a block was refused, what follows it is not what the program means: its errors come first.
    if (!interrupted() && collectors[i].faults == 0 && !only_subprograms)
      for (AlarmReport& advice : checklists[i].reports(stop_token())) (void)collectors[i].take(std::move(advice));
    if (const auto note = i == session->own() ? unstated(*channels[i].control, *job.def, job.setup, job.stated) : std::nullopt)
      (void)collectors[i].take(*note);
    report.count.faults += collectors[i].faults;
    report.count.warnings += collectors[i].warnings;
    report.count.advices += collectors[i].advices;
    clean = clean && collectors[i].clean();
  }
  if (report.text != nullptr) found.finish();
  return clean ? Checked::clean : Checked::faulty;
}

/// Every program of the file, if it is a tape with several and none is named.
///   basis  of all files together
Checked check_file(const Options& options, const GuessedControls& controls, const std::string& file, ChecklistBasis basis, Report& report) {
  const auto control = controls.of(file);
  if (!control) return Checked::unreadable;
  if (control->empty()) return Checked::unknown;
  auto job = make_job(options, file, *control);
  if (!job) return Checked::unreadable;
  const std::size_t programs = options.program == 0 ? count_programs(*job) : 1;
  const bool only_program = programs == 1 && options.program == 0;  // of a tape
  if (!basis.tools) basis.tools = tool_table_beside(file);
  basis.own_tools = only_program && (basis.own_tools || (basis.tools && basis.tools->kind == ToolTable::Kind::own));
  basis.own_setup = only_program && basis.own_setup;
  std::deque<Collector::Seen> seen;
  Checked worst = Checked::clean;
  for (std::size_t i = 0; i < programs && !interrupted(); ++i) {
    if (programs > 1) job->program_index = i;
    worst = std::max(worst, check_program(options, *job, basis, report, seen));
  }
  return worst;
}

/// "3 programs checked: 1 error, 0 warnings."
void print_count(const Options& options, std::size_t files, Count count, std::size_t known) {
  if (options.format != "text" || options.quiet) return;
  const auto [faults, warnings, advices] = count;
  const auto many = [](std::size_t n) { return n == 1 ? "" : "s"; };
  if (language(options) == Lang::ru) {
    type_out("Проверено программ: {}. Ошибок: {}, предупреждений: {}", files, faults, warnings);
    type_out("{}", advices == 0 ? "." : fmt::format(", советов: {}.", advices));
    if (known != 0) type_out(" Уже известных пропущено: {}.", known);
  } else {
    type_out("{} program{} checked: {} error{}, {} warning{}", files, many(files), faults, many(faults), warnings, many(warnings));
    type_out("{}", advices == 0 ? "." : fmt::format(", {} advice{}.", advices, many(advices)));
    if (known != 0) type_out(" {} known finding{} left out.", known, many(known));
  }
  type_out("\n");
}

/// The baseline that is asked for; complains.
bool read_baseline(const Options& options, Report& report) {
  constexpr std::size_t longest = std::size_t{256} << 20;  // bytes
  if (options.baseline.empty()) return true;
  const auto text = read_small(options.baseline, longest);
  if (!text) return false;
  auto baseline = Baseline::read(*text);
  if (!baseline) {
    complain(fmt::format("{}: {}", options.baseline, baseline.error()));
    return false;
  }
  report.baseline = std::move(*baseline);
  return true;
}

/// The tools file that is asked for; complains.
bool read_table(const Options& options, std::shared_ptr<const ToolTable>& to) {
  if (options.table.empty()) return true;
  auto tools = load_tools(options.table);
  if (!tools) {
    complain(tools.error());
    return false;
  }
  to = std::make_shared<const ToolTable>(ToolTable{std::filesystem::path(options.table).filename().string(), std::move(*tools)});
  return true;
}

Outputs outputs_of(const Options& options, const ProgramFiles& programs) {
  Outputs outputs(language(options));
  for (const std::string& file : programs.files) outputs.reads(file);
  for (const std::string& file : {options.setup, options.baseline, options.table}) outputs.reads(file);
  outputs.writes("--output", options.output.empty() && options.format != "text" ? "-" : options.output);
  return outputs;
}

/// json, sarif: all findings at once.
void write_findings(std::FILE* to, const Options& options, const Report& report, int status) {
  Invocation invocation{KADR_VERSION, status, {}};
  for (const Unreadable& file : report.unreadable) invocation.unreadable.emplace_back(file.path, file.reason);
  const std::string text = options.format == "json" ? findings_json(report.findings) : findings_sarif(report.findings, invocation);
  write_data(to, text);  // Outputs::keep() tells whether all was written
}

}  // namespace

int check(const Options& given) {
  if (!given.explained.empty()) return explain({given.explained, {}, given.lang});
  Options options = given;
  options.guesses_silently = options.quiet;
  ProgramFiles programs = program_files(options.programs, options.exclude);
  Outputs outputs = outputs_of(options, programs);
  Report report;
  std::shared_ptr<const ToolTable> tools;
  if (!read_table(options, tools) || !read_baseline(options, report) || !outputs.check() || !outputs.open()) return wrong_usage;
  const ResultFile* const output = outputs.file("--output");
  if (options.format == "text") report.text = output != nullptr ? output->get() : stderr;
  for (const Unreadable& file : programs.unreadable) complain(fmt::format("{}: {}", file.path, file.reason));
  int status = programs.unreadable.empty() ? ok : wrong_usage;
  report.unreadable = std::move(programs.unreadable);
  if (programs.files.empty()) {
    complain(told("no program to check there", "там нет УП для проверки"));
    return wrong_usage;
  }
  std::size_t checked = 0;
  const bool alone = programs.files.size() == 1;
  const GuessedControls controls(options, programs.files);
  for (const std::string& file : programs.files) {
    const Checked result = check_file(options, controls, file, {tools, alone, alone}, report);
    const bool named = std::find(options.programs.begin(), options.programs.end(), file) != options.programs.end();
    checked += result == Checked::clean || result == Checked::faulty;
    if (result == Checked::faulty) status = std::max<int>(status, alarms);
    if (result == Checked::unreadable || (result == Checked::unknown && named)) {  // of a folder not every file is a program
      report.unreadable.push_back({file, told("cannot be checked", "не может быть проверен")});
      status = wrong_usage;
    }
    if (interrupted()) return interrupted_status();
    if (report.text != nullptr && std::ferror(report.text) != 0) break;  // nobody can read it
  }
  if (report.text == nullptr) write_findings(output->get(), options, report, status);
  if (checked == 0 && status == ok) {  // of the files of a folder
    complain(told("no program of a control that Kadr knows is there: --control says which it is",
                  "там нет УП известного Kadr УЧПУ: какое оно, скажет --control"));
    status = wrong_usage;
  }
  if (checked != 0) print_count(options, checked, report.count, report.baseline ? report.baseline->found() : 0);
  return outputs.keep() ? status : wrong_usage;
}

}  // namespace kadr::cli
