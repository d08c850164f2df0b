// A program for Grbl from one of its lines on. Used by kadr drive, tested by tests/drive/grbl_restart_test.cpp.

#include "drive/grbl/grbl_restart.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "config/texts.h"
#include "drive/grbl/grbl_words.h"
#include "lang/text/text_spool.h"
#include "texts/drive.h"

namespace kadr::drive {
namespace {

using Kind = InForce::Kind;
using Expected = tl::expected<GrblRestart, std::string>;

/// Returns a number as Grbl reads it: at most three decimals, no exponent.
std::string digits(double value) {
  std::string text = fmt::format("{:.3f}", value + 0.0);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string axis_words(const GrblPoint& point) { return fmt::format("X{}Y{}Z{}", digits(point[0]), digits(point[1]), digits(point[2])); }

/// Returns the program for the run up to the line. A probe motion is a feed there, because it has been executed and where it ended does
/// not matter; the tables that the controller has written are those of its answers.
std::shared_ptr<ByteSource> text_to_run(const std::shared_ptr<ByteSource>& program, const GrblRestartPlan& plan) {
  if (!plan.keeps_offsets) return program;
  TextSpool spool;
  LineReader reader(program);
  Line line;
  std::vector<std::uint32_t> place;
  while (reader.next(line)) {
    place.clear();
    std::string text = filtered(line.bytes, place);
    if (line.number >= plan.line) {
      spool.append(text + "\n");
      continue;
    }
    if (writes_eeprom(text) || has_code(text, 'G', 920) || has_code(text, 'G', 921)) text.clear();
    each_word(std::string(text), [&](char letter, double value, std::size_t begin, std::size_t end) {
      const auto tenths = std::lround(value * 10);
      if (letter == 'G' && tenths >= 382 && tenths <= 385) text.replace(begin, end - begin, "G1" + std::string(end - begin - 2, ' '));
    });
    spool.append(text);
    spool.append("\n");
  }
  return spool.source();
}

/// True for a line without a word that Grbl would execute.
bool is_empty(const std::string& filtered_line) { return filtered_line.empty() || filtered_line == "%"; }

struct Place {
  std::uint32_t line;
  std::uint64_t offset;
  std::string text, filtered;
};

/// Returns the line with this number, or the next one that has words.
std::optional<Place> find_line(const std::shared_ptr<ByteSource>& program, std::uint32_t number) {
  LineReader reader(program);
  Line line;
  std::vector<std::uint32_t> place;
  while (reader.next(line)) {
    if (line.number < number) continue;
    place.clear();
    const std::string text = filtered(line.bytes, place);
    if (!is_empty(text)) return Place{line.number, line.offset, std::string(line.bytes), text};
  }
  return std::nullopt;
}

GrblPoint place_of(const Axes& axes) { return {axes[0], axes[1], axes[2]}; }

class Head {
 public:
  Head(const ControlDef& def, const Restart& restart, const GrblRestartPlan& plan, const GrblSettings& settings)
      : def_(def), restart_(restart), plan_(plan), settings_(settings) {}

  /// Writes the lines. Returns an error sentence, empty if there is none.
  std::string write(const std::string& next_line) {
    lines_.push_back("G21G90G94");
    origin();
    if (std::string why = blocks(Part::spindle_and_coolant, next_line); !why.empty()) return why;
    way();
    return blocks(Part::modes, next_line);
  }
  const std::vector<std::string>& lines() const { return lines_; }
  GrblPoint place() const {
    GrblPoint there = plan_.place ? *plan_.place : place_of(restart_.stand.machine);
    for (std::size_t a = 0; a < grbl_axes; ++a) there[a] += shift(a);
    return there;
  }

 private:
  double value_of(Kind kind, const std::string& axis) const {
    for (const InForce& one : restart_.in_force)
      if (one.kind == kind && one.name == axis) return one.value;
    return 0;
  }
  std::string code_in_force(std::string_view beginning) const {
    for (const InForce& one : restart_.in_force)
      if (one.kind == Kind::code && one.code.starts_with(beginning)) return one.code;
    return {};
  }

  GrblPoint offset(const GrblSettings& settings, const std::string& name) const {
    const auto found = settings.offsets.find(name);
    return found != settings.offsets.end() ? found->second : GrblPoint{};
  }
  /// How far the work zero of an axis was moved since the tool was at the place.
  double shift(std::size_t axis) const {
    if (!plan_.offsets_at_place) return 0;
    const std::string system = code_in_force("G5");
    const GrblSettings& before = *plan_.offsets_at_place;
    return offset(settings_, system)[axis] - offset(before, system)[axis] + offset(settings_, "G92")[axis] - offset(before, "G92")[axis] +
           (axis == 2 ? settings_.tool_length - before.tool_length : 0);
  }

  /// The length that the operator has set by hand since, else that of the program.
  double tool_length() const {
    const bool is_set = plan_.offsets_at_place && plan_.offsets_at_place->tool_length != settings_.tool_length;
    return is_set ? settings_.tool_length : value_of(Kind::length, "Z");
  }

  /// The work system, the tool length and the shift by G92. The controller keeps G54 to G59; the other two are lost by a reset.
  void origin() {
    const std::string system = code_in_force("G5");
    const GrblPoint table = offset(settings_, system);
    if (!system.empty()) lines_.push_back(system);
    const double length = tool_length();
    lines_.push_back(length != 0 ? "G43.1Z" + digits(length) : "G49");
    GrblPoint g92{};
    constexpr const char* axes[] = {"X", "Y", "Z"};
    if (plan_.keeps_offsets) {
      g92 = offset(settings_, "G92");
    } else {
      for (std::size_t a = 0; a < grbl_axes; ++a) g92[a] = value_of(Kind::origin, axes[a]) - table[a];
    }
    constexpr double smallest = 0.0005;  // mm; half of the last digit of an offset
    const bool is_shifted = std::any_of(g92.begin(), g92.end(), [](double s) { return std::fabs(s) > smallest; });
    if (!is_shifted) return lines_.push_back("G92.1");
    GrblPoint work = plan_.from;
    for (std::size_t a = 0; a < grbl_axes; ++a) work[a] -= table[a] + g92[a] + (a == 2 ? length : 0);
    lines_.push_back("G92" + axis_words(work));
  }

  enum class Part : std::uint8_t { spindle_and_coolant, modes };
  static bool belongs_to(Part part, const InForce& one) {
    if (one.kind == Kind::code && one.code.starts_with("M")) return part == Part::spindle_and_coolant;
    const bool is_done = one.code.starts_with("G43") || one.code == "G49" || one.code.starts_with("G5");  // origin()
    if (one.kind == Kind::code) return part == Part::modes && !is_done;
    if (one.kind == Kind::feed) return part == Part::modes;
    const bool is_machine = one.kind == Kind::speed || one.kind == Kind::spindle || one.kind == Kind::coolant;
    return part == Part::spindle_and_coolant && is_machine;
  }

  /// Writes the lines that set a part of the state.
  std::string blocks(Part part, const std::string& next_line) {
    std::vector<InForce> wanted;
    for (const InForce& one : restart_.in_force)
      if (belongs_to(part, one)) wanted.push_back(one);
    auto made = restart_blocks(def_, wanted, wanted, {});
    if (!made) return translated(texts::drive::restart_impossible, plan_.line, "F");
    for (const InForce& one : made->by_hand) {
      const bool moves = one.code == "G2" || one.code == "G3" || one.code.starts_with("G38") || one.code == "G80";
      const bool is_said = moves && says_motion(next_line);
      if (!is_said) return translated(texts::drive::restart_impossible, plan_.line, one.code.empty() ? one.name : one.code);
    }
    bool turns = false;
    with_feed(made->blocks);
    for (std::string& line : made->blocks) {
      line.erase(std::remove(line.begin(), line.end(), ' '), line.end());
      turns = turns || line.starts_with("M3") || line.starts_with("M4");
      if (!line.empty()) lines_.push_back(std::move(line));
    }
    if (turns && plan_.spin_up > 0) lines_.push_back("G4P" + digits(plan_.spin_up));
    return {};
  }

  /// Puts the feed into the line of G1, because Grbl refuses G1 as long as no feed is known (error:22). In G93 each block states its own
  /// feed, so G93 comes after G1 with any feed.
  void with_feed(std::vector<std::string>& lines) const {
    if (const auto inverse = std::find(lines.begin(), lines.end(), "G93"); inverse != lines.end()) {
      lines.erase(inverse);
      for (std::string& line : lines)
        if (line == "G1") line += "F" + digits(plan_.feed);
      return lines.push_back("G93");
    }
    const auto feed = std::find_if(lines.begin(), lines.end(), [](const std::string& line) { return line.starts_with("F"); });
    const auto motion = std::find(lines.begin(), lines.end(), "G1");
    if (feed == lines.end() || motion == lines.end()) return;
    *motion += *feed;
    lines.erase(feed);
  }

  /// True if the line itself states which motion it is.
  static bool says_motion(const std::string& line) {
    bool says = !has_axis_word(line);
    each_word(line, [&](char letter, double value, std::size_t, std::size_t) {
      const auto tenths = std::lround(value * 10);
      says = says || (letter == 'G' && (tenths <= 30 || tenths == 800 || (tenths >= 382 && tenths <= 385)));
    });
    return says;
  }

  /// The way to the place: up, over it, down; the last part at feed.
  void way() {
    Restart there = restart_;
    there.normal = 2;
    ToolPosition from;
    for (std::size_t a = 0; a < grbl_axes; ++a) {
      from.machine[a] = plan_.from[a];
      there.stand.machine[a] = there.stand.work[a] = place()[a];
    }
    for (const WayPoint& point : path_there(from, there, {plan_.clear + std::max(0.0, shift(2)), plan_.above, plan_.feed}, grbl_axes)) {
      std::string line = point.rapid ? "G53G0" : "G53G1";
      for (std::size_t a = 0; a < grbl_axes; ++a)
        if ((point.named >> a & 1U) != 0) line += "XYZ"[a] + digits(point.machine[a]);
      if (!point.rapid) line += "F" + digits(point.feed);
      lines_.push_back(std::move(line));
    }
  }

  const ControlDef& def_;
  const Restart& restart_;
  const GrblRestartPlan& plan_;
  const GrblSettings& settings_;
  std::vector<std::string> lines_;
};

}  // namespace

Expected grbl_restart(const std::shared_ptr<ByteSource>& program, const GrblOpener& open, const GrblSettings& settings,
                      const GrblRestartPlan& plan) {
  const auto place = find_line(program, plan.line);
  if (!place) return tl::unexpected(translated(texts::drive::no_such_line, plan.line));
  GrblRestartPlan to = plan;
  to.line = place->line;
  const auto session = open(text_to_run(program, to));
  if (!session) return tl::unexpected(translated(texts::drive::restart_impossible, plan.line, ""));
  session->outlets().warning = [](const AlarmReport&) {};
  session->outlets().alarm = [](const AlarmReport&) { return false; };
  Stepping stepping(*session);
  StopPoint target;
  target.line = to.line;
  const auto restart = restart_at(*session, stepping, target);
  if (!restart) return tl::unexpected(translated(texts::drive::alarm_before_line, to.line));
  Head head(session->def(), *restart, to, settings);
  if (std::string why = head.write(place->filtered); !why.empty()) return tl::unexpected(std::move(why));
  GrblRestart made;
  made.head = head.lines();
  made.place = head.place();
  made.source = place->text;
  TextSpool spool;
  for (const std::string& line : made.head) spool.append(line + "\n");
  std::string piece(64 << 10, '\0');
  for (std::uint64_t at = place->offset;;) {
    const std::size_t got = program->read(at, piece.data(), piece.size());
    if (got == 0) break;
    spool.append(std::string_view(piece).substr(0, got));
    at += got;
  }
  made.text = {spool.source(), static_cast<std::uint32_t>(made.head.size()), to.line};
  return made;
}

std::shared_ptr<ByteSource> with_tool_stops(const std::shared_ptr<ByteSource>& program, std::vector<std::uint32_t>& lines) {
  TextSpool spool;
  LineReader reader(program);
  Line line;
  std::vector<std::uint32_t> place;
  while (reader.next(line)) {
    std::string source(line.bytes);
    place.clear();
    const std::string text = filtered(line.bytes, place);
    if (has_code(text, 'M', 60)) {
      lines.push_back(line.number);
      if (has_axis_word(text)) return nullptr;  // M0 acts after the motion, a tool change before it
      each_word(text, [&](char letter, double value, std::size_t begin, std::size_t end) {
        if (letter != 'M' || value != 6) return;
        for (std::size_t i = begin + 1; i < end; ++i) source[place[i]] = '0';
      });
    }
    spool.append(source);
    if (line.ended) spool.append("\n");
  }
  return lines.empty() ? program : spool.source();
}

}  // namespace kadr::drive
