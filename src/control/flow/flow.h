#pragma once
// Flow: the course of the program: readers, call stack, repetitions, jumps, and the limit for a program that never ends.

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "config/control/control_def.h"
#include "control/flow/program_file.h"
#include "control/state/control_state.h"
#include "control/state/run_limits.h"
#include "lang/block/block_reader.h"

namespace kadr {

/// An open call or repetition.
struct CallFrame {
  enum class Kind : std::uint8_t { subprogram, cycle_body, repetition, macro, interrupt };
  Kind kind = Kind::subprogram;
  Position start;            // first block of its body
  Position back;             // where the caller continues
  std::uint16_t reader = 0;  // file that contains the body: 0 the program, 1 the cycle bodies, then other files
  std::uint16_t back_reader = 0;
  std::uint32_t name = 0;  // subprogram number
  std::uint32_t left = 0;  // remaining passes, including this one
  std::uint32_t done = 0;  // passes started
  bool repeating = false;  // true from the second pass on
  Origin caller;
  std::uint16_t work_zero = 0;  // work offset of the caller (2С42: restored on return)
  Axes zero_shift{};
  std::int16_t work_offset_row = -1;
  std::array<std::int16_t, 3> then{-1, -1, -1};  // code rows of the calling block that are executed on return: M17, M20, M2
  // nct
  std::uint8_t modal_calls = 0;   // number of modal macro calls in force in the caller (23.3.2)
  bool opened_level = false;      // an interrupt macro with its own local variables
  std::int32_t return_to = -1;    // M99 P: number of the caller's block to return to
  char called_by = 0;             // address of the calling word: inside the call this word does not call again (23.3.4–23.3.8)
  std::int32_t called_code = -1;  // … and the number of its code
};

class Flow {
 public:
  Flow(const ControlDef& def, Program program, RunLimits limits);

  /// Reads the next block to execute, or finds the end of the program.
  Result<BlockReader::Got> next(Block*& block);

  // ---- a block that is read but not executed yet
  /// The state of reading before a block, to return to it.
  struct Mark {
    Position position;
    BlockReader::Memory memory;
    std::uint64_t blocks = 0, repeated = 0;
    bool ended = false;
  };
  Mark mark() const;
  /// Restores the state that `before` recorded, so that the block is read again.
  void unread(const Mark& before);

  // ---- a line entered by the operator (MDI)
  /// Makes this line the next block; after it reading continues where it was.
  void enter(std::string line);
  /// True while the line is being executed.
  bool in_entered() const { return now_.entered.on; }
  /// Number of calls that were open when the line was entered.
  std::size_t entered_depth() const { return now_.entered.depth; }
  /// Returns from the entered line to the program. Returns false if no line was entered.
  bool leave_entered();

  // ---- snapshot
  struct Entered {
    bool on = false;
    bool ended = false, started = false;  // state of the program before the line was entered
    std::uint16_t reader = 0;             // 0: no line has been entered yet
    std::uint16_t back_reader = 0;
    Position back;
    std::size_t depth = 0;
    std::string line;
  };
  /// The part of the state that remains from one block to the next.
  struct Counts {
    std::uint16_t reader = 0;
    std::vector<CallFrame> frames;
    CallFrame left;  // the frame that was closed last
    std::set<std::uint32_t> passed;
    bool ended = false;
    bool jumped_back = false;
    std::uint32_t restarts = 0;
    std::uint64_t blocks = 0;
    std::uint64_t repeated = 0;
    bool started = false;  // a block that begins with '%' has been seen
    Entered entered;
  };
  struct File {
    std::string name;  // path of the file; for a built-in program its name
    bool built_in = false;
    ProgramFile::Memory memory;
  };
  struct Memory {
    Counts now;
    Position position;
    std::vector<File> files;            // [0] the program, then by reader number; [1] is unused
    std::vector<std::uint32_t> called;  // numbers of the program's subprograms that were called
  };
  Memory memory() const;
  /// Continues from the state stored in `memory`.
  ///   alarms  file_missing: a file that had been called is missing now; nothing has changed
  Status resume_from(const Memory& memory);

  // ---- jumps
  /// Open calls and the position in the program: these a faulty block may have changed.
  struct Place {
    std::vector<CallFrame> frames;
    Position position;
    std::uint16_t reader = 0;
    std::uint32_t restarts = 0;
    bool ended = false;
  };
  Place place() const { return {now_.frames, position(), now_.reader, now_.restarts, now_.ended}; }
  void back_to(const Place& place);
  /// alarms  subprogram_missing, label_twice, call_too_deep
  Status call(std::uint32_t subprogram, std::uint32_t times, const Origin& caller, Span where);
  Status call_body(const CycleRow& cycle, std::uint32_t times, const Origin& caller, Span where);
  Status repeat(std::uint32_t times, const Origin& caller, Span where);
  /// Calls the body that starts at `start` in the file with number `reader` (from open_program). `frame`: kind, left, caller, …
  ///   alarms  call_too_deep
  Status call_at(std::uint16_t reader, Position start, const CallFrame& frame, Span where);
  /// Returns the position of the label `Onnnn` in the main file; nullopt if the label is missing or not unique.
  std::optional<Position> label_of(std::uint32_t number);
  /// Returns true if the program has a subprogram with this number.
  bool has_subprogram(std::uint32_t number) {
    if (!indexed_) make_index();
    return labels_.contains(number);
  }
  /// Opens the file at this path of the program memory; a second call does not open it again. Returns nullopt if the file cannot be read.
  std::optional<std::uint16_t> open_program(const std::string& path);
  /// Opens a built-in program of the control (macros/). Returns nullopt if there is none with this name.
  std::optional<std::uint16_t> open_built_in(const std::string& name);
  /// The file being read.
  ProgramFile& program_file() { return *files_[now_.reader]; }
  std::uint16_t reader() const { return now_.reader; }
  /// Continues at a block of the file being read. A jump back may be a loop: from then on the file keeps its blocks.
  void jump(Position position);
  /// The innermost open call or repetition; nullptr if there is none.
  CallFrame* innermost() { return now_.frames.empty() ? nullptr : &now_.frames.back(); }
  /// Returns true if the file of the innermost call's caller has a block with this number (nct M99 P).
  bool caller_has(std::uint32_t number) {
    const CallFrame& top = now_.frames.back();
    return files_[top.back_reader] && files_[top.back_reader]->find_number(number, top.back).has_value();
  }
  /// Ends a subprogram. Returns nullptr if it repeats, else the frame that was left; the pointer is valid until the next end.
  ///   alarms  return_without_call, repeat_end_missing
  Result<const CallFrame*> end_subprogram(Span where);
  Status end_repetition(Span where);
  /// Starts another pass of the main program at `from`. Returns false if the last pass is over (RunLimits::restarts).
  bool restart(Position from);
  std::uint32_t passes() const { return now_.restarts + 1; }  // passes started so far
  void end() { now_.ended = true; }
  /// Records that the main program runs over this label (its own name, or the start of a subprogram): the label then counts as called.
  void pass_label(std::uint32_t label) {
    if (now_.passed.size() < 1000) now_.passed.insert(label);
  }

  bool ended() const { return now_.ended; }
  /// Closes the innermost call or repetition if its end was not found; a repetition continues at `again`.
  void abandon(std::optional<Position> again);
  std::string shown(std::string_view text, Span& place) const {
    return visiting_ ? elsewhere_->shown(text, place) : now_.reader != 1 ? files_[now_.reader]->shown(text, place) : std::string(text);
  }
  bool in_body() const { return now_.reader == 1; }
  std::size_t depth() const { return now_.frames.size(); }
  const std::vector<CallFrame>& frames() const { return now_.frames; }
  std::vector<CallFrame>& frames() { return now_.frames; }
  /// Path of the file being read; in a cycle body, that of the program.
  const std::string& file() const { return files_[now_.reader == 1 ? 0 : now_.reader]->path(); }
  /// Returns the file with this number, as in Origin::file and reader().
  const ProgramFile& file(std::uint16_t reader) const { return *files_[reader]; }
  /// Returns true if a file has this number; the cycle bodies are not a file.
  bool has_file(std::uint32_t reader) const { return reader < files_.size() && files_[reader] != nullptr; }
  /// Numbers of the files that the program has called, as in Origin::file, in the order of opening.
  std::vector<std::uint16_t> called_files() const;
  /// Paths of all opened files, the program first.
  std::vector<std::string> paths() const;
  const std::string& main_file() const { return files_[0]->path(); }
  const RunLimits& limits() const { return limits_; }
  /// True once a block that begins with '%' has been read.
  bool started() const { return now_.started; }
  void set_started(bool started) { now_.started = started; }
  /// Records that the warnings of a kept block were reported: see ProgramFile::note_warned.
  void note_warned(const Block& block) {
    if (now_.reader != 1) files_[now_.reader]->note_warned(block);
  }
  std::uint64_t blocks() const { return now_.blocks; }
  std::uint64_t repeated() const { return now_.repeated; }  // blocks executed again: after a jump back, in a call, in another pass
  std::uint64_t bytes_read() const { return program().offset(); }
  std::uint64_t bytes() const { return program().size(); }
  const BlockReader& program() const { return files_[0]->reader(); }
  /// Position after the block just read.
  Position position() const { return now_.reader == 1 ? bodies_->position() : files_[now_.reader]->position(); }

  /// Reads the blocks of the subprograms that were never called, in the order of their numbers.
  void each_uncalled(const std::function<void(Result<BlockReader::Got>, const Block&)>& visit);

  static std::string name_of(const ControlDef& def, const CallFrame& frame);

 private:
  struct Label {
    Position position;
    bool twice = false;
    bool called = false;
  };
  Result<CallFrame*> push(const CallFrame& frame, Span where);
  Status count_repeated(const Block& last);
  void make_index();
  BlockReader& elsewhere();
  void go_to(std::uint16_t reader, Position position);

  const ControlDef& def_;
  RunLimits limits_;
  std::vector<std::unique_ptr<ProgramFile>> files_;  // [1] is reserved for the cycle bodies
  std::map<std::string, std::uint16_t> opened_, built_in_;
  std::unique_ptr<BlockReader> elsewhere_;  // reads other parts of the file, so that the current block keeps its text
  Grammar body_grammar_;
  std::unique_ptr<BlockReader> bodies_;
  Block body_block_;
  std::map<std::string, Position> body_starts_;
  Counts now_;
  std::map<std::uint32_t, Label> labels_;
  bool indexed_ = false;
  bool visiting_ = false;  // each_uncalled() is running
};

}  // namespace kadr
