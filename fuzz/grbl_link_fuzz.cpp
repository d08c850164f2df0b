// Feeds the conversation with a Grbl controller any bytes, times and commands, and checks its promises: a line is never sent twice nor
// left out, the bytes in flight never exceed the controller's buffer, and after a fault no line is sent until a new job begins.
//
// The first byte of the input selects the link: new, or connected already. Then follow records: their first byte selects what happens, the
// second how many bytes are its data.

#include <algorithm>
#include <cstdint>
#include <string>

#include "drive/grbl/grbl_link.h"
#include "require.h"

namespace {

using namespace kadr::drive;
using kadr::fuzz::require;

LinkOptions options_of_link(bool is_paced) {
  LinkOptions options;
  options.line_rate = is_paced ? 11520 : 0;
  return options;
}

/// Returns a link that is connected to an idle controller, or to one in its check mode.
GrblLink connected_link(bool is_paced, bool checks) {
  GrblLink link(options_of_link(is_paced));
  link.open(0);
  const std::string_view report = checks ? "<Check|MPos:0.000,0.000,0.000|Bf:15,128>\r\n" : "<Idle|MPos:0.000,0.000,0.000|Bf:15,128>\r\n";
  for (const std::string_view bytes :
       {std::string_view("Grbl 1.1h ['$' for help]\r\n"), std::string_view("[OPT:V,15,128]\r\nok\r\nok\r\nok\r\nok\r\n"), report})
    link.receive(bytes, 0);
  while (!link.take_output().empty()) {
  }
  require(link.view().phase == LinkPhase::ready, "connected");
  (void)link.take_events();
  return link;
}

class Conversation {
 public:
  explicit Conversation(std::uint8_t how) : link_(options_of_link((how & 1) != 0)) {
    static const GrblLink ready[] = {connected_link(false, false), connected_link(true, false), connected_link(false, true)};
    if ((how & 6) != 0) {
      link_ = ready[how % std::size(ready)];
      return;
    }
    link_.open(0);
    require(link_.view().phase == LinkPhase::opening, "opening");
  }

  void act(std::uint8_t what, std::string_view bytes) {
    switch (what % 16) {
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
      case 10: (void)link_.command(bytes.empty() ? "$J=G91X1F100" : "$H", 1); break;
      case 11: (void)link_.end_at_stop(); break;
      case 12: (void)link_.ask_offsets(); break;
      case 13:
        link_.override_feed(static_cast<int>(bytes.size()) * 5);
        link_.override_rapid(static_cast<int>(bytes.size()) * 2);
        break;
      case 14: link_.cancel_jog(); break;
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
    line.kind = offered_ % 13 == 0 ? LineKind::alone : offered_ % 7 == 0 ? LineKind::stop : LineKind::plain;
    line.probes = offered_ % 26 == 0;
    line.seconds = 0.1;
    line.path = {{double(offered_ - 1), 0, 0}, {double(offered_), 0, 0}};
    link_.offer(line);
  }

  static bool is_stop(std::uint32_t line) { return (line + 1) % 13 != 0 && (line + 1) % 7 == 0; }

  void settle() {
    for (std::string bytes = link_.take_output(); !bytes.empty(); bytes = link_.take_output())
      if (bytes.front() == 'X') {
        while (is_stop(next_sent_)) ++next_sent_;
        require(bytes == "X" + std::to_string(next_sent_) + "\n", "the lines are sent in order, each once");
        require(!broken_, "no line is sent after a fault");
        ++next_sent_;
      }
    require(link_.view().bytes_in_flight <= 127 + 80, "the buffer of the controller");
    for (const LinkEvent& event : link_.take_events())
      broken_ = broken_ || event.kind == LinkEventKind::fault || event.kind == LinkEventKind::stopped;
    require(next_sent_ <= offered_, "only offered lines are sent");
    require(link_.lines_kept() <= 64 + 130 + offered_, "nothing grows without a line");
  }

  static constexpr std::string_view answers_[] = {"ok\r\n",
                                                  "Grbl 1.1h ['$' for help]\r\n",
                                                  "<Idle|MPos:0.000,0.000,0.000|Bf:15,128>\r\n",
                                                  "<Run|MPos:0.500,0.000,0.000|Bf:14,120>\r\n",
                                                  "<Hold:0|MPos:0.500,0.000,0.000>\r\n",
                                                  "[OPT:V,15,128]\r\n",
                                                  "error:20\r\n",
                                                  "ALARM:1\r\n",
                                                  "<Idle|MPos:1.000,0.000,0.000|Bf:15,128>\r\n",
                                                  "<Check|MPos:0.000,0.000,0.000|Bf:15,128>\r\n",
                                                  "<Door:0|MPos:0.500,0.000,0.000|Bf:10,90>\r\n",
                                                  "[PRB:0.500,0.000,0.000:1]\r\nok\r\n",
                                                  "<Jog|MPos:0.500,0.000,0.000|Bf:15,128>\r\n",
                                                  "ok\r\nok\r\nok\r\nok\r\n"};
  GrblLink link_{LinkOptions{}};
  double now_ = 0;
  std::uint32_t offered_ = 0, next_sent_ = 0;
  bool broken_ = false;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  Conversation conversation(data[0]);
  for (std::size_t at = 1; at + 1 < size;) {
    const std::size_t length = std::min<std::size_t>(data[at + 1] % 64, size - at - 2);
    conversation.act(data[at], {reinterpret_cast<const char*>(data + at + 2), length});
    at += 2 + length;
  }
  return 0;
}
