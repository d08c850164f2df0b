// kadr cut: a program carried out on a blank; what is left, what collides.

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <thread>

#include "cli/cut_body.h"
#include "cli/drive.h"
#include "cli/job.h"
#include "cli/outputs.h"
#include "cli/progress.h"
#include "cli/stop.h"
#include "cli/terminal.h"
#include "config/nearest.h"
#include "config/read_file.h"
#include "config/setup_names.h"
#include "config/told.h"
#include "out/picture/part_page.h"
#include "out/text/alarm_print.h"
#include "out/text/cut_text.h"
#include "out/text/page_file.h"
#include "session/cutting/cutting.h"
#include "stock/mesh/mesh_file.h"
#include "stock/mesh/stl.h"
#include "stock/mesh/threemf.h"
#include "stock/part/part_compare.h"
#include "stock/size.h"
#include "stock/surface/surface.h"

namespace kadr::cli {
namespace {

constexpr double bytes_per_mb = 1 << 20;
constexpr double allowed = 0.01, allowed_of_cell = 0.1;  // a gouge, mm; what a point of the surface may be off: docs/stock.md
constexpr double share_of_cell = 0.02;                   // volume error of the surface for each mm² of it, in cells: docs/stock.md

/// --until: seconds, or a line in `line`.
std::optional<double> seconds_of(const std::string& text, std::string& line) {
  if (text.empty()) return 1e300;
  if (!text.ends_with('s')) {
    const bool is_line = text.find_first_not_of("0123456789") == std::string::npos && text.size() < 10;
    return is_line ? (line = text, std::optional(1e300)) : std::nullopt;
  }
  double seconds = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size() - 1, seconds);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size() - 1 || !(seconds >= 0)) return std::nullopt;
  return seconds;
}

/// The files of the command, none of them opened yet.
Outputs outputs_of(const CutOptions& options, const Job& job) {
  Outputs outputs(language(options.run));
  outputs.reads(job.file);
  outputs.reads(job.setup_file);
  outputs.reads(options.tools);
  if (options.run.control.ends_with(".toml")) outputs.reads(options.run.control);
  if (options.run.machine.ends_with(".toml")) outputs.reads(options.run.machine);
  outputs.writes("--out", options.out);
  outputs.writes("--json", options.json);
  outputs.writes("--plot", options.run.plot);
  for (const std::string& body : options.fixtures) outputs.reads(body);
  outputs.reads(options.stock);
  outputs.reads(options.part);
  return outputs;
}

/// The row of the work system that --stock-zero names; complains.
bool find_system(const CutOptions& options, const Job& job, std::optional<std::uint8_t>& system) {
  if (options.stock_zero.empty()) return true;
  const std::vector<std::string> names = system_names(*job.def);
  const auto found = std::find(names.begin(), names.end(), options.stock_zero);
  if (found == names.end() || found == names.begin())
    return complain(fmt::format("--stock-zero {}: {}", options.stock_zero,
                                told("this control has no such work system", "у этого УЧПУ нет такой системы координат"))),
           false;
  system = std::uint8_t(found - names.begin());
  return true;
}

/// A body of the command line; complains.
std::shared_ptr<const Blank> named_body(const char* option, const std::string& text, double most) {
  const auto named = body_of(text, most);
  if (!named) return complain(fmt::format("{} {}", option, named.error())), nullptr;
  for (const std::string& note : named->notes) say(note + "\n");
  return named->body;
}

/// The part that is wanted, if one is; complains.
bool find_part(const CutOptions& options, std::optional<Mesh>& part) {
  if (options.part.empty()) {
    const char* const lonely = options.allow >= 0 ? "--allow" : options.run.colour == "deviation" ? "--colour deviation" : nullptr;
    if (lonely != nullptr)
      complain(lonely + std::string(told(": of --part FILE, which is missing", ": нужна --part ФАЙЛ, а она не указана")));
    return lonely == nullptr;
  }
  MeshRules rules;
  rules.memory = std::size_t(options.max_memory * bytes_per_mb);
  auto solid = read_mesh_file(options.part, rules);
  if (!solid) return complain("--part " + solid.error()), false;
  for (const std::string& note : solid->notes) say(note + "\n");
  part = std::move(solid->mesh);
  return true;
}

/// Cell and bodies, within the memory that may be taken; complains.
bool find_material(const CutOptions& options, CutJob& job) {
  const double most = options.max_memory * bytes_per_mb;
  job.blank = named_body("--stock", options.stock, most);
  if (!job.blank) return false;
  for (const std::string& text : options.fixtures)
    if (!job.fixtures.emplace_back(named_body("--fixture", text, most))) return false;
  job.cell = options.resolution > 0 ? options.resolution : cell_for(job.blank->box(), most / 2);
  double bytes = bytes_of_bricks(job.blank->box(), job.cell);
  for (const auto& fixture : job.fixtures) bytes += bytes_of_bricks(fixture->box(), job.cell);
  if (bytes <= most) return true;
  complain(fmt::format("{}: {:.0f} MB",
                       told("at this resolution the material may take more than --max-memory",
                            "с таким шагом материал может занять больше, чем --max-memory"),
                       bytes / bytes_per_mb));
  return false;
}

CutJob on_machine(CutJob cut, const MachineProfile& profile, const std::vector<std::string>& axes) {
  cut.machine = std::make_shared<MachineTree>(profile, axes);
  return cut;
}

class CutCommand {
 public:
  CutCommand(const CutOptions& options, const Job& job, Session& session, const CutJob& cut)
      : job_(job),
        lang_(language(options.run)),
        session_(session),
        cutting_(on_machine(cut, job.profile, session.control().axes()),
                 AxisRoles::of(session.control().axes(), session.control().rotary())),
        progress_(options.run.quiet) {
    cutting_.on_finding = [this](const CutFinding& f) { tell(session_.control().report_for(alarm_of(f), f.origin)); };
  }

  void run(Drive& drive, const StopToken& stop) {
    const bool planned = session_.look_ahead().has_value();
    const Channel& own = session_.channels()[session_.own()];
    TimeEstimate clock(AxisRoles::of(own.control->axes(), own.control->rotary()), rates_of(job_.profile, own.setup, own.control->axes()));
    const auto say_it = [this](const AlarmReport& report) { count(report), tell(report); };
    Outlets& outlets = session_.outlets();
    outlets.warning = say_it;
    outlets.alarm = [say_it](const AlarmReport& report) { return say_it(report), false; };
    outlets.onlooker = &progress_;
    outlets.clock = &clock;
    outlets.stop = stop;
    outlets.works_long = true;
    if (planned) outlets.timed = [this](const Step& step, double longer) { consume(step, longer); };
    outlets.step = [this, planned](const Step& step) {
      if (!planned) consume(step, 0);
    };
    session_.change_outlets();
    drive.carry_out(session_);
    if (!interrupted()) cutting_.finish();
  }

  const Stock& stock() const { return cutting_.stock(); }
  CutResult result(double left, double bound) const { return cutting_.result(left, bound); }
  PartResult part_result(const PartComparison& c, double allow) const {
    const auto difference = [&](const PartOffence& o) { return PartDifference{o.volume, o.deepest, o.at, cutting_.line_of(o.sweep)}; };
    return {difference(c.left_on), difference(c.gouged), allow};
  }
  std::size_t alarms() const { return alarms_; }
  std::size_t warnings() const { return warnings_; }

 private:
  /// After the first tool that cannot be cut with nothing more is.
  void consume(const Step& step, double longer) {
    if (failed_) return;
    const Status taken = cutting_.consume(step, longer);
    if (taken) return;
    failed_ = true;
    const AlarmReport report = session_.control().report_for(taken.error(), step.action.origin);
    count(report);
    tell(report);
  }

  void count(const AlarmReport& report) {
    if (report.alarm.severity != Severity::note) ++(report.alarm.severity == Severity::alarm ? alarms_ : warnings_);
  }
  void tell(const AlarmReport& report) { say(alarm_text(report, job_.texts(), lang_, colours())); }

  const Job& job_;
  const Lang lang_;
  Session& session_;
  Cutting cutting_;
  Progress progress_;
  std::size_t alarms_ = 0, warnings_ = 0;
  bool failed_ = false;
};

bool is_3mf(const std::string& name) { return in_small_letters(name).ends_with(".3mf"); }

PartColour colour_of(const std::string& word) {
  return word == "age" ? PartColour::age : word == "deviation" ? PartColour::deviation : PartColour::tool;
}

/// The picture, if one is asked for. Returns an error sentence.
tl::expected<void, std::string> draw(const CutOptions& options, const Job& job, const Outputs& outputs, const Surface& surface,
                                     const CutResult& result, const PartComparison& held, const Stock& stock) {
  if (options.run.plot.empty()) return {};
  const Lang lang = language(options.run);
  PartScene scene{surface, stock.blank().box(), colour_of(options.run.colour), {}, {}, {}};
  if (result.part) scene.deviation = {held.deviation, result.part->allow};
  scene.title = {job.file, lang == Lang::ru ? job.def->name.ru : job.def->name.en, lang, cut_caption(result, lang), {}};
  scene.colours.resize(stock.sweeps());
  for (std::size_t i = 0; i < scene.colours.size(); ++i) scene.colours[i] = std::uint8_t(stock.sweep(i).tool);
  for (std::size_t i = 0; i < stock.tools(); ++i) scene.title.legend.push_back(fmt::format("T{}", stock.tool(i).geometry.number));
  return draw_part_page(*outputs.file("--plot"), scene);
}

bool write_results(const CutOptions& options, const Job& job, Outputs& outputs, const Surface& surface, const CutResult& result,
                   const PartComparison& held, const CutCommand& command) {
  if (std::FILE* const file = outputs.stream("--out"); file != nullptr) {
    const ByteSink sink = [file](std::string_view bytes) { return std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size(); };
    const std::string fault = is_3mf(options.out) ? write_3mf(surface, sink) : write_stl(surface, sink) ? std::string() : told_errno(errno);
    if (!fault.empty()) return complain(options.out + ": " + fault), false;
  }
  if (std::FILE* const file = outputs.stream("--json"); file != nullptr)
    fmt::print(file, "{}", cut_json(result, command.alarms(), command.warnings()));
  if (const auto drawn = draw(options, job, outputs, surface, result, held, command.stock()); !drawn) return complain(drawn.error()), false;
  if (!options.run.quiet && options.json != "-" && options.out != "-") fmt::print("{}", cut_summary(result, language(options.run)));
  return outputs.keep();
}

/// Why a result cannot be written in that form; complains.
bool can_write(const CutOptions& options) {
  if (!options.out.empty() && options.out != "-" && !is_3mf(options.out) && !in_small_letters(options.out).ends_with(".stl"))
    return complain("--out " + options.out + told(": want a file .stl or .3mf", ": нужен файл .stl или .3mf")), false;
  const std::string fault = options.run.plot.empty() ? "" : page_fault(options.run.plot);
  if (!fault.empty()) complain("--plot " + fault);
  return fault.empty();
}

}  // namespace

int cut(const CutOptions& given) {
  CutOptions options = given;
  CutJob cut_job;
  const auto until = seconds_of(options.until, options.run.to);
  if (!until)
    return complain("--until " + options.until + told(": want a line, or seconds as in 35.5s", ": нужна строка или секунды, как 35.5s")),
           wrong_usage;
  cut_job.until = *until;
  std::optional<Mesh> part;
  if (!can_write(options) || !find_part(options, part) || !find_material(options, cut_job)) return wrong_usage;
  auto tools = load_tools(options.tools);
  if (!tools) return complain(tools.error()), wrong_usage;
  for (const std::string& note : tools->notes) say(note + "\n");
  cut_job.tools = std::move(*tools);
  auto job = make_job(options.run, options.run.programs.front());
  if (!job || !find_system(options, *job, cut_job.system)) return wrong_usage;
  cut_job.threads = options.threads > 0 ? options.threads : std::max(1, int(std::thread::hardware_concurrency()));
  cut_job.wants_coolant = options.coolant;
  cut_job.tool = std::uint32_t(std::max(job->setup.tool, 0));
  cut_job.starts_known = job->stated.count("start") != 0;
  for (const auto& [number, offset] : job->setup.offsets)
    if (number > 0 && offset.length != 0) cut_job.lengths[std::uint32_t(number)] = offset.length;
  cut_job.stop = options.run.limits.stop;
  Outputs outputs = outputs_of(options, *job);
  auto program = outputs.check() ? open_program(*job) : std::nullopt;
  const auto drive = program ? drive_of(options.run) : nullptr;
  if (!drive) return wrong_usage;
  const auto session = make_session(*job, std::move(*program), options.run.limits);
  if (!session || !outputs.open()) return wrong_usage;
  const std::unique_ptr<Drive, void (*)(Drive*)> leaves(drive.get(), [](Drive* left) { left->leave(); });
  if (const auto nothing = drive->begin(*session, *job)) return interrupted() ? interrupted_status() : *nothing;
  CutCommand command(options, *job, *session, cut_job);
  command.run(*drive, options.run.limits.stop);
  if (interrupted()) return interrupted_status();
  const Surface surface = surface_of(command.stock());
  CutResult result = command.result(volume_of(surface), share_of_cell * cut_job.cell * area_of(surface));
  PartComparison held;
  if (part) {
    held = compare(command.stock(), surface, *part);
    result.part = command.part_result(held, options.allow >= 0 ? options.allow : allowed + allowed_of_cell * cut_job.cell);
  }
  if (interrupted()) return interrupted_status();
  erase_bar();
  if (!write_results(options, *job, outputs, surface, result, held, command)) return wrong_usage;
  return command.alarms() != 0 || !result.collisions.empty() || (result.part && result.part->is_gouged()) ? alarms : ok;
}

}  // namespace kadr::cli
