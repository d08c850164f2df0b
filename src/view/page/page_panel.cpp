// Answers the requests about a machine at its operator panel: `machines`, `machine`, `panel`, `press`, `switches`, `enter`, `undo`, `jog`,
// `jogging`, `stops`. Used by view/page/page_session; tested by tests/panel.py.

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "config/json_text.h"
#include "panel/grbl_axes.h"
#include "texts/panel_page.h"
#include "view/page/page_drive.h"
#include "view/page/page_inside.h"
#include "view/panel_content.h"
#include "view/panel_json.h"
#include "view/served_folder.h"

namespace kadr {
namespace {

constexpr std::size_t max_expression = 200, most_watched = 50;
// Greatest size in bytes of a program that is stored in memory; longer programs cannot be edited on the page.
constexpr std::size_t max_held = std::size_t{8} << 20;

PageAnswer answer_of(const PanelMachine::Answer& answer) {
  if (!answer) return refused(answer.error());
  if (*answer == PanelMachine::Outcome::queued) return PageJson{{"queued", true}};
  return PageJson::object();
}

bool is_true(const PageJson& question, const char* key) {
  const auto found = question.find(key);
  return found != question.end() && found->is_boolean() && found->get<bool>();
}

/// Returns the functions that save the events of a machine in the journal. When a line of the operator changes tables, these functions also
/// add the change to the tables of the machine's program.
PanelRecorder keeper_of(PanelJournal& journal, const std::string& name, PanelProgram& program, Lang lang) {
  PanelRecorder keeper;
  const std::shared_ptr<const AlarmTexts> texts = program.opened().texts;
  keeper.spot = [&journal, name](const PanelLocation& spot) {
    const auto saved = journal.keep("spot", name, spot_text(spot));
    return saved ? std::string() : saved.error();
  };
  keeper.event = [&journal, name](const char* kind, const std::string& text, std::uint32_t line) {
    // A failure to save this entry is not reported here, because it is reported when the location of the machine is saved.
    (void)journal.log(name, log_entry(kind, text, line));
  };
  keeper.tables = [&journal, &program, name](const Setup& before, const Setup& after) {
    const auto patch = program.take_by_hand(before, after);
    if (!patch) return patch.error();
    const auto saved = journal.keep("tables", name, dumped(program.edited()));
    (void)journal.log(name, log_entry("edit", dumped(*patch), 0));
    return saved ? std::string() : saved.error();
  };
  keeper.alarm = [&journal, name, texts, lang](const AlarmReport& report) {
    const Finding finding = finding_of(report, *texts, lang);
    (void)journal.log(name, log_entry("alarm", finding.text, finding.line));
  };
  return keeper;
}

/// Reads the program file when a machine starts, and stores the text in `program`.
void hold_text(const ServedFolder& folder, const std::string& file, PanelProgram& program) {
  if (auto text = folder.read(file, max_held))
    return program.take_text(std::make_shared<const std::string>(std::move(text->bytes)), std::move(text->digest));
  program.take_text(nullptr, folder.digest(file).value_or(""));
}

/// Returns, as text for the journal, the part of the request that describes how the machine is switched on.
std::string machine_text(const PageJson& question) {
  PageJson saved = PageJson::object();
  for (const char* const key : {"file", "control", "machine", "setup", "encoding"})
    if (question.contains(key)) saved[key] = question[key];
  return dumped(saved);
}

/// Returns the saved location of a machine in its program as JSON, without the axis positions (the value of the key "stands").
PageJson spot_json(const std::string& text) {
  PageJson spot = ordered_json_of(text);
  if (spot.is_object()) spot.erase("stands");
  return spot;
}

/// Edits of the tables keep what the set-up does not state and the controller has.
void fill_tables(PanelProgram& program, const drive::GrblMachine& machine, const RealPorts& ports) {
  program.complete_with([settings = machine.settings(), own = ports.own(*program.opened().def)](Setup setup) {
    return drive::setup_with_controller(std::move(setup), settings, own);
  });
}

Axes position_of(const drive::GrblMachine& machine) {
  Axes axes{};
  const auto at = machine.status().view.machine.value_or(drive::GrblPoint{});
  std::copy(at.begin(), at.end(), axes.begin());
  return axes;
}

/// Returns the maker of the axes of a real machine; an empty one if `machine` is nullptr.
AxesMaker axes_of(const std::shared_ptr<drive::GrblMachine>& machine) {
  if (!machine) return {};
  return [machine](int, std::vector<std::string> names, const AxisRoles& roles, const Axes&) {
    return std::make_unique<GrblAxes>(machine, std::move(names), roles);
  };
}

}  // namespace

PageSession::Inside::Answer PageSession::Inside::machines(const PageJson&) {
  PageJson list = PageJson::array();
  std::set<std::string> on;
  for (const auto& place : server.hub != nullptr ? server.hub->all() : std::vector<std::shared_ptr<PanelHub::HubMachine>>()) {
    on.insert(place->name);
    list.push_back({{"name", place->name}, {"mode", name_of(place->machine->state().mode)}, {"held", place->holder != 0}});
  }
  if (server.journal != nullptr)
    for (const std::string& name : server.journal->machines())
      if (!on.contains(name)) list.push_back({{"name", name}, {"mode", "kept"}, {"held", false}});
  return PageJson{{"machines", std::move(list)}};
}

/// Connects the real machine that the request names, and checks that each refused row of the proof is accepted. Without a name there is no
/// real machine.
tl::expected<RealConnection, Refusal> PageSession::Inside::connect_for(const PageJson& question, OpenedProgram& opened) const {
  const auto port = value_in<std::string>(question, "port", "");
  if (port.empty()) return RealConnection{};
  if (server.real == nullptr) return tl::unexpected(not_served("port").error());
  auto made = connect_machine(*server.real, port, opened, token());
  if (!made) return refused(made.error());
  std::set<std::string> accepted;
  if (const auto list = question.find("accept"); list != question.end() && list->is_array())
    for (const PageJson& row : *list)
      if (row.is_string()) accepted.insert(row.get<std::string>());
  if (const std::string row = refused_row(*made, accepted); !row.empty()) return refused(row);
  return std::move(*made);
}

/// Returns whether the machine of a program is on.
bool PageSession::Inside::is_machine_on(const std::string& file) const { return server.hub != nullptr && server.hub->find(file); }

/// Switches on a machine, with its edited tables and with the axes at their last positions.
tl::expected<std::shared_ptr<PanelHub::HubMachine>, Refusal> PageSession::Inside::switch_on(const std::string& file,
                                                                                            const PageJson& question) {
  if (!may_change) return refused(translated(texts::panel_page::may_only_look));
  PanelJournal& journal = *server.journal;
  PageJson saved_machine = ordered_json_of(journal.value("machine", file).value_or("{}"));
  if (saved_machine.is_object()) saved_machine.update(question);
  auto request = opening_request_in(saved_machine.is_object() ? saved_machine : question);
  if (!request) return tl::unexpected(request.error());
  request->text.reset();  // the machine runs the file on disk, not the text in the editor
  request->tables = journal.value("tables", file).value_or("");
  auto opened = open_for_page(*request);
  if (!opened) return refused(opened.error());
  auto real = connect_for(question, *opened);
  if (!real) return tl::unexpected(real.error());
  const auto content = std::make_shared<PanelContent>(std::move(*opened), std::move(*request));
  if (real->machine) fill_tables(content->program, *real->machine, *server.real);
  const std::string stood = journal.value("spot", file).value_or("");
  const auto spot = spot_of(stood);
  const auto opens = [program = &content->program](const std::optional<Axes>& start, const StopToken& stop) {
    return program->open(start, stop);
  };
  PanelRecorder keeper = keeper_of(journal, file, content->program, lang);
  keeper.begins = [&folder = server.folder, file, program = &content->program] { hold_text(folder, file, *program); };
  std::optional<Axes> start = spot ? std::optional(spot->machine) : std::nullopt;
  if (real->machine) start = position_of(*real->machine);
  auto made = PanelMachine::make(opens, std::move(keeper), start, spot && !real->machine ? spot->stands : std::vector<Axes>(),
                                 axes_of(real->machine));
  if (!made) return refused(made.error());
  if (const auto saved = journal.keep("machine", file, machine_text(saved_machine)); !saved) return refused(saved.error());
  auto place = std::make_shared<PanelHub::HubMachine>();
  place->name = file, place->content = content, place->machine = std::move(*made);
  place->stood = spot && spot->number > 1 ? stood : std::string();
  (void)journal.log(file, log_entry("on", content->program.opened().def->id, 0));
  if (!server.hub->add(place)) {
    place = server.hub->find(file);
    if (!place) return refused(translated(texts::panel_page::too_many_machines));
  }
  return place;
}

/// Switches on the machine of a program, or displays the machine if it is already on. A machine has the same name as its program.
PageSession::Inside::Answer PageSession::Inside::machine(const PageJson& question) {
  if (server.hub == nullptr || server.journal == nullptr) return not_served("machine");
  const std::string file = value_in<std::string>(question, "file", "");
  auto place = server.hub->find(file);
  if (!place) {
    auto made = switch_on(file, question);
    if (!made) return tl::unexpected(made.error());
    place = std::move(*made);
  }
  if (page == 0) page = server.hub->new_page();
  leave_machine();
  {
    const std::lock_guard hold(place_lock);
    hub_machine = place;
  }
  std::uint64_t nobody = 0;
  const bool holds = may_change && place->holder.compare_exchange_strong(nobody, page);
  const OpenedProgram& its = content_of(*place).program.opened();
  const PageJson stood = place->stood.empty() ? PageJson() : spot_json(place->stood);
  return PageJson{
      {"name", place->name}, {"axes", place->machine->axes()},  {"control", its.def->id}, {"machine", its.machine.id}, {"holds", holds},
      {"stood", stood},      {"lasts", server.journal->lasts()}};
}

/// Adds an entry to the log of the machine that this page displays.
void PageSession::Inside::note(const char* kind, const std::string& text, std::uint32_t at_line) const {
  (void)server.journal->log(hub_machine->name, log_entry(kind, text, at_line));
}

/// Saves a value of the machine. Returns an error sentence if the value could not be saved, else an empty text.
std::string PageSession::Inside::keep(const char* what, const std::string& text) const {
  const auto saved = server.journal->keep(what, hub_machine->name, text);
  return saved ? std::string() : saved.error();
}

/// Gives up the control of the machine, so that another page can take control.
void PageSession::Inside::leave_machine() {
  std::shared_ptr<PanelHub::HubMachine> place;
  {
    const std::lock_guard hold(place_lock);
    place = std::exchange(hub_machine, nullptr);
  }
  std::uint64_t mine = page;
  if (place) place->holder.compare_exchange_strong(mine, 0);
}

/// Returns the machine that this page displays. Refuses the request if this page does not have control of the machine.
tl::expected<PanelMachine*, Refusal> PageSession::Inside::held_machine() const {
  if (!hub_machine) return refused(translated(texts::panel_page::no_machine));
  if (!may_change) return refused(translated(texts::panel_page::may_only_look));
  if (hub_machine->holder != page) return refused(translated(texts::panel_page::held_by_another));
  return hub_machine->machine.get();
}

PageSession::Inside::Answer PageSession::Inside::panel(const PageJson&) {
  // Another page has switched the machine off, so this page no longer has a machine.
  if (hub_machine && server.hub->find(hub_machine->name) != hub_machine) leave_machine();
  if (!hub_machine) return refused(translated(texts::panel_page::no_machine));
  const PanelState state = hub_machine->machine->state();
  const OpenedProgram& opened = content_of(*hub_machine).program.opened();
  PageJson json = panel_json(state, hub_machine->machine->axes(), opened, lang);
  json["alarm"] = PageJson();
  if (state.alarm) json["alarm"] = problem_json(finding_of(*state.alarm, *opened.texts, lang), state.alarm->origin.file, std::nullopt);
  show_files(json["calls"]);
  json["digest"] = content_of(*hub_machine).program.digest();
  json["holds"] = may_change && hub_machine->holder == page;
  json["held"] = hub_machine->holder != 0;
  if (json["holds"]) hub_machine->machine->keep_alive();
  return json;
}

/// Returns the text of the program that the machine runs. The file on disk may have changed after the program started.
PageSession::Inside::Answer PageSession::Inside::machine_source(const PageJson&) {
  if (!hub_machine) return refused(translated(texts::panel_page::no_machine));
  const PanelProgram& program = content_of(*hub_machine).program;
  std::string digest = program.digest();
  auto text = program.text();
  if (!text) return refused(translated(texts::panel_page::too_long_to_show));
  return PageJson{{"text", std::move(*text)}, {"digest", std::move(digest)}};
}

PageSession::Inside::Answer PageSession::Inside::press(const PageJson& question) {
  const std::string key = value_in<std::string>(question, "key", "");
  if (key == "emergency") {
    stop_machine();
    return PageJson::object();
  }
  if (key == "take" && hub_machine && may_change) {
    hub_machine->holder = page;
    return PageJson::object();
  }
  const auto machine = held_machine();
  if (!machine) return tl::unexpected(machine.error());
  if (key == "run") return answer_of((*machine)->run());
  if (key == "block") return answer_of((*machine)->run(Stepping::How::single));
  if (key == "over") return answer_of((*machine)->run(Stepping::How::over));
  if (key == "out") return answer_of((*machine)->run(Stepping::How::out));
  if (key == "hold") return answer_of((*machine)->hold());
  if (key == "reset") return answer_of((*machine)->reset());
  if (key == "home") return answer_of((*machine)->home());
  if (key == "unlock") return answer_of((*machine)->unlock());
  if (key != "off") return refused(translated(texts::panel_page::no_such_key, key));
  (*machine)->switch_off();  // The machine is switched off before its saved data are deleted, so that it saves nothing afterwards.
  note("off", {}, 0);
  const auto forgotten = server.journal->forget(hub_machine->name);
  server.hub->remove(hub_machine->name);
  leave_machine();
  if (!forgotten) return refused(forgotten.error());
  return PageJson::object();
}

PageSession::Inside::Answer PageSession::Inside::switches(const PageJson& question) {
  const auto machine = held_machine();
  if (!machine) return tl::unexpected(machine.error());
  const auto flag = [&](const char* key) -> std::optional<bool> {
    const auto found = question.find(key);
    return found != question.end() && found->is_boolean() ? std::optional(found->get<bool>()) : std::nullopt;
  };
  PanelMachine::Answer answer;
  if (const auto on = flag("single")) answer = (*machine)->set_single(*on);
  if (const auto on = flag("optional_stop"); on && answer) answer = (*machine)->set_optional_stop(*on);
  if (const auto on = flag("on"); on && answer) answer = (*machine)->set_skip(int(count_in(question, "skip", 0)), *on);
  PanelOverrides shares = (*machine)->state().shares;
  const PanelOverrides before = shares;
  if (question.contains("override")) shares.feed = value_in<double>(question, "override", -1);
  if (question.contains("rapid")) shares.rapid = value_in<double>(question, "rapid", -1);
  if (question.contains("spindle")) shares.spindle = value_in<double>(question, "spindle", -1);
  if (question.contains("dry_feed")) shares.dry_feed = value_in<double>(question, "dry_feed", -1);
  if (answer && !(shares == before)) answer = (*machine)->set_overrides(shares);
  return answer_of(answer);
}

PageSession::Inside::Answer PageSession::Inside::enter(const PageJson& question) {
  const auto machine = held_machine();
  if (!machine) return tl::unexpected(machine.error());
  return answer_of((*machine)->enter(value_in<std::string>(question, "line", "")));
}

PageSession::Inside::Answer PageSession::Inside::undo(const PageJson&) {
  const auto machine = held_machine();
  if (!machine) return tl::unexpected(machine.error());
  return answer_of((*machine)->undo());
}

PageSession::Inside::Answer PageSession::Inside::jog(const PageJson& question) {
  const auto machine = held_machine();
  if (!machine) return tl::unexpected(machine.error());
  const auto axis = value_in<std::string>(question, "axis", "");
  const double way = value_in<double>(question, "way", 0), feed = value_in<double>(question, "feed", 0);
  const int channel = int(count_in(question, "channel", 0));
  if (is_true(question, "held")) return answer_of((*machine)->jog_while_held(axis, way, feed, channel));
  return answer_of((*machine)->jog(axis, way, feed, channel));
}

/// The key that moves an axis is still held, or it has been released.
PageSession::Inside::Answer PageSession::Inside::jogging(const PageJson& question) {
  const auto machine = held_machine();
  if (!machine) return tl::unexpected(machine.error());
  return PageJson{{"moves", (*machine)->keep_jogging(is_true(question, "on"))}};
}

/// Answers a question that the program on the machine has asked the operator.
PageSession::Inside::Answer PageSession::Inside::answer_to_machine(const PageJson& question) {
  const auto machine = held_machine();
  if (!machine) return tl::unexpected(machine.error());
  return answer_of((*machine)->answer(value_in<double>(question, "answer", -1)));
}

/// Evaluates the expressions that the operator watches on this page.
PageSession::Inside::Answer PageSession::Inside::watch(const PageJson& question) {
  if (!hub_machine) return refused(translated(texts::panel_page::no_machine));
  std::vector<std::string> expressions;
  if (const auto list = question.find("expressions"); list != question.end() && list->is_array())
    for (const PageJson& one : *list)
      if (one.is_string() && one.get_ref<const std::string&>().size() <= max_expression && expressions.size() < most_watched)
        expressions.push_back(one.get<std::string>());
  const auto values = hub_machine->machine->watch_values(expressions);
  if (!values) return refused(values.error());
  PageJson list = PageJson::array();
  for (const PanelWatch& one : *values)
    list.push_back({{"text", one.text}, {"value", one.value && std::isfinite(*one.value) ? PageJson(*one.value) : PageJson()}});
  return PageJson{{"values", std::move(list)}};
}

/// Adds a stop point, or removes the stop point whose number is the value of `remove` in the request.
PageSession::Inside::Answer PageSession::Inside::stops_at(const PageJson& question) {
  const auto machine = held_machine();
  if (!machine) return tl::unexpected(machine.error());
  if (question.contains("remove")) return answer_of((*machine)->remove_stop(count_in(question, "remove", 0)));
  StopPoint point = stop_point_of(question);
  if (point == StopPoint{}) return refused(translated(texts::panel_page::stop_point_wanted));
  const auto number = (*machine)->add_stop(std::move(point));
  if (!number) return refused(number.error());
  return PageJson{{"number", *number}};
}

/// Stops everything at once (emergency stop). May be called from any thread.
void PageSession::Inside::stop_machine() {
  std::shared_ptr<PanelHub::HubMachine> place;
  {
    const std::lock_guard hold(place_lock);
    place = hub_machine;
  }
  if (place && may_change) place->machine->stop_at_once();
}

}  // namespace kadr
