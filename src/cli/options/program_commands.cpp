// kadr run, check, setup: defines the options of these commands.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <limits>

#include "cli/options/command_parts.h"
#include "cli/options/help_text.h"
#include "cli/options/option_values.h"
#include "texts/check_options.h"
#include "texts/command_line.h"
#include "texts/program_options.h"
#include "texts/run_options.h"
#include "texts/values.h"

namespace kadr::cli {
namespace {

/// Adds the options that state set-up data: the set-up file, and values that override the file.
void setup_options(CLI::App& app, Options& o) {
  takes_file(app.add_option("--setup", o.setup, plain_text(texts::program_options::setup_file)));
  takes(app.add_option("--tool", o.tools, plain_text(texts::program_options::tool_offset))->allow_extra_args(false),
        plain_text(texts::values::tool_offset));
  takes(app.add_option("--zero", o.zeros, plain_text(texts::program_options::work_zero))->allow_extra_args(false),
        plain_text(texts::values::work_zero));
  takes(app.add_option("--corrector", o.correctors, plain_text(texts::program_options::axis_corrector))->allow_extra_args(false),
        plain_text(texts::values::axis_corrector));
}

}  // namespace

void program_argument(CLI::App& app, Options& o) {
  app.add_option(plain_text(texts::values::program), o.programs, plain_text(texts::program_options::program))
      ->required()
      ->expected(1)
      ->allow_extra_args(false);
}

void program_options(CLI::App& app, Options& o) {
  control_id(app.add_option("--control", o.control, plain_text(texts::program_options::control)));
  app.add_flag("--remember", o.remembers, plain_text(texts::program_options::remember));
  machine_id(app.add_option("--machine", o.machine, plain_text(texts::program_options::machine)));
  setup_options(app, o);
  encoding(app.add_option("--encoding", o.encoding, plain_text(texts::program_options::encoding)));
  whole_number(app.add_option("--program", o.program, plain_text(texts::program_options::program_number)), 1, 999999999);
  whole_number(app.add_option("--skip", o.skip, plain_text(texts::program_options::skip_switches)), 1, 9);
  app.add_flag("--optional-stop", o.optional_stop, plain_text(texts::program_options::optional_stop));
  whole_number(app.add_option("--max-blocks", o.limits.repeated_blocks, plain_text(texts::program_options::max_blocks)), 0, 1e15)
      ->capture_default_str();
  whole_number(app.add_option("--max-passes", o.limits.restarts, plain_text(texts::program_options::max_passes)), 0,
               std::numeric_limits<std::uint32_t>::max())
      ->capture_default_str();
  takes(app.add_option("--disable", o.disabled, plain_text(texts::program_options::disabled_finding))
            ->allow_extra_args(false)
            ->check([](const std::string& name) {
              return alarm_named(name) != AlarmId::count ? std::string() : translated(texts::program_options::no_such_finding, name);
            }),
        plain_text(texts::values::finding_id));
  app.add_flag("--every", o.every, plain_text(texts::program_options::every_warning));
  quiet_option(app, o.quiet);
  language_option(app, o.lang);
}

void memory_option(CLI::App& app, Options& o) {
  takes(app.add_option_function<std::string>(
               "--files", [&o](const std::string& folder) { o.limits.files = (std::filesystem::path(folder) / "").string(); },
               plain_text(texts::program_options::memory_folder))
            ->check([](const std::string& folder) {
              std::error_code error;
              return std::filesystem::is_directory(folder, error) ? std::string()
                                                                  : translated(texts::program_options::no_such_folder, folder);
            }),
        plain_text(texts::values::folder));
}

namespace {

/// Reads a change of the feed override in the form `SECONDS:PERCENT`, e.g. 2.5:50.
OverrideChange override_change(const std::string& text) {
  const char* const end = text.data() + text.size();
  OverrideChange change;
  const auto time = std::from_chars(text.data(), end, change.seconds);
  const bool colon = time.ec == std::errc() && time.ptr != end && *time.ptr == ':';
  double percent = 0;
  const auto share = std::from_chars(colon ? time.ptr + 1 : end, end, percent);
  if (!colon || share.ec != std::errc() || share.ptr != end || !(change.seconds >= 0) || !(percent >= 0 && percent <= 100))
    throw CLI::ValidationError("--override", translated(texts::run_options::wrong_override, text));
  change.share = percent / 100;
  return change;
}

void sample_options(CLI::App& run, Options& o) {
  writes_file(run.add_option("--samples", o.samples, plain_text(texts::run_options::samples)));
  writes_file(run.add_option("--samples-tip", o.samples_tip, plain_text(texts::run_options::tip_samples)))->needs("--samples");
  number(run.add_option("--rate", o.rate, plain_text(texts::run_options::sample_rate)), plain_text(texts::values::hertz), 1, 1e6)
      ->capture_default_str();
  number(run.add_option("--max-time", o.max_time, plain_text(texts::run_options::max_time)), plain_text(texts::values::seconds), 0, 1e9)
      ->capture_default_str();
  takes(run.add_option_function<std::vector<std::string>>(
               "--override",
               [&o](const std::vector<std::string>& changes) {
                 for (const std::string& text : changes) o.overrides.push_back(override_change(text));
                 std::stable_sort(o.overrides.begin(), o.overrides.end(),
                                  [](const auto& a, const auto& b) { return a.seconds < b.seconds; });
               },
               plain_text(texts::run_options::override_changes))
            ->delimiter(','),
        plain_text(texts::values::override_changes));
}

void picture_options(CLI::App& run, Options& o) {
  writes_file(run.add_option("--plot", o.plot, plain_text(texts::run_options::plot)));
  one_of(run.add_option("--colour,--color", o.colour, plain_text(texts::run_options::plot_colour)), {"speed", "limit"});
  writes_file(run.add_option("--plot-speed", o.plot_speed, plain_text(texts::run_options::speed_plot)));
}

/// Adds the options that select the results of a run, and those that select a part of the program.
void result_options(CLI::App& run, Options& o) {
  writes_file(run.add_option("--trace", o.trace, plain_text(texts::run_options::trace)));
  writes_file(run.add_option("--state", o.state, plain_text(texts::run_options::state_file)));
  takes(run.add_option("--files", o.files, plain_text(texts::run_options::output_folder)), plain_text(texts::values::folder));
  sample_options(run, o);
  picture_options(run, o);
  run.add_flag("--json", o.json, plain_text(texts::run_options::summary_as_json));
  run.add_flag("--why", o.why, plain_text(texts::run_options::slowest_lines));
  takes(run.add_option("--from", o.from, plain_text(texts::run_options::first_line)), plain_text(texts::values::line_and_pass));
  takes(run.add_option("--to", o.to, plain_text(texts::run_options::last_line)), plain_text(texts::values::line));
}

}  // namespace

void add_run(CLI::App& app, Commands& c) {
  CLI::App* const run = app.add_subcommand("run", plain_text(texts::run_options::run_command));
  program_argument(*run, c.options);
  program_options(*run, c.options);
  result_options(*run, c.options);
  run->footer(plain_text(texts::help_examples::run));
}

void add_debug(CLI::App& app, Commands& c) {
  CLI::App* const debug = app.add_subcommand("debug", plain_text(texts::run_options::debug_command));
  program_argument(*debug, c.options);
  program_options(*debug, c.options);
  result_options(*debug, c.options);
  debug->footer(plain_text(texts::help_examples::debug));
}

void add_check(CLI::App& app, Commands& c) {
  Options& o = c.options;
  CLI::App* const check = app.add_subcommand("check", plain_text(texts::check_options::check_command));
  CLI::Option* const programs =
      check->add_option(plain_text(texts::values::program), o.programs, plain_text(texts::check_options::programs));
  program_options(*check, o);
  memory_option(*check, o);
  one_of(check->add_option("--format", o.format, plain_text(texts::check_options::format)), {"text", "json", "sarif"})
      ->capture_default_str();
  writes_file(check->add_option("--output", o.output, plain_text(texts::check_options::output)));
  takes_file(check->add_option("--baseline", o.baseline, plain_text(texts::check_options::baseline)));
  takes_file(check->add_option("--tools", o.table, plain_text(texts::check_options::tools_file)));
  takes(check->add_option("--exclude", o.exclude, plain_text(texts::check_options::excluded_files)), plain_text(texts::values::pattern));
  takes(check->add_option("--control-for", o.control_for, plain_text(texts::check_options::control_for_files)),
        plain_text(texts::values::pattern_and_control));
  CLI::Option* const explained = takes(
      check->add_option("--explain", o.explained, plain_text(texts::check_options::explained_finding))->check([](const std::string& name) {
        return alarm_named(name) != no_alarm ? std::string() : translated(texts::program_options::no_such_finding, name);
      }),
      plain_text(texts::values::finding_id));
  check->callback([programs, explained] {
    if (programs->count() == 0 && explained->count() == 0) throw CLI::RequiredError(programs->get_name());
  });
  check->add_flag("--strict", o.strict, plain_text(texts::check_options::strict));
  check->footer(plain_text(texts::help_examples::check));
}

void add_setup(CLI::App& app, Commands& c) {
  CLI::App* const setup = app.add_subcommand("setup", plain_text(texts::command_line::setup_command));
  program_argument(*setup, c.setup.program);
  program_options(*setup, c.setup.program);
  writes_file(setup->add_option("--out", c.setup.output, plain_text(texts::command_line::setup_output)));
  setup->add_flag("--tools", c.setup.tools, plain_text(texts::command_line::setup_tools));
  setup->footer(plain_text(texts::help_examples::setup));
}

}  // namespace kadr::cli
