// Answers the requests `cut`, `part` and `proposals`, about cutting a blank with the open program. Used by view/page/page_session; tested
// by tests/serve.py.

#include <fmt/core.h>

#include "config/setup/setup_blank.h"
#include "config/tools/tool_list.h"
#include "out/program/setup_template.h"
#include "out/text/cut_text.h"
#include "session/cutting/named_body.h"
#include "texts/page.h"
#include "texts/part_run.h"
#include "view/page/page_inside.h"
#include "view/proposals.h"
#include "view/turned_json.h"
#include "view/turned_part.h"

namespace kadr {
namespace {

constexpr std::size_t max_fixtures = 100;
constexpr std::size_t max_tools_files = 32;                        // greatest number of tools files that are read for proposals
constexpr std::uint64_t max_tools_bytes = std::uint64_t{1} << 20;  // greatest size in bytes of a tools file that is read for proposals

/// Returns the description of a solid for body_of(). The name of a mesh file is replaced by the path of this file.
tl::expected<std::string, Refusal> placed_body(const ServedFolder& folder, const std::string& text) {
  if (!names_mesh_file(text)) return text;
  auto path = folder.path_of(text);
  if (!path) return refused(path.error());
  return *path;
}

/// Reads the tools in a request: a list of tools, or the name of a tools file.
tl::expected<ToolLibrary, Refusal> tools_in(const ServedFolder& folder, const PageJson& question) {
  const auto found = question.find("tools");
  if (found != question.end() && found->is_array()) {
    if (found->empty()) return refused(translated(texts::part_run::no_tool_given));
    PageJson list = PageJson::array();
    for (PageJson tool : *found) {
      // The cut takes inserts of the offset table from there.
      if (tool.is_object() && value_in<bool>(tool, "by_offset", false)) continue;
      // These keys are removed, because proposals have them but a tool must not have them.
      if (tool.is_object()) tool.erase("from"), tool.erase("known"), tool.erase("by_offset");
      list.push_back(std::move(tool));
    }
    if (list.empty()) return ToolLibrary();
    auto tools = tools_of_list(dumped(list));
    if (!tools) return refused(tools.error());
    return std::move(*tools);
  }
  if (found == question.end() || !found->is_string()) return refused(translated(texts::part_run::tools_wanted));
  const std::string name = found->get<std::string>();
  const auto path = folder.path_of(name);
  if (!path) return refused(path.error());
  auto tools = load_tools(*path, &folder);
  if (!tools) return refused(tools.error());
  return std::move(*tools);
}

tl::expected<PartRequest, Refusal> part_request(const ServedFolder& folder, const PageJson& question) {
  PartRequest request;
  auto stock = placed_body(folder, value_in<std::string>(question, "stock", ""));
  if (!stock) return tl::unexpected(stock.error());
  request.stock = *stock;
  if (request.stock.empty()) return refused(translated(texts::part_run::blank_missing));
  const auto fixtures = question.find("fixtures");
  if (fixtures != question.end()) {
    if (!fixtures->is_array() || fixtures->size() > max_fixtures) return refused(translated(texts::part_run::too_many_fixtures));
    for (const PageJson& text : *fixtures) {
      if (!text.is_string()) return refused(translated(texts::part_run::fixtures_wanted));
      auto body = placed_body(folder, text.get<std::string>());
      if (!body) return tl::unexpected(body.error());
      request.fixtures.push_back(*body);
      request.fixture_names.push_back(text.get<std::string>());
    }
  }
  const auto resolution = question.find("resolution");
  if (resolution != question.end() && !resolution->is_number()) return refused(translated(texts::part_run::resolution_wanted));
  request.resolution = value_in<double>(question, "resolution", 0);
  if (resolution != question.end() && !(request.resolution > 0)) return refused(translated(texts::part_run::resolution_limits));
  auto tools = tools_in(folder, question);
  if (!tools) return tl::unexpected(tools.error());
  request.tools = std::move(*tools);
  return request;
}

/// Returns a message that lists the tools with which the program cuts but that `tools` does not describe; empty if all tools are described.
std::string missing_tools_message(const ProgramRun& run, const ToolLibrary& tools) {
  std::string missing;
  if (run.opened().def->behaviour.lathe != Lathe::none) return missing;  // the offset table may describe the others
  for (const std::uint32_t number : tools_cutting(run)) {
    if (tools.find(number) != nullptr || (number == 0 && tools.tools.size() == 1)) continue;
    missing += fmt::format("{}T{}", missing.empty() ? "" : ", ", number);
  }
  return missing.empty() ? missing : translated(texts::part_run::tools_without_shape, missing);
}

/// Returns the names of the tools files in the folder of the program, relative to the served folder.
std::vector<std::string> tools_files(const ServedFolder& folder, const std::string& program) {
  const std::size_t slash = program.rfind('/');
  const std::string folder_path = slash == std::string::npos ? "" : program.substr(0, slash);
  std::vector<std::string> names;
  const auto list = folder.list(folder_path);
  if (!list) return names;
  for (const FolderEntry& entry : list->entries)
    if (entry.kind == FolderEntry::Kind::tools && entry.size <= max_tools_bytes && names.size() < max_tools_files)
      names.push_back(folder_path.empty() ? entry.name : folder_path + "/" + entry.name);
  return names;
}

std::vector<KnownTools> known_tools(const ServedFolder& folder, const std::string& program) {
  std::vector<KnownTools> known;
  for (const std::string& name : tools_files(folder, program)) {
    const auto path = folder.path_of(name);
    auto tools = path ? load_tools(*path, &folder) : tl::unexpected(std::string());
    if (tools) known.push_back({name, std::move(*tools)});
  }
  return known;
}

PageJson proposal_json(const ProposedTool& proposed) {
  PageJson json = tool_json(proposed.tool);
  json["from"] = proposed.from;
  json["known"] = proposed.known;
  if (proposed.by_offset) json["by_offset"] = true;
  return json;
}

/// Returns the outlines of proposed turning tools.
std::vector<ShownInsert> inserts_of(const std::vector<ProposedTool>& tools) {
  std::vector<ShownInsert> all;
  for (const ProposedTool& one : tools) {
    if (!one.known || one.tool.kind != ToolKind::turning) continue;
    for (ShownInsert& insert : shown_inserts(one.tool)) all.push_back(std::move(insert));
  }
  return all;
}

}  // namespace

PageSession::Inside::Answer PageSession::Inside::cut(const PageJson& question) {
  part_run.reset();
  auto request = part_request(server.folder, question);
  if (!request) return tl::unexpected(request.error());
  if (const std::string missing = missing_tools_message(*run, request->tools); !missing.empty()) return refused(missing);
  request->zero = run->path().zero();
  auto made = PartRun::make(run->opened(), *request, token());
  if (!made) return refused(made.error());
  part_run = std::move(*made);
  afterwards = [this] { cut_part(); };
  return PageJson::object();
}

void PageSession::Inside::cut_part() {
  PageJson marks = PageJson::array();
  part_run->on_progress = [this](double part) {
    send({{"event", "cutting"}, {"part", part}});
    end_if_memory_is_full();
    if (gone) stops = true;
  };
  cut_hits.clear();
  part_run->on_finding = [&](const CutFinding& f, const AlarmReport& report) {
    cut_hits.push_back({f, report});
    const PageJson reported = problem(report);
    marks.push_back(cut_mark_json(reported, f));
    PageJson event = {{"event", "finding"}};
    event.update(cut_finding_json(reported, f));
    send(event);
    if (gone) stops = true;
  };
  const auto done = part_run->execute();
  PageJson event = {{"event", "cut"}};
  if (done) {
    event.update(cut_json(part_run->result(), part_run->alarms(), part_run->warnings()));
    event["marks"] = std::move(marks);
    event["inserts"] = inserts_json(part_run->inserts());
    event["notes"] = part_run->notes();
  } else {
    event["error"] = {{"text", done.error()}};
    part_run.reset();
  }
  send(event);
}

PageSession::Inside::Answer PageSession::Inside::part(const PageJson& question) {
  if (!part_run) return refused(translated(texts::part_run::nothing_cut));
  const PartThen then = part_run->at(value_in<double>(question, "at", 0));
  gone = !line.frame(part_run->frame_of(then)) || gone;
  PageJson json = {{"stock", then.stock},
                   {"left", then.left},
                   {"triangles", then.surface.triangle_count()},
                   {"seconds", then.seconds},
                   {"cell", then.cell}};
  if (part_run->result().turned) json.update(turned_json(then, part_run->zero().z));
  return json;
}

/// Answers with proposals of a blank and tools. `tools` in the request is a tools file to be used instead of the tools files next to the
/// program.
PageSession::Inside::Answer PageSession::Inside::proposals(const PageJson& question) {
  const Vec3 zero = run->path().zero();
  KnownTools named;
  std::vector<KnownTools> known;
  const KnownTools* file = nullptr;
  if (question.contains("tools")) {
    auto tools = tools_in(server.folder, question);
    if (!tools) return tl::unexpected(tools.error());
    named = {value_in<std::string>(question, "tools", ""), std::move(*tools)};
    file = &named;
  } else {
    known = known_tools(server.folder, server.folder.shown(run->opened().path));
    file = tools_file_for(known, *run);
  }
  const std::vector<ProposedTool> proposed = proposed_tools(*run, file);
  const bool turns = turns_part(*run, guess);
  const BlankHints hints = blank_hints(*run);
  PageJson json = {{"stock", guess.text(zero, turns, radii_of(proposed), hints)}, {"tools", PageJson::array()}};
  if (turns && hints.turned.stated) json["stock_by"] = {{"line", hints.turned.stated->line}, {"text", hints.turned.stated->text}};
  else if (!turns && hints.box) json["stock_by"] = {{"line", hints.box->line}, {"text", hints.box->text}};
  for (const ProposedTool& tool : proposed) json["tools"].push_back(proposal_json(tool));
  json["inserts"] = inserts_json(inserts_of(proposed));
  json["files"] = tools_files(server.folder, server.folder.shown(run->opened().path));
  take_setup_blank(json);
  json["keep"] = kept_tools_file();
  return json;
}

/// Blank and fixtures that the set-up states come before proposals.
void PageSession::Inside::take_setup_blank(PageJson& json) const {
  if (opened_request.setup.empty()) return;
  const std::string file = server.folder.shown(opened_request.setup);
  const auto text = setup_file(file);
  const SetupBlank blank = text ? setup_blank(text->bytes) : SetupBlank();
  if (!blank.fixtures.empty()) json["fixtures"] = blank.fixtures;
  if (blank.stock.empty()) return;
  json["stock"] = blank.stock;
  json["stock_by"] = {{"line", 0}, {"text", file}};
}

/// Returns the name of the tools file that belongs to the program, and the digest of the file if it exists.
PageJson PageSession::Inside::kept_tools_file() const {
  const std::string program = server.folder.shown(run->opened().path);
  const std::size_t slash = program.rfind('/'), dot = program.rfind('.');
  const bool has_ending = dot != std::string::npos && (slash == std::string::npos || dot > slash + 1);
  std::string file = program.substr(0, has_ending ? dot : program.size()) + ".toml";
  const auto path = server.folder.path_of(file);
  if (path && !load_tools(*path, &server.folder)) file = free_name(file, ".toml");
  const auto digest = server.folder.digest(file);
  return {{"file", file}, {"digest", digest ? PageJson(*digest) : PageJson()}};
}

/// Writes the tools of the request into a tools file, in place of the tools that the file has.
PageSession::Inside::Answer PageSession::Inside::keep_tools(const PageJson& question) {
  if (!may_change) return refused(translated(texts::page::may_not_save));
  const std::string file = value_in<std::string>(question, "file", "");
  if (!file.ends_with(".toml")) return refused(translated(texts::part_run::tools_name_wanted));
  if (!question.contains("tools") || !question["tools"].is_array()) return refused(translated(texts::part_run::tools_wanted));
  const auto tools = tools_in(server.folder, question);
  if (!tools) return tl::unexpected(tools.error());
  std::string text;
  for (const ToolGeometry& tool : tools->tools) {
    text += text.empty() ? "[[tool]]\n" : "\n[[tool]]\n";
    const PageJson keys = tool_json(tool);
    for (const auto& [key, value] : keys.items()) text += key + " = " + inline_text(value) + "\n";
  }
  std::optional<FileDigest> replaces;
  if (const auto digest = question.find("digest"); digest != question.end() && digest->is_string()) replaces = digest->get<std::string>();
  const auto saved = server.folder.save(file, text, replaces);
  if (!saved) return tl::unexpected(Refusal{saved.error().text, saved.error().changed});
  opened_names.insert(file);
  return PageJson{{"digest", *saved}};
}

}  // namespace kadr
