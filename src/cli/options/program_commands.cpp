// kadr run, check, setup: their options.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <limits>

#include "cli/options/command_parts.h"
#include "cli/options/help_text.h"
#include "cli/options/option_values.h"
#include "config/language.h"

namespace kadr::cli {
namespace {

/// Options: what is stated besides the set-up file.
void setup_options(CLI::App& app, Options& o) {
  takes_file(
      app.add_option("--setup", o.setup, told("state before the start: a JSON file", "исходное состояние станка и УЧПУ: файл JSON")));
  takes(app.add_option("--tool", o.tools,
                       told("offset number, radius, length, their wear, mm: 1:r8,l100,rw-0.02,lw0.1; repeated",
                            "корректор: номер, радиус, вылет и их износ, мм: 1:r8,l100,rw-0.02,lw0.1; можно повторять"))
            ->allow_extra_args(false),
        "N:VALUES", "N:ДАННЫЕ");
  takes(app.add_option("--zero", o.zeros,
                       told("work zero, machine coordinates: G54=X-400,Y-250,Z-300, or 1=X40 (2С42); repeated",
                            "нулевая точка в координатах станка: G54=X-400,Y-250,Z-300 или 1=X40 (2С42); можно повторять"))
            ->allow_extra_args(false),
        "NAME=AXES", "ИМЯ=ОСИ");
  takes(app.add_option("--corrector", o.correctors,
                       told("axis corrector, mm: 17=-0.35; repeated", "осевой корректор, мм: 17=-0.35; можно повторять"))
            ->allow_extra_args(false),
        "N=MM", "N=ММ");
}

}  // namespace

void program_argument(CLI::App& app, Options& o) {
  app.add_option(told("PROGRAM", "УП"), o.programs,
                 told("the part program (- for standard input)", "управляющая программа (- стандартный ввод)"))
      ->required()
      ->expected(1)
      ->allow_extra_args(false);
}

void program_options(CLI::App& app, Options& o) {
  control_id(app.add_option("--control", o.control,
                            told("control: an id of `kadr controls`, or a file NAME.toml (default: guessed from the text)",
                                 "УЧПУ: обозначение из `kadr controls` или файл ИМЯ.toml (по умолчанию определяется по тексту)")));
  app.add_flag("--remember", o.remembers,
               told("write --control to .kadr.toml in the program's folder: what lies there needs no --control any more",
                    "записать --control в .kadr.toml в папке УП: лежащему там --control больше не нужен"));
  machine_id(app.add_option("--machine", o.machine,
                            told("machine profile: an id of `kadr machines`, or a file NAME.toml (default: generic)",
                                 "станок: обозначение из `kadr machines` или файл ИМЯ.toml (по умолчанию generic)")));
  setup_options(app, o);
  encoding(app.add_option(
      "--encoding", o.encoding,
      told("of the text: utf-8, cp1251, koi8-r, cp866, utf-16, utf-16le, utf-16be, iso7, eia (default: detected)",
           "кодировка текста: utf-8, cp1251, koi8-r, cp866, utf-16, utf-16le, utf-16be, iso7, eia (по умолчанию определяется сама)")));
  whole_number(app.add_option("--program", o.program,
                              told("number of the program on a tape with several (default: the first; check: all)",
                                   "номер программы на ленте с несколькими (по умолчанию первая; у check — все)")),
               1, 999999999);
  whole_number(
      app.add_option("--skip", o.skip, told("skip switches that are on, 1 to 9", "включённые переключатели пропуска кадров, от 1 до 9")), 1,
      9);
  app.add_flag("--optional-stop", o.optional_stop, told("stop at M01", "останавливаться на M01 (останов с подтверждением)"));
  whole_number(app.add_option("--max-blocks", o.limits.repeated_blocks,
                              told("stop a program that repeats more blocks than this", "прервать УП, если повторных кадров больше")),
               0, 1e15)
      ->capture_default_str();
  whole_number(app.add_option("--max-passes", o.limits.restarts,
                              told("passes of an endless program (M99, M47), where they may differ",
                                   "проходы бесконечной УП (M99, M47), если они могут различаться")),
               0, std::numeric_limits<std::uint32_t>::max())
      ->capture_default_str();
  takes(app.add_option("--disable", o.disabled,
                       told("a warning or note that is not told, by its id; repeated",
                            "предупреждение или замечание, о котором не сообщать, по имени; можно повторять"))
            ->allow_extra_args(false)
            ->check([](const std::string& name) {
              return alarm_named(name) != AlarmId::count ? std::string()
                                                         : told("no finding has this name: ", "нет сообщения с таким именем: ") + name;
            }),
        "ID", "ИМЯ");
  app.add_flag(
      "--every", o.every,
      told("print each warning whole, however many are alike", "печатать каждое предупреждение целиком, сколько бы ни было похожих"));
  quiet_option(app, o.quiet);
  language_option(app, o.lang);
}

void memory_option(CLI::App& app, Options& o) {
  takes(app.add_option_function<std::string>(
               "--files", [&o](const std::string& folder) { o.limits.files = (std::filesystem::path(folder) / "").string(); },
               told("folder of the program memory, where what the program calls and the set-up names is looked for (default: the "
                    "program's own); nothing is written there",
                    "папка памяти программ, где ищется то, что вызывает УП и называет наладка (по умолчанию папка самой УП); в неё "
                    "ничего не пишется"))
            ->check([](const std::string& folder) {
              std::error_code error;
              return std::filesystem::is_directory(folder, error) ? std::string() : told("no folder ", "нет папки ") + folder;
            }),
        "DIR", "ПАПКА");
}

namespace {

/// Reads `SECONDS:PERCENT`, as in 2.5:50.
OverrideChange override_change(const std::string& text) {
  const char* const end = text.data() + text.size();
  OverrideChange change;
  const auto time = std::from_chars(text.data(), end, change.seconds);
  const bool colon = time.ec == std::errc() && time.ptr != end && *time.ptr == ':';
  double percent = 0;
  const auto share = std::from_chars(colon ? time.ptr + 1 : end, end, percent);
  if (!colon || share.ec != std::errc() || share.ptr != end || !(change.seconds >= 0) || !(percent >= 0 && percent <= 100))
    throw CLI::ValidationError("--override", told(text + ": want SECONDS:PERCENT, PERCENT from 0 (feed hold) to 100",
                                                  text + ": нужно СЕКУНДЫ:ПРОЦЕНТ, ПРОЦЕНТ от 0 (останов подачи) до 100"));
  change.share = percent / 100;
  return change;
}

void sample_options(CLI::App& run, Options& o) {
  writes_file(run.add_option("--samples", o.samples,
                             told("positions of the axes at the servo rate as CSV, to a file or - for stdout",
                                  "положения осей с тактом привода в виде CSV: в файл или - на стандартный вывод")));
  writes_file(run.add_option("--samples-tip", o.samples_tip,
                             told("beside --samples: the tool's tip in work coordinates and its direction at the same times, as CSV",
                                  "вместе с --samples: вершина инструмента в координатах детали и его направление в те же моменты, CSV")))
      ->needs("--samples");
  number(run.add_option("--rate", o.rate, told("of the samples, Hz", "частота этих отсчётов, Гц")), "HZ", "ГЦ", 1, 1e6)
      ->capture_default_str();
  number(run.add_option("--max-time", o.max_time,
                        told("the samples end after so many seconds (exit status 1); a day, if not given",
                             "через столько секунд отсчёты кончаются (код возврата 1); если не указано — сутки")),
         "SECONDS", "СЕКУНДЫ", 0, 1e9)
      ->capture_default_str();
  takes(run.add_option_function<std::vector<std::string>>(
               "--override",
               [&o](const std::vector<std::string>& texts) {
                 for (const std::string& text : texts) o.overrides.push_back(override_change(text));
                 std::stable_sort(o.overrides.begin(), o.overrides.end(),
                                  [](const auto& a, const auto& b) { return a.seconds < b.seconds; });
               },
               told("of the samples' speed, from times on (0: feed hold)", "доля скорости отсчётов с этих времён (0 — останов подачи)"))
            ->delimiter(','),
        "SECONDS:PERCENT,…", "СЕКУНДЫ:ПРОЦЕНТ,…");
}

void picture_options(CLI::App& run, Options& o) {
  writes_file(run.add_option("--plot", o.plot, told("draw the path: a file .svg or .png", "чертёж траектории: файл .svg или .png")));
  one_of(run.add_option("--colour,--color", o.colour,
                        told("of the path in --plot: by speed, or by the limit that slows it",
                             "цвет траектории на --plot: по скорости или по пределу, который её снижает")),
         {"speed", "limit"});
  writes_file(run.add_option("--plot-speed", o.plot_speed,
                             told("draw speed, acceleration and jerk over the time: a file .svg or .png",
                                  "график скорости, ускорения и рывка во времени: файл .svg или .png")));
}

/// Options: the results of a run, and the part of the program that is run.
void result_options(CLI::App& run, Options& o) {
  writes_file(run.add_option("--trace", o.trace,
                             told("every action as a line of JSON, to a file or - for stdout",
                                  "протокол: каждое действие строкой JSON, в файл или - на стандартный вывод")));
  writes_file(
      run.add_option("--state", o.state,
                     told("file that keeps offsets, #500-#999, tool life, parameters from run to run (nct)",
                          "файл, где от прогона к прогону хранятся корректоры, #500–#999, стойкость инструмента и параметры (nct)")));
  takes(run.add_option("--files", o.files,
                       told("folder for what the program itself writes (FOPEN, DPRNT …); nothing outside it (default: it writes nothing)",
                            "папка для того, что пишет сама УП (FOPEN, DPRNT …); вне её ничего (по умолчанию УП ничего не пишет)")),
        "DIR", "ПАПКА");
  sample_options(run, o);
  picture_options(run, o);
  run.add_flag("--json", o.json, told("the summary as JSON, alone on standard output", "сводка в виде JSON, одна на стандартном выводе"));
  run.add_flag("--why", o.why,
               told("the ten lines that lose most time against their feed, and the limit that costs it",
                    "десять строк, теряющих больше всего времени против своей подачи, и предел, из-за которого оно теряется"));
  takes(run.add_option(
            "--from", o.from,
            told("begin with this line of the program, what is before it silently: LINE, or LINE:PASS where it comes several times",
                 "начать с этой строки УП, пройдя предыдущее молча: СТРОКА или СТРОКА:ПРОХОД, если она встречается не раз")),
        "LINE[:PASS]", "СТРОКА[:ПРОХОД]");
  takes(run.add_option("--to", o.to, told("end after this line of the program", "закончить после этой строки УП")), "LINE", "СТРОКА");
}

}  // namespace

void add_run(CLI::App& app, Commands& c) {
  CLI::App* const run =
      app.add_subcommand("run", told("carry a program out: summary, trace, picture", "отработать УП: сводка, протокол, чертёж"));
  program_argument(*run, c.options);
  program_options(*run, c.options);
  result_options(*run, c.options);
  run->footer(run_examples());
}

void add_debug(CLI::App& app, Commands& c) {
  CLI::App* const debug = app.add_subcommand("debug", told("carry a program out step by step, by commands on standard input",
                                                           "отрабатывать УП по шагам, командами со стандартного ввода"));
  program_argument(*debug, c.options);
  program_options(*debug, c.options);
  result_options(*debug, c.options);
  debug->footer(debug_examples());
}

void add_check(CLI::App& app, Commands& c) {
  Options& o = c.options;
  CLI::App* const check = app.add_subcommand("check", told("find every fault of programs", "найти все ошибки программ"));
  CLI::Option* const programs =
      check->add_option(told("PROGRAM", "УП"), o.programs, told("programs and folders of programs", "программы и папки с программами"));
  program_options(*check, o);
  memory_option(*check, o);
  one_of(check->add_option("--format", o.format, told("of what is found", "вид перечня найденного")), {"text", "json", "sarif"})
      ->capture_default_str();
  writes_file(check->add_option("--output", o.output,
                                told("file for the findings (default: text on stderr, json and sarif on stdout)",
                                     "файл для найденного (по умолчанию text в stderr, json и sarif в stdout)")));
  takes_file(check->add_option("--baseline", o.baseline,
                               told("findings that are known, as --format json wrote them: only new ones are told",
                                    "известное, как его записал --format json: сообщается только о новом")));
  takes_file(check->add_option("--tools", o.table,
                               told("tools file that the programs are held against, as of kadr cut: which tools are missing in it, which "
                                    "are never called (default: NAME.toml, NAME.tbl or tools.toml beside NAME.nc)",
                                    "файл инструментов, как у kadr cut, с которым сверяются УП: каких инструментов в нём нет и какие не "
                                    "вызываются (по умолчанию NAME.toml, NAME.tbl или tools.toml рядом с NAME.nc)")));
  takes(check->add_option("--exclude", o.exclude,
                          told("in folders, leave out what is like the pattern (* ? [abc]): a path or a name; may be repeated",
                               "в папках пропускать похожее на образец (* ? [abc]): путь или имя; можно повторять")),
        "PATTERN", "ОБРАЗЕЦ");
  takes(check->add_option("--control-for", o.control_for,
                          told("the control of the files that are like the pattern; may be repeated",
                               "УЧПУ для файлов, похожих на образец; можно повторять")),
        "PATTERN=ID", "ОБРАЗЕЦ=УЧПУ");
  CLI::Option* const explained = takes(
      check
          ->add_option("--explain", o.explained,
                       told("what a finding means and what to do about it, by its id", "что значит сообщение и что с ним делать, по имени"))
          ->check([](const std::string& name) {
            return alarm_named(name) != no_alarm ? std::string()
                                                 : told("no finding has this name: ", "нет сообщения с таким именем: ") + name;
          }),
      "ID", "ИМЯ");
  check->callback([programs, explained] {
    if (programs->count() == 0 && explained->count() == 0) throw CLI::RequiredError(programs->get_name());
  });
  check->add_flag("--strict", o.strict, told("warnings count as errors", "считать предупреждения ошибками"));
  check->footer(check_examples());
}

void add_setup(CLI::App& app, Commands& c) {
  CLI::App* const setup = app.add_subcommand("setup", told("write a set-up to be filled in, with what a program uses",
                                                           "записать бланк исходного состояния с тем, что использует УП"));
  program_argument(*setup, c.setup.program);
  program_options(*setup, c.setup.program);
  writes_file(setup->add_option("--out", c.setup.output,
                                told("the new file (default: standard output)", "новый файл (по умолчанию стандартный вывод)")));
  setup->add_flag("--tools", c.setup.tools,
                  told("write a tools file for kadr cut instead, with what comments say of the tools",
                       "записать вместо него файл инструментов для kadr cut с тем, что о них говорят комментарии"));
  setup->footer(setup_examples());
}

}  // namespace kadr::cli
