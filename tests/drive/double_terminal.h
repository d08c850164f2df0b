#pragma once
// A pseudo-terminal on whose other side a program finds the double of a Grbl controller.

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

#include "drive/grbl_double.h"

namespace kadr::drive::test {

class DoubleTerminal {
 public:
  DoubleTerminal() {
    master_ = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
    if (master_ < 0 || ::grantpt(master_) != 0 || ::unlockpt(master_) != 0) return;
    name_ = ::ptsname(master_);
    kept_ = ::open(name_.c_str(), O_RDWR | O_NOCTTY);  // kept open, so that the terminal does not end with its first user
    termios raw{};
    if (kept_ < 0 || ::tcgetattr(kept_, &raw) != 0) return;
    ::cfmakeraw(&raw);
    is_open_ = ::tcsetattr(kept_, TCSANOW, &raw) == 0;
    (void)machine.take_output();
    machine.power_cycle();
  }
  ~DoubleTerminal() { unplug(); }
  DoubleTerminal(const DoubleTerminal&) = delete;
  DoubleTerminal& operator=(const DoubleTerminal&) = delete;

  bool is_open() const { return is_open_; }
  const std::string& name() const { return name_; }
  int master() const { return master_; }
  /// Closes the terminal, as a pulled cable does.
  void unplug() {
    for (int* const file : {&master_, &kept_})
      if (*file >= 0) ::close(std::exchange(*file, -1));
    is_open_ = false;
  }

  /// Passes what has come to the double, lets it work until `now` (s), and sends its answers. Returns false if nobody can receive them.
  bool serve(double now) {
    char bytes[256];
    for (ssize_t got = ::read(master_, bytes, sizeof bytes); got > 0; got = ::read(master_, bytes, sizeof bytes))
      for (ssize_t i = 0; i < got; ++i) machine.receive(bytes[i]);
    while (machine.now < now) machine.advance();
    const std::string output = machine.take_output();
    return output.empty() || ::write(master_, output.data(), output.size()) >= 0;
  }

  GrblDouble machine;

 private:
  int master_ = -1, kept_ = -1;
  bool is_open_ = false;
  std::string name_;
};

}  // namespace kadr::drive::test
