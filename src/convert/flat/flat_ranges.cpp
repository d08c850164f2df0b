// Expands ranges of lines into flat blocks. Used by convert/word_by_word; tested by tests/convert.

#include "convert/flat/flat_ranges.h"

#include <algorithm>
#include <utility>

#include "convert/code_match.h"
#include "convert/flat/flat_program.h"
#include "convert/source_setup.h"

namespace kadr {
namespace {

class RangeWriter {
 public:
  RangeWriter(Session& session, const ControlDef& to, std::vector<FlatRange>& places, bool centres, bool straight_on)
      : session_(session),
        control_(session.control()),
        places_(places),
        blocks_(to, [this](std::string_view line) { return has_room_for(line); }),
        flat_(blocks_, flat_source_of(session, to), centres ? FlatForm::centres : FlatForm::places),
        centres_(centres),
        straight_on_(straight_on && !centres) {
    for (const CodeRow& row : session.def().codes)
      if (row.function == Function::incremental || row.function == Function::inch || row.function == Function::exact_stop_mode ||
          row.function == Function::feed_control)
        codes_of_modes_.push_back(&row);
  }

  Result<std::size_t> run(const StopToken& stop) {
    flat_.allow_after_probe();
    control_.return_each_block();
    control_.watch_calls();
    Outlets& outlets = session_.outlets();
    outlets.stop = stop;
    if (centres_) {
      // A compensated motion arrives after later blocks were read, so its block is found by the origin of the action.
      outlets.step = [this](const Step& step) {
        if (step.action.origin.number != number_) begin_block(step.action.origin);
        take(step.action);
      };
    } else {
      outlets.step = [](const Step&) {};
      outlets.programmed = [this](const Action& action) { take(action); };
      control_.holds_before = [this](const Origin& origin) {
        begin_block(origin);
        return false;
      };
    }
    if (const Status begun = flat_.begin(session_.stand(), control_.placement()); !begun) return fail(begun.error());
    // discards the mode codes that FlatProgram::begin() has written, because the rewritten blocks express these modes already
    text_.clear();
    while (!is_over_ && !is_full_ && session_.go_on() == Session::State::running) {
    }
    close();
    if (is_full_) return fail(too_long());
    return std::size_t{number_ + 1};
  }

 private:
  static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

  bool has_room_for(std::string_view line) {
    is_full_ = is_full_ || stored_bytes_ + text_.size() + line.size() > max_made;
    if (!is_full_) text_ += line;
    return !is_full_;
  }

  /// Returns the index of the range that a block belongs to: the range of the line of the main program from which calls led to the block.
  std::size_t place_of(const Origin& origin, std::uint32_t& line, bool& is_own) const {
    if (origin.depth > 0)
      for (const AlarmReport::Call& call : control_.calls_of(origin))
        if (call.file.empty())
          if (const std::size_t found = place_at(call.line); found != nowhere) {
            line = call.line;
            is_own = false;
            return found;
          }
    line = origin.line, is_own = true;
    return origin.file == 0 ? place_at(origin.line) : nowhere;
  }
  std::size_t place_at(std::uint32_t line) const {
    const auto after = std::upper_bound(places_.begin(), places_.end(), line,
                                        [](std::uint32_t at, const FlatRange& place) { return at < place.lines.first; });
    if (after == places_.begin() || !std::prev(after)->lines.holds(line)) return nowhere;
    return static_cast<std::size_t>(std::prev(after) - places_.begin());
  }

  void begin_block(const Origin& origin) {
    if (open_ != nowhere) note(flat_.end_block());
    is_new_ = true, number_ = origin.number;
    std::uint32_t line = 0;
    bool is_own = false;
    const std::size_t place = place_of(origin, line, is_own);
    const bool again = place != nowhere && place == open_ && is_own && places_[place].lines.first == places_[place].lines.last;
    if (place == open_ && !again) return;
    const bool goes_on = open_ != nowhere && place == open_ + 1 && places_[place].follows;
    close(!goes_on);
    if (place != nowhere) open(place, !goes_on);
    else is_over_ = straight_on_ && origin.depth == 0 && origin.file == 0 && origin.line > places_.back().lines.last;
  }

  ///   afresh  true if the block executed before this range is a rewritten block
  void open(std::size_t place, bool afresh) {
    open_ = place;
    text_.clear();
    begun_at_ = flat_.motions();
    if (!afresh) return;
    const FlatBefore before = in_force();
    inch_ = before.inch;
    note(flat_.open(before, offsets_of(control_, session_.def())));
  }
  FlatBefore in_force() const {
    FlatBefore modes;
    // uses only the codes in force, because listing the variables in force too would take long: there may be thousands
    for (const std::string& code : control_.state_now().modal) {
      for (const CodeRow* const row : codes_of_modes_) {
        if (row->code != code) continue;
        modes.incremental = modes.incremental || row->function == Function::incremental;
        modes.inch = modes.inch || row->function == Function::inch;
        modes.exact = modes.exact || row->function == Function::exact_stop_mode;
        if (row->function != Function::feed_control) continue;
        if (row->arg == inner_corners) modes.corners = CornerSpeed::inner_slower;
        if (row->arg == without_slowing) modes.corners = CornerSpeed::kept;
      }
    }
    return modes;
  }

  ///   at_end  true if rewritten blocks follow this range
  void close(bool at_end = true) {
    if (open_ == nowhere) return;
    note(at_end ? close_flat() : flat_.end_block());
    FlatRange& place = places_[open_];
    // A range that has done nothing is not counted as executed: its lines were only skipped, such as a subprogram before its call.
    if (!std::exchange(has_acted_, false)) return void(open_ = nowhere);
    place.probed = place.probed || flat_.has_probed();
    if (place.times++ == 0) place.text = text_, stored_bytes_ += text_.size(), place.motions = flat_.motions() - begun_at_;
    else place.differs = place.differs || place.text != text_;
    text_.clear();
    open_ = nowhere;
  }

  Status close_flat() {
    FlatBefore after = in_force();
    after.inch = inch_;
    return flat_.close(after);
  }

  void take(const Action& action) {
    if (open_ == nowhere) return flat_.pass(action);
    if (std::holds_alternative<FrameChange>(action.what)) flat_.system_changes();
    if (std::exchange(is_new_, false)) now_ = offsets_of(control_, session_.def());
    has_acted_ = true;
    note(flat_.take(action, now_));
  }

  void note(const Status& status) {
    if (status || open_ == nowhere) return;
    if (!places_[open_].cannot) places_[open_].cannot = status.error();
  }

  Session& session_;
  Control& control_;
  std::vector<FlatRange>& places_;
  std::string text_;
  BlockMaker blocks_;
  FlatProgram flat_;
  const bool centres_, straight_on_;
  // rows of those codes that set the modes in FlatBefore: incremental, inch, exact stop, corner mode
  std::vector<const CodeRow*> codes_of_modes_;
  OffsetsInForce now_;
  std::uint32_t number_ = ~std::uint32_t{0};  // sequence number of the block in the run
  std::size_t stored_bytes_ = 0;              // size in bytes of the texts of all ranges so far
  std::size_t open_ = nowhere, begun_at_ = 0;
  bool is_new_ = true, has_acted_ = false, inch_ = false, is_over_ = false, is_full_ = false;
};

}  // namespace

Result<std::size_t> write_flat_ranges(Session& source, const ControlDef& to, std::vector<FlatRange>& places, bool centres, bool straight_on,
                                      const StopToken& stop) {
  return RangeWriter(source, to, places, centres, straight_on).run(stop);
}

}  // namespace kadr
