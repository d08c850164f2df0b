#pragma once
// Plc: the machine's logic and its operator, scripted by the events of a set-up (tests/golden/README.md, "Events"). Its input is
// blocks, actions and the program's end, its output commands; apply() passes these to the channels' controls.
//
//   block start ─▶ execution of the block ─▶ its actions ─▶ block end ─▶ next block     (a command takes effect at once)

#include <string>
#include <variant>
#include <vector>

#include "action/action.h"
#include "config/setup.h"

namespace kadr {

struct SetSignal {
  std::string name;  // "CP_MINT"
  double value;
};
struct SetSkip {
  int number;
  bool on;
};
struct AnswerBox {
  double value;  // for #3107: 0 cancel, 1 OK, 2 yes, 3 no
};
struct Start {};  // ends a stop; the virtual operator presses START at once anyway
struct PowerCycle {};
/// Spindle `slave` follows `master`; master 0 ends this, slave 0 means all spindles.
struct Synchronise {
  int slave, master;
};
struct CoupleAxes {
  std::vector<std::string> axes;
  AxisLink link;
  bool on;
};
struct ConvertSpindle {
  int number;
  bool to_axis;
};
using PlcCommand = std::variant<SetSignal, SetSkip, AnswerBox, Start, PowerCycle, Synchronise, CoupleAxes, ConvertSpindle>;

class Plc {
 public:
  ///   told_of_ends  the control reports M2, M30, M98 and M99 to the logic too (nct 13.1)
  explicit Plc(const std::vector<SetupEvent>& events, bool told_of_ends = true);

  /// Returns a sentence about an event that cannot be served; empty if there is none.
  const std::string& error() const { return error_; }
  /// True without events: nothing has to be passed to the logic.
  bool idle() const { return events_.empty(); }

  /// Each function returns the commands of the events that occur, in the order of the set-up; valid until the next call.
  const std::vector<PlcCommand>& block(const Origin& origin, bool at_end);
  /// Codes count whichever channel issues them. An answer needs a message that asks a question.
  const std::vector<PlcCommand>& action(const Action& action);
  const std::vector<PlcCommand>& program_end();

 private:
  struct Event {
    SetupEvent::When when;
    bool main_block;  // ':' instead of N
    char letter;      // of the code
    double number;    // of the block or code
    int count;        // fires at the n-th occurrence; 0: at each
    int seen = 0;
    PlcCommand command = Start{};
  };
  template <class Matches>
  const std::vector<PlcCommand>& fire(Matches matches);

  std::vector<Event> events_;
  std::vector<PlcCommand> commands_;
  std::string error_;
};

}  // namespace kadr
