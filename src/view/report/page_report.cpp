// Creates the HTML report of a program from the results of the run (as JSON), the path and the stock. Used by cli/report_run; tested by
// tests/view/report_test.cpp, tests/report.py.

#include "view/report/page_report.h"

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

#include "config/json_text.h"
#include "out/text/alarm_print.h"
#include "out/text/base64.h"
#include "out/text/cut_text.h"
#include "view/machine_bounds.h"
#include "view/page/page_json.h"
#include "view/report/packed_columns.h"
#include "view/report/report_path.h"

namespace kadr {
namespace {

constexpr double max_file = 5e6;  // greatest size of a report in bytes, for a program of at most `blocks_of_most_file` blocks
constexpr double blocks_of_most_file = 1e5;
constexpr double longest_file = 60e6;  // greatest size of a report in bytes, for any number of blocks
// Compressed size in bytes that the path may have even if the program's text alone exceeds the limit.
constexpr double least_path = 2.5e5;
constexpr std::size_t max_alarms = 2000;      // greatest number of alarms in a report, which is more than anybody reads
constexpr std::size_t most_called = 1 << 20;  // greatest size in bytes of the texts of all called files together
// Greatest size in bytes of the program's text in a report; of a longer program, only the beginning is included.
constexpr std::uint64_t max_source = 64 << 20;
constexpr std::uint32_t piece_of_part = 3;  // number that marks the data of the stock in the data of the report
constexpr double base64_by_bytes = 4.0 / 3;

PageJson control_json(const OpenedProgram& o, Lang lang) {
  const bool ru = lang == Lang::ru;
  return {{"id", o.def->id},
          {"name", ru ? o.def->name.ru : o.def->name.en},
          {"guessed", o.guess.has_value()},
          {"lathe", o.def->behaviour.lathe != Lathe::none},
          {"decisive", !o.guess || o.guess->decisive},
          {"why", !o.guess ? std::string()
                  : ru     ? o.guess->reason_ru
                           : o.guess->reason_en}};
}

PageJson opened_json(const ReportContent& c, Lang lang) {
  const OpenedProgram& opened = c.run.opened();
  return {{"file", c.file},
          {"size", c.source.bytes()},
          {"digest", ""},
          {"encoding", name_of(c.source.encoding())},
          {"control", control_json(opened, lang)},
          {"machine", opened.machine.id},
          {"setup", ""},
          {"editable", false},
          {"lines", c.source.lines()},
          {"bounds", bounds_json(machine_bounds(opened, c.run.control()))}};
}

PageJson problem_of(const ReportAlarm& alarm, const AlarmTexts& texts, Lang lang) {
  PageJson json = problem_json(finding_of(alarm.report, texts, lang), alarm.report.origin.file, std::nullopt);
  json["at"] = alarm.at;
  return json;
}

/// Returns the results of the run with texts in the language `lang`. The run has its texts in only one language; for the other language,
/// the texts of the alarms are created again.
PageJson done_in(const ReportContent& c, Lang lang) {
  PageJson done = done_json(c.run, lang);
  auto alarm = c.alarms.begin();
  for (PageJson& mark : done["marks"]) {
    if (mark["kind"] != "alarm" && mark["kind"] != "warning") continue;
    if (alarm == c.alarms.end()) break;
    mark["text"] = sentence_of(alarm->report, *c.run.opened().texts, lang);
    ++alarm;
  }
  return done;
}

PageJson finding_json(const ReportPart::Hit& hit, const AlarmTexts& texts, Lang lang) {
  return cut_finding_json(problem_json(finding_of(hit.report, texts, lang), hit.report.origin.file, std::nullopt), hit.finding);
}

/// Returns the result of the cut as JSON, including the findings as marks on the time line.
PageJson cut_json_of(const ReportPart& part, const AlarmTexts& texts, Lang lang) {
  PageJson json = ordered_json_of(part.result);
  if (!json.is_object()) return PageJson();
  PageJson marks = PageJson::array();
  for (const ReportPart::Hit& hit : part.hits) marks.push_back(cut_mark_json(finding_json(hit, texts, lang), hit.finding));
  json["marks"] = std::move(marks);
  return json;
}

PageJson texts_in(const ReportContent& c, Lang lang) {
  PageJson problems = PageJson::array(), findings = PageJson::array();
  for (std::size_t i = 0; i < std::min(c.alarms.size(), max_alarms); ++i)
    problems.push_back(problem_of(c.alarms[i], *c.run.opened().texts, lang));
  if (c.part != nullptr)
    for (const ReportPart::Hit& hit : c.part->hits) findings.push_back(finding_json(hit, *c.run.opened().texts, lang));
  return {{"opened", opened_json(c, lang)},  {"done", done_in(c, lang)},
          {"problems", std::move(problems)}, {"sheet", sheet_json(sheet_of(c.run, c.source, c.file, lang, c.tools), c.run.statistics())},
          {"findings", std::move(findings)}, {"cut", c.part != nullptr ? cut_json_of(*c.part, *c.run.opened().texts, lang) : PageJson()}};
}

std::string text_of(const SourceText& source) {
  if (source.bytes() <= max_source) return source.whole();
  std::string text;
  const double share = double(max_source) / double(source.bytes());
  for (const std::string& line : source.from(1, std::uint32_t(share * source.lines()))) text += line + '\n';
  return text;
}

/// Returns the texts of the program and of the files that it has called. If the called files together are too long, the last files are
/// omitted.
PageJson sources_json(const ReportContent& c) {
  PageJson list = PageJson::array({{{"file", 0}, {"name", c.file}, {"text", text_of(c.source)}}});
  std::size_t bytes = 0;
  const Control& control = c.run.control();
  for (const std::uint16_t file : control.called_files()) {
    const std::string& name = control.file_name(file);
    OpenedText text = open_text(name);
    if (!text.source) continue;
    const SourceText called(std::move(text));
    bytes += called.bytes();
    if (bytes > most_called) break;
    list.push_back({{"file", file}, {"name", name.substr(name.rfind('/') + 1)}, {"text", called.whole()}});
  }
  return list;
}

/// Reads a value of the type T from a binary frame, at the byte offset `at`.
template <class T>
T value_at(const std::string& frame, std::size_t at) {
  T value{};
  std::memcpy(&value, frame.data() + at, sizeof value);
  return value;
}

/// Packs column by column the numbers of a frame of kind 3, which contains the surface of the stock.
std::string part_bytes(const std::string& frame, const ReportQuanta& quanta) {
  constexpr std::size_t head = 16, point = 12, triangle = 12, made_by = 4;
  const std::size_t points = value_at<std::uint32_t>(frame, 8), triangles = value_at<std::uint32_t>(frame, 12);
  PackedColumns to;
  to.put_u32(std::uint32_t(points));
  to.put_u32(std::uint32_t(triangles));
  std::vector<std::int32_t> column;
  const auto put = [&](std::size_t count, const auto& value) {
    column.clear();
    for (std::size_t i = 0; i < count; ++i) column.push_back(value(i));
    to.put(column);
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    put(points, [&](std::size_t i) { return in_steps(double(value_at<float>(frame, head + point * i + 4 * axis)), quanta.length); });
  const std::size_t corners = head + point * points, tools = corners + triangle * triangles, lines = tools + made_by * points;
  put(3 * triangles, [&](std::size_t i) { return std::int32_t(value_at<std::uint32_t>(frame, corners + 4 * i)); });
  put(points, [&](std::size_t i) { return std::int32_t(value_at<std::uint16_t>(frame, tools + made_by * i)); });
  put(points, [&](std::size_t i) { return std::int32_t(value_at<std::uint32_t>(frame, lines + 4 * i)); });
  PackedColumns before;
  before.put_u32(piece_of_part);
  before.put_u32(std::uint32_t(to.bytes().size()));
  return before.bytes() + to.bytes();
}

double max_bytes(const ProgramRun& run) {
  return std::min(longest_file, max_file * std::max(1.0, double(run.blocks()) / blocks_of_most_file));
}

PageJson part_head(const ReportPart& part) {
  PageJson json = {{"cell", part.cell}, {"off", part.off}};
  if (const PageJson turned = ordered_json_of(part.turned); turned.is_object()) json.update(turned);
  return json;
}

PageJson head_json(const ReportContent& c, const ReportQuanta& q) {
  PageJson json = {{"version", c.version}, {"file", c.file}, {"language", c.lang == Lang::ru ? "ru" : "en"}};
  json["quanta"] = {{"length", q.length}, {"time", q.time}, {"feed", q.feed}, {"direction", q.direction}, {"position", q.position}};
  json["en"] = texts_in(c, Lang::en);
  json["ru"] = texts_in(c, Lang::ru);
  json["made"] = json["en"]["sheet"]["date"];
  json["part"] = c.part != nullptr ? part_head(*c.part) : PageJson();
  json["licences"] = c.licences;
  json["sources"] = sources_json(c);
  return json;
}

}  // namespace

tl::expected<std::string, std::string> report_html(std::string_view viewer, const ReportContent& c) {
  const std::size_t place = viewer.find(report_data_marker);
  if (place == std::string_view::npos) return tl::unexpected(std::string("report.html: ") + std::string(report_data_marker));
  const std::vector<DrawnPiece> pieces = drawn_pieces(c.run.path(), c.contour);
  const ReportQuanta quanta = quanta_of(pieces);
  PageJson json = head_json(c, quanta);
  const std::string part = c.part != nullptr ? part_bytes(c.part->frame, quanta) : std::string();
  const auto packed_rest = zlib_packed(dumped(json) + part);
  if (!packed_rest) return tl::unexpected(packed_rest.error());
  const double left = (max_bytes(c.run) - double(viewer.size())) / base64_by_bytes - double(packed_rest->size());
  auto path = report_path(pieces, quanta, std::max(left, least_path));
  if (!path) return tl::unexpected(path.error());
  json["thinned"] = path->thinning.off();
  const std::string text = dumped(json);
  PackedColumns length;
  length.put_u32(std::uint32_t(text.size()));
  const auto packed = zlib_packed(length.bytes() + text + part + path->bytes);
  if (!packed) return tl::unexpected(packed.error());
  std::string html(viewer.substr(0, place));
  html += base64_of(*packed);
  html += viewer.substr(place + report_data_marker.size());
  return html;
}

}  // namespace kadr
