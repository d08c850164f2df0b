// Compares the courses (what the machine does, in order of time) of two programs. Used by view/page/page_compare; tested by
// tests/compare/comparison_test.cpp.

#include "compare/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/course_words.h"
#include "compare/path_match.h"
#include "compare/piece_follower.h"
#include "config/machine/machine_codes.h"

namespace kadr {
namespace {

using Kind = CourseDifference::Kind;
constexpr double chord_of_tolerance = 1.0 / 16;
constexpr double same_value = 1e-6;  // relative tolerance of dwell times and of feeds
// Greatest number of items of both courses together that are searched for a position at which both courses do the same again
constexpr std::size_t most_ahead = 3000;
constexpr std::size_t max_sliver = 1000;  // greatest number of successive motions that may stay within the tolerance of a single position
// Greatest number of vertices of each path that are used to measure the distance of a difference.
constexpr std::size_t max_measured = 500;
// Greatest number of long or unsuccessful searches; if two programs need more, the comparison counts them as unrelated
constexpr int max_searches = 200;

bool is_same(double a, double b) { return std::abs(a - b) <= same_value * std::max({1.0, std::abs(a), std::abs(b)}); }

bool is_same(const CourseEvent& a, const CourseEvent& b) { return a.kind == b.kind && a.text == b.text && is_same(a.value, b.value); }

/// Returns the feed in mm/min, for a feed per revolution at the state's spindle speed; 0 with constant surface speed, or if the feed has
/// another unit.
double per_minute(const CourseState& s) {
  if (s.unit == FeedUnit::mm_per_min) return s.feed;
  return s.unit == FeedUnit::mm_per_rev && !s.surface ? s.feed * s.speed : 0;
}

/// True if two feeds are equal apart from the rounding of the F word: their difference is at most half the increment `step` of this word,
/// and at most 1 % of the feed.
bool is_rounded(double a, double b, double step) { return std::abs(a - b) <= std::min(step / 2 + same_value, 0.01 * std::abs(a)); }

/// Returns the first difference between the states a and b, apart from the feed unit; nullopt if the states are equal.
std::optional<Kind> first_difference(const CourseState& a, const CourseState& b, const CompareRules& rules) {
  if (a.move != b.move) return Kind::move;
  const bool at_speed = rules.feeds_at_speed && a.unit != b.unit && per_minute(a) > 0 && is_same(per_minute(a), per_minute(b));
  if (!at_speed && (a.unit != b.unit || !(is_same(a.feed, b.feed) || is_rounded(a.feed, b.feed, rules.feed_step)))) return Kind::feed;
  if (!is_same(a.lead, b.lead)) return Kind::feed;
  if (a.tool != b.tool) return Kind::tool;
  if (a.spindle != b.spindle || a.surface != b.surface || !is_same(a.speed, b.speed) || !is_same(a.most_rpm, b.most_rpm))
    return Kind::spindle;
  if (a.coolant != b.coolant) return Kind::coolant;
  if (!is_same(a.tolerance, b.tolerance) || a.corners != b.corners || a.smoothing != b.smoothing) return Kind::corners;
  return std::nullopt;
}

std::optional<Coolant> coolant_of(const ControlDef& def, std::uint32_t code) {
  const CodeRow* const row = machine_row(def, code);
  if (row == nullptr) return std::nullopt;
  switch (row->function) {
    case Function::coolant_off: return Coolant::off;
    case Function::coolant_mist: return Coolant::mist;
    case Function::coolant_flood: return Coolant::flood;
    default: return std::nullopt;
  }
}

class Comparer {
 public:
  Comparer(Course& a, Course& b, std::size_t axes, const CompareRules& rules)
      : rules_(rules),
        space_(axes),
        course_a_(a),
        course_b_(b),
        a_([&a](ItemRing& to) { a.more(to); }, a.start(), space_),
        b_([&b](ItemRing& to) { b.more(to); }, b.start(), space_),
        follower_(rules.on_piece, space_, rules.tolerance) {
    if (!rules_.on_piece) return;
    a_.on_pass = [this](const CourseItem& item, const Axes& from, const Axes& to) { follower_.take(item, from, to, false); };
    b_.on_pass = [this](const CourseItem& item, const Axes& from, const Axes& to) { follower_.take(item, from, to, true); };
  }

  Comparison all() {
    if (space_.distance(a_.at(), b_.at()) > rules_.tolerance) meet_again();
    while (!out_.lost && !is_enough() && !rules_.stop.requested() &&
           (a_.item(0).kind != CourseItem::Kind::end || b_.item(0).kind != CourseItem::Kind::end))
      go_on();
    if (!out_.lost && !is_enough() && !rules_.stop.requested()) ends();
    out_.cancelled = rules_.stop.requested();
    out_.moves_a = a_.moves(), out_.moves_b = b_.moves();
    out_.stopped_a = course_a_.stopped(), out_.stopped_b = course_b_.stopped();
    name_files(false, course_a_), name_files(true, course_b_);
    out_.zero = course_a_.zero() ? *course_a_.zero() : course_b_.zero().value_or(Vec3{});
    return std::move(out_);
  }

 private:
  using ItemKind = CourseItem::Kind;

  bool is_enough() const { return rules_.first_only && !out_.differences.empty(); }

  void go_on() {
    const ItemKind a = a_.item(0).kind, b = b_.item(0).kind;
    if (a == ItemKind::move && b == ItemKind::move) return move();
    if (a == ItemKind::move && pass_sliver(a_, b_, [&](const CourseItem& next) { return next.kind != ItemKind::move; })) return;
    if (b == ItemKind::move && pass_sliver(b_, a_, [&](const CourseItem& next) { return next.kind != ItemKind::move; })) return;
    if (a == ItemKind::act && b == ItemKind::act && is_same(*a_.item(0).act, *b_.item(0).act)) return act();
    meet_again();
  }

  void name_files(bool of_b, Course& course) {
    const Control& control = course.session().settled_control();
    for (auto& [file, name] : follower_.files(of_b)) name = control.file_name(file);
    (of_b ? out_.files_b : out_.files_a) = follower_.files(of_b);
    (of_b ? out_.read_b : out_.read_a) = control.files_read();
  }

  /// Moves both cursors past an act that occurs in both courses, and compares the states in force during the act.
  void act() {
    if (const auto differs = difference(as_act(a_.item(0).state), as_act(b_.item(0).state)))
      follower_.begin(ComparedPiece::Part::changed, report_state(*differs));
    a_.pass(), b_.pass();
    follower_.end();
  }
  static CourseState as_act(CourseState state) {
    state.move = CourseMove::rapid, state.feed = state.lead = 0, state.unit = FeedUnit::mm_per_min;
    return state;
  }
  std::optional<Kind> difference(const CourseState& a, const CourseState& b) const { return first_difference(a, b, rules_); }

  void move() {
    const CourseState a = a_.item(0).state, b = b_.item(0).state;
    const auto differs = difference(a, b);
    out_.feeds_at_speed = out_.feeds_at_speed || (!differs && a.unit != b.unit);
    out_.feeds_rounded = out_.feeds_rounded || (!differs && a.unit == b.unit && !is_same(a.feed, b.feed));
    if (differs) {
      if (pass_sliver(a_, b_, [&](const CourseItem& next) { return next.kind == ItemKind::move && !difference(next.state, b); })) return;
      if (pass_sliver(b_, a_, [&](const CourseItem& next) { return next.kind == ItemKind::move && !difference(a, next.state); })) return;
    }
    const CourseSpot from_a = spot(a_), from_b = spot(b_);
    const std::string a_value = differs ? words_of_state(a, *differs) : "", b_value = differs ? words_of_state(b, *differs) : "";
    if (differs) follower_.begin_waiting(number_of_next({*differs, {}, {}, {}, {}, 0, {}, {}, a_value, b_value}), a_.at());
    const PathMatch result = match_paths(a_, b_, space_, rules_.tolerance);
    follower_.end(result.reach > rules_.tolerance);
    out_.greatest = std::max(out_.greatest, result.greatest);
    if (differs && result.reach > rules_.tolerance) add({*differs, from_a, from_b, spot(a_), spot(b_), 0, {}, {}, a_value, b_value});
    if (!result.together) meet_again();
  }

  /// Moves the cursor of one course past motions that stay within the tolerance of the other course's position, up to an item for which
  /// `is_sought` is true. Returns false, and moves nothing, if there is no such item.
  template <class Condition>
  bool pass_sliver(CourseCursor& lane, const CourseCursor& other, const Condition& is_sought) {
    for (std::size_t i = 0; i < max_sliver; ++i) {
      const CourseItem& item = lane.item(i);
      if (i > 0 && is_sought(item)) {
        lane.pass(i);
        return true;
      }
      if (item.kind != ItemKind::move || space_.distance(item.to, other.at()) > rules_.tolerance) return false;
    }
    return false;
  }

  /// Adds a difference between the states in force in the two courses, such as feed or spindle.
  ///   returns  the index of the difference in Comparison::differences
  std::size_t report_state(Kind kind) {
    const std::string a_value = words_of_state(a_.item(0).state, kind), b_value = words_of_state(b_.item(0).state, kind);
    const CourseDifference d{kind, spot(a_), spot(b_), spot(a_), spot(b_), 0, {}, {}, a_value, b_value};
    const std::size_t number = number_of_next(d);
    add(d);
    return number;
  }
  /// Compares the ends of both courses, and the states of spindle and coolant there. Program b may switch off at its end what program a
  /// leaves on, because most controls switch spindle and coolant off by themselves. The reverse is a difference: a switches off what b
  /// leaves on.
  void ends() {
    const CourseItem &a = a_.item(0), &b = b_.item(0);
    if (a.fault != b.fault) return ends_differ();
    if (a.fault) return;
    const auto differs = difference(as_act(a.state), as_act(b.state));
    if (!differs) return;
    const bool is_off = b.state.coolant == Coolant::off && b.state.speed == 0;
    if (is_off && !rules_.same_control && !difference(as_act(a.state), as_act(course_b_.before_last_block()))) return;
    (void)report_state(*differs);
  }
  void ends_differ() {
    const auto name = [](const CourseItem& end) { return end.fault ? std::string(name_of(*end.fault)) : std::string("end"); };
    add({Kind::end, spot(a_), spot(b_), spot(a_), spot(b_), 0, {}, {}, name(a_.item(0)), name(b_.item(0))});
  }

  CourseSpot spot(CourseCursor& lane) {
    const CourseItem& item = lane.item(0);
    CourseSpot spot{item.origin.line == 0 ? lane.last_origin() : item.origin, {}, item.begins, lane.at()};
    Course& course = &lane == &a_ ? course_a_ : course_b_;
    if (spot.origin.file != 0) spot.file = course.session().settled_control().file_name(spot.origin.file);
    return spot;
  }

  /// Searches ahead for the nearest position from which both courses do the same, and continues there. Called where the courses differ.
  void meet_again() {
    std::size_t da = 0, db = 0;
    if (rules_.first_only) da = items_ahead(a_), db = items_ahead(b_);
    else if (!search(da, db)) out_.lost = true, da = db = most_ahead;
    CourseDifference d;
    d.a = spot(a_), d.b = spot(b_);
    describe(d, da, db);
    follower_.begin(ComparedPiece::Part::apart, number_of_next(d), d.distance);
    a_.pass(da), b_.pass(db);
    follower_.end();
    d.a_to = spot(a_), d.b_to = spot(b_);
    add(d);
  }

  /// Returns the number of items up to the end of the course, at most max_looked_at. The items are read for this, which shows whether an
  /// alarm ends the course.
  static std::size_t items_ahead(CourseCursor& lane) {
    constexpr std::size_t max_looked_at = 50;
    std::size_t count = 0;
    while (count < max_looked_at && lane.item(count).kind != ItemKind::end) ++count;
    return count;
  }

  bool search(std::size_t& da, std::size_t& db) {
    if (far_searches_ >= max_searches) return false;
    for (const bool strictly : {true, false})
      for (std::size_t sum = 1; sum < most_ahead; ++sum) {
        if (rules_.stop.requested()) return false;
        for (da = 0; da <= sum; ++da) {
          db = sum - da;
          if (is_common(da, db, strictly)) {
            far_searches_ += sum > most_ahead / 10;
            return true;
          }
        }
      }
    ++far_searches_;
    return false;
  }

  bool is_common(std::size_t i, std::size_t j, bool strictly) {
    const CourseItem& a = a_.item(i);
    const CourseItem& b = b_.item(j);
    if (a.kind != b.kind || !is_near(a_.begin(i), b_.begin(j)) || is_after_end(a_, i) || is_after_end(b_, j)) return false;
    if (a.kind == ItemKind::end) return a.fault == b.fault || !strictly;
    if (a.kind == ItemKind::act) return is_same(*a.act, *b.act);
    if (!strictly) return a.state.move == b.state.move && space_.distance(a_.begin(i), a.to) > rules_.tolerance;
    return is_near(a.to, b.to) && !difference(a.state, b.state);
  }
  static bool is_after_end(CourseCursor& lane, std::size_t i) { return i > 0 && lane.item(i - 1).kind == ItemKind::end; }
  bool is_near(const Axes& a, const Axes& b) const {
    return std::abs(a[0] - b[0]) <= rules_.tolerance && space_.distance(a, b) <= rules_.tolerance;
  }

  /// Sets the kind and the texts of the difference: an act that only one course has, or a different path.
  void describe(CourseDifference& d, std::size_t da, std::size_t db) {
    const auto acts = [](CourseCursor& lane, std::size_t count) {
      std::string text;
      bool only = true;
      for (std::size_t i = 0; i < count && i < max_measured; ++i) {
        const CourseItem& item = lane.item(i);
        only = only && item.kind == ItemKind::act;
        if (item.kind == ItemKind::act && text.size() < 100) text += (text.empty() ? "" : " ") + text_of(*item.act);
      }
      return std::pair(text, only);
    };
    const auto [a_value, only_a] = acts(a_, da);
    const auto [b_value, only_b] = acts(b_, db);
    d.a_value = a_value, d.b_value = b_value;
    d.kind = only_a && only_b ? Kind::act : Kind::path;
    if (d.kind != Kind::path) return;
    const Apart of_a = farthest(a_, da, b_, db), of_b = farthest(b_, db, a_, da);
    if (of_a.distance >= of_b.distance) d.distance = of_a.distance, d.a_far = of_a.vertex, d.b_far = of_a.nearest;
    else d.distance = of_b.distance, d.a_far = of_b.nearest, d.b_far = of_b.vertex;
  }

  struct Apart {
    double distance = 0;  // mm
    Axes vertex{}, nearest{};
  };
  /// Returns the vertex, among the first `count` vertices of one course, that is farthest from the path of the other course.
  Apart farthest(CourseCursor& of, std::size_t count, CourseCursor& from, std::size_t pieces) {
    Apart most{0, of.at(), from.at()};
    const std::size_t step = count / max_measured + 1, other_step = pieces / max_measured + 1;
    for (std::size_t i = 0; i < count; i += step) {
      const Axes& at = of.item(i).to;
      Apart least{space_.distance(at, from.at()), at, from.at()};
      for (std::size_t j = 0; j < pieces; j += other_step) {
        const Axes &begin = from.begin(j), &end = from.item(j).to;
        const Axes nearest = space_.between(begin, end, space_.nearest(at, begin, end, {0, 1}));
        if (const double distance = space_.distance(at, nearest); distance < least.distance) least = {distance, at, nearest};
      }
      if (least.distance > most.distance) most = least;
    }
    return most;
  }

  bool continues_last_difference(const CourseDifference& d) const {
    if (out_.differences.empty() || out_.more > 0 || d.kind == Kind::path || d.kind == Kind::act || d.kind == Kind::end) return false;
    const CourseDifference& last = out_.differences.back();
    return last.kind == d.kind && last.a_value == d.a_value && last.b_value == d.b_value;
  }
  std::size_t number_of_next(const CourseDifference& d) const {
    return out_.differences.size() + out_.more - (continues_last_difference(d) ? 1 : 0);
  }
  /// Adds a difference to the result. A difference that begins where the last one ended is joined with it.
  void add(CourseDifference d) {
    if (continues_last_difference(d)) {
      CourseDifference& last = out_.differences.back();
      last.a_to = d.a_to, last.b_to = d.b_to;
    } else if (out_.differences.size() >= rules_.max_reported) ++out_.more;
    else out_.differences.push_back(std::move(d));
  }

  const CompareRules rules_;
  const CourseSpace space_;
  Course &course_a_, &course_b_;
  CourseCursor a_, b_;
  int far_searches_ = 0;
  PieceFollower follower_;
  Comparison out_;
};

/// Makes the M functions of both courses comparable. Each function gets its number on b's control, or becomes the coolant that it switches.
/// A number of a that means another function on b's control gets a number that b does not use.
void match_codes(Course& a, Course& b) {
  using Meaning = Course::CodeMeaning;
  const ControlDef &of_a = a.session().def(), &of_b = b.session().def();
  const MachineCodes codes(of_a, of_b);
  std::map<std::uint32_t, Meaning> means_a, means_b;
  for (const auto& [here, there] : codes.pairs()) {
    const std::optional<Coolant> coolant_a = coolant_of(of_a, here), coolant_b = coolant_of(of_b, there);
    means_a[here] = {coolant_b, there};
    if (coolant_a) means_b[there] = {coolant_a, there};
    if (!coolant_b && !codes.there(there)) means_a[there] = {std::nullopt, there + not_of_b};
  }
  a.read_codes(std::move(means_a)), b.read_codes(std::move(means_b));
}

}  // namespace

std::vector<std::string> common_frame(const Session& a, const Session& b) {
  std::vector<std::string> names = a.control().axes();
  for (const std::string& name : b.control().axes())
    if (std::find(names.begin(), names.end(), name) == names.end() && names.size() < max_axes) names.push_back(name);
  return names;
}

Comparison compare_sessions(std::unique_ptr<Session> a, std::unique_ptr<Session> b, const CompareRules& rules) {
  const std::vector<std::string> frame = common_frame(*a, *b);
  const double chord = rules.chord > 0 ? rules.chord : rules.tolerance * chord_of_tolerance;
  Course course_a(std::move(a), frame, chord, rules.stop), course_b(std::move(b), frame, chord, rules.stop);
  Axes zero{};
  for (std::size_t i = 0; i < frame.size(); ++i)
    if (const auto found = rules.zero_of_b.find(frame[i]); found != rules.zero_of_b.end()) zero[i] = found->second;
  course_b.shift(zero);
  if (!rules.times) course_a.pass_times(), course_b.pass_times();
  course_a.change_items(rules.expected_of_a);
  if (!rules.messages) course_a.pass_messages(), course_b.pass_messages();
  if (rules.same_control) course_a.state_everything(), course_b.state_everything();
  if (rules.tools_by_hand) course_a.change_tools_by_hand(), course_b.change_tools_by_hand();
  const PathModes of_b = path_modes_of(course_b.session().def());
  PathModes modes = path_modes_of(course_a.session().def()) & of_b;
  modes.exact = of_b.exact;  // exact stops are compared whenever b's control has codes for them, even if a's control has none
  course_a.look_at(modes), course_b.look_at(modes);
  match_codes(course_a, course_b);
  Comparison made = Comparer(course_a, course_b, frame.size(), rules).all();
  made.axes = frame;
  made.passed_messages = course_a.passed_messages();
  made.passed_exact_stops = course_a.passed_exact_stops();
  return made;
}

}  // namespace kadr
