// PanelSearch finds restart positions in a machine's program. Used by panel/panel_machine; tested by tests/panel/panel_restart_test.cpp.

#include "panel/panel_search.h"

#include <utility>

#include "config/language.h"
#include "texts/panel.h"

namespace kadr {

PanelSearch::PanelSearch(SessionOpener opens) : opens_(std::move(opens)) {
  thread_.begin_or_throw([this] { live(); });
}

PanelSearch::~PanelSearch() {
  {
    const std::lock_guard hold(lock_);
    ends_ = true;
    stops_ = true;
  }
  wakes_.notify_all();
  thread_.wait();
}

void PanelSearch::begin(const PanelStart& start) {
  {
    const std::lock_guard hold(lock_);
    to_begin_ = start;
    stops_ = true;  // The flag stops the search that is in progress, because its results are no longer valid.
    answer_.reset();
  }
  wakes_.notify_all();
}

PanelSearch::Answer PanelSearch::find(const SearchRequest& request) {
  const std::lock_guard hold(lock_);
  if (request_ == request && lang_ == thread_language()) return answer_.value_or(Answer{});
  if (searching_) stops_ = true;
  request_ = request, lang_ = thread_language();
  answer_.reset();
  wakes_.notify_all();
  return {};
}

void PanelSearch::live() {
  std::unique_lock hold(lock_);
  while (true) {
    wakes_.wait(hold, [this] { return ends_ || to_begin_ || (request_ && !answer_ && run_.is_there); });
    if (ends_) break;
    stops_ = false;
    if (to_begin_) {
      const PanelStart start = *std::exchange(to_begin_, std::nullopt);
      hold.unlock();
      prepare(start);
      hold.lock();
      continue;
    }
    const SearchRequest request = *request_;
    set_thread_language(lang_);
    searching_ = true;
    hold.unlock();
    Answer answer = search(request);
    hold.lock();
    searching_ = false;
    if (request_ == request && !to_begin_ && !stops_) answer_ = std::move(answer);
  }
  hold.unlock();
  forget();
}

/// Destroys the objects that use the session first, and then the session.
void PanelSearch::forget() {
  own_is_over_ = false;
  run_.stepping.reset(), run_.checkpoints.reset(), run_.session.reset();
  run_ = {};
}

/// Opens a session with the same start position and switches as the session of the machine, but without observers.
std::unique_ptr<Session> PanelSearch::open() {
  auto opened = opens_(start_.axes, StopToken(stops_));
  if (!opened) {
    run_.error = opened.error();
    return nullptr;
  }
  std::unique_ptr<Session> session = std::move(*opened);
  Control& control = session->control();
  for (int number = 1; number <= 9; ++number) control.set_skip(number, start_.skip.contains(number));
  control.set_optional_stop(start_.optional_stop);
  for (std::size_t i = 0; i < session->channels().size(); ++i) {
    session->outlets(i).stop = StopToken(stops_);
    if (i == session->own()) continue;
    Control& other = *session->channels()[i].control;
    for (int number = 1; number <= 9; ++number) other.set_skip(number, start_.skip.contains(number));
    other.set_optional_stop(start_.optional_stop);
    other.watch_calls();
    end_with_own(other);
    if (i < start_.stands.size()) session->stand_at(i, start_.stands[i]);
  }
  return session;
}

/// Lets another channel end when the own channel has ended. Otherwise an endless program in the other channel would prevent the end of the
/// search.
void PanelSearch::end_with_own(Control& other) {
  other.holds_before = [this](const Origin&) { return own_is_over_; };
}

void PanelSearch::prepare(const PanelStart& start) {
  forget();
  run_.is_there = true;
  start_ = start;
  auto session = open();
  if (!session) return;
  session->control().watch_calls();
  session->together().over = [this, own = session->own()](std::size_t channel) { own_is_over_ = own_is_over_ || channel == own; };
  auto checkpoints = std::make_unique<Checkpoints>(*session);
  (void)checkpoints->run();  // The session runs until no channel can continue, whatever the reason is.
  run_.stepping = std::make_unique<Stepping>(*session);
  run_.checkpoints = std::move(checkpoints);
  run_.session = std::move(session);
}

std::optional<Restart> PanelSearch::reach(const SearchRequest& request) {
  Session& session = *run_.session;
  own_is_over_ = false;
  const auto reached = run_.checkpoints ? run_.checkpoints->reach(*run_.stepping, request.target)
                                        : Result<Session::State>(run_.stepping->go_to(request.target));
  if (!reached || *reached != Session::State::held) return std::nullopt;
  auto restart = restart_here(session, *run_.stepping);
  if (restart && request.hole != 0 && !move_over_hole(session, *run_.stepping, request.hole, *restart)) return std::nullopt;
  return restart;
}

std::optional<BlockSearch> PanelSearch::search_by_control(const StopPoint& target) {
  if (!run_.session->control().search_rules() || run_.session->channels().size() > 1) return std::nullopt;
  const auto session = open();
  if (!session) return std::nullopt;
  Stepping stepping(*session);
  return search_block(*session, stepping, target);
}

/// Finds the block that the channel would execute next, without executing this block. The session cannot be continued afterwards.
void PanelSearch::find_next(OtherChannelState& channel) {
  Session& session = *run_.session;
  Control& control = *session.channels()[channel.channel].control;
  control.holds_before = [&](const Origin& origin) {
    channel.restart.at = origin;
    return true;
  };
  session.alone(channel.channel);
  channel.is_over = session.run() != Session::State::held;
  end_with_own(control);
}

/// Returns the state of the other channels at the moment at which the own channel has reached the restart position.
std::vector<OtherChannelState> PanelSearch::other_channels() {
  Session& session = *run_.session;
  std::vector<OtherChannelState> all;
  session.hold_each(false);
  for (std::size_t i = 0; i < session.channels().size(); ++i) {
    if (i == session.own()) continue;
    Control& control = *session.channels()[i].control;
    OtherChannelState one;
    one.channel = i, one.number = session.channels()[i].number;
    one.restart = {Origin(), control.in_force(), session.stand(i), control.plane_normal()};
    one.calls = control.calls();
    one.placement = control.placement();
    one.waits = control.meeting();
    one.in_block = control.in_block();
    one.blocks = control.blocks();
    one.restart.at = one.waits ? one.waits->origin : control.origin();
    all.push_back(std::move(one));
  }
  for (OtherChannelState& one : all) {
    if (!one.waits && !one.in_block) find_next(one);
    one.line = session.channels()[one.channel].control->line_at(one.restart.at);
  }
  return all;
}

/// Opens a session in which each channel runs from its beginning until it has executed the number of blocks that the request states for
/// this channel.
void PanelSearch::run_each_channel(const SearchRequest& request) {
  run_.session = open();
  if (!run_.session) return;
  Session& session = *run_.session;
  session.control().watch_calls();
  run_.stepping = std::make_unique<Stepping>(session);
  session.alone(session.own());  // The program's own channel starts before the other channels.
  (void)run_.stepping->go(Stepping::How::block);
  for (std::size_t i = 0; i < session.channels().size() && i < request.blocks.size(); ++i)
    if (i != session.own())
      session.channels()[i].control->holds_before = [most = request.blocks[i]](const Origin& origin) { return origin.number > most; };
  session.hold_each(true);
}

PanelSearch::Answer PanelSearch::search(const SearchRequest& request) {
  if (request.blocks.empty()) return found(request);
  Run run_before = std::exchange(run_, {});
  run_each_channel(request);
  Answer answer = found(request);
  forget();
  run_ = std::move(run_before);
  run_.is_there = true;
  return answer;
}

PanelSearch::Answer PanelSearch::found(const SearchRequest& request) {
  Answer answer;
  answer.ready = true;
  if (!run_.session) {
    answer.error = run_.error;
    return answer;
  }
  auto restart = reach(request);
  if (!restart) {
    answer.error = request.hole != 0 ? translated(texts::panel::too_few_holes) : translated(texts::panel::not_reached);
    return answer;
  }
  auto memory = run_.stepping->snapshot();
  if (!memory) {
    answer.error = translated(texts::panel::probe_there);
    return answer;
  }
  memory->next = restart->at;
  const Control& control = run_.session->control();
  const bool in_block = control.in_block();
  RestartPoint place{std::move(*restart),
                     control.line_at(memory->next.value()),
                     control.calls(),
                     control.placement(),
                     std::move(*memory),
                     in_block,
                     request.by_control ? search_by_control(request.target) : std::nullopt,
                     {}};
  place.other_channels = other_channels();
  answer.place = std::make_shared<const RestartPoint>(std::move(place));
  return answer;
}

}  // namespace kadr
