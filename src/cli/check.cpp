// kadr check: finds all faults of programs, in all their channels, and counts the faults.

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "cli/job/files.h"
#include "cli/job/found.h"
#include "cli/job/guessed_control.h"
#include "cli/job/job.h"
#include "cli/job/outputs.h"
#include "cli/job/program_files.h"
#include "cli/job/progress.h"
#include "cli/job/stop_signals.h"
#include "cli/job/terminal.h"
#include "config/read_file.h"
#include "lang/text/utf16.h"
#include "out/text/alarm_print.h"
#include "out/text/baseline.h"
#include "session/checklist/program_check.h"
#include "texts/check_command.h"

namespace kadr::cli {
namespace {

struct Count {
  std::size_t faults = 0, warnings = 0, advices = 0;
};

/// Stores the findings, and prints them at once or at the end.
struct Report {
  std::FILE* text = nullptr;  // stream on which findings are printed at once for --format text; nullptr for other formats
  std::vector<Finding> findings;
  std::optional<Baseline> baseline;
  Count count;
  std::vector<Unreadable> unreadable;

  void add(const AlarmReport& report, Finding finding, Found& found) {
    if (text != nullptr) found.print_report(report);
    else findings.push_back(std::move(finding));
  }
};

/// Collects the findings about one program file. Findings that the baseline contains are omitted.
class Collector {
 public:
  Collector(const Job& job, const Options& options, Report& report, Found& found)
      : job_(job), lang_(language(options)), to_(report), found_(found) {}

  void take(const AlarmReport& report) {
    Finding finding = finding_of(report, job_.texts(), lang_);
    if (to_.baseline && to_.baseline->has(finding)) return;
    switch (report.alarm.severity) {
      case Severity::alarm: ++count.faults; break;
      case Severity::warning: ++count.warnings; break;
      case Severity::advice: ++count.advices; break;
      case Severity::note: break;
    }
    to_.add(report, std::move(finding), found_);
  }

  Count count;

 private:
  const Job& job_;
  const Lang lang_;
  Report& to_;
  Found& found_;
};

// the result of checking a file: `unknown` means that the file is no program of a control that Kadr supports
enum class Checked { clean, faulty, unreadable, unknown };

Checked check_program(const Job& job, const RunLimits& limits, ProgramCheck& check) {
  auto program = open_program(job);
  if (!program) return Checked::unreadable;
  const auto session = make_session(job, std::move(*program), limits);
  if (!session) return Checked::unreadable;
  check.check(*session);
  return Checked::clean;
}

/// Checks the file. If a tape contains several programs, all of them are checked, unless --program names one.
///   basis  data for the checklist that are the same for all files
Checked check_file(const Options& options, const GuessedControls& controls, const std::string& file, ChecklistBasis basis, Report& report) {
  const auto control = controls.of(file);
  if (!control) return Checked::unreadable;
  if (control->empty()) return Checked::unknown;
  auto job = make_job(options, file, *control);
  if (!job) return Checked::unreadable;
  const std::size_t programs = options.program == 0 ? count_programs(*job) : 1;
  RunLimits limits = options.limits;
  // true: each program runs only once, since the user has not requested several runs by --max-passes
  const bool one_pass = limits.restarts == RunLimits{}.restarts;
  if (one_pass) limits.restarts = 0;
  // true: the tools file and the set-up belong to this program only, since the file contains no other program
  const bool only_program = programs == 1 && options.program == 0;
  if (!basis.tools) basis.tools = tool_table_next_to(file);
  basis.own_tools = only_program && (basis.own_tools || (basis.tools && basis.tools->kind == ToolTable::Kind::own));
  basis.own_setup = only_program && basis.own_setup;
  Progress progress(options.quiet);
  Found found(job->texts(), language(options), report.text, options.every);
  Collector collector(*job, options, report, found);
  ProgramCheck check({job->stated, basis, one_pass, &progress, stop_token()}, [&](std::size_t, const AlarmReport& report) {
    collector.take(report);
    return true;
  });
  Checked worst = Checked::clean;
  for (std::size_t i = 0; i < programs && !interrupted(); ++i) {
    if (programs > 1) job->program_index = i;
    worst = std::max(worst, check_program(*job, limits, check));
  }
  if (report.text != nullptr) found.finish();
  const Count& of_file = collector.count;
  report.count.faults += of_file.faults, report.count.warnings += of_file.warnings, report.count.advices += of_file.advices;
  const bool faulty = of_file.faults != 0 || (options.strict && of_file.warnings != 0);
  return std::max(worst, faulty ? Checked::faulty : Checked::clean);
}

/// Prints the totals, e.g. "3 programs checked: 1 error, 0 warnings."
void print_count(const Options& options, std::size_t files, Count count, std::size_t known) {
  if (options.format != "text" || options.quiet) return;
  const auto [faults, warnings, advices] = count;
  const Lang lang = language(options);
  const auto in_words = [lang](PluralId<0> id, std::size_t n) { return counted_in(lang, id, n); };
  const std::string programs = in_words(texts::check_command::programs_checked, files);
  const std::string of_faults = in_words(texts::check_command::errors, faults),
                    of_warnings = in_words(texts::check_command::warnings, warnings);
  if (advices == 0) type_out("{}", translated_in(lang, texts::check_command::result, programs, of_faults, of_warnings));
  else
    type_out("{}", translated_in(lang, texts::check_command::result_with_advices, programs, of_faults, of_warnings,
                                 in_words(texts::check_command::advices, advices)));
  if (known != 0) type_out(" {}", in_words(texts::check_command::known_findings, known));
  type_out("\n");
}

/// Reads the baseline if --baseline names a file. If an error occurs, it is printed and the function returns false.
bool read_baseline(const Options& options, Report& report) {
  constexpr std::size_t longest = std::size_t{256} << 20;  // greatest size of a baseline file, bytes
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

/// Reads the tools file if the user has named one. If an error occurs, it is printed and the function returns false.
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

/// Writes all findings in the format json or sarif.
void write_findings(std::FILE* to, const Options& options, const Report& report, int status) {
  Invocation invocation{KADR_VERSION, status, {}};
  for (const Unreadable& file : report.unreadable) invocation.unreadable.emplace_back(file.path, file.reason);
  const std::string text = options.format == "json" ? findings_json(report.findings) : findings_sarif(report.findings, invocation);
  write_data(to, text);  // a write error is not checked here, since Outputs::keep() reports it
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
    complain(translated(texts::check_command::no_program_there));
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
    // a file that is no program is an error only if the user has named it, since a folder may also contain files of other kinds
    if (result == Checked::unreadable || (result == Checked::unknown && named)) {
      report.unreadable.push_back({file, translated(texts::check_command::cannot_be_checked)});
      status = wrong_usage;
    }
    if (interrupted()) return interrupted_status();
    // the reader of the pipe has closed standard output, so nobody reads further findings
    if (report.text != nullptr && std::ferror(report.text) != 0) break;
  }
  if (report.text == nullptr) write_findings(output->get(), options, report, status);
  if (checked == 0 && status == ok) {  // the named folders contain no program, which is an error
    complain(translated(texts::check_command::no_program_of_known_control));
    status = wrong_usage;
  }
  if (checked != 0) print_count(options, checked, report.count, report.baseline ? report.baseline->found() : 0);
  return outputs.keep() ? status : wrong_usage;
}

}  // namespace kadr::cli
