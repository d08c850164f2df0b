// Places of a machine's program, found beside it. For panel/panel_machine; tested by tests/panel/panel_restart_test.cpp.

#include "panel/panel_search.h"

#include <utility>

#include "config/told.h"

namespace kadr {

PanelSearch::PanelSearch(PanelOpens opens) : opens_(std::move(opens)) {
  thread_ = std::thread([this] { live(); });
}

PanelSearch::~PanelSearch() {
  {
    const std::lock_guard hold(lock_);
    ends_ = true;
    stops_ = true;
  }
  wakes_.notify_all();
  thread_.join();
}

void PanelSearch::begin(const PanelStart& start) {
  {
    const std::lock_guard hold(lock_);
    to_begin_ = start;
    stops_ = true;  // what is under way
    answer_.reset();
  }
  wakes_.notify_all();
}

PanelSearch::Answer PanelSearch::find(const Wish& wish) {
  const std::lock_guard hold(lock_);
  if (wish_ == wish && lang_ == told_lang()) return answer_.value_or(Answer{});
  if (searching_) stops_ = true;
  wish_ = wish, lang_ = told_lang();
  answer_.reset();
  wakes_.notify_all();
  return {};
}

void PanelSearch::live() {
  std::unique_lock hold(lock_);
  while (true) {
    wakes_.wait(hold, [this] { return ends_ || to_begin_ || (wish_ && !answer_ && run_.is_there); });
    if (ends_) break;
    stops_ = false;
    if (to_begin_) {
      const PanelStart start = *std::exchange(to_begin_, std::nullopt);
      hold.unlock();
      prepare(start);
      hold.lock();
      continue;
    }
    const Wish wish = *wish_;
    tell_here_in(lang_);
    searching_ = true;
    hold.unlock();
    Answer answer = search(wish);
    hold.lock();
    searching_ = false;
    if (wish_ == wish && !to_begin_ && !stops_) answer_ = std::move(answer);
  }
  hold.unlock();
  forget();
}

/// What looks at the session goes before it.
void PanelSearch::forget() {
  run_.stepping.reset(), run_.checkpoints.reset(), run_.session.reset();
  run_ = {};
}

/// As the machine begins, with nobody looking.
std::unique_ptr<Session> PanelSearch::open() {
  auto opened = opens_(start_.axes, StopToken(stops_));
  if (!opened) return run_.error = opened.error(), nullptr;
  std::unique_ptr<Session> session = std::move(*opened);
  Control& control = session->control();
  for (int number = 1; number <= 9; ++number) control.set_skip(number, start_.skip.contains(number));
  control.set_optional_stop(start_.optional_stop);
  session->outlets().stop = StopToken(stops_);
  return session;
}

void PanelSearch::prepare(const PanelStart& start) {
  forget();
  run_.is_there = true;
  start_ = start;
  auto session = open();
  if (!session) return;
  session->control().watch_calls();
  auto checkpoints = std::make_unique<Checkpoints>(*session);
  (void)checkpoints->run();  // to where it stands: nobody can go on after that
  run_.stepping = std::make_unique<Stepping>(*session);
  run_.checkpoints = std::move(checkpoints);
  run_.session = std::move(session);
}

std::optional<Restart> PanelSearch::reach(const Wish& wish) {
  Session& session = *run_.session;
  const auto reached = run_.checkpoints->reach(*run_.stepping, wish.target);
  if (!reached || *reached != Session::State::held) return std::nullopt;
  auto restart = restart_here(session, *run_.stepping);
  if (restart && wish.hole != 0 && !go_over_hole(session, *run_.stepping, wish.hole, *restart)) return std::nullopt;
  return restart;
}

std::optional<BlockSearch> PanelSearch::search_by_control(const StopPoint& target) {
  if (!run_.session->control().search_rules()) return std::nullopt;
  const auto session = open();
  if (!session) return std::nullopt;
  Stepping stepping(*session);
  return search_block(*session, stepping, target);
}

PanelSearch::Answer PanelSearch::search(const Wish& wish) {
  Answer answer;
  answer.ready = true;
  if (!run_.session) return answer.error = run_.error, answer;
  auto restart = reach(wish);
  if (!restart) {
    answer.error = wish.hole != 0 ? told("the block is not reached, or drills not so many holes", "кадр не достигнут или сверлит меньше отверстий")
                                  : told("the block is not reached in this run", "в этом прогоне кадр не достигнут");
    return answer;
  }
  auto memory = run_.stepping->snapshot();
  if (!memory) return answer.error = told("a probe is waited for there", "там ожидается касание щупа"), answer;
  memory->next = restart->at;
  const Control& control = run_.session->control();
  const bool in_block = control.in_block();
  answer.place = std::make_shared<const PanelPlace>(PanelPlace{std::move(*restart), control.line_at(memory->next.value()), control.calls(),
                                                               control.placement(), std::move(*memory), in_block,
                                                               wish.by_control ? search_by_control(wish.target) : std::nullopt});
  return answer;
}

}  // namespace kadr
