#pragma once
// Ctrl-C while the interpreter lock is released: sets what a StopToken looks at, and tells Python.

#include <atomic>
#include <csignal>

namespace kadr::python {

/// While it lives, SIGINT sets the flag, and the handler that was there before handles it afterwards. In Python's main thread only, as its
/// handlers.
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
