// Answers the requests `open`, `source`, `state` and `passes`, about the open program. Used by view/page/page_session; tested by
// tests/serve.py.

#include <fmt/core.h>

#include "texts/page.h"
#include "view/page/page_inside.h"

namespace kadr {
namespace {

// Greatest size in bytes of a program that the page can edit; a longer program can only be viewed.
constexpr std::uint64_t max_text = std::uint64_t{8} << 20;
constexpr std::uint32_t max_lines = 5000;
constexpr std::size_t max_passes = 1000;

}  // namespace

std::string PageSession::Inside::place_of(const PageJson& question, const char* key, std::string& to, bool may_be_a_name) const {
  const std::string name = value_in<std::string>(question, key, "");
  if (name.empty() || (may_be_a_name && !name.ends_with(".toml") && name.find('/') == std::string::npos)) {
    to = name;
    return {};
  }
  const auto path = server.folder.path_of(name);
  if (!path) return path.error();
  to = *path;
  return {};
}

/// Returns the request, with the paths of the files that it names. The files must be in the served folder; a control or machine may also be
/// built-in.
tl::expected<OpeningRequest, Refusal> PageSession::Inside::opening_request_in(const PageJson& question) const {
  OpeningRequest request;
  request.lang = lang;
  request.door = &server.folder;
  request.encoding = value_in<std::string>(question, "encoding", "");
  for (const std::string& fault : {place_of(question, "file", request.path, false), place_of(question, "control", request.control, true),
                                   place_of(question, "machine", request.machine, true), place_of(question, "setup", request.setup, false)})
    if (!fault.empty()) return tl::unexpected(Refusal{fault});
  if (request.path.empty()) return tl::unexpected(Refusal{translated(texts::page::no_file_named)});
  if (question.contains("text") && question["text"].is_string()) request.text = question["text"].get<std::string>();
  if (const auto tables = question.find("tables"); tables != question.end() && tables->is_object() && !tables->empty())
    request.tables = dumped(*tables);
  return request;
}

PageSession::Inside::Answer PageSession::Inside::open(const PageJson& question) {
  const auto request = opening_request_in(question);
  if (!request) return tl::unexpected(request.error());
  const std::string file = value_in<std::string>(question, "file", "");
  const auto digest = server.folder.digest(file);
  if (!digest) return tl::unexpected(Refusal{digest.error()});
  auto opened = open_for_page(*request);
  if (!opened) return tl::unexpected(Refusal{opened.error()});
  part_run.reset(), called_sources.clear(), instants.reset(), run.reset(), source.reset();
  guess = {};
  auto made = ProgramRun::make(*opened, token());
  if (!made) return tl::unexpected(Refusal{made.error()});
  run = std::move(*made);
  source = std::make_unique<SourceText>(opened->text ? OpenedText{text_source(*opened->text), Encoding::utf8}
                                                     : open_text(request->path, opened->encoding, &server.folder));
  opened_names.insert(file);
  opened_request = *request;
  if (server.last != nullptr) server.last->set(file);
  const bool whole = source->bytes() <= max_text;
  PageJson control = {{"id", opened->def->id},
                      {"name", lang == Lang::ru ? opened->def->name.ru : opened->def->name.en},
                      {"guessed", opened->guess.has_value()},
                      {"lathe", opened->def->behaviour.lathe != Lathe::none}};
  control["decisive"] = !opened->guess || opened->guess->decisive;
  control["why"] = !opened->guess ? std::string() : lang == Lang::ru ? opened->guess->reason_ru : opened->guess->reason_en;
  PageJson json = {{"file", file},
                   {"size", source->bytes()},
                   {"digest", *digest},
                   {"encoding", name_of(source->encoding())},
                   {"control", std::move(control)},
                   {"machine", opened->machine.id},
                   {"setup", value_in<std::string>(question, "setup", "")},
                   {"editable", whole && may_change.load() && source->encoding() == Encoding::utf8},
                   {"lines", source->lines()},
                   {"bounds", bounds_json(machine_bounds(*opened, run->control()))}};
  if (whole) json["text"] = source->whole();
  afterwards = [this] { execute(); };
  return json;
}

void PageSession::Inside::send(const ViewPiece& piece, std::uint32_t which, std::uint32_t channel) {
  if (gone) return;
  gone = !line.frame(path_frame(piece, which, channel)) ||
         (!piece.directions.empty() && !line.frame(directions_frame(piece, which, channel))) ||
         (!piece.positions.empty() && !line.frame(positions_frame(piece, which, channel)));
  if (gone) stops = true;
}

/// Converts a finding about another channel to JSON. The line of the finding is in the program of that channel, so the text contains this
/// line.
PageJson PageSession::Inside::problem_of_channel(const AlarmReport& report, int channel) const {
  const Finding finding = finding_of(report, *run->opened().texts, lang);
  PageJson json = problem_json(finding, 0, std::nullopt);
  json["channel"] = channel;
  json["line"] = 0;
  json["text"] = translated(texts::page::alarm_of_channel, channel, server.folder.shown(finding.file), finding.line, finding.text);
  return json;
}

void PageSession::Inside::execute() {
  run->on_piece = [this](const ViewPiece& piece, std::uint32_t channel) {
    if (channel == 0) guess.take(piece);
    send(piece, 0, channel);
  };
  run->on_contour = [this](const ViewPiece& piece) { send(piece, 2, 0); };
  run->on_alarm = [this](const AlarmReport& report, double at, int channel) {
    PageJson shown_problem = channel == 0 ? problem(report) : problem_of_channel(report, channel);
    send({{"event", "alarm"}, {"at", at}, {"problem", std::move(shown_problem)}});
  };
  run->on_progress = [this](double part, std::uint64_t blocks, double seconds) {
    send({{"event", "progress"}, {"part", part}, {"blocks", blocks}, {"seconds", seconds}});
    end_if_memory_is_full();
    if (gone) stops = true;
  };
  run->execute();
  PageJson done = {{"event", "done"}};
  done.update(done_json(*run, lang));
  send(done);
}

/// Answers with lines of the program, or of a called file. The first request for a called file finds where the lines of this file begin.
PageSession::Inside::Answer PageSession::Inside::source_lines(const PageJson& question) {
  const std::uint32_t from = count_in(question, "from", 1), count = std::min(count_in(question, "count", max_lines), max_lines);
  const std::uint32_t file = count_in(question, "file", 0);
  if (file == 0) return PageJson{{"lines", source->from(from, count)}, {"count", source->lines()}};
  auto called = called_sources.find(file);
  if (called == called_sources.end()) {
    auto bytes = run->control().source_of(file);
    if (!bytes) return tl::unexpected(Refusal{translated(texts::page::no_such_file)});
    called = called_sources.emplace(file, std::make_unique<SourceText>(std::move(bytes), std::nullopt)).first;
  }
  const std::string name = server.folder.shown(run->control().file_name(std::uint16_t(file)));
  return PageJson{{"lines", called->second->from(from, count)}, {"count", called->second->lines()}, {"name", name}};
}

PageSession::Inside::Answer PageSession::Inside::state(const PageJson& question) {
  if (!instants) instants = std::make_unique<Instants>(*run);
  const bool by_number = question.contains("number");
  const auto state =
      by_number ? instants->after(count_in(question, "number", 1), token()) : instants->at(value_in<double>(question, "at", 0), token());
  if (!state) return tl::unexpected(Refusal{state.error()});
  PageJson json = state_json(*state, *run);
  json["file_name"] = server.folder.shown(state->line.file);
  show_files(json["calls"]);
  return json;
}

PageSession::Inside::Answer PageSession::Inside::passes(const PageJson& question) {
  if (!instants) instants = std::make_unique<Instants>(*run);
  std::size_t count = 0;
  PageJson list = PageJson::array();
  for (const Instants::Pass& pass :
       instants->passes(count_in(question, "line", 0), std::uint16_t(count_in(question, "file", 0)), max_passes, count))
    list.push_back({{"from", pass.from}, {"to", pass.to}, {"number", pass.number}});
  return PageJson{{"passes", std::move(list)}, {"count", count}};
}

}  // namespace kadr
