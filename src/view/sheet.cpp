// Creates the set-up sheet of a program. Used by view/page/page_sheet, view/report/page_report; tested by tests/view/sheet_test.cpp.

#include "view/sheet.h"

#include <algorithm>
#include <ctime>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "config/setup/setup_names.h"
#include "lang/text/tool_comment.h"
#include "session/used_key.h"
#include "stock/tool/tool_outline.h"
#include "view/page/page_json.h"

namespace kadr {
namespace {

constexpr std::uint32_t head_lines = 200;  // number of lines at the beginning of a program that are searched for notes
constexpr std::size_t max_calls = 12;      // greatest number of listed lines that call a tool
constexpr std::size_t max_stops = 500;     // greatest number of stops on a sheet
constexpr double flutes_by_diameter = 3;   // length of the flutes, in diameters, that is assumed if only the radius is known

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  if (localtime_r(&now, &local) == nullptr) return {};
  char text[16];
  return std::string(text, std::strftime(text, sizeof text, "%Y-%m-%d", &local));
}

/// Returns true for a line that contains only comments, or only comments and the number of a program or a block.
bool is_head(const std::string& line) {
  std::string rest = without_comments(line);
  rest.erase(std::remove_if(rest.begin(), rest.end(), [](unsigned char c) { return c <= ' '; }), rest.end());
  const bool names = !rest.empty() && (rest[0] == 'O' || rest[0] == ':' || rest[0] == 'N' || rest[0] == '%') &&
                     rest.find_first_not_of("0123456789", 1) == std::string::npos;
  return rest.empty() || names;
}

class SheetMaker {
 public:
  SheetMaker(const ProgramRun& run, const SourceText& source, const ToolLibrary* library)
      : run_(run), source_(source), library_(library), inch_(run.statistics().extents().unit() == LengthUnit::inch) {}

  void take_zeros(Sheet& sheet) const {
    const Setup& setup = run_.opened().setup;
    std::set<std::string> listed;
    for (const Use& use : run_.control().use().all()) {
      if (use.kind != UseKind::work_zero) continue;
      const UsedKey used = used_key(use, *run_.opened().def);
      if (!listed.insert(used.word).second) continue;
      Sheet::Zero zero{used.word, {}};
      if (used.key.starts_with("zeros.")) {
        if (const auto row = setup.zeros.find(int(use.number)); row != setup.zeros.end()) zero.values = row->second;
      } else if (const auto row = setup.work_offsets.find(used.word); row != setup.work_offsets.end()) {
        zero.values = row->second;
      }
      sheet.zeros.push_back(std::move(zero));
    }
  }

  void take_tools(Sheet& sheet) const {
    for (const Statistics::ToolUse& use : run_.statistics().tools()) sheet.tools.push_back(tool(use));
  }

  void take_head(Sheet& sheet) const {
    const std::vector<std::string> lines = source_.from(1, head_lines);
    for (std::uint32_t i = 0; i < lines.size() && is_head(lines[i]); ++i)
      for (std::string& comment : comments_of(lines[i])) sheet.comments.push_back({i + 1, std::move(comment)});
  }

  void take_stops(Sheet& sheet) const {
    for (const TimeMark& mark : run_.marks()) {
      if (mark.kind != TimeMark::Kind::stop && mark.kind != TimeMark::Kind::optional_stop) continue;
      if (sheet.stops.size() >= max_stops) break;
      sheet.stops.push_back({mark.line, mark.file == 0 ? comment_on_line(mark.line) : std::string(), mark.at});
    }
  }

 private:
  /// Returns the comment in the line `line`. If this line has no comment, returns the comment in the line before or after it, provided that
  /// the other line contains only comments.
  std::string comment_on_line(std::uint32_t line) const {
    if (line == 0) return {};
    const std::uint32_t first = line > 1 ? line - 1 : 1;
    const std::vector<std::string> lines = source_.from(first, 3);
    const std::size_t here = line - first;
    // For the first line of the program, here − 1 wraps around to a number out of range, so no line before the first is read.
    for (const std::size_t i : {here, here - 1, here + 1}) {
      if (i >= lines.size()) continue;
      if (i != here && !without_comments(lines[i]).empty()) continue;
      const std::vector<std::string> comments = comments_of(lines[i]);
      if (!comments.empty()) return comments.front();
    }
    return {};
  }

  /// Returns a comment at the beginning of the program that names the tool, else the comment at the block that calls the tool.
  std::string comment_of(std::uint32_t tool, std::uint32_t called_at) const {
    for (const std::string& line : source_.from(1, head_lines))
      for (const std::string& comment : comments_of(line))
        if (read_tool_comment(comment, inch_).tool == tool) return comment;
    const std::string comment = comment_on_line(called_at);
    const auto named = read_tool_comment(comment, inch_).tool;
    return !named || *named == tool ? comment : std::string();
  }

  const ToolOffset* offset(std::uint32_t number) const {
    const auto& all = run_.opened().setup.offsets;
    const auto found = all.find(int(number));
    return found == all.end() ? nullptr : &found->second;
  }

  /// Lists the other tools that use the same offset, because an edit of the offset for one tool changes it for all these tools.
  void take_shared(Sheet::Tool& tool, const Use& by, const std::string& word) const {
    std::set<std::uint32_t> others;
    for (const Use& use : run_.control().use().all())
      if ((use.kind == UseKind::length || use.kind == UseKind::radius) && use.number == by.number && use.tool != by.tool &&
          used_key(use, *run_.opened().def).word == word)
        others.insert(use.tool);
    if (!others.empty()) tool.shared.push_back({word, {others.begin(), others.end()}});
  }

  void take_offsets(Sheet::Tool& tool) const {
    std::set<std::string> listed;
    for (const Use& use : run_.control().use().all()) {
      if (use.tool != tool.number || (use.kind != UseKind::length && use.kind != UseKind::radius)) continue;
      const std::string word = used_key(use, *run_.opened().def).word;
      if (listed.insert(word).second) {
        tool.corrector += (tool.corrector.empty() ? "" : " ") + word;
        take_shared(tool, use, word);
      }
      const ToolOffset* const row = offset(use.number);
      if (row == nullptr) continue;
      if (use.kind == UseKind::length) tool.length = row->whole_length();
      else if (row->whole_radius() != 0) tool.radius = row->whole_radius();
    }
  }

  /// Returns the shape of a tool as its comment describes it; dimensions that the comment does not state are missing.
  static ToolGeometry geometry_by(const ToolComment& tool_data, const Sheet::Tool& tool) {
    ToolGeometry g;
    g.number = tool.number;
    g.diameter = tool_data.diameter.value_or(tool.radius.value_or(0) * 2);
    g.flutes = g.diameter * flutes_by_diameter;
    g.corner = tool_data.corner.value_or(0);
    g.angle = tool_data.angle.value_or(tool_data.kind == ToolWord::drill ? 118 : tool_data.kind == ToolWord::chamfer ? 90 : 0);
    g.kind = tool_data.kind == ToolWord::ball      ? ToolKind::ball
             : tool_data.kind == ToolWord::drill   ? ToolKind::drill
             : tool_data.kind == ToolWord::chamfer ? ToolKind::chamfer
             : g.corner > 0                        ? ToolKind::bull
                                                   : ToolKind::flat;
    return g;
  }

  void take_shape(Sheet::Tool& tool) const {
    const ToolComment tool_data = read_tool_comment(tool.comment, inch_);
    if (const ToolGeometry* const known = library_ == nullptr ? nullptr : library_->find(tool.number); known != nullptr) {
      tool.name = known->name;
      tool.outline = outline_of(*known);
      if (!tool.radius && known->diameter > 0) tool.radius = known->diameter / 2;
      return;
    }
    tool.outline = outline_of(geometry_by(tool_data, tool));
    if (!tool.radius && tool_data.diameter) tool.radius = *tool_data.diameter / 2;
  }

  Sheet::Tool tool(const Statistics::ToolUse& use) const {
    Sheet::Tool tool;
    tool.number = use.tool;
    tool.seconds = use.cutting_s;
    const std::string name = "T" + std::to_string(use.tool);
    for (const TimeMark& mark : run_.marks())
      if (mark.kind == TimeMark::Kind::tool && mark.file == 0 && mark.text == name && tool.lines.size() < max_calls &&
          std::find(tool.lines.begin(), tool.lines.end(), mark.line) == tool.lines.end())
        tool.lines.push_back(mark.line);
    tool.comment = comment_of(use.tool, tool.lines.empty() ? 0 : tool.lines.front());
    take_offsets(tool);
    take_shape(tool);
    return tool;
  }

  const ProgramRun& run_;
  const SourceText& source_;
  const ToolLibrary* library_;
  const bool inch_;
};

PageJson number(const std::optional<double>& value) { return value ? PageJson(*value) : PageJson(); }

PageJson tool_json(const Sheet::Tool& t) {
  PageJson outline = PageJson::array();
  for (const ProfilePoint& p : t.outline) outline.push_back({p.diameter, p.height});
  PageJson shared = PageJson::array();
  for (const Sheet::Tool::Shared& one : t.shared) shared.push_back({{"word", one.word}, {"tools", one.tools}});
  return {{"number", t.number},         {"name", t.name},
          {"radius", number(t.radius)}, {"length", number(t.length)},
          {"corrector", t.corrector},   {"seconds", t.seconds},
          {"lines", t.lines},           {"outline", std::move(outline)},
          {"comment", t.comment},       {"shared", std::move(shared)}};
}

}  // namespace

Sheet sheet_of(const ProgramRun& run, const SourceText& source, const std::string& program, Lang lang, const ToolLibrary* library) {
  const OpenedProgram& opened = run.opened();
  Sheet sheet;
  sheet.program = program;
  sheet.control = lang == Lang::ru ? opened.def->name.ru : opened.def->name.en;
  sheet.machine = opened.machine.id;
  sheet.date = today();
  sheet.seconds = run.seconds();
  const SheetMaker maker(run, source, library);
  maker.take_zeros(sheet);
  maker.take_tools(sheet);
  maker.take_head(sheet);
  maker.take_stops(sheet);
  return sheet;
}

PageJson sheet_json(const Sheet& s, const Statistics& statistics) {
  PageJson zeros = PageJson::array(), tools = PageJson::array(), comments = PageJson::array(), stops = PageJson::array();
  for (const Sheet::Zero& z : s.zeros) zeros.push_back({{"name", z.name}, {"values", z.values}});
  for (const Sheet::Tool& t : s.tools) tools.push_back(tool_json(t));
  for (const Sheet::Note& n : s.comments) comments.push_back({{"line", n.line}, {"text", n.text}});
  for (const Sheet::Stop& p : s.stops) stops.push_back({{"line", p.line}, {"text", p.text}, {"at", p.at}});
  return {{"program", s.program},      {"control", s.control},
          {"machine", s.machine},      {"date", s.date},
          {"zeros", std::move(zeros)}, {"diameters", statistics.extents().x_is_diameter() ? PageJson::array({"X"}) : PageJson::array()},
          {"tools", std::move(tools)}, {"extents", extents_json(statistics)},
          {"seconds", s.seconds},      {"comments", std::move(comments)},
          {"stops", std::move(stops)}};
}

}  // namespace kadr
