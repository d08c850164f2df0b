// Feeds the conversation with a Grbl controller any bytes, times and commands, and checks its promises: a line is never sent twice nor
// left out, the bytes in flight never exceed the controller's buffer, and after a fault no line is sent until a new job begins.
//
// The first byte of a record selects what happens; the rest are its data.

#include <algorithm>
#include <cstdint>
#include <string>

#include "drive/grbl/grbl_link.h"
#include "require.h"

namespace {

using namespace kadr::drive;
using kadr::fuzz::require;

class Conversation {
 public:
  Conversation() {
    link_.open(0);
    require(link_.view().phase == LinkPhase::opening, "opening");
  }

  void act(std::uint8_t what, std::string_view bytes) {
    switch (what % 10) {
      case 0: link_.receive(bytes, now_); break;
      case 1:
        now_ += static_cast<double>(bytes.size()) * 0.05;
        link_.tick(now_);
        break;
      case 2:
        if (link_.begin_job()) {
          next_sent_ = offered_ = 0;
          broken_ = false;
        }
        break;
      case 3: offer(); break;
      case 4: link_.end_of_job(); break;
      case 5: link_.hold(); break;
      case 6: link_.resume(); break;
      case 7: link_.stop(); break;
      case 8: link_.port_lost(); break;
      default: link_.receive(answers_[bytes.size() % std::size(answers_)], now_);
    }
    settle();
  }

 private:
  void offer() {
    if (!link_.wants_line()) return;
    JobLine line;
    line.number = offered_ + 1;
    line.text = "X" + std::to_string(offered_++);
    line.kind = offered_ % 13 == 0 ? LineKind::alone : LineKind::plain;
    line.seconds = 0.1;
    line.path = {{double(offered_ - 1), 0, 0}, {double(offered_), 0, 0}};
    link_.offer(line);
  }

  void settle() {
    for (std::string bytes = link_.take_output(); !bytes.empty(); bytes = link_.take_output())
      if (bytes.front() == 'X') {
        require(bytes == "X" + std::to_string(next_sent_) + "\n", "the lines are sent in order, each once");
        require(!broken_, "no line is sent after a fault");
        ++next_sent_;
      }
    require(link_.view().bytes_in_flight <= 127 + 80, "the buffer of the controller");
    for (const LinkEvent& event : link_.take_events())
      broken_ = broken_ || event.kind == LinkEventKind::fault || event.kind == LinkEventKind::stopped;
    require(next_sent_ <= offered_, "only offered lines are sent");
  }

  static constexpr std::string_view answers_[] = {"ok\r\n",
                                                  "Grbl 1.1h ['$' for help]\r\n",
                                                  "<Idle|MPos:0.000,0.000,0.000|Bf:15,128>\r\n",
                                                  "<Run|MPos:0.500,0.000,0.000|Bf:14,120>\r\n",
                                                  "<Hold:0|MPos:0.500,0.000,0.000>\r\n",
                                                  "[OPT:V,15,128]\r\n",
                                                  "error:20\r\n",
                                                  "ALARM:1\r\n",
                                                  "<Idle|MPos:1.000,0.000,0.000|Bf:15,128>\r\n"};
  GrblLink link_{LinkOptions{}};
  double now_ = 0;
  std::uint32_t offered_ = 0, next_sent_ = 0;
  bool broken_ = false;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Conversation conversation;
  for (std::size_t at = 0; at + 1 < size;) {
    const std::size_t length = std::min<std::size_t>(data[at + 1] % 64, size - at - 2);
    conversation.act(data[at], {reinterpret_cast<const char*>(data + at + 2), length});
    at += 2 + length;
  }
  return 0;
}
