// Fuzz target for the session of a web page. The input is any messages, one per line. Each request must get one answer, all answers must
// be JSON, and binary frames must be as long as their headers state. The session has a folder with a program for each of several
// controls, the files that they call, a set-up, tools and a user's own control.

#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string_view>
#include <thread>

#include "panel/panel_hub.h"
#include "panel/panel_journal.h"
#include "require.h"
#include "view/page/page_session.h"
#include "view/served_folder.h"

namespace {

using namespace kadr;
namespace fs = std::filesystem;

constexpr std::size_t max_lines = 24;                        // messages in an input
constexpr auto patience = std::chrono::milliseconds(150);    // time for a message; then it is stopped
constexpr std::size_t max_frames = 40, most_answers = 4000;  // limits for an input; after that the client is treated as disconnected
constexpr std::pair<const char*, const char*> files[] = {
    {"part.nc",
     "(</script>)\nG21 G90 G17\nT1 M6\nS1000 M3\nG0 X0 Y0 Z5\nG1 Z-2 F200\nX40 F600\nG41 D1 X40 Y1\nG3 X40 Y20 J10\nG40 G1 X0\nY0\nM30\n"},
    {"call.nc", "M98 P30\nG65 P30 A5\nG83 X5 Y5 Z-5 R2 Q1 F100\nM30\n"},
    {"O0030.nc", "#1=#1+1\nG1 X#1 F100\nM99\n"},
    {"endless.nc", "G90 F1000\no100 while [1]\nG1 X1\nX0\no100 endwhile\nM2\n"},
    {"turn.nc", "G18 G95 G96 S120 M3\nG0 X40 Z2\nG1 Z-20 F0.2\nX42\nM30\n"},
    {"faulty.nc", "G1 X10\nG2 X5 R1\nG99 Y\n(\nG41 X\nM98 P7\nM30\n"},
    {"setup.json", R"({"offsets": {"1": {"radius": 5, "length": 50}}, "work_offsets": {"G54": {"X": 10, "Y": 20, "Z": 30}}})"},
    {"tools.toml", "[[tool]]\nnumber = 1\nkind = \"end\"\ndiameter = 10\nlength = 40\n"},
    {"own.toml", "id = \"own\"\nextends = \"nct\"\nname = {en = \"Own\", ru = \"Своя\"}\n"},
    {"zone.txt", "from 0 0\nline 30 0\nline 30 20\nline 0 20 open\nclose\n"},
    {"sub/other.nc", "G1 X1 F100\nM30\n"}};

void lay_out(const fs::path& folder) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) fs::remove_all(entry.path(), error);
  fs::create_directories(folder / "sub");
  for (const auto& [name, text] : files) std::ofstream(folder / name) << text;
}

fs::path make_folder() {
  const fs::path memory = "/dev/shm", above = fs::is_directory(memory) ? memory : fs::temp_directory_path();
  static const fs::path folder = above / ("kadr_fuzz_page_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  lay_out(folder);
  std::atexit([] { fs::remove_all(folder); });
  return folder;
}

class Taker : public PageLine {
 public:
  bool text(std::string message) override {
    const auto json = nlohmann::json::parse(message, nullptr, false);
    fuzz::require(json.is_object(), "what is said is a JSON object");
    if (json.contains("re")) ++answers;
    else fuzz::require(json.contains("event"), "an answer or an event");
    return ++said < most_answers;
  }
  bool frame(std::string bytes) override {
    fuzz::require(bytes.size() >= 16 && bytes.size() % 4 == 0, "a frame has a head");
    std::uint32_t head[4];
    std::memcpy(head, bytes.data(), sizeof head);
    if (head[0] == 1)
      fuzz::require(head[2] > 0 && head[2] <= 8192 && bytes.size() == 96 + 40 * std::size_t(head[2]),
                    "a piece is as long as its head says");
    return ++frames < max_frames;
  }
  std::size_t answers = 0, said = 0, frames = 0;
};

/// Stops a message that takes too long.
class Watch {
 public:
  explicit Watch(PageSession& session) : session_(session), thread_([this] { wait(); }) {}
  ~Watch() {
    {
      const std::lock_guard hold(lock_);
      over_ = true;
    }
    news_.notify_all();
    thread_.join();
  }

 private:
  void wait() {
    std::unique_lock hold(lock_);
    if (!news_.wait_for(hold, patience, [this] { return over_; })) session_.stop();
  }
  PageSession& session_;
  std::mutex lock_;
  std::condition_variable news_;
  bool over_ = false;
  std::thread thread_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fs::path place = make_folder();
  static const auto folder = ServedFolder::open(place.string());
  PanelJournal journal;
  PanelHub hub;  // its machines are switched off at the end of the input
  const PageServer server{*folder, "t", false, Lang::en, "0", nullptr, &hub, &journal};
  std::string_view text(reinterpret_cast<const char*>(data), size);
  Taker line;
  {
    PageSession session(server, line);
    session.begin(false);
    bool goes_on = session.take(R"({"id":0,"do":"hello","token":"t","lang":"ru"})");
    for (std::size_t count = 1; goes_on && count < max_lines && !text.empty(); ++count) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      const std::string message(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
      session.begin(PageSession::asks_to_stop(message));
      if (PageSession::asks_for_emergency(message)) session.emergency();
      const Watch watch(session);
      const std::size_t before = line.answers;
      goes_on = session.take(message);
      fuzz::require(line.answers == before + 1, "a message has one answer");
    }
  }
  if (std::string_view(reinterpret_cast<const char*>(data), size).find("save") != std::string_view::npos) lay_out(place);
  return 0;
}
