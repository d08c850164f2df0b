// The Grbl double behind a pseudo-terminal, for tests/drive.py. It prints the name of the terminal, then serves it in real time. Lines on
// standard input command it: `limit`, `door`, `reset`, `set N VALUE`, `offset G54 X Y Z`, `probe PART` (of a probe motion, after which it
// touches; 2: never), `unplug`; `quit` or the end of the input ends it. Then it prints the executed lines, what it has read in check mode,
// and last its state and position.

#include <chrono>
#include <cstdio>
#include <sstream>

#include "drive/double_terminal.h"

namespace {

using kadr::drive::test::DoubleTerminal;
using kadr::drive::test::GrblDouble;

bool command(DoubleTerminal& terminal, const std::string& line) {
  GrblDouble& machine = terminal.machine;
  std::istringstream words(line);
  std::string name, offset;
  words >> name;
  int number = 0;
  double value = 0;
  if (name == "limit") machine.hard_limit();
  else if (name == "door") machine.open_door();
  else if (name == "reset") machine.power_cycle();
  else if (name == "set" && words >> number >> value) machine.settings[number] = value;
  else if (name == "probe" && words >> value) machine.probe_part = value, machine.probe_touches = value <= 1;
  else if (name == "unplug") terminal.unplug();
  else if (name == "offset" && words >> offset)
    words >> machine.offsets[offset][0] >> machine.offsets[offset][1] >> machine.offsets[offset][2];
  return name != "quit";
}

}  // namespace

int main() {
  DoubleTerminal terminal;
  if (!terminal.is_open()) return 2;
  GrblDouble& machine = terminal.machine;
  std::printf("%s\n", terminal.name().c_str());
  std::fflush(stdout);
  const auto begin = std::chrono::steady_clock::now();
  std::string typed;
  for (bool runs = true; runs;) {
    pollfd inputs[] = {{terminal.master(), POLLIN, 0}, {STDIN_FILENO, POLLIN, 0}};
    (void)::poll(inputs, 2, 1);
    char bytes[256];
    if ((inputs[1].revents & (POLLIN | POLLHUP)) != 0) {
      const ssize_t got = ::read(STDIN_FILENO, bytes, sizeof bytes);
      if (got <= 0) break;
      typed.append(bytes, static_cast<std::size_t>(got));
      for (std::size_t end = typed.find('\n'); end != std::string::npos; end = typed.find('\n')) {
        runs = command(terminal, typed.substr(0, end)) && runs;
        typed.erase(0, end + 1);
      }
    }
    const std::chrono::duration<double> now = std::chrono::steady_clock::now() - begin;
    if (terminal.is_open() && !terminal.serve(now.count())) break;
  }
  for (const std::string& line : machine.executed) std::printf("%s\n", line.c_str());
  if (!machine.checked.empty()) std::printf("checked %zu%s\n", machine.checked.size(), machine.written_in_check ? ", EEPROM written" : "");
  std::printf("%s %.3f %.3f %.3f\n", machine.state_text().c_str(), machine.position[0], machine.position[1], machine.position[2]);
  return 0;
}
