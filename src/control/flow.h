#pragma once
// Where the program is: readers, call stack, repetitions, jumps; and when it runs away.

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "control/control.h"
#include "control/state.h"
#include "lang/block_reader.h"

namespace kadr {

/// A call or repetition that is open.
struct CallFrame {
  enum class Kind : std::uint8_t { subprogram, cycle_body, repetition };
  Kind kind = Kind::subprogram;
  Position start;           // first block of its body
  Position back;            // where the caller goes on
  std::uint8_t reader = 0;  // of the body: 0 the program, 1 the cycle bodies
  std::uint8_t back_reader = 0;
  std::uint32_t name = 0;  // subprogram number
  std::uint32_t left = 0;  // passes still to do, this one included
  bool repeating = false;  // beyond its first pass
  Origin caller;
  std::uint8_t work_zero = 0;  // of the caller (2С42: comes back)
  Axes zero_shift{};
  std::int16_t zero_row = -1;
  std::array<std::int16_t, 3> then{-1, -1, -1};  // rows of the calling block carried out on return: M17, M20, M2
};

class Flow {
 public:
  Flow(const ControlDef& def, Program program, RunLimits limits);

  /// The next block to carry out, or the end of the program.
  Result<BlockReader::Got> next(Block& block);

  // ---- jumps
  /// Calls open and where reading goes on: what a faulty block may have changed.
  struct Place {
    std::vector<CallFrame> frames;
    Position position;
    std::uint8_t reader = 0;
    std::uint32_t restarts = 0;
    bool ended = false;
  };
  Place place() const { return {frames_, position(), reader_, restarts_, ended_}; }
  void back_to(const Place& place);
  /// alarms  subprogram_missing, label_twice, call_too_deep
  Status call(std::uint32_t subprogram, std::uint32_t times, const Origin& caller, Span where);
  Status call_body(const CycleRow& cycle, std::uint32_t times, const Origin& caller, Span where);
  Status repeat(std::uint32_t times, const Origin& caller, Span where);
  /// End of a subprogram: once more, or back to the caller; the frame left, if it was left.
  ///   alarms  return_without_call, repeat_end_missing
  Result<std::optional<CallFrame>> end_subprogram(Span where);
  Status end_repetition(Span where);
  /// From the first block again. alarms endless_program
  Status restart(Span where);
  void end() { ended_ = true; }
  /// The main program runs over this label (its own name, or into a subprogram): it counts as called.
  void pass_label(std::uint32_t label) {
    if (passed_.size() < 1000) passed_.insert(label);
  }

  bool ended() const { return ended_; }
  /// Leaves the innermost call or repetition whose end was not found; in a repetition to go on at `again`.
  void abandon(std::optional<Position> again);
  std::string shown(std::string_view text, Span& place) const {
    return visiting_ ? elsewhere_->shown(text, place) : reader_ == 0 ? program_.shown(text, place) : std::string(text);
  }
  bool in_body() const { return reader_ == 1; }
  std::size_t depth() const { return frames_.size(); }
  const std::vector<CallFrame>& frames() const { return frames_; }
  std::vector<CallFrame>& frames() { return frames_; }
  const std::string& file() const { return file_; }
  std::uint64_t blocks() const { return blocks_; }
  std::uint64_t bytes_read() const { return program_.offset(); }
  std::uint64_t bytes() const { return program_.size(); }
  const BlockReader& program() const { return program_; }
  /// Position behind the block just read.
  Position position() const { return reader_ == 0 ? program_.position() : bodies_->position(); }

  /// Blocks of the subprograms that were never called, in the file's order.
  void each_uncalled(const std::function<void(Result<BlockReader::Got>, const Block&)>& visit);

  static std::string name_of(const ControlDef& def, const CallFrame& frame);

  /// A block that begins with '%' has been seen.
  bool started = false;

 private:
  struct Label {
    Position position;
    bool twice = false;
    bool called = false;
  };
  Status push(CallFrame frame, Span where);
  Status count_repeated(const Block& last);
  void make_index();
  BlockReader& elsewhere();
  void go_to(std::uint8_t reader, Position position);

  const ControlDef& def_;
  std::string file_;
  RunLimits limits_;
  std::shared_ptr<ByteSource> source_;
  BlockReader program_;
  std::unique_ptr<BlockReader> elsewhere_;  // reads the file in other places: the block in hand keeps its text
  Grammar body_grammar_;
  std::unique_ptr<BlockReader> bodies_;
  std::map<std::string, Position> body_starts_;
  std::uint8_t reader_ = 0;
  std::vector<CallFrame> frames_;
  std::map<std::uint32_t, Label> labels_;
  std::set<std::uint32_t> passed_;
  bool indexed_ = false;
  bool visiting_ = false;  // each_uncalled is at work
  bool ended_ = false;
  std::uint32_t restarts_ = 0;
  std::uint64_t blocks_ = 0;
  std::uint64_t repeated_ = 0;
};

}  // namespace kadr
