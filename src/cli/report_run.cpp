// kadr report: executes a program, and writes the HTML viewer together with the results into one file. The command is tested by
// tests/report.py.

#include <fmt/core.h>

#include <cstdio>
#include <filesystem>

#include "cli/job/found.h"
#include "cli/job/job.h"
#include "cli/job/outputs.h"
#include "cli/job/progress.h"
#include "cli/job/stop_signals.h"
#include "cli/job/terminal.h"
#include "cli/report_files.h"
#include "cli/report_live.h"
#include "config/read_file.h"
#include "out/text/cut_text.h"
#include "texts/report_command.h"
#include "view/report/page_report.h"
#include "view/report/report_part.h"

namespace kadr::cli {
namespace {

Outputs outputs_of(const ReportOptions& options, const Job& job) {
  Outputs outputs(job.lang);
  outputs.reads(job.file);
  outputs.reads(job.setup_file);
  outputs.reads(options.cut.tools);
  outputs.reads(options.live);
  outputs.reads(options.cut.stock);
  for (const std::string& body : options.cut.fixtures) outputs.reads(body);
  if (options.cut.run.control.ends_with(".toml")) outputs.reads(options.cut.run.control);
  if (options.cut.run.machine.ends_with(".toml")) outputs.reads(options.cut.run.machine);
  outputs.writes("--out", options.out);
  return outputs;
}

/// Reads all of standard input into memory, since the program is read several times. If an error occurs, it is printed and the function
/// returns nullopt.
std::optional<std::string> text_of_input(const Job& job) {
  OpenedText text = open_text(job.file, job.encoding);
  if (text.source) return SourceText(std::move(text)).whole();
  complain(fmt::format("{}: {}", job.file, errno_message(errno)));
  return std::nullopt;
}

/// Opens the program in the same way as the web page does. If an error occurs, it is printed and the function returns nullopt.
std::optional<OpenedProgram> opened_by(const Job& job, const Options& options) {
  OpenedProgram opened;
  opened.path = job.file;
  opened.def = job.def;
  opened.texts = std::make_shared<const AlarmTexts>(job.texts());
  opened.machine = job.profile;
  opened.setup = job.setup;
  opened.stated = job.stated;
  opened.encoding = job.encoding;
  opened.number = options.program;
  opened.limits = options.limits;
  if (job.file != "-") return opened;
  opened.text = text_of_input(job);
  return opened.text ? std::optional(std::move(opened)) : std::nullopt;
}

class ReportRun {
 public:
  ReportRun(const Job& job, const Options& options)
      : job_(job), progress_(options.quiet), found_(job.texts(), job.lang, stderr, options.every) {}

  /// Opens the session. If an error occurs, it is printed and the function returns false.
  bool open(const OpenedProgram& opened) {
    auto run = ProgramRun::make(opened, stop_token());
    if (!run) {
      complain(run.error());
      return false;
    }
    run_ = std::move(*run);
    OpenedText text = opened.text ? OpenedText{text_source(*opened.text), Encoding::utf8} : open_text(opened.path, opened.encoding);
    if (!text.source) {
      complain(fmt::format("{}: {}", opened.path, errno_message(errno)));
      return false;
    }
    source_ = std::make_unique<SourceText>(std::move(text));
    return true;
  }

  void execute() {
    run_->on_alarm = [this](const AlarmReport& report, double at, int channel) {
      AlarmReport shown_report = report;
      // an alarm of another channel gets no line number, since its line is in the program of that channel
      if (channel != 0) shown_report.origin.line = 0;
      take(shown_report, at);
    };
    run_->on_progress = [this](double part, std::uint64_t blocks, double) {
      if (progress_.is_due()) progress_.show(part, counted(texts::report_command::blocks, blocks));
    };
    run_->on_contour = [this](const ViewPiece& piece) { contour_.push_back(piece); };
    run_->execute();
    found_.finish();
    erase_bar();
  }

  ReportContent content(const std::string& file) const {
    return {*run_, *source_, file, KADR_VERSION, job_.lang, alarms_, contour_, nullptr, cut_ ? &part_ : nullptr, {}};
  }
  const ProgramRun& run() const { return *run_; }
  /// Returns the names of the files that the program has called or read.
  std::vector<std::string> files() const { return run_->control().files_read(); }

  /// Cuts the blank. If an error occurs, it is printed and the function returns false.
  bool cut(const CutOptions& options, const ToolLibrary& tools) {
    PartRequest request{options.stock, options.fixtures, options.fixtures, tools, options.resolution, run_->path().zero()};
    auto part = PartRun::make(run_->opened(), request, stop_token());
    if (!part) {
      complain(part.error());
      return false;
    }
    (*part)->on_progress = [this](double share) {
      if (progress_.is_due()) progress_.show(share, translated(texts::report_command::cutting));
    };
    (*part)->on_finding = [this](const CutFinding& f, const AlarmReport& report) {
      part_.hits.push_back({f, report});
      write_message(alarm_text(report, job_.texts(), job_.lang, colours()));
    };
    if (const auto done = (*part)->execute(); !done) return interrupted() || (complain(done.error()), false);
    for (const std::string& note : (*part)->notes()) write_message(note + "\n");
    erase_bar();
    take_part(**part, part_, stop_token());
    cut_ = (*part)->result();
    return true;
  }
  const std::optional<CutResult>& cut() const { return cut_; }

 private:
  void take(const AlarmReport& report, double at) {
    alarms_.push_back({report, at});
    found_.print_report(report);
  }

  const Job& job_;
  Progress progress_;
  Found found_;
  std::unique_ptr<ProgramRun> run_;
  std::unique_ptr<SourceText> source_;
  std::vector<ReportAlarm> alarms_;
  std::vector<ViewPiece> contour_;
  ReportPart part_;
  std::optional<CutResult> cut_;  // result of the cut; nullopt: no blank is cut
};

std::string shown_name(const std::string& file) { return file == "-" ? file : std::filesystem::path(file).filename().string(); }

/// Writes the HTML file. Also prints the summary, unless the HTML goes to standard output. Returns the exit status.
int write(const ReportOptions& options, const ReportRun& report, const std::string& html, Outputs& outputs) {
  std::FILE* const file = outputs.stream("--out");
  if (std::fwrite(html.data(), 1, html.size(), file) != html.size()) {
    complain(fmt::format("{}: {}", options.out, errno_message(errno)));
    return wrong_usage;
  }
  const ProgramRun& run = report.run();
  if (!options.cut.run.quiet && options.out != "-") {
    const Lang lang = language(options.cut.run);
    type_out("{}{}", run.statistics().text(run.blocks(), lang), report.cut() ? cut_summary(*report.cut(), lang) : std::string());
  }
  if (interrupted()) return interrupted_status();
  if (!outputs.keep(run.control().files_read())) return wrong_usage;
  const bool hit = report.cut() && !report.cut()->collisions.empty();
  return hit || run.end() == ProgramRun::End::stopped ? alarms : ok;
}

/// Returns why the report cannot be made; empty if it can.
std::string fault_message(const ReportOptions& options) {
  if (!options.live.empty()) return live_fault_message(options);
  return report_file("report.html").empty() ? translated(texts::report_command::built_without_page) : std::string();
}

tl::expected<std::string, std::string> made_report(const ReportOptions& options, const ReportRun& run, const Job& job,
                                                   const ToolLibrary& tools) {
  ReportContent content = run.content(shown_name(job.file));
  content.tools = options.cut.tools.empty() ? nullptr : &tools;
  content.licences = report_file("licences.txt");
  return report_html(report_file("report.html"), content);
}

}  // namespace

int report(const ReportOptions& options) {
  if (const std::string fault = fault_message(options); !fault.empty()) {
    complain(fault);
    return wrong_usage;
  }
  auto job = make_job(options.cut.run, options.cut.run.programs.front());
  if (!job) return wrong_usage;
  Outputs outputs = outputs_of(options, *job);
  auto opened = outputs.check() ? opened_by(*job, options.cut.run) : std::nullopt;
  if (!opened) return wrong_usage;
  ToolLibrary tools;
  if (!options.cut.tools.empty()) {
    auto library = load_tools(options.cut.tools);
    if (!library) {
      complain(library.error());
      return wrong_usage;
    }
    for (const std::string& note : library->notes) write_message(note + "\n");
    tools = std::move(*library);
  }
  opened->tools = options.cut.tools.empty() ? tool_table_next_to(job->file)
                                            : std::make_shared<const ToolTable>(ToolTable{shown_name(options.cut.tools), tools});
  ReportRun run(*job, options.cut.run);
  if (!run.open(*opened) || !outputs.open()) return wrong_usage;
  run.execute();
  if (!interrupted() && !options.cut.stock.empty() && !run.cut(options.cut, tools)) return wrong_usage;
  if (interrupted()) return interrupted_status();
  const auto html = options.live.empty() ? made_report(options, run, *job, tools) : live_report(options, *job, run.files());
  if (!html) {
    complain(html.error());
    return wrong_usage;
  }
  return interrupted() ? interrupted_status() : write(options, run, *html, outputs);
}

int print_licences() {
  type_out("{}", report_file("licences.txt"));
  return came_out() ? ok : wrong_usage;
}

}  // namespace kadr::cli
