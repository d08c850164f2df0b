// Answers the requests about real machines: `ports`, `prove`, `probe`; and connects the machine of `machine` with `port`. Used by
// view/page/page_session and page_panel; tested by tests/panel_drive.py with a double of a Grbl controller.

#include "view/page/page_drive.h"

#include <algorithm>
#include <filesystem>

#include "drive/grbl/grbl_proof.h"
#include "panel/panel_journal.h"
#include "texts/grbl_machine.h"
#include "texts/panel_page.h"
#include "view/page/page_inside.h"

namespace kadr {
namespace {

using drive::ProofRow;
using drive::Verdict;

/// Executes the program as the controller would, and adds what it cannot do to the proof.
tl::expected<void, std::string> prove(const OpenedProgram& opened, const drive::GrblMachine& machine, RealConnection& made, Setup stated,
                                      const StopToken& stop) {
  auto text = opened.program();
  if (!text) return tl::unexpected(text.error());
  SessionSpec spec = opened.spec(std::move(*text), stop);
  constexpr const char* axes[] = {"X", "Y", "Z"};
  const auto at = machine.status().view.machine.value_or(drive::GrblPoint{});
  spec.setup.start_in_work = false;
  for (std::size_t a = 0; a < drive::grbl_axes; ++a) spec.setup.start[axes[a]] = at[a];
  if (!spec.setup.channels.empty()) return tl::unexpected(translated(texts::grbl_machine::one_channel));
  const auto session = Session::open(std::move(spec));
  if (!session) return tl::unexpected(in_thread_language(session.error().fault.en, session.error().fault.ru));
  made.needs = drive::needs_of(**session, machine.settings(), stop);
  made.rows = drive::grbl_proof(machine.settings(), made.needs, stated, false);
  const auto add = [&](std::uint32_t line, std::string why) {
    made.rows.push_back({"program", plain_text(texts::grbl_machine::program), "", translated(texts::grbl_machine::at_line, line),
                         Verdict::refused, std::move(why)});
  };
  if (made.needs.alarm) add(made.needs.alarm->origin.line, finding_of(*made.needs.alarm, *opened.texts, thread_language()).text);
  if (!made.needs.impossible.empty()) add(made.needs.impossible_line, made.needs.impossible);
  return {};
}

const char* name_of(Verdict verdict) { return verdict == Verdict::right ? "equal" : verdict == Verdict::note ? "note" : "refused"; }

PageJson point_json(const drive::GrblPoint& point) { return {{"X", point[0]}, {"Y", point[1]}, {"Z", point[2]}}; }

}  // namespace

std::vector<std::string> RealPorts::now() const {
  std::vector<std::string> all = ports;
  std::error_code none;  // there is no such folder without a serial line
  if (all_found)
    for (const auto& entry : std::filesystem::directory_iterator("/dev/serial/by-id", none)) all.push_back(entry.path().string());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

PageJson proof_json(const RealConnection& made) {
  PageJson rows = PageJson::array();
  for (const ProofRow& row : made.rows)
    rows.push_back({{"id", row.id},
                    {"what", row.what},
                    {"controller", row.controller},
                    {"program", row.program},
                    {"verdict", name_of(row.verdict)},
                    {"why", row.why}});
  const drive::JobNeeds& needs = made.needs;
  PageJson first;
  if (needs.first_target)
    first = {
        {"line", needs.first_line}, {"text", needs.first_text}, {"from", point_json(needs.start)}, {"to", point_json(*needs.first_target)}};
  const drive::GrblStatus status = made.machine->status();
  return {{"rows", std::move(rows)},
          {"lines", needs.lines},
          {"stops", needs.stops},
          {"seconds", needs.seconds},
          {"first", std::move(first)},
          {"controller", status.view.version},
          {"locked", status.view.state == drive::GrblState::alarm}};
}

tl::expected<RealConnection, std::string> connect_machine(const RealPorts& ports, const std::string& port, OpenedProgram& opened,
                                                          const StopToken& stop) {
  const std::vector<std::string> offered = ports.now();
  if (std::find(offered.begin(), offered.end(), port) == offered.end())
    return tl::unexpected(translated(texts::grbl_machine::no_such_port, port));
  auto machine = drive::GrblMachine::connect({port, ports.baud, ports.log}, stop);
  if (!machine) return tl::unexpected(machine.error());
  RealConnection made;
  made.machine = std::move(*machine);
  const Setup stated = opened.setup;
  opened.setup = drive::setup_with_controller(std::move(opened.setup), made.machine->settings(), ports.own(*opened.def));
  if (const auto proven = prove(opened, *made.machine, made, stated, stop); !proven) return tl::unexpected(proven.error());
  return made;
}

std::string refused_row(const RealConnection& made, const std::set<std::string>& accepted) {
  for (const ProofRow& row : made.rows)
    if (row.verdict == Verdict::refused && (!accepted.contains(row.id) || row.id == "program"))
      return translated(texts::grbl_machine::not_proven, row.what, row.why);
  return {};
}

PageSession::Inside::Answer PageSession::Inside::ports(const PageJson&) {
  PageJson list = PageJson::array();
  if (may_change && server.real != nullptr)
    for (const std::string& port : server.real->now()) list.push_back(port);
  return PageJson{{"ports", std::move(list)}};
}

/// Touches with the probe of a real machine.
PageSession::Inside::Answer PageSession::Inside::probe(const PageJson& question) {
  const auto machine = held_machine();
  if (!machine) return tl::unexpected(machine.error());
  const auto touched = (*machine)->probe(value_in<std::string>(question, "axis", ""), value_in<double>(question, "way", 0),
                                         value_in<double>(question, "feed", 0));
  if (!touched) return refused(touched.error());
  return PageJson::object();
}

/// Connects a real machine, compares it with the program, and lets it go. Nothing moves.
PageSession::Inside::Answer PageSession::Inside::prove_machine(const PageJson& question) {
  if (!may_change) return refused(translated(texts::panel_page::may_only_look));
  if (server.real == nullptr) return not_served("prove");
  auto request = opening_request_in(question);
  if (!request) return tl::unexpected(request.error());
  request->text.reset();
  if (server.journal != nullptr)
    request->tables = server.journal->value("tables", value_in<std::string>(question, "file", "")).value_or("");
  auto opened = open_for_page(*request);
  if (!opened) return refused(opened.error());
  const auto made = connect_machine(*server.real, value_in<std::string>(question, "port", ""), *opened, token());
  if (!made) return refused(made.error());
  return proof_json(*made);
}

}  // namespace kadr
