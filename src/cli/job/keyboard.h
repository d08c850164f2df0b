#pragma once
// Keyboard: what the operator types on standard input, without waiting for it.

#include <optional>
#include <string>

namespace kadr::cli {

class Keyboard {
 public:
  /// Returns the next typed character that is not blank; 0 if there is none.
  char next();
  /// Returns the next complete line without its end; nullopt if there is none yet. At the end of the input the rest is a line, and after
  /// it each line is empty.
  std::optional<std::string> line();
  bool has_ended() const { return ended_; }

 private:
  void read();
  std::string typed_;
  bool ended_ = false;
};

}  // namespace kadr::cli
