// PanelMachine, the opening of a session at the beginning of the program, and the switches. Used by panel/panel_machine; tested by
// tests/panel/panel_machine_test.cpp and tests/panel/panel_channels_test.cpp.

#include "panel/panel_machine.h"
#include "panel/virtual_axes.h"
#include "texts/grbl_machine.h"
#include "texts/panel.h"

namespace kadr {
namespace {

using Failed = tl::unexpected<std::string>;

}  // namespace

/// Creates a machine. After this call the number of channels never changes.
tl::expected<std::unique_ptr<PanelMachine>, std::string> PanelMachine::make(SessionOpener opens, PanelRecorder keeper,
                                                                            const std::optional<Axes>& start, std::vector<Axes> stands,
                                                                            AxesMaker axes) {
  std::unique_ptr<PanelMachine> machine(new PanelMachine(std::move(opens), std::move(keeper), std::move(stands), std::move(axes)));
  try {
    if (const Answer opened = machine->open(start); !opened) return Failed(opened.error());
    machine->search_ = std::make_unique<PanelSearch>(machine->opens_);
    machine->begin_search();
    machine->thread_.begin_or_throw([m = machine.get()] { m->live(); });
  } catch (const NoThread&) {
    return Failed(translated(texts::panel::no_threads));
  }
  return machine;
}

/// A real machine has one channel with the axes X, Y and Z, and may have further ones that the program does not move.
PanelMachine::Answer PanelMachine::may_have_axes() const {
  if (!makes_axes_) return {};
  if (session_->channels().size() != 1) return Failed(translated(texts::grbl_machine::one_channel));
  const std::vector<std::string>& names = session_->control().axes();
  if (names.size() < 3 || names[0] != "X" || names[1] != "Y" || names[2] != "Z")
    return Failed(translated(texts::grbl_machine::axes_wanted));
  return {};
}

PanelMachine::Answer PanelMachine::make_lanes() {
  const std::vector<Channel>& channels = session_->channels();
  if (const Answer may = may_have_axes(); !may) return may;
  for (std::size_t i = lanes_.size(); lane_ == nullptr && i < channels.size(); ++i) {
    const Control& control = *channels[i].control;
    const AxisRoles roles = AxisRoles::of(control.axes(), control.rotary());
    const Axes stand = session_->stand(i).machine;
    if (makes_axes_) lanes_.push_back(makes_axes_(channels[i].number, control.axes(), roles, stand));
    else lanes_.push_back(std::make_unique<VirtualAxes>(channels[i].number, control.axes(), roles, rate, stand));
  }
  if (lanes_.size() != channels.size()) return Failed(translated(texts::panel::other_channels));
  if (lane_ != nullptr) return {};
  own_ = session_->own();
  for (std::size_t i = 0; i < lanes_.size() && stands_.size() == lanes_.size(); ++i)
    if (i != own_) lanes_[i]->stand_at(stands_[i]);
  lane_ = lanes_[own_].get();  // From here on other threads read the object of the program's own channel through this pointer.
  return {};
}

void PanelMachine::obey_switches() {
  for (const Channel& channel : session_->channels()) {
    for (int number = 1; number <= 9; ++number) channel.control->set_skip(number, panel_state_.skip.contains(number));
    channel.control->set_optional_stop(panel_state_.optional_stop);
  }
}

/// Opens a session at the beginning of the program and connects it with the machine.
PanelMachine::Answer PanelMachine::begin_session(const std::optional<Axes>& start) {
  stops_ = false;
  auto opened = opens_(start, StopToken(stops_));
  if (!opened) return Failed(opened.error());
  stepping_.reset();
  session_ = std::move(*opened);
  if (lane_ == nullptr)
    panel_state_.skip.insert(session_->setup().skip.begin(), session_->setup().skip.end()),
        panel_state_.optional_stop = session_->setup().optional_stop;
  start_ = start;
  Control& control = session_->control();
  control.return_each_block();  // The control returns after each block, so that a stop request can hold the program before the next block.
  control.watch_calls();
  stepping_ = std::make_unique<Stepping>(*session_);
  stepping_->keep(panel_state_.stops);
  stepping_->on_block = [this](const Origin& origin) {
    note_variables(last_line_);
    last_line_ = origin.line;
  };
  if (const Answer made = make_lanes(); !made) return made;
  obey_switches();
  const auto take = [this](const AlarmReport& report) {
    panel_state_.alarm = report;
    if (keeper_.alarm) keeper_.alarm(report);
  };
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    Outlets& outlets = session_->outlets(i);
    outlets.warning = take;
    outlets.alarm = [take](const AlarmReport& report) {
      take(report);
      return false;
    };
    outlets.stop = StopToken(stops_);
    outlets.step = [this, i](const Step& step) { look(*lanes_[i], *session_->channels()[i].control, step); };
    lanes_[i]->start_over();
  }
  watch_channels();
  panel_state_.alarm.reset();
  before_.clear();
  retables_.reset();
  goes_on_ = false;
  entered_ = 0;
  last_line_ = 0;
  variables_.clear(), set_by_.clear();
  note_variables(0);
  return {};
}

PanelMachine::Answer PanelMachine::open(const std::optional<Axes>& start) {
  if (keeper_.begins) keeper_.begins();
  if (const Answer begun = begin_session(start); !begun) return begun;
  stands_.clear();
  for (std::size_t i = 0; start && !is_alone() && i < lanes_.size(); ++i) {
    stands_.push_back(lanes_[i]->sample().machine);
    if (i != own_) session_->stand_at(i, stands_.back());
  }
  if (search_) begin_search();
  session_->alone(session_->own());  // The other channels start later, with the first run().
  const Session::State state = stepping_->go(Stepping::How::block);
  panel_state_.asks = false;
  stand_here();
  goes_on_ = state == Session::State::held;
  panel_state_.mode = goes_on_ ? PanelMode::standing : state == Session::State::stopped ? PanelMode::alarm : PanelMode::ended;
  show();
  return {};
}

/// Returns the program to its beginning. If the program file can no longer be read, the program counts as ended. An alarm or an emergency
/// stop is over in this case too, so that the operator can move the axes by hand.
PanelMachine::Answer PanelMachine::start_over() {
  lane_->recover();
  Answer opened = open(lane_->sample().machine);
  if (!opened) panel_state_.mode = PanelMode::ended, panel_state_.alarm.reset();
  return opened;
}

/// Passes the start position and the switches of this run to the search.
void PanelMachine::begin_search() { search_->begin({start_, stands_, panel_state_.skip, panel_state_.optional_stop}); }

/// Sets the displayed position and modes before any axis has moved.
void PanelMachine::stand_here() {
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    const Control& control = *session_->channels()[i].control;
    ChannelAxes& lane = *lanes_[i];
    lane.placement = control.placement();
    lane.on.work = session_->stand(i).work, lane.on.machine = session_->stand(i).machine, lane.on.placement = lane.placement;
    lane.on.modes = std::make_shared<PanelModes>(PanelModes{control.in_force(), {}, control.lathe_modes()});
  }
}

}  // namespace kadr
