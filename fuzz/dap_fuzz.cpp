// Fuzz target for the debug adapter. The input is any messages, one per line. Each request must get one response, and all messages must be
// JSON with rising numbers. The programs that may be launched are in the present folder.

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string_view>

#include "lsp/debug_adapter.h"
#include "protocol_watch.h"
#include "require.h"

namespace {

using namespace kadr;
namespace fs = std::filesystem;

constexpr std::size_t max_lines = 32;                     // messages in an input
constexpr auto patience = std::chrono::milliseconds(50);  // time for the program to run after a message; then it is interrupted
constexpr std::pair<const char*, const char*> files[] = {
    {"part.nc", "O1\nG21 G90 G54\n#101=0\nN10 #101=#101+1\nG1 X#101 F100\nM98 P200\nIF[#101LT5]GOTO 10\nM30\nO200\n#102=#101*2\nM99\n"},
    {"macro.nc", "O1\nG21 G90\nG65 P2 A5.\nM30\nO2\n#2=#1*2\nM99\n"},
    {"loop.ngc", "G21 F100\no1 while [1]\n#1=[#1+1]\nG1 X[#1]\no1 endwhile\nM2\n"},
    {"still.ngc", "o1 while [1]\n#1=[#1+1]\no1 endwhile\nM2\n"},
    {"fault.ngc", "G21\nG1 X1 F100\nG2 X9 I1 J0\nM2\n"},
    {"part.mpf", "G90 G71\nDEF REAL A=1\nA=A+1\nG1 X=A F100\nM30\n"}};

void go_to_folder() {
  const fs::path memory = "/dev/shm", above = fs::is_directory(memory) ? memory : fs::temp_directory_path();
  static const fs::path folder = above / ("kadr_fuzz_dap_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  for (const auto& [name, text] : files) std::ofstream(folder / name) << text;
  fs::current_path(folder);
  std::atexit([] {
    fs::current_path("/");
    fs::remove_all(folder);
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const bool placed = (go_to_folder(), true);
  fuzz::require(placed, "the programs are there");
  std::string_view text(reinterpret_cast<const char*>(data), size);
  int last = 0;
  std::size_t responses = 0;
  DebugAdapter adapter(
      [&](const std::string& message) {
        const LspJson json = LspJson::parse(message, nullptr, false);
        fuzz::require(json.is_object() && json.value("seq", 0) == ++last, "messages have rising numbers");
        if (json.value("type", "") == "response") ++responses;
      },
      Lang::en);
  for (std::size_t count = 0; count < max_lines && !text.empty() && !adapter.is_over(); ++count) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string message(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    const LspJson json = LspJson::parse(message, nullptr, false);
    const bool is_request =
        json.is_object() && json.value("type", LspJson()) == "request" && json.contains("seq") && json["seq"].is_number_integer();
    const std::size_t before = responses;
    adapter.take(message);
    fuzz::require(responses == before + (is_request ? 1 : 0), "a request has one response");
    const fuzz::ProtocolWatch watch(patience);
    if (adapter.is_running()) adapter.work(watch.token());
  }
  return 0;
}
