#pragma once
// What the text of a program shows without being carried out: read once more from its beginning to its end, block by block.

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/stop.h"
#include "config/control_def.h"
#include "lang/block/block_reader.h"
#include "session/checklist/advice.h"
#include "session/checklist/table_check.h"

namespace kadr {

class TextWatch {
 public:
  /// `most_rpm`: of the spindle; 0: not known. A control may turn it no faster and say nothing.
  TextWatch(const ControlDef& def, double most_rpm) : def_(def), most_rpm_(most_rpm) {}

  /// All of it; `stop` is asked now and then.
  void read(BlockReader reader, const StopToken& stop);
  void finish(Advices& to);
  /// Of tools, as comments name them: "4 FLUTE", "4FL".
  const std::map<std::uint32_t, int>& teeth() const { return teeth_; }
  const NamedInText& named() const { return named_; }
  /// The program says somewhere that it ends or returns.
  bool has_end() const;

 private:
  /// A program or subprogram of the text: from one O number to the next.
  struct Section {
    std::uint32_t label = 0;
    Origin begins;
    bool ends_program = false, returns = false;
    std::map<std::uint32_t, std::uint32_t> jumps;  // target, line
    std::map<std::uint32_t, std::uint32_t> twice;  // N numbers that are targets, and how many blocks have them: in the second reading
    std::optional<Origin> behind_end;              // first motion behind the end of the program
    std::uint32_t lines_behind = 0;
    bool has_targets = false;  // something leads to block numbers: nothing behind its end is surely dead
  };
  void take(const Block& block);
  void take_points(const Block& block);
  void take_codes(const Block& block);
  void take_cycle(const Block& block);
  void take_levels(const Block& block, const Word& cycle);
  void take_flow(const Block& block);
  void take_comments(const Block& block);
  void take_numbers(const Word& word);
  void note_call(const Block& block, const Word& code);
  bool is_axis(char letter) const;
  bool moves(const Block& block) const;
  const CodeRow* row(const Word& word) const;
  static Origin origin_of(const Block& block);
  template <class... Args>
  void add(AlarmId id, const Origin& origin, Span where, Args... args);

  const ControlDef& def_;
  const double most_rpm_;
  NamedInText named_;
  std::vector<Advice> found_;
  // numbers without a point
  std::size_t with_point_ = 0, without_point_ = 0;
  std::vector<Advice> pointless_;
  bool inch_ = false;
  // drilling cycles, in the order of the text
  bool in_cycle_ = false, absolute_ = true, in_xy_ = true;  // G90, G17: for certain
  std::optional<Advice> cancelled_;                         // by a motion code
  bool lost_ = false;                                       // positions have followed
  std::optional<double> level_, bottom_;
  // modes
  bool began_ = false;                                              // a motion has come
  std::set<Function> stated_;                                       // before it
  std::map<Function, std::pair<Origin, std::string>> switched_on_;  // where last, by which code
  bool main_over_ = false;                                          // the end of a program has come
  // flow
  std::vector<Section> sections_;
  std::set<std::uint32_t> calls_;
  bool calls_by_value_ = false, has_o_words_ = false;
  bool ended_ = false;
  bool repeats_ = false;  // from its beginning, by a code
  // comments
  std::map<std::uint32_t, int> teeth_;
  std::uint32_t tool_ = 0;
  int loose_teeth_ = 0;
};

}  // namespace kadr
