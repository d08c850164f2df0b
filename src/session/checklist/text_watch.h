#pragma once
// TextWatch: finds problems in the text of a program without executing it. It reads the text from beginning to end, block by block.

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
  /// `most_rpm`: the highest spindle speed; 0: unknown. A control may limit a higher S silently.
  TextWatch(const ControlDef& def, double most_rpm) : def_(def), most_rpm_(most_rpm) {}

  /// Reads the whole text; polls `stop` now and then.
  void read(BlockReader reader, const StopToken& stop);
  void finish(Advices& to);
  /// Number of teeth by tool, from comments such as "4 FLUTE", "4FL".
  const std::map<std::uint32_t, int>& teeth() const { return teeth_; }
  const NamedInText& named() const { return named_; }
  /// True if some code of the program ends it or returns.
  bool has_end() const;

 private:
  /// A program or subprogram of the text: from one O number to the next.
  struct Section {
    std::uint32_t label = 0;
    Origin begins;
    bool ends_program = false, returns = false;
    std::map<std::uint32_t, std::uint32_t> jumps;  // target, line
    std::map<std::uint32_t, std::uint32_t> twice;  // jump target → number of blocks with this N; second reading
    std::optional<Origin> behind_end;              // first motion after the end of the program
    std::uint32_t lines_behind = 0;
    bool has_targets = false;  // something refers to block numbers, so that lines after the end may be reachable
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
  bool in_cycle_ = false, absolute_ = true, in_xy_ = true;  // G90, G17: only if certain
  std::optional<Advice> cancelled_;                         // a cycle cancelled by a motion code
  bool lost_ = false;                                       // positions have followed the cancellation
  std::optional<double> level_, bottom_;
  // modes
  bool began_ = false;                                              // a motion has been read
  std::set<Function> stated_;                                       // before the first motion
  std::map<Function, std::pair<Origin, std::string>> switched_on_;  // location of the last switch-on, and its code
  bool main_over_ = false;                                          // the end of a program has been read
  // flow
  std::vector<Section> sections_;
  std::set<std::uint32_t> calls_;
  bool calls_by_value_ = false, has_o_words_ = false;
  bool ended_ = false;
  bool repeats_ = false;  // a code repeats it from the beginning
  // comments
  std::map<std::uint32_t, int> teeth_;
  std::uint32_t tool_ = 0;
  int loose_teeth_ = 0;
};

}  // namespace kadr
