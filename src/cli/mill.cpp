// kadr mill: contour → path, verified → program → read back, verified again → file.

#include "path/area/mill.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "cli/files.h"
#include "cli/mill_options.h"
#include "cli/outputs.h"
#include "cli/progress.h"
#include "cli/stop.h"
#include "cli/terminal.h"
#include "config/contour.h"
#include "config/control_file.h"
#include "out/picture/mill_picture.h"
#include "out/program/part_program.h"
#include "out/text/alarm_print.h"
#include "out/text/page_file.h"
#include "path/area/verify.h"
#include "session/program_moves.h"

namespace kadr::cli {
namespace {

using area::Zone;

/// What is milled: zones, or lines that the tool goes along.
struct Shape {
  std::vector<Zone> zones;
  std::vector<Edges> lines;
};

std::string line_of(std::string_view text, std::uint32_t number) {
  for (; number > 1; --number) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  constexpr std::size_t longest = 200;  // bytes shown
  std::string_view line = text.substr(0, std::min(text.find_first_of("\r\n"), longest));
  std::string utf8;
  return append_utf8(line, Encoding::utf8, utf8) ? utf8 : std::string();
}

class MillCommand {
 public:
  MillCommand(const MillOptions& options, Lang lang, const ControlDef& def, const AlarmTexts& texts)
      : options_(options), lang_(lang), def_(def), texts_(texts), outputs_(lang) {}

  Exit run() {
    outputs_.reads(options_.contour);
    if (options_.control.ends_with(".toml")) outputs_.reads(options_.control);
    outputs_.writes("--output", options_.output.empty() ? "-" : options_.output);
    outputs_.writes("--plot", options_.plot);
    if (!outputs_.check()) return wrong_usage;
    const auto text = read_small(options_.contour, limits::contour_bytes);
    if (!text) return wrong_usage;
    auto job = mill_job(options_);
    if (!job) return say(job.error()), wrong_usage;
    watch(*job);
    const auto shape = shape_of(*text);
    if (!shape) return say(shape.error(), *text), alarms;
    auto path = shape->lines.empty() ? area::verified_path(shape->zones, *job) : along_lines(*shape, *job);
    if (!path) return say(path.error()), alarms;
    const auto program = written(*path, *shape, *job);
    if (!program) return say(program.error()), alarms;
    if (stop_token().asked()) return say(alarm(AlarmId::interrupted, {})), alarms;
    progress_.reset();
    if (!outputs_.open()) return wrong_usage;
    std::fwrite(program->text.data(), 1, program->text.size(), outputs_.stream("--output"));  // keep() tells whether all was written
    if (!options_.plot.empty() && !draw(*path, *shape, *job)) return wrong_usage;
    if (!outputs_.keep()) return wrong_usage;
    warn_of_holes(path->path);
    if (!options_.quiet) print(*path, *shape, *job, *program);
    return ok;
  }

 private:
  bool ru() const { return lang_ == Lang::ru; }
  const char* mm() const { return ru() ? "мм" : "mm"; }

  void watch(area::Job& job) {
    job.watch.stop = stop_token();
    progress_.emplace(options_.quiet);
    job.watch.show = [this](area::Stage stage, double part) {
      constexpr std::pair<const char*, const char*> names[] = {{"passes", "проходы"}, {"path", "траектория"}, {"verification", "проверка"}};
      const auto& [en, russian] = names[static_cast<std::size_t>(stage)];
      if (progress_ && progress_->is_due()) progress_->show(part, ru() ? russian : en);
    };
  }

  /// An alarm of the whole job, not of a line of the drawing.
  void say(const Alarm& alarm) {
    progress_.reset();
    if (alarm.id == AlarmId::interrupted) return complain(ru() ? "прервано: ничего не записано" : "interrupted: nothing is written");
    complain(fmt::format("{}: {}: {}", options_.contour, name_of(alarm.id), texts_.sentence(alarm, lang_)));
    if (const std::string hint = texts_.hint(alarm, lang_); !hint.empty()) kadr::cli::say("  " + hint + "\n");
  }

  void say(const ContourFault& fault, std::string_view text) {
    progress_.reset();
    if (fault.line == 0) return say(fault.alarm);
    AlarmReport report;
    report.alarm = fault.alarm;
    report.file = options_.contour;
    report.origin.line = fault.line;
    report.origin.column = fault.alarm.where.begin + 1;
    report.line_text = line_of(text, fault.line);
    if (fault.alarm.where.end > report.line_text.size()) report.alarm.where = {};
    kadr::cli::say(alarm_text(report, texts_, lang_, colours()));
  }

  tl::expected<Shape, ContourFault> shape_of(std::string_view text) const {
    const auto edges = read_contour(text);
    if (!edges) return tl::unexpected(edges.error());
    auto chains = area::chained(*edges);
    if (!chains) return tl::unexpected(chains.error());
    if (options_.task == "slot" && !chains->open.empty()) {
      const double width = options_.width < 0 ? options_.tool_diameter : options_.width;
      const bool wider = width > options_.tool_diameter;
      return Shape{area::slot_zones(chains->open, width / 2), wider ? std::vector<Edges>() : chains->open};
    }
    auto zones = area::zones_of(*chains);
    if (!zones) return tl::unexpected(zones.error());
    if (options_.task == "face")
      for (Zone& zone : *zones)
        for (Edge& e : zone.loops[0]) e.open = true;
    return Shape{std::move(*zones), {}};
  }

  static Result<area::Verified> along_lines(const Shape& shape, const area::Job& job) {
    auto path = area::slot_path(shape.lines, job);
    if (!path) return fail(path.error());
    const area::Outcome outcome = area::verified(shape.zones, job, path->moves);
    if (outcome.fault) return fail(*outcome.fault);
    return area::Verified{std::move(*path), outcome};
  }

  /// The program, its path read back by the control's interpreter and verified like the first.
  Result<PartProgram> written(const area::Verified& path, const Shape& shape, const area::Job& job) const {
    Technology technology;
    technology.feed = options_.feed;
    technology.plunge_feed = options_.plunge_feed < 0 ? std::max(1.0, std::round(options_.feed / 3)) : options_.plunge_feed;
    technology.speed = options_.speed;
    technology.tool = options_.tool;
    technology.coolant = options_.coolant;
    technology.mark = options_.mark;
    auto program = part_program(def_, path.path.moves, technology);
    if (!program) return program;
    const auto read = program_moves(def_, program->text);
    if (!read) return fail(read.error());
    KADR_TRY(same_moves(program->moves, *read));
    if (const auto outcome = area::verified(shape.zones, job, *read); outcome.fault) return fail(*outcome.fault);
    return program;
  }

  bool draw(const area::Verified& path, const Shape& shape, const area::Job& job) const {
    const std::size_t slash = options_.contour.find_last_of("/\\");
    const std::string title = options_.contour.substr(slash == std::string::npos ? 0 : slash + 1);
    const std::string subtitle =
        fmt::format("{}   Ø{}   {}", scheme_name(job), number_text(2 * job.radius), ru() ? def_.name.ru : def_.name.en);
    const auto drawn = draw_milling(*outputs_.file("--plot"),
                                    {shape.zones, path.path.moves, path.path.holes, job.radius, job.top, title, subtitle, lang_});
    if (!drawn) complain(drawn.error());
    return drawn.has_value();
  }

  std::string scheme_name(const area::Job& job) const {
    return fmt::format("{} {}", russian_name(job.scheme), job.direction == area::Direction::ccw ? "ПЧС" : "ЧС");
  }

  void print(const area::Verified& path, const Shape& shape, const area::Job& job, const PartProgram& program) const {
    std::FILE* const to = options_.output.empty() || options_.output == "-" ? stderr : stdout;
    const area::Outcome& o = path.outcome;
    const auto line = [&](const char* en, const char* russian, const std::string& value) {
      fmt::print(to, "{:<17}{}\n", ru() ? std::string(russian) : std::string(en), value);
    };
    const auto blocks = std::count(program.text.begin(), program.text.end(), '\n');
    line("zone", "зона", zone_text(shape));
    line("scheme", "схема",
         fmt::format("{}, {} {} {} ({} %)", scheme_name(job), ru() ? "шаг" : "step", number_text(path.path.step, 3), mm(),
                     number_text(50 * path.path.step / job.radius, 1)));
    line("path", "траектория",
         fmt::format("{} {}, {} × Z, {}: {}", number_text(o.length, 1), mm(), path.path.layers, ru() ? "подъёмов" : "lifts",
                     path.path.lifts));
    if (std::isfinite(o.nearest_wall))
      line("wall", "стенка",
           fmt::format("{} {} ({} {})", number_text(o.nearest_wall, 3), mm(), ru() ? "нужно" : "wanted", number_text(o.wanted, 3)));
    line("uncut", "не обработано",
         fmt::format("{0} {3}²; {1} {2} {3}²", number_text(o.uncut, 2), ru() ? "недоступно фрезе" : "out of the tool's reach",
                     number_text(o.out_of_reach, 2), mm()));
    line("plunge", "врезание", plunge_text(path.path.plunges, job));
    for (const Vec2 hole : path.path.holes) line("drill before", "засверлить", place(hole));
    if (path.path.step < job.step) line("note", "примечание", ru() ? "шаг уменьшен: острые углы" : "the step was reduced: sharp corners");
    if (path.path.fields > shape.zones.size())
      line("note", "примечание", ru() ? "зона распалась: есть места уже фрезы" : "the zone falls apart: places narrower than the tool");
    line(
        "program", "УП",
        fmt::format("{} {}, {}", blocks, ru() ? "кадров" : "blocks", ru() ? "прочитана обратно: путь тот же" : "read back: the same path"));
  }

  static std::string place(Vec2 p) { return fmt::format("X{} Y{}", number_text(p.x, 3), number_text(p.y, 3)); }

  /// How the tool goes down into material not yet cut. Straight down is told, for not every tool cuts over its centre.
  std::string plunge_text(const area::Plunges& p, const area::Job& job) const {
    std::string text;
    const auto add = [&](std::size_t count, const char* en, const char* russian) {
      if (count > 0) text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", ru() ? russian : en, count);
    };
    add(p.ramps, "ramps to and fro", "спуски вперёд и назад");
    add(p.helices, "ramps round and round", "спуски по замкнутой линии");
    add(p.straight, "straight down into the material (the tool must cut over its centre)",
        "отвесно в материал (фреза должна резать центром)");
    add(p.drilled, "straight down into holes drilled before", "отвесно в засверленные отверстия");
    if (text.empty()) return ru() ? "вне материала" : "beside the material";
    if (p.ramps + p.helices > 0) text += fmt::format("; {}°", number_text(job.ramp_deg, 3));
    return fmt::format("{}: {}", russian_name(job.plunge), text);
  }

  /// Said even to those who asked for no summary: without the hole the tool breaks.
  void warn_of_holes(const area::AreaPath& path) const {
    if (path.plunges.no_room == 0) return;
    std::string holes;
    for (const Vec2 hole : path.holes) holes += (holes.empty() ? "" : "; ") + place(hole);
    complain((ru() ? "спуску нет места, фреза идёт вниз отвесно: засверлить заранее "
                   : "no room for a ramp, the tool goes straight down: drill before ") +
             holes);
  }

  std::string zone_text(const Shape& shape) const {
    std::size_t islands = 0, open = 0, edges = 0;
    for (const Zone& zone : shape.zones) {
      islands += zone.loops.size() - 1;
      for (const Edges& loop : zone.loops)
        for (const Edge& e : loop) ++edges, open += e.open ? 1 : 0;
    }
    const std::string kind = open == 0       ? (ru() ? "закрытая" : "closed")
                             : open == edges ? (ru() ? "открытая" : "open")
                                             : (ru() ? "полуоткрытая" : "half-open");
    return fmt::format("{}; {}: {}", kind, ru() ? "островков" : "islands", islands);
  }

  const MillOptions& options_;
  Lang lang_;
  const ControlDef& def_;
  const AlarmTexts& texts_;
  Outputs outputs_;
  std::optional<Progress> progress_;
};

}  // namespace

int mill(const MillOptions& options) {
  Options shared;
  shared.lang = options.lang;
  auto def = load_control(options.control);
  if (!def) return complain(def.error()), wrong_usage;
  const auto texts = AlarmTexts::load(&*def);
  if (!texts) return complain(texts.error()), wrong_usage;
  if (const std::string fault = options.plot.empty() ? "" : page_fault(options.plot); !fault.empty())
    return complain("--plot " + fault), wrong_usage;
  const int status = MillCommand(options, language(shared), *def, *texts).run();
  return interrupted() ? interrupted_status() : status;
}

}  // namespace kadr::cli
