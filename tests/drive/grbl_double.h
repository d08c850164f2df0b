#pragma once
// GrblDouble: a controller that behaves as Grbl 1.1h does on its serial line, for tests. It is our own program; what it does follows these
// files of Grbl, by rule:
//   serial.c    real-time characters are taken out of the stream; a byte that finds the receive buffer full is dropped without a sign
//   protocol.c  one line at a time; real-time commands act between lines; in a hold no line is executed; auto cycle start
//   system.c    `$` lines; `$X`; error:8, error:9 by state
//   gcode.c     words and modes, as far as tests need them; all other words are error:20
//   planner.c   15 usable blocks; a line waits while they are full
//   report.c    answers, status reports, banner
//   eeprom.c    while a value is written, receive interrupts are off and bytes are lost
// Motion is even: a block takes its length divided by its feed, and a hold stops within 50 ms. Tests of times use planner_twin.h instead.

#include <fmt/core.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kadr::drive::test {

using Point = std::array<double, 3>;

class GrblDouble {
 public:
  static constexpr double tick = 0.001;  // s
  static constexpr std::size_t planner_blocks = 15, longest_line = 80;

  GrblDouble() { banner(); }

  // ---- what a test sees
  double now = 0;
  Point position{};                             // machine position, mm
  std::vector<std::string> executed;            // every line of G-code that was accepted, in order
  std::vector<std::string> checked;             // every line that was read in check mode
  bool written_in_check = false;                // the EEPROM was written in check mode
  double tool_length = 0;                       // G43.1, mm
  std::vector<std::string> states;              // the states that were reported
  std::size_t dropped = 0;                      // bytes that found the receive buffer full, or came while the EEPROM was written
  std::size_t starts = 0;                       // how often the axes began to move
  double moved_at = -1;                         // when the axes last moved
  std::map<std::string, Point> offsets;         // work offsets by name, G54 …
  std::size_t receive_size = 128;               // bytes of the receive buffer, one of which is never used
  int feed_percent = 100, rapid_percent = 100;  // overrides
  bool spindle = false;
  bool probe_touches = true;
  double probe_part = 1;         // the part of a probe motion after which it touches
  double line_seconds = 0.0024;  // time for one line: 419 lines/s, measured on grbl-sim
  std::map<int, double> settings = {{0, 10},    {1, 25},    {2, 0},      {3, 0},     {4, 0},      {5, 0},      {6, 0},
                                    {10, 3},    {11, 0.01}, {12, 0.002}, {13, 0},    {20, 0},     {21, 0},     {22, 0},
                                    {23, 0},    {24, 25},   {25, 500},   {26, 250},  {27, 1},     {30, 1000},  {31, 0},
                                    {32, 0},    {100, 250}, {101, 250},  {102, 250}, {110, 3000}, {111, 3000}, {112, 1000},
                                    {120, 200}, {121, 200}, {122, 100},  {130, 300}, {131, 200},  {132, 100}};

  /// Returns the state as a report has it: "Idle", "Hold:0".
  std::string state_text() const {
    switch (state_) {
      case State::idle: return "Idle";
      case State::run: return "Run";
      case State::hold: return speed_share_ > 0 ? "Hold:1" : "Hold:0";
      case State::alarm: return "Alarm";
      case State::home: return "Home";
      case State::jog: return "Jog";
      case State::door: return speed_share_ > 0 ? "Door:2" : "Door:0";
      case State::check: return "Check";
    }
    return "";
  }
  bool moves() const { return is_moving(); }
  /// True if nothing moves and no line waits. A byte that was changed on the way may lie in the line buffer.
  bool is_idle() const { return state_ == State::idle && blocks_.empty() && !waiting_; }

  // ---- what the world does to it
  /// A byte comes over the serial line.
  void receive(char byte) {
    switch (static_cast<unsigned char>(byte)) {
      case '?': wants_report_ = true; return;
      case '!': wants_hold_ = true; return;
      case '~': wants_start_ = true; return;
      case 0x18: wants_reset_ = true; return;
      case 0x84: wants_door_ = true; return;
      case 0x85: cancels_jog_ = true; return;
      case 0x90: feed_percent = 100; return;
      case 0x91: feed_percent = std::min(feed_percent + 10, 200); return;
      case 0x92: feed_percent = std::max(feed_percent - 10, 10); return;
      case 0x93: feed_percent = std::min(feed_percent + 1, 200); return;
      case 0x94: feed_percent = std::max(feed_percent - 1, 10); return;
      case 0x95: rapid_percent = 100; return;
      case 0x96: rapid_percent = 50; return;
      case 0x97: rapid_percent = 25; return;
      default: break;
    }
    if (static_cast<unsigned char>(byte) > 0x7f) return;  // overrides of the spindle and coolant, which this double does not have
    if (receive_.size() + 1 >= receive_size || now < eeprom_until_) {
      ++dropped;
      return;
    }
    receive_ += byte;
  }
  void hard_limit() {
    output_ += "ALARM:1\r\n[MSG:Reset to continue]\r\n";
    blocks_.clear();
    state_ = State::alarm;
    is_dead_ = true;
  }
  void power_cycle() {
    clear();
    state_ = State::idle;
    banner();
  }
  void open_door() { wants_door_ = true; }

  std::string take_output() { return std::exchange(output_, {}); }

  /// Lets one tick pass.
  void advance() {
    now += tick;
    if (wants_reset_) reset();
    if (is_dead_) return;
    if (std::exchange(wants_report_, false)) report();
    real_time();
    move();
    if (state_ != State::hold && state_ != State::door) work();
    start_cycle();
  }

 private:
  enum class State : std::uint8_t { idle, run, hold, alarm, home, jog, door, check };
  struct PlannedBlock {
    Point to;
    double speed;  // mm/s
    bool is_rapid = false, is_probe = false;
  };

  bool is_moving() const {
    return !blocks_.empty() &&
           (state_ == State::run || state_ == State::jog || ((state_ == State::hold || state_ == State::door) && speed_share_ > 0));
  }
  void banner() { output_ += "\r\nGrbl 1.1h ['$' for help]\r\n"; }
  void clear() {
    receive_.clear();
    line_.clear();
    waiting_.reset();
    blocks_.clear();
    is_dead_ = writes_ = is_probing_ = wants_report_ = wants_hold_ = wants_start_ = wants_reset_ = wants_door_ = cancels_jog_ = false;
    spindle = false;
    tool_length = 0;
    offsets["G92"] = {};
    system_ = "G54";
    motion_ = 0;
    is_incremental_ = false;
    is_inch_ = false;
    feed_ = 0;
    planned_ = position;
    dwell_until_ = busy_until_ = eeprom_until_ = 0;
    speed_share_ = 1;
  }
  void reset() {
    const bool in_motion = state_ == State::run || state_ == State::jog || state_ == State::home ||
                           ((state_ == State::hold || state_ == State::door) && speed_share_ > 0 && !blocks_.empty());
    const bool locks = in_motion || state_ == State::alarm;
    if (in_motion) output_ += "ALARM:3\r\n";
    clear();
    state_ = locks ? State::alarm : State::idle;
    banner();
    if (locks) output_ += "[MSG:'$H'|'$X' to unlock]\r\n";
  }
  void real_time() {
    if (std::exchange(cancels_jog_, false) && state_ == State::jog) {
      blocks_.clear();
      planned_ = position;
      state_ = State::idle;
    }
    const bool may_hold = state_ == State::idle || state_ == State::run || state_ == State::jog;
    if (std::exchange(wants_hold_, false) && may_hold) stand(State::hold);
    if (std::exchange(wants_door_, false) && (may_hold || state_ == State::hold)) stand(State::door);
    if (std::exchange(wants_start_, false) && (state_ == State::hold || state_ == State::door) && speed_share_ <= 0) {
      speed_share_ = 1;
      state_ = blocks_.empty() ? State::idle : State::run;
      if (!blocks_.empty()) ++starts;
    }
  }
  void stand(State state) {
    if (state_ == State::idle || blocks_.empty()) speed_share_ = 0;
    state_ = state;
  }
  void move() {
    if (state_ == State::hold || state_ == State::door) speed_share_ = std::max(0.0, speed_share_ - tick / 0.05);
    if (!is_moving()) return;
    double left = tick * speed_share_;
    while (left > 0 && !blocks_.empty()) {
      PlannedBlock& block = blocks_.front();
      double length = 0;
      for (std::size_t i = 0; i < 3; ++i) length = std::hypot(length, block.to[i] - position[i]);
      const double need = length / (block.speed * (block.is_rapid ? rapid_percent : feed_percent) / 100);
      const double part = need > left ? left / need : 1;
      for (std::size_t i = 0; i < 3; ++i) position[i] = part < 1 ? position[i] + (block.to[i] - position[i]) * part : block.to[i];
      if (length > 0) moved_at = now;
      left -= std::min(need, left);
      if (part < 1) return;
      if (block.is_probe) probed();
      blocks_.pop_front();
    }
    if (blocks_.empty() && (state_ == State::run || state_ == State::jog)) state_ = State::idle;
  }
  /// mc_probe_cycle: the motion ends where the probe touches; without a contact ALARM:5 locks the controller.
  void probed() {
    planned_ = position;
    if (!probe_touches) {
      output_ += "ALARM:5\r\n";
      state_ = State::alarm;
    }
    output_ += fmt::format("[PRB:{:.3f},{:.3f},{:.3f}:{}]\r\n", position[0], position[1], position[2], probe_touches ? 1 : 0);
  }
  void start_cycle() {
    if (state_ != State::idle || blocks_.empty()) return;
    state_ = State::run;
    speed_share_ = 1;
    ++starts;
  }

  // ---- lines
  void work() {
    if (now < busy_until_ || now < eeprom_until_) return;
    if (state_ == State::home) {
      position = planned_ = {};
      state_ = State::idle;
      output_ += "ok\r\n";
    }
    if (now < dwell_until_) return;
    if (dwell_until_ > 0) {
      dwell_until_ = 0;
      output_ += "ok\r\n";
      waiting_.reset();
    }
    if (waiting_) return perform(std::string(*waiting_));
    if (writes_) {
      writes_ = false;
      return answer();
    }
    while (!receive_.empty() && now >= busy_until_ && !waiting_ && !writes_ && state_ != State::hold && state_ != State::home) {
      const char byte = receive_.front();
      receive_.erase(receive_.begin());
      if (byte == '\n' || byte == '\r') {
        const std::string text = std::exchange(line_, {});
        busy_until_ = now + line_seconds;
        if (std::exchange(is_long_, false)) output_ += "error:11\r\n";
        else perform(text);
        continue;
      }
      if (line_.size() + 1 >= longest_line) is_long_ = true;
      else if (byte > ' ') line_ += static_cast<char>(std::toupper(byte));
    }
  }
  void answer(int error = 0) {
    output_ += error == 0 ? "ok\r\n" : fmt::format("error:{}\r\n", error);
    waiting_.reset();
  }
  void perform(const std::string& text) {
    if (text.empty()) return answer();
    if (text.front() == '$') return system_line(text);
    if ((state_ == State::alarm && !is_probing_) || state_ == State::jog) return answer(9);
    code_line(text);
  }
  void system_line(const std::string& text) {
    const bool rests = state_ == State::idle || state_ == State::alarm || state_ == State::check;
    if (text == "$I") output_ += fmt::format("[VER:1.1h.20190830:]\r\n[OPT:V,{},{}]\r\n", planner_blocks, receive_size);
    else if (text == "$$" && rests)
      for (const auto& [number, value] : settings) output_ += fmt::format("${}={:.3f}\r\n", number, value);
    else if (text == "$#") {
      for (const char* const name : {"G54", "G55", "G56", "G57", "G58", "G59", "G28", "G30", "G92"})
        output_ += fmt::format("[{}:{:.3f},{:.3f},{:.3f}]\r\n", name, offsets[name][0], offsets[name][1], offsets[name][2]);
      output_ += fmt::format("[TLO:{:.3f}]\r\n", tool_length);
    } else if (text == "$C" && (state_ == State::idle || state_ == State::check)) {
      if (state_ == State::check) wants_reset_ = true;  // mc_reset
      state_ = State::check;
    } else if (text == "$G") output_ += "[GC:G0 G54 G17 G21 G90 G94 M5 M9 T0 F0 S0]\r\n";
    else if (text == "$X" && rests) {
      if (state_ == State::alarm) output_ += "[MSG:Caution: Unlocked]\r\n";
      state_ = State::idle;
    } else if (text == "$H" && rests && settings[22] != 0) {
      state_ = State::home;
      busy_until_ = now + 1;
      return;
    } else if (text.starts_with("$J=") && (state_ == State::idle || state_ == State::jog)) {
      const int error = plan(text.substr(3), true);
      if (error == 0 && state_ == State::idle) {
        state_ = State::jog;
        speed_share_ = 1;
        ++starts;
      }
      return answer(error);
    } else return answer(rests ? 3 : 8);
    answer();
  }
  /// Check mode: a line is only read.
  void check(const std::string& text) {
    checked.push_back(text);
    if (text.starts_with("G10")) written_in_check = true;  // settings_write_coord_data is called in this mode too
    const bool only_read = text.starts_with("G4P") || text.starts_with("G10") || (text.starts_with("M") && !text.starts_with("M6"));
    const std::string probe = text.starts_with("G38.2") ? text.substr(5) : text;
    const int error = only_read || text.starts_with("G92") || text.starts_with("G49") || text.starts_with("G43.1") ? 0 : plan(probe, false);
    blocks_.clear();
    answer(error);
  }
  static std::optional<double> number_after(const std::string& text, char letter) {
    const std::size_t at = text.find(letter);
    return at == std::string::npos ? std::nullopt : std::optional(std::atof(text.c_str() + at + 1));
  }
  double shift(std::size_t axis) { return offsets[system_][axis] + offsets["G92"][axis] + (axis == 2 ? tool_length : 0); }
  /// G92, G92.1, G43.1, G49. Returns false if the line is none of them.
  bool offset_line(const std::string& text) {
    if (text.starts_with("G92.1")) offsets["G92"] = {};
    else if (text.starts_with("G92"))
      for (std::size_t a = 0; a < 3; ++a) {
        const auto value = number_after(text, "XYZ"[a]);
        if (value) offsets["G92"][a] += planned_[a] - shift(a) - *value;
      }
    else if (text.starts_with("G43.1")) tool_length = number_after(text, 'Z').value_or(0);
    else if (text.starts_with("G49")) tool_length = 0;
    else return false;
    executed.push_back(text);
    answer();
    return true;
  }
  /// G10 L20 P1 sets G54 so that the position has the stated coordinates, G10 L2 P1 sets it to the values.
  void write_offset(const std::string& text) {
    if (!text.starts_with("G10L2")) return;
    Point& table = offsets[fmt::format("G{}", 53 + static_cast<int>(number_after(text, 'P').value_or(1)))];
    for (std::size_t a = 0; a < 3; ++a)
      if (const auto value = number_after(text, "XYZ"[a]))
        table[a] = text.starts_with("G10L20") ? planned_[a] - *value - offsets["G92"][a] - (a == 2 ? tool_length : 0) : *value;
  }
  void code_line(const std::string& text) {
    if (state_ == State::check) return check(text);
    if (offset_line(text)) return;
    const bool is_dwell = text.starts_with("G4P");
    const bool is_probe = text.starts_with("G38.2");
    const bool writes = text.starts_with("G10") || text.starts_with("G28.1");
    const bool stops = text == "M0" || text == "M30" || text == "M2";
    const bool waits_for_rest = is_dwell || is_probe || writes || stops || text.starts_with("M3") || text.starts_with("M5");
    if (waits_for_rest && (!blocks_.empty() || state_ == State::run)) {
      waiting_ = text;
      return;
    }
    if (blocks_.size() >= planner_blocks) {
      waiting_ = text;
      return;
    }
    if (is_probe && std::exchange(is_probing_, !is_probing_)) {  // the second time: the motion is done
      executed.push_back(text);
      return answer();
    }
    if (is_dwell) {
      dwell_until_ = now + std::atof(text.c_str() + 3);
      waiting_ = text;
      executed.push_back(text);
      return;
    }
    if (writes) {
      write_offset(text);
      eeprom_until_ = now + 0.02;
      writes_ = true;
      waiting_.reset();
      executed.push_back(text);
      return;
    }
    if (text.starts_with("M") && !stops) {
      spindle = text.starts_with("M3") || text.starts_with("M4") || (spindle && !text.starts_with("M5"));
      if (text.starts_with("M6")) return answer(20);
      executed.push_back(text);
      return answer();
    }
    if (stops) {
      if (text == "M0") stand(State::hold);
      executed.push_back(text);
      return answer();
    }
    if (is_probe) {
      waiting_ = text;
      const Point from = planned_;
      if (plan(text.substr(5), false) != 0 || blocks_.empty()) return;
      PlannedBlock& block = blocks_.back();
      block.is_probe = true;
      if (probe_touches)
        for (std::size_t i = 0; i < 3; ++i) block.to[i] = from[i] + (block.to[i] - from[i]) * probe_part;
      return;
    }
    const int error = plan(text, false);
    if (error == 0) executed.push_back(text);
    answer(error);
  }
  /// Reads the words of a line and plans its motion. Returns the number of the error.
  int plan(const std::string& text, bool is_jog) {
    Point to = planned_;
    double i = 0, j = 0, feed = feed_;
    int motion = motion_;
    bool has_axis = false, is_incremental = is_incremental_, is_machine = false;
    for (std::size_t at = 0; at < text.size();) {
      const char letter = text[at++];
      double value = 0;
      const char* const begin = text.c_str() + at + (text[at] == '+' ? 1 : 0);
      const auto [end, wrong] = std::from_chars(begin, text.c_str() + text.size(), value, std::chars_format::fixed);
      if (wrong != std::errc()) return 2;
      at = static_cast<std::size_t>(end - text.c_str());
      const double length = is_inch_ ? value * 25.4 : value;
      switch (letter) {
        case 'N':
        case 'S':
        case 'T': break;
        case 'F': feed = length; break;
        case 'X':
        case 'Y':
        case 'Z': {
          const auto axis = static_cast<std::size_t>(letter - 'X');
          to[axis] = is_incremental ? planned_[axis] + length : is_machine ? length : length + shift(axis);
          has_axis = true;
          break;
        }
        case 'I': i = length; break;
        case 'J': j = length; break;
        case 'G':
          if (value == 90) is_incremental = false;
          else if (value == 91) is_incremental = true;
          else if (value == 20 || value == 21) is_inch_ = value == 20;
          else if (value == 53) is_machine = true;
          else if (value >= 54 && value <= 59) system_ = fmt::format("G{:g}", value);
          else if (value >= 0 && value <= 3) motion = static_cast<int>(value);
          else if (value != 17 && value != 94 && value != 91.1 && value != 61 && value != 40 && value != 49 && value != 80) return 20;
          break;
        case 'M':
          if (value != 3 && value != 4 && value != 5 && value != 8 && value != 9) return 20;
          spindle = value == 3 || value == 4 || (spindle && value != 5);
          break;
        default: return 20;
      }
    }
    if (has_axis && (motion != 0 || is_jog) && feed <= 0) return 22;
    if (!is_jog) {
      motion_ = motion;
      feed_ = feed;
      is_incremental_ = is_incremental;
    }
    if (!has_axis && i == 0 && j == 0) return 0;
    const double speed = (motion == 0 && !is_jog ? settings[110] : std::min(feed, settings[110])) / 60;
    if (motion >= 2) add_arc(to, i, j, motion == 2, speed);
    if (to != planned_) blocks_.push_back({to, speed, motion == 0 && !is_jog});
    planned_ = to;
    return 0;
  }
  void add_arc(const Point& to, double i, double j, bool clockwise, double speed) {
    const double cx = planned_[0] + i, cy = planned_[1] + j, radius = std::hypot(i, j);
    double sweep = std::atan2(to[1] - cy, to[0] - cx) - std::atan2(-j, -i);
    if (clockwise && sweep >= -1e-6) sweep -= 2 * M_PI;
    if (!clockwise && sweep <= 1e-6) sweep += 2 * M_PI;
    const auto pieces = static_cast<int>(std::fabs(0.5 * sweep * radius) / std::sqrt(0.002 * (2 * radius - 0.002)));
    const double begin = std::atan2(-j, -i), z = planned_[2];
    for (int n = 1; n < pieces; ++n) {
      const double part = double(n) / pieces, angle = begin + sweep * part;
      blocks_.push_back({{cx + radius * std::cos(angle), cy + radius * std::sin(angle), z + (to[2] - z) * part}, speed});
    }
  }
  void report() {
    states.push_back(state_text());
    const auto used = std::min(blocks_.size(), planner_blocks);
    output_ += fmt::format("<{}|MPos:{:.3f},{:.3f},{:.3f}|Bf:{},{}|FS:{:.0f},0", states.back(), position[0] + 0.0, position[1] + 0.0,
                           position[2] + 0.0, planner_blocks - used, receive_size - receive_.size(),
                           is_moving() ? blocks_.front().speed * 60 : 0.0);
    if (++reports_ % 10 == 1) output_ += "|WCO:0.000,0.000,0.000";
    else if (reports_ % 10 == 2) output_ += fmt::format("|Ov:{},{},100", feed_percent, rapid_percent);
    output_ += ">\r\n";
  }

  State state_ = State::idle;
  std::string receive_, line_, output_;
  bool is_long_ = false, is_dead_ = false, writes_ = false, is_probing_ = false;
  bool wants_report_ = false, wants_hold_ = false, wants_start_ = false, wants_reset_ = false, wants_door_ = false, cancels_jog_ = false;
  std::optional<std::string> waiting_;  // a line that waits for space in the planner, or for the end of the motion
  std::deque<PlannedBlock> blocks_;
  Point planned_{};
  std::string system_ = "G54";
  int motion_ = 0, reports_ = 0;
  bool is_incremental_ = false, is_inch_ = false;
  double feed_ = 0, speed_share_ = 1;
  double dwell_until_ = 0, busy_until_ = 0, eeprom_until_ = 0;
};

}  // namespace kadr::drive::test
