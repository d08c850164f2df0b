// A complete run of a program as a fuzz target. Used by fuzz/run_*_fuzz and fuzz/own_control.

#include "run_program.h"

#include <atomic>
#include <memory>
#include <random>

#include "looks.h"
#include "run_control.h"
#include "session/checkpoints.h"
#include "session/restart.h"

namespace kadr::fuzz {

Setup some_setup(unsigned switches) {
  Setup s;
  s.start = {{"X", 10}, {"Y", -20}, {"Z", 100}};
  s.offsets = {{1, {50, 5}}, {2, {-12.5, 0}}, {9, {33.3, 0}}};
  s.work_offsets = {{"G54", {{"X", 100}, {"Y", 50}}}, {"G55", {{"Z", -25}}}, {"common", {{"X", 1}}}};
  s.zeros = {{1, {{"X", 100}, {"Y", 50}, {"Z", 7}}}, {2, {{"X", -3}}}};
  s.correctors = {{1, 0.5}, {2, -0.25}, {15, 9.8}, {17, 2}};
  s.variables = {{"#100", 3.5}, {"R0", 100}, {"R1", -20000}, {"R2", 1000}, {"R3", 5000}};
  s.reference_points = {{1, {{"X", 500}, {"Y", 400}, {"Z", 300}}}, {2, {{"Z", 200}}}};
  s.probe_hole = ProbeHole{1, 0, 0, 40, 0, 10};
  s.watch = {"#100", "#2000", "#7", "R4"};
  s.spindles[1].rpm = 500;
  s.points = {0.25, 0.5};
  if ((switches & mirror_x) != 0) s.mirror.emplace_back("X");
  if ((switches & mirror_y) != 0) s.mirror.emplace_back("Y");
  if ((switches & skip_blocks) != 0) s.skip = {1, 3};
  s.optional_stop = (switches & skip_blocks) != 0;
  if ((switches & narrow_limits) != 0) s.machine["*"].limits = {-300, 300};
  return s;
}

namespace {

constexpr std::size_t max_actions = 20'000;  // limit for a run
constexpr std::size_t max_planned = 24;      // actions; at a sharp corner the planner needs 1 ms, with sanitizers 100 ms
constexpr std::size_t max_cells = 150;
constexpr std::size_t max_alarms = 200;
constexpr std::size_t max_calls = 4000;  // limit for calls of go_on(), for loops without actions
constexpr std::size_t max_commands = 60;
constexpr std::size_t max_commanded = 5000;  // limit of actions while single-stepping or searching

enum class RunKind : std::uint8_t { watched, rewound, fresh, planned, stepped, searched, count };

/// A random generator seeded with the text, so that the same text always runs in the same way.
class Chance {
 public:
  explicit Chance(std::string_view text) {
    std::uint32_t sum = 2166136261U;
    for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * 16777619U;
    engine_.seed(sum);
  }
  std::size_t below(std::size_t count) { return count == 0 ? 0 : engine_() % count; }
  bool one_in(std::size_t count) { return below(count) == 0; }
  /// Returns a random line of the text, from a random character on.
  std::string piece_of(const std::string& text) {
    const std::size_t begin = below(text.size()), end = text.find('\n', begin);
    return text.substr(begin, std::min<std::size_t>(end - begin, 80));
  }

 private:
  std::mt19937 engine_;
};

class Run {
 public:
  Run(const Shop& shop, const std::string& text, unsigned switches)
      : shop_(shop),
        text_(text),
        switches_(switches),
        chance_(text),
        kind_(static_cast<RunKind>(chance_.below(static_cast<std::size_t>(RunKind::count)))) {
    has_logic_ = shop.logic && (switches & machine_logic) != 0;
    if (has_logic_ && kind_ != RunKind::stepped) kind_ = RunKind::watched;  // the state of the logic is not part of snapshots
    has_channels_ = !shop.second_channel.empty() && chance_.one_in(4);
  }

  /// Runs the program in the selected way. `then` is called while the session still exists.
  void execute(const std::function<void()>& then) {
    const std::unique_ptr<Session> session = open();
    if (!session) return;
    Looks looks(shop_, *session);
    if (has_logic_) attach_logic(*session, looks);
    switch (kind_) {
      case RunKind::watched: watch(*session, looks); break;
      case RunKind::rewound: rewind(*session, looks); break;
      case RunKind::fresh: go_on_in_a_fresh_one(*session, looks); break;
      case RunKind::planned: plan(*session, looks); break;
      case RunKind::stepped: step(*session, looks); break;
      default: search(*session, looks); break;
    }
    if (state_ == Session::State::ended || state_ == Session::State::stopped) looks.finish();
    if (then) then();
  }

 private:
  /// Returns nullptr if the control accepts neither the set-up of the shop nor an empty one.
  std::unique_ptr<Session> open() const {
    for (Setup setup : {shop_.setup(switches_), Setup()}) {
      if (has_channels_) setup.channels[2] = {shop_.second_channel, {"U", "V"}};
      const auto encoding = (switches_ & as_cp1251) != 0 ? std::optional(Encoding::cp1251) : std::nullopt;
      auto session = Session::open({{&shop_.def, [](const ControlDef*) {}},
                                    shop_.profile,
                                    std::move(setup),
                                    {shop_.file, text_source(text_), encoding},
                                    shop_.limits});
      if (session) return std::move(*session);
      require(!session.error().fault.en.empty() && !session.error().fault.ru.empty(), "a refusal says why in both languages");
    }
    return nullptr;
  }

  void attach_logic(Session& session, Looks& looks) const {
    session.control().return_each_block();
    session.control().on_block = [&shop = shop_, &control = session.control(), &looks](const Origin& origin, bool at_end) {
      if (!at_end) looks.before_block();
      else looks.forget_block();
      shop.logic(control, origin, at_end);
    };
  }

  bool goes_on(const Looks& looks) {
    const std::size_t most = kind_ == RunKind::planned ? max_planned : max_actions;
    return ++calls_ < max_calls && state_ == Session::State::running && looks.actions() < most && looks.alarms() < max_alarms;
  }
  void run(Session& session, const Looks& looks) {
    while (goes_on(looks)) state_ = session.go_on();
  }

  /// Limits the actions: a command may execute many blocks, and a block many motions.
  void stop_after_some(Session& session, Looks& looks) {
    looks.stop_after(max_commanded, stop_);
    session.outlets().stop = StopToken(stop_);
  }

  /// Saves the state before each block for comparison. Continues after alarms.
  void watch(Session& session, Looks& looks) {
    looks.goes_on_after_alarm = [this] { return !chance_.one_in(3); };
    session.control().holds_before = [&looks, this](const Origin&) {
      if (has_logic_) looks.forget_block();  // the logic's callback saves the state, unless the block cannot be read
      else looks.before_block();
      return false;
    };
    while (goes_on(looks)) {
      state_ = session.go_on();
      if (state_ != Session::State::stopped) continue;
      session.acknowledge();
      state_ = Session::State::running;
    }
  }

  /// Restores an earlier snapshot now and then: the steps that follow must be the same as the first time.
  void rewind(Session& session, Looks& looks) {
    session.outlets().works_long = true;  // the control may execute ahead of the machine
    while (goes_on(looks)) {
      state_ = session.go_on();
      if (state_ == Session::State::running && chance_.one_in(8)) repeat(session, looks);
    }
  }
  void repeat(Session& session, Looks& looks) {
    const auto snapshot = session.snapshot();
    if (!snapshot) return;
    const Looks::Place place = looks.place();
    const std::size_t begin = looks.digest().size(), count = 1 + chance_.below(12);
    for (std::size_t i = 0; i < count && goes_on(looks); ++i) state_ = session.go_on();
    const std::size_t middle = looks.digest().size();
    require(session.restore(*snapshot).has_value(), "a snapshot of the session is restored");
    looks.begin_at(place);
    state_ = Session::State::running;
    for (std::size_t i = 0; i < count && goes_on(looks); ++i) state_ = session.go_on();
    same(looks.digest(), begin, middle, looks.digest(), middle);
  }

  void go_on_in_a_fresh_one(Session& session, Looks& looks) {
    for (std::size_t first = chance_.below(30); first > 0 && goes_on(looks); --first) state_ = session.go_on();
    const auto snapshot = state_ == Session::State::running ? session.snapshot() : std::nullopt;
    const Looks::Place place = looks.place();
    const std::size_t begin = looks.digest().size();
    run(session, looks);
    if (!snapshot) return;
    const std::unique_ptr<Session> fresh = open();
    Looks other(shop_, *fresh);
    require(fresh->restore(*snapshot).has_value(), "a snapshot is restored in a fresh session");
    other.begin_at(place);
    const Session::State ended = std::exchange(state_, Session::State::running);
    calls_ = 0;
    run(*fresh, other);
    same(looks.digest(), begin, looks.digest().size(), other.digest(), 0);
    if (ended == Session::State::ended && state_ == Session::State::ended)
      require(looks.digest().size() - begin == other.digest().size(), "a fresh session goes as far");
  }

  static void same(const std::vector<std::uint64_t>& a, std::size_t begin, std::size_t end, const std::vector<std::uint64_t>& b,
                   std::size_t at) {
    for (; begin < end && at < b.size(); ++begin, ++at) require(a[begin] == b[at], "what comes after a snapshot is what came before");
  }

  void plan(Session& session, Looks& looks) {
    SampleOptions options;
    options.rate = 50;
    options.max_time = 10;
    (void)session.look_ahead();
    Planned& planned = session.plan(session.own(), StopToken(planned_enough_));
    planned.write_samples(shop_.nowhere, options);
    planned.on_cells = [this](const TimedCells& more) { planned_enough_ = (cells_ += more.laws.size()) > max_cells; };
    while (goes_on(looks)) {
      state_ = session.go_on();
      if (state_ == Session::State::running && chance_.one_in(16)) repeat(session, looks);
    }
    if (chance_.one_in(2)) return;
    if (state_ == Session::State::running) state_ = session.stop_here();
    (void)planned.finish();
  }

  void step(Session& session, Looks& looks) {
    looks.goes_on_after_alarm = [this] { return chance_.one_in(2); };
    stop_after_some(session, looks);
    Stepping stepping(session);
    std::optional<Stepping::Memory> saved;
    for (std::size_t i = 0; i < max_commands && !stop_; ++i) {
      state_ = command(session, stepping, saved);
      looks.begin_at({session.control().tool_position(), std::nullopt});
      if (state_ == Session::State::stopped && chance_.one_in(2)) session.acknowledge();
    }
  }
  Session::State command(Session& session, Stepping& stepping, std::optional<Stepping::Memory>& saved) {
    constexpr Stepping::How hows[] = {Stepping::How::block, Stepping::How::over, Stepping::How::out};
    constexpr std::uint64_t max_blocks = 300;
    switch (chance_.below(9)) {
      case 0: return stepping.go_to(some_line(), max_blocks);
      case 1:
        if (!stepping.next()) break;
        return stepping.enter(chance_.piece_of(text_));
      case 2: (void)stepping.value(chance_.piece_of(text_)); break;
      case 3: (void)stepping.holds(chance_.piece_of(text_) + " > " + chance_.piece_of(text_)); break;
      case 4: (void)stepping.add({.line = static_cast<std::uint32_t>(chance_.below(20)), .condition = chance_.piece_of(text_)}); break;
      case 5: saved = stepping.next() ? stepping.snapshot() : std::nullopt; break;
      case 6:
        if (!saved) break;
        require(stepping.restore(*saved).has_value(), "a snapshot of stepping is restored");
        return Session::State::held;
      case 7: (void)session.control().in_force(); break;
      default: break;
    }
    return stepping.go(hows[chance_.below(3)]);
  }
  StopPoint some_line() {
    return {.line = static_cast<std::uint32_t>(1 + chance_.below(20)), .pass = static_cast<std::uint32_t>(chance_.below(3))};
  }

  /// Sets checkpoints, jumps to lines from them, and restarts there.
  void search(Session& session, Looks& looks) {
    if (session.channels().size() > 1) return run(session, looks);
    looks.goes_on_after_alarm = [&looks] { return looks.alarms() < max_alarms; };
    looks.jumps = true;
    stop_after_some(session, looks);
    Checkpoints checkpoints(session, 8, 4);
    state_ = checkpoints.run();
    Stepping stepping(session);
    for (int i = 0; i < 4; ++i) {
      const auto reached = checkpoints.reach(stepping, some_line());
      if (!reached) return;
      state_ = *reached;
      looks.begin_at({session.control().tool_position(), std::nullopt});
      if (state_ != Session::State::held) continue;
      if (const auto restart = restart_here(session, stepping)) write_path(session, *restart);
      state_ = stepping.go(Stepping::How::over);
    }
  }
  static void write_path(const Session& session, const Restart& restart) {
    const ControlDef& def = session.def();
    const auto path = path_there({}, restart, {.clearance = 100, .above = 2, .feed = 100}, session.control().axes().size());
    const auto blocks = restart_blocks(def, restart.in_force, restart.in_force, in_work_coordinates(path, restart, def));
    if (!blocks) return;
    for (const std::string& block : blocks->blocks) require(is_utf8(block) && block.find('\n') == std::string::npos, "a block is a line");
  }

  const Shop& shop_;
  const std::string& text_;
  unsigned switches_;
  Chance chance_;
  RunKind kind_;
  bool has_logic_ = false, has_channels_ = false;
  Session::State state_ = Session::State::running;
  std::size_t calls_ = 0;
  std::size_t cells_ = 0;  // cells received from the planner
  std::atomic<bool> planned_enough_ = false, stop_ = false;
};

}  // namespace

void run_text(const Shop& shop, const std::string& text, unsigned switches, const std::function<void()>& then) {
  Run run(shop, text, switches);
  run.execute(then);
}

int run_control(const char* control, const std::uint8_t* data, std::size_t size) {
  static const Shop shop = Shop::open(control);
  return run_program(shop, data, size);
}

}  // namespace kadr::fuzz
