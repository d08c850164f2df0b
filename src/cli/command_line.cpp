#include "cli/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

#include "config/control_file.h"

namespace kadr::cli {
namespace {

constexpr const char* run_examples =
    "Examples:\n"
    "  kadr run flange.nc                              guess the control, print the summary\n"
    "  kadr run flange.nc --control s2c42 --plot f.svg draw the path\n"
    "  kadr run part.tap --control mach3 --trace -     every action as a line of JSON\n"
    "  kadr run part.nc --setup shop.json --lang ru    offsets and start from a file, in Russian\n"
    "Exit status: 0 ran to its end, 1 stopped by an alarm, 2 wrong usage or unreadable file.";
constexpr const char* check_examples =
    "Examples:\n"
    "  kadr check programs/                            every program of a folder, every fault\n"
    "  kadr check a.nc b.nc --control gost\n"
    "  kadr check programs/ --format sarif >r.sarif    for an editor or a code host\n"
    "  kadr check . --exclude 'old/*' --control-for '*.nct=nct' --strict\n"
    "  kadr check . --format json --output known.json; kadr check . --baseline known.json\n"
    "Exit status: 0 no error, 1 errors found, 2 wrong usage or unreadable file.";
constexpr const char* explain_examples =
    "Examples:\n"
    "  kadr explain s2c42 G41         a code: group, words, source\n"
    "  kadr explain s2c42 L83         a cycle and its body\n"
    "  kadr explain mach3 X           an address\n"
    "  kadr explain mach3             the whole control\n"
    "  kadr explain mach3 radius_mismatch   an alarm and what to do\n"
    "  kadr explain nct setup         the keys of a set-up";
constexpr const char* setup_examples =
    "Examples:\n"
    "  kadr setup part.nc --control nct                what is to be filled in, to standard output\n"
    "  kadr setup part.nc --control nct --out shop.json; kadr run part.nc --control nct --setup shop.json\n"
    "Exit status: 0 written, 2 wrong usage, unreadable file, or the file --out is there already.";
constexpr const char* tape_examples =
    "Examples:\n"
    "  kadr tape encode flange.nc flange.tape     text to rows with even parity\n"
    "  kadr tape decode flange.tape               rows to text; parity errors by row on stderr\n"
    "  kadr tape encode part.nc part.tape --code eia   rows of EIA RS-244, odd parity\n"
    "Exit status: 0 all well, 1 parity errors, a tape that lies wrongly or a character that has no code, 2 wrong usage.";

constexpr const char* state_examples =
    "Examples:\n"
    "  kadr state check shop.state                    sound, or what is damaged in it\n"
    "  kadr state recover shop.state --out new.state  what is sound, in a new file; the old one stays as it is\n"
    "Exit status: 0 sound, 1 damaged, 2 wrong usage, or no state that can be read.";

constexpr const char* mill_examples =
    "Examples:\n"
    "  kadr mill pocket cover.dxf --tool-diameter 10 --depth 12 --pass 4 --control s2c42 --output cover.nc\n"
    "  kadr mill pocket cam.txt --tool-diameter 8 --depth 5 --scheme СПИР --stepover 60% --control mach3\n"
    "  kadr mill face plate.svg --tool-diameter 50 --depth 1 --control nct --plot face.svg\n"
    "  kadr mill slot groove.txt --tool-diameter 8 --depth 6 --pass 2 --control gost\n"
    "Exit status: 0 written and verified, 1 the contour or the path is faulty, 2 wrong usage or unreadable file.";

void language_option(CLI::App& app, std::string& lang) {
  app.add_option("--lang", lang, "language of messages: en or ru (default: by LANG)")->check(CLI::IsMember({"en", "ru"}));
}

void program_options(CLI::App& app, Options& o) {
  app.add_option("--control", o.control, "control: an id of `kadr controls`, or a file NAME.toml (default: guessed from the text)");
  app.add_option("--machine", o.machine, "machine profile: an id or a file NAME.toml (default: generic)");
  app.add_option("--setup", o.setup, "state before the start: a JSON file");
  app.add_option("--tool", o.tools, "offset number, radius, length, their wear, mm: 1:r8,l100,rw-0.02,lw0.1; repeated")
      ->allow_extra_args(false);
  app.add_option("--zero", o.zeros, "work zero, machine coordinates: G54=X-400,Y-250,Z-300, or 1=X40 (2С42); repeated")
      ->allow_extra_args(false);
  app.add_option("--corrector", o.correctors, "axis corrector, mm: 17=-0.35; repeated")->allow_extra_args(false);
  app.add_option("--encoding", o.encoding,
                 "of the text: utf-8, cp1251, koi8-r, cp866, utf-16, utf-16le, utf-16be, iso7, eia (default: detected)");
  app.add_option("--program", o.program, "number of the program on a tape with several (default: the first; check: all)")
      ->check(CLI::Range(1, 999999999));
  app.add_option("--skip", o.skip, "skip switches that are on, 1 to 9")->check(CLI::Range(1, 9));
  app.add_flag("--optional-stop", o.optional_stop, "stop at M01");
  app.add_option("--max-blocks", o.limits.repeated_blocks, "stop a program that repeats more blocks than this")->capture_default_str();
  app.add_option("--max-passes", o.limits.restarts, "passes of an endless program (M99, M47), where they may differ")
      ->capture_default_str();
  app.add_flag("--quiet,-q", o.quiet, "no summary, no progress bar");
  language_option(app, o.lang);
}

/// `SECONDS:PERCENT`, as in 2.5:50.
OverrideChange override_change(const std::string& text) {
  const char* const end = text.data() + text.size();
  OverrideChange change;
  const auto time = std::from_chars(text.data(), end, change.seconds);
  const bool colon = time.ec == std::errc() && time.ptr != end && *time.ptr == ':';
  double percent = 0;
  const auto share = std::from_chars(colon ? time.ptr + 1 : end, end, percent);
  if (!colon || share.ec != std::errc() || share.ptr != end || !(change.seconds >= 0) || !(percent >= 0 && percent <= 100))
    throw CLI::ValidationError("--override", text + ": want SECONDS:PERCENT, PERCENT from 0 (feed hold) to 100");
  change.share = percent / 100;
  return change;
}

void sample_options(CLI::App& run, Options& o) {
  run.add_option("--samples", o.samples, "positions of the axes at the servo rate as CSV, to a file or - for stdout");
  run.add_option("--rate", o.rate, "of the samples, Hz")->check(CLI::Range(1.0, 1e6))->capture_default_str();
  run.add_option("--max-time", o.max_time, "the samples end after so many seconds (exit status 1); default: a day")
      ->check(CLI::Range(0.0, 1e9))
      ->capture_default_str();
  run.add_option_function<std::vector<std::string>>(
         "--override",
         [&o](const std::vector<std::string>& texts) {
           for (const std::string& text : texts) o.overrides.push_back(override_change(text));
           std::stable_sort(o.overrides.begin(), o.overrides.end(), [](const auto& a, const auto& b) { return a.seconds < b.seconds; });
         },
         "of the samples' speed, from times on: SECONDS:PERCENT,… (0: feed hold)")
      ->delimiter(',');
}

void add_run(CLI::App& app, Commands& c) {
  CLI::App* const run = app.add_subcommand("run", "carry a program out: summary, trace, picture");
  run->add_option("PROGRAM", c.options.programs, "the part program (- for standard input)")->required()->expected(1);
  program_options(*run, c.options);
  run->add_option("--trace", c.options.trace, "every action as a line of JSON, to a file or - for stdout");
  run->add_option("--state", c.options.state, "file that keeps offsets, #500-#999, tool life, parameters from run to run (nct)");
  run->add_option("--files", c.options.files,
                  "folder for what the program itself writes (FOPEN, DPRNT …); nothing outside it (default: it writes nothing)");
  sample_options(*run, c.options);
  run->add_option("--plot", c.options.plot, "draw the path: a file .svg or .png");
  run->add_option("--colour,--color", c.options.colour, "of the path in --plot: by speed, or by the limit that slows it")
      ->check(CLI::IsMember({"speed", "limit"}));
  run->add_option("--plot-speed", c.options.plot_speed, "draw speed, acceleration and jerk over the time: a file .svg or .png");
  run->add_flag("--why", c.options.why, "the ten lines that lose most time against their feed, and the limit that costs it");
  run->footer(run_examples);
}

void add_check(CLI::App& app, Commands& c) {
  CLI::App* const check = app.add_subcommand("check", "find every fault of programs");
  check->add_option("PROGRAM", c.options.programs, "programs and folders of programs")->required();
  program_options(*check, c.options);
  check->add_option("--format", c.options.format, "text, json or sarif")
      ->check(CLI::IsMember({"text", "json", "sarif"}))
      ->capture_default_str();
  check->add_option("--output", c.options.output, "file for the findings (default: text on stderr, json and sarif on stdout)");
  check->add_option("--baseline", c.options.baseline, "findings that are known, as --format json wrote them: only new ones are told");
  check->add_option("--exclude", c.options.exclude,
                    "in folders, leave out what is like the pattern (* ? [abc]): a path or a name; may be repeated");
  check->add_option("--control-for", c.options.control_for,
                    "PATTERN=ID: the control of the files that are like the pattern; may be repeated");
  check->add_flag("--strict", c.options.strict, "warnings count as errors");
  check->footer(check_examples);
}

void add_explain(CLI::App& app, Commands& c) {
  CLI::App* const explain = app.add_subcommand("explain", "what a code, address, cycle or alarm means");
  explain->add_option("CONTROL", c.explain.control, "control id or NAME.toml")->required();
  explain->add_option("CODE", c.explain.code, "G41, M3, X, L81, an alarm id, setup; left out: all codes");
  explain->add_flag("--markdown", c.explain.markdown, "the page of the documentation");
  language_option(*explain, c.explain.lang);
  explain->footer(explain_examples);
  CLI::App* const controls = app.add_subcommand("controls", "the controls Kadr knows");
  language_option(*controls, c.options.lang);
}

void add_setup(CLI::App& app, Commands& c) {
  Options& o = c.setup.program;
  CLI::App* const setup = app.add_subcommand("setup", "write a set-up to be filled in, with what a program uses");
  setup->add_option("PROGRAM", o.programs, "the part program (- for standard input)")->required()->expected(1);
  program_options(*setup, o);
  setup->add_option("--out", c.setup.output, "the new file (default: standard output)");
  setup->footer(setup_examples);
}

void add_tape(CLI::App& app, Commands& c) {
  CLI::App* const tape = app.add_subcommand("tape", "punched tape: rows of ISO-7 with even parity or of EIA RS-244, and text");
  tape->require_subcommand(1);
  for (const bool decode : {true, false}) {
    CLI::App* const sub = tape->add_subcommand(decode ? "decode" : "encode", decode ? "rows to text" : "text to rows");
    sub->add_option("INPUT", c.tape.input, "file, or - for stdin")->required();
    sub->add_option("OUTPUT", c.tape.output, "file, or - for stdout (default)");
    sub->add_option("--code", c.tape.code, decode ? "of the tape: iso or eia (default: detected)" : "of the tape: iso (default) or eia")
        ->check(CLI::IsMember({"iso", "eia"}));
    language_option(*sub, c.tape.lang);
    if (!decode) {
      sub->add_option("--encoding", c.tape.encoding, "of the text: utf-8, cp1251, koi8-r, cp866, utf-16 (default: detected)");
      sub->add_option("--leader", c.tape.leader, "rows of blank tape before and after")
          ->capture_default_str()
          ->check(CLI::Range(0, 100000));
    }
  }
  tape->footer(tape_examples);
}

void add_state(CLI::App& app, Commands& c) {
  CLI::App* const state = app.add_subcommand("state", "the file of run --state: is it sound");
  state->require_subcommand(1);
  for (const bool recover : {false, true}) {
    CLI::App* const sub = recover ? state->add_subcommand("recover", "write what is sound into a new file")
                                  : state->add_subcommand("check", "find every damaged row");
    sub->add_option("FILE", c.state.file, "state file")->required();
    language_option(*sub, c.state.lang);
    if (!recover) continue;
    sub->add_option("--out", c.state.out, "the new file, which must not be there yet (default: FILE.recovered)");
    sub->add_option("--control", c.state.control, "whose state it is, where the file no longer says");
  }
  state->footer(state_examples);
}

void geometry_options(CLI::App& app, MillOptions& o) {
  app.add_option("CONTOUR", o.contour, "drawing: DXF, SVG or text (- for standard input)")->required();
  app.add_option("--tool-diameter", o.tool_diameter, "mm")->required();
  app.add_option("--depth", o.depth, "below the top, mm")->required();
  app.add_option("--pass", o.pass, "depth of a layer at most, mm (default: all at once)");
  app.add_option("--scheme", o.scheme, "zigzag 1zigzag 2zigzag spiral-out spiral-in comb 1comb 2comb, or ЗИГЗАГ СПИР АСПИР ШТИП …");
  app.add_option("--direction", o.direction, "of going round: ccw or cw (default: climb milling)");
  app.add_option("--stepover", o.stepover, "mm, or % of the diameter (default: 50%, face 70%)");
  app.add_option("--plunge", o.plunge, "hole, tangential or ramp (ЗАСВ, КАС, СПУСК)")->capture_default_str();
  app.add_option("--hole", o.hole, "X Y of the hole drilled before (default: named by Kadr)")->expected(2);
  app.add_option("--ramp-angle", o.ramp_angle, "of the ramp, degrees")->capture_default_str();
  app.add_option("--allowance", o.allowance, "left on walls, mm")->capture_default_str();
  app.add_option("--top", o.top, "Z of the material")->capture_default_str();
  app.add_option("--clearance", o.clearance, "above the top: free way, mm")->capture_default_str();
  app.add_option("--overrun", o.overrun, "of the tool beyond open sides, mm")->capture_default_str();
  app.add_option("--angle", o.angle, "of the rows to X, degrees")->capture_default_str();
}

void add_mill(CLI::App& app, Commands& c) {
  CLI::App* const mill = app.add_subcommand("mill", "make a program that mills an area");
  mill->require_subcommand(1);
  const std::pair<const char*, const char*> tasks[] = {
      {"pocket", "a zone within walls, with islands; open sides where the drawing says so"},
      {"face", "a zone without walls: the tool runs over its edges"},
      {"slot", "along a line, or a pocket in the shape of a slot"}};
  for (const auto& [name, what] : tasks) {
    CLI::App* const sub = mill->add_subcommand(name, what);
    MillOptions& o = c.mill;
    geometry_options(*sub, o);
    if (std::string(name) == "slot") sub->add_option("--width", o.width, "of the slot along a line, mm (default: that of the tool)");
    sub->add_option("--control", o.control, "control: an id of `kadr controls`, or a file NAME.toml")->required();
    sub->add_option("--feed", o.feed, "mm/min")->capture_default_str();
    sub->add_option("--plunge-feed", o.plunge_feed, "mm/min (default: a third of the feed)");
    sub->add_option("--speed", o.speed, "of the spindle, rev/min (default: not written)");
    sub->add_option("--tool", o.tool, "number of the tool (default: not called)");
    sub->add_flag("--coolant", o.coolant, "switch the coolant on and off");
    sub->add_option("--mark", o.mark, "end of block written out: ПС or LF")->check(CLI::IsMember({"ПС", "LF"}));
    sub->add_option("--output", o.output, "the program (default: standard output)");
    sub->add_option("--plot", o.plot, "draw contour and path: a file .svg or .png");
    sub->add_flag("--quiet,-q", o.quiet, "no summary");
    language_option(*sub, o.lang);
    sub->footer(mill_examples);
  }
  mill->footer(mill_examples);
}

}  // namespace

std::unique_ptr<CLI::App> make_app(Commands& c) {
  auto app =
      std::make_unique<CLI::App>("Kadr reads part programs exactly as a given control would: checks, runs, draws and times them.", "kadr");
  app->set_version_flag("--version", std::string("kadr ") + KADR_VERSION);
  app->require_subcommand(1);
  add_run(*app, c);
  add_check(*app, c);
  add_explain(*app, c);
  add_setup(*app, c);
  add_tape(*app, c);
  add_state(*app, c);
  add_mill(*app, c);
  app->add_subcommand("man", "print the manual page (kadr man > kadr.1)");
  CLI::App* const complete = app->add_subcommand("completion", "print the completion script of a shell");
  complete->add_option("SHELL", c.shell, "bash, zsh or fish")->required()->check(CLI::IsMember({"bash", "zsh", "fish"}));
  app->footer("`kadr COMMAND --help` shows options and examples. Try: kadr run examples/s2c42/flange.nc --plot flange.svg");
  return app;
}

}  // namespace kadr::cli
