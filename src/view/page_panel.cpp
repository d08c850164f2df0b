// Questions about a machine at its panel: machines, machine, panel, press, switches, enter, undo, jog, stops. For view/page_session; tested by
// tests/panel.py.

#include <fmt/core.h>

#include "view/page_inside.h"
#include "view/panel_json.h"

namespace kadr {
namespace {

tl::unexpected<Refusal> refused(std::string text) { return tl::unexpected(Refusal{std::move(text)}); }

PageAnswer answer_of(const PanelMachine::Answer& answer) {
  if (!answer) return refused(answer.error());
  return PageJson::object();
}

/// Where the axes stand when the program begins anew; the tables are those of the set-up.
Setup standing_at(const Setup& setup, const std::vector<std::string>& axes, const Axes& start) {
  Setup with = setup;
  with.start_in_work = false;
  for (std::size_t a = 0; a < std::min(axes.size(), max_axes); ++a) with.start[axes[a]] = start[a];
  return with;
}

/// What a machine's sessions are made of.
struct PanelProgram {
  OpenedProgram opened;
  std::vector<std::string> axes;  // of its control, once it is known
};

PanelMachine::Opens opens_of(const std::shared_ptr<PanelProgram>& program) {
  return [program = program.get()](const std::optional<Axes>& start, const StopToken& stop) -> tl::expected<std::unique_ptr<Session>, std::string> {
    auto text = program->opened.program();
    if (!text) return tl::unexpected(text.error());
    SessionSpec spec = program->opened.spec(std::move(*text), stop);
    if (start) spec.setup = standing_at(spec.setup, program->axes, *start);
    auto session = Session::open(std::move(spec));
    if (!session) return tl::unexpected(told(session.error().fault.en, session.error().fault.ru));
    program->axes = (*session)->control().axes();
    return std::move(*session);
  };
}

}  // namespace

PageSession::Inside::Answer PageSession::Inside::machines(const PageJson&) {
  PageJson list = PageJson::array();
  for (const auto& place : server.hub != nullptr ? server.hub->all() : std::vector<std::shared_ptr<PanelHub::Place>>())
    list.push_back({{"name", place->name}, {"mode", name_of(place->machine->state().mode)}, {"held", place->holder != 0}});
  return PageJson{{"machines", std::move(list)}};
}

/// Switches the machine of a program on, or looks at one that is on. It is named by its program.
PageSession::Inside::Answer PageSession::Inside::machine(const PageJson& question) {
  if (server.hub == nullptr) return not_served("machine");
  const std::string file = value_in<std::string>(question, "file", "");
  auto place = server.hub->find(file);
  if (!place) {
    if (!may_change) return refused(told("this page may only look: open the printed address", "эта страница может только смотреть: откройте напечатанный адрес"));
    auto wish = wish_of(question);
    if (!wish) return tl::unexpected(wish.error());
    wish->text.reset();  // a machine runs what lies on the disk
    auto opened = open_for_page(*wish);
    if (!opened) return refused(opened.error());
    const auto program = std::make_shared<PanelProgram>(PanelProgram{std::move(*opened), {}});
    auto made = PanelMachine::make(opens_of(program));
    if (!made) return refused(made.error());
    place = std::make_shared<PanelHub::Place>();
    place->name = file, place->content = program, place->machine = std::move(*made);
    if (!server.hub->add(place)) {
      place = server.hub->find(file);
      if (!place) return refused(told("too many machines are on", "включено слишком много станков"));
    }
  }
  if (page == 0) page = server.hub->new_page();
  leave_machine();
  {
    const std::lock_guard hold(place_lock);
    panel_place = place;
  }
  std::uint64_t nobody = 0;
  const bool holds = may_change && place->holder.compare_exchange_strong(nobody, page);
  const auto& its = static_cast<const PanelProgram*>(place->content.get())->opened;
  return PageJson{{"name", place->name}, {"axes", place->machine->axes()}, {"control", its.def->id}, {"machine", its.machine.id}, {"holds", holds}};
}

/// Its controls are for others to take.
void PageSession::Inside::leave_machine() {
  std::shared_ptr<PanelHub::Place> place;
  {
    const std::lock_guard hold(place_lock);
    place = std::exchange(panel_place, nullptr);
  }
  std::uint64_t mine = page;
  if (place) place->holder.compare_exchange_strong(mine, 0);
}

/// The machine, if this page may act on it.
tl::expected<PanelMachine*, Refusal> PageSession::Inside::held_machine() const {
  if (!panel_place) return refused(told("no machine is looked at", "станок не выбран"));
  if (!may_change) return refused(told("this page may only look: open the printed address", "эта страница может только смотреть: откройте напечатанный адрес"));
  if (panel_place->holder != page) return refused(told("another page holds the controls: take them first", "управление у другой страницы: сначала возьмите его"));
  return panel_place->machine.get();
}

PageSession::Inside::Answer PageSession::Inside::panel(const PageJson&) {
  if (!panel_place) return refused(told("no machine is looked at", "станок не выбран"));
  const PanelState state = panel_place->machine->state();
  PageJson json = panel_json(state, panel_place->machine->axes());
  const auto& opened = static_cast<const PanelProgram*>(panel_place->content.get())->opened;
  json["alarm"] = PageJson();
  if (state.alarm) json["alarm"] = problem_json(finding_of(*state.alarm, *opened.texts, lang), state.alarm->origin.file, std::nullopt);
  json["holds"] = may_change && panel_place->holder == page;
  json["held"] = panel_place->holder != 0;
  return json;
}

PageSession::Inside::Answer PageSession::Inside::press(const PageJson& question) {
  const std::string key = value_in<std::string>(question, "key", "");
  if (key == "emergency") return stop_machine(), PageJson::object();
  if (key == "take" && panel_place && may_change) return panel_place->holder = page, PageJson::object();
  const auto machine = held_machine();
  if (!machine) return tl::unexpected(machine.error());
  if (key == "run") return answer_of((*machine)->run());
  if (key == "hold") return answer_of((*machine)->hold());
  if (key == "reset") return answer_of((*machine)->reset());
  if (key != "off") return refused(key + told(": there is no such key", ": такой клавиши нет"));
  (*machine)->stop_at_once();
  server.hub->remove(panel_place->name);
  leave_machine();
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
  if (question.contains("override") && answer) answer = (*machine)->override_to(value_in<double>(question, "override", -1));
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
  return answer_of((*machine)->jog(value_in<std::string>(question, "axis", ""), value_in<double>(question, "way", 0), value_in<double>(question, "feed", 0)));
}

/// `remove`: the number of one; else one more.
PageSession::Inside::Answer PageSession::Inside::stops_at(const PageJson& question) {
  const auto machine = held_machine();
  if (!machine) return tl::unexpected(machine.error());
  if (question.contains("remove")) return answer_of((*machine)->remove_stop(count_in(question, "remove", 0)));
  StopPoint point;
  point.line = count_in(question, "line", 0), point.pass = count_in(question, "pass", 0);
  point.call = value_in<std::string>(question, "call", ""), point.condition = value_in<std::string>(question, "condition", "");
  if (point.line == 0 && point.call.empty() && point.condition.empty())
    return refused(told("want a line, a call or a condition", "нужна строка, вызов или условие"));
  const auto number = (*machine)->add_stop(std::move(point));
  if (!number) return refused(number.error());
  return PageJson{{"number", *number}};
}

/// From any thread.
void PageSession::Inside::stop_machine() {
  std::shared_ptr<PanelHub::Place> place;
  {
    const std::lock_guard hold(place_lock);
    place = panel_place;
  }
  if (place && may_change) place->machine->stop_at_once();
}

}  // namespace kadr
