// kadr diff: compares what two programs do, in words and as a picture. The command is tested by tests/run_diff.py and tests/diff_plot.py.

#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "cli/job/job.h"
#include "cli/job/outputs.h"
#include "cli/job/stop_signals.h"
#include "cli/job/terminal.h"
#include "cli/options/command_parts.h"
#include "cli/options/help_text.h"
#include "cli/options/option_values.h"
#include "compare/comparison_text.h"
#include "compare/difference_plot.h"
#include "out/program/words.h"
#include "out/text/alarm_print.h"
#include "out/text/page_file.h"
#include "out/text/source_line.h"
#include "texts/diff_command.h"
#include "texts/values.h"
#include "view/source_text.h"

namespace kadr::cli {
namespace {

constexpr double least_tolerance = 1e-5, max_tolerance = 10;  // limits of the value of --tolerance, mm
constexpr std::size_t shown = 20;                             // greatest number of differences that are printed without --all
constexpr std::size_t max_shown = 100'000, most_of_line = 100;

/// One of the two programs: its text, and what is needed to run it.
struct Side {
  std::string name;
  std::optional<Job> job;
  std::unique_ptr<SourceText> text;
};

Options options_of(const DiffOptions& o, bool b) {
  Options options = o.both;
  options.programs = {b ? o.b : o.a};
  const std::string &control = b ? o.control_b : o.control_a, &setup = b ? o.setup_b : o.setup_a;
  if (!control.empty()) options.control = control;
  if (!setup.empty()) options.setup = setup;
  return options;
}

/// Opens a session for one program. If an error occurs, it is printed and the function returns nullptr.
std::unique_ptr<Session> open_side(const Options& options, Side& side) {
  side.name = options.programs.front();
  side.job = make_job(options, side.name);
  if (!side.job) return nullptr;
  auto program = open_program(*side.job);
  if (!program) return nullptr;
  auto session = make_session(*side.job, std::move(*program), options.limits);
  if (session && session->channels().size() > 1) {
    complain(translated(texts::diff_command::several_channels, side.name));
    return nullptr;
  }
  return session;
}

using Names = std::array<std::string, 2>;  // the names of the two programs

/// Returns the location of a difference in one of the programs, e.g. "part.nc:5-7".
std::string place(const std::string& name, const CourseSpot& from, const CourseSpot& to) {
  std::string text = fmt::format("{}:{}", from.file.empty() ? name : from.file, from.origin.line);
  if (to.origin.line > from.origin.line + 1 && to.file == from.file) text += fmt::format("-{}", to.origin.line - 1);
  return text;
}

void show_line(Side& side, const CourseSpot& spot, char mark) {
  if (!spot.file.empty() || side.name == "-") return;
  if (!side.text) side.text = std::make_unique<SourceText>(open_text(side.name, side.job->encoding));
  const auto lines = side.text->from(spot.origin.line, 1);
  if (!lines.empty()) type_out("  {} {}\n", mark, shortened_line(lines.front(), most_of_line));
}

std::string places(const Names& names, const CourseDifference& d) {
  return place(names[0], d.a, d.a_to) + " | " + place(names[1], d.b, d.b_to);
}

struct Showing {
  std::size_t most;  // greatest number of differences that are printed
  bool numbered;     // true: each difference is printed with its number in the picture
  Lang lang;
};

void show(Side& a, Side& b, const Comparison& c, const Showing& how) {
  std::size_t count = 0;
  for (const CourseDifference& d : c.differences) {
    if (count++ == how.most) break;
    if (how.numbered) type_out("{}. ", count);
    type_out("{}: {}\n", places({a.name, b.name}, d), sentence_of(d, how.lang));
    show_line(a, d.a, '<');
    show_line(b, d.b, '>');
  }
  if (const std::size_t all = c.differences.size() + c.more; all > count - (count > how.most ? 1 : 0) && all > how.most)
    type_out("{}\n", translated(texts::diff_command::and_more, all - how.most));
}

void print_alarm(const Side& side, const std::optional<AlarmReport>& report, Lang lang) {
  if (report) write_message(alarm_text(*report, side.job->texts(), lang, colours()));
}

void print_all(const DiffOptions& o, Side& a, Side& b, const Comparison& made) {
  const Lang lang = language(o.both);
  show(a, b, made, {o.all ? max_shown : shown, !o.plot.empty(), lang});
  print_alarm(a, made.stopped_a, lang);
  print_alarm(b, made.stopped_b, lang);
  if ((made.stopped_a || made.stopped_b) && made.differences.empty())
    type_out("{}\n", translated(texts::diff_command::same_up_to_alarm, summary_of(made, lang)));
  else type_out("{}\n", summary_of(made, lang));
}

CompareRules rules_of(const DiffOptions& o, const ControlDef& of_b, DifferencePlot& plot) {
  CompareRules rules;
  rules.tolerance = o.tolerance;
  rules.max_reported = max_shown;
  rules.messages = !o.no_messages;
  rules.tools_by_hand = o.tools_by_hand;
  rules.feeds_at_speed = o.feeds_at_speed;
  if (const Words form(of_b, 'F'); o.feeds_rounded && form.known()) rules.feed_step = form.increment();
  rules.stop = o.both.limits.stop;
  if (!o.plot.empty()) rules.on_piece = [&plot](const ComparedPiece& piece) { plot.take(piece); };
  return rules;
}

/// Returns the names of the files that both programs have called.
std::vector<std::string> files_of(const Comparison& made) {
  std::vector<std::string> files = made.read_a;
  files.insert(files.end(), made.read_b.begin(), made.read_b.end());
  return files;
}

/// Returns the output files of the command. They are not open yet.
Outputs outputs_of_diff(const DiffOptions& o, const Side& a, const Side& b) {
  Outputs outputs(language(o.both));
  for (const Side* const side : {&a, &b}) outputs.reads(side->name), outputs.reads(side->job->setup_file);
  for (const std::string& file : {o.both.control, o.control_a, o.control_b, o.both.machine})
    if (file.ends_with(".toml")) outputs.reads(file);
  outputs.writes("--plot", o.plot);
  return outputs;
}

struct Drawing {
  DifferencePlot& plot;
  const ResultFile& file;
  Lang lang;
  bool all;  // true: the picture shows the numbers of all differences; false: only the first ones
};

/// Draws the comparison. If an error occurs, it is printed and the function returns false.
bool draw(const Drawing& to, const Side& a, const Side& b, const Comparison& made) {
  const Lang lang = to.lang;
  const auto control = [lang](const Side& side) { return lang == Lang::ru ? side.job->def->name.ru : side.job->def->name.en; };
  const Names names = short_names(a.name, b.name);
  DifferenceTitle title{names[0],
                        names[1],
                        control(a),
                        lang,
                        {},
                        to.all ? max_shown : shown,
                        [&names](const CourseDifference& d) { return places(names, d); }};
  if (control(a) != control(b)) title.control += " | " + control(b);
  for (std::size_t i = 0; i < made.differences.size() && i < shown; ++i)
    title.lines.push_back(places(names, made.differences[i]) + ": " + sentence_of(made.differences[i], lang));
  const auto drawn = to.plot.write(to.file, title, made);
  if (!drawn) complain(drawn.error());
  return drawn.has_value();
}

}  // namespace

void add_diff(CLI::App& app, Commands& c) {
  CLI::App* const diff = app.add_subcommand("diff", translated(texts::diff_command::about));
  DiffOptions& o = c.diff;
  diff->add_option("A", o.a, translated(texts::diff_command::program_a))->required();
  diff->add_option("B", o.b, translated(texts::diff_command::program_b))->required();
  number(diff->add_option("--tolerance", o.tolerance, translated(texts::diff_command::tolerance)), plain_text(texts::values::mm),
         least_tolerance, max_tolerance)
      ->capture_default_str();
  diff->add_flag("--all", o.all, translated(texts::diff_command::all_differences));
  diff->add_flag("--no-messages", o.no_messages, translated(texts::diff_command::no_messages));
  diff->add_flag("--tools-by-hand", o.tools_by_hand, translated(texts::diff_command::tools_by_hand));
  diff->add_flag("--feeds-at-speed", o.feeds_at_speed, translated(texts::diff_command::feeds_at_speed));
  diff->add_flag("--feeds-rounded", o.feeds_rounded, translated(texts::diff_command::feeds_rounded));
  writes_file(diff->add_option("--plot", o.plot, translated(texts::diff_command::plot)));
  control_id(diff->add_option("--control-a", o.control_a, translated(texts::diff_command::control_a)));
  control_id(diff->add_option("--control-b", o.control_b, translated(texts::diff_command::control_b)));
  takes_file(diff->add_option("--setup-a", o.setup_a, translated(texts::diff_command::setup_a)));
  takes_file(diff->add_option("--setup-b", o.setup_b, translated(texts::diff_command::setup_b)));
  program_options(*diff, o.both);
  memory_option(*diff, o.both);
  diff->footer(plain_text(texts::help_examples::diff));
}

int diff(const DiffOptions& o) {
  const Lang lang = language(o.both);
  if (o.a == "-" && o.b == "-") {
    complain(translated(texts::diff_command::both_from_input));
    return wrong_usage;
  }
  if (const std::string fault = o.plot.empty() ? "" : page_fault(o.plot); !fault.empty()) {
    complain("--plot " + fault);
    return wrong_usage;
  }
  Side a, b;
  const Options options_a = options_of(o, false), options_b = options_of(o, true);
  auto session_a = open_side(options_a, a);
  auto session_b = session_a ? open_side(options_b, b) : nullptr;
  if (!session_b) return wrong_usage;
  Outputs outputs = outputs_of_diff(o, a, b);
  if (!outputs.check() || !outputs.open()) return wrong_usage;
  DifferencePlot plot(common_frame(*session_a, *session_b));
  const Comparison made = compare_sessions(std::move(session_a), std::move(session_b), rules_of(o, *b.job->def, plot));
  if (interrupted()) return interrupted_status();
  print_all(o, a, b, made);
  if (!o.plot.empty() && !draw({plot, *outputs.file("--plot"), lang, o.all}, a, b, made)) return wrong_usage;
  if (interrupted()) return interrupted_status();
  if (!outputs.keep(files_of(made))) return wrong_usage;
  return made.equal() && !made.stopped_a && !made.stopped_b ? ok : alarms;
}

}  // namespace kadr::cli
