#pragma once
// Handles Ctrl-C while the Python interpreter lock (GIL) is released: sets the flag of a StopToken, then calls Python's own handler.

#include <atomic>
#include <csignal>

namespace kadr::python {

/// During the lifetime of this object SIGINT sets the flag; then the previous handler is called. Works only in Python's main thread,
/// which is the only one that handles signals.
class CatchInterrupt {
 public:
  explicit CatchInterrupt(std::atomic<bool>& flag);
  ~CatchInterrupt();
  CatchInterrupt(const CatchInterrupt&) = delete;
  CatchInterrupt& operator=(const CatchInterrupt&) = delete;

 private:
  bool installed_ = false;
};

}  // namespace kadr::python
