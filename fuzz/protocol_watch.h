#pragma once
// ProtocolWatch: ends work that takes too long, for the targets of the protocols of editors.

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "base/stop_token.h"

namespace kadr::fuzz {

class ProtocolWatch {
 public:
  explicit ProtocolWatch(std::chrono::milliseconds patience) : thread_([this, patience] { wait(patience); }) {}
  ~ProtocolWatch() {
    {
      const std::lock_guard hold(lock_);
      over_ = true;
    }
    news_.notify_all();
    thread_.join();
  }
  ProtocolWatch(const ProtocolWatch&) = delete;
  ProtocolWatch& operator=(const ProtocolWatch&) = delete;

  StopToken token() const { return StopToken(stops_); }

 private:
  void wait(std::chrono::milliseconds patience) {
    std::unique_lock hold(lock_);
    if (!news_.wait_for(hold, patience, [this] { return over_; })) stops_ = true;
  }
  std::atomic<bool> stops_ = false;
  std::mutex lock_;
  std::condition_variable news_;
  bool over_ = false;
  std::thread thread_;
};

}  // namespace kadr::fuzz
