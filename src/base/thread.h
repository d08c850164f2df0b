#pragma once
// Thread: the only class that creates threads in Kadr. It reports if a thread cannot be created (too many threads, too little memory), and
// it catches exceptions, so that an exception in a thread never ends the process.

#include <exception>
#include <functional>
#include <memory>
#include <thread>

namespace kadr {

/// The exception of begin_or_throw(), thrown if no thread can be created.
struct NoThread : std::exception {
  const char* what() const noexcept override { return "no more threads are to be had"; }
};

/// Returns how many threads may work at once, including the calling one: as many as the process has processors; 1 where there are no
/// threads (a page in a browser).
int threads_at_once();

class Thread {
 public:
  Thread() = default;
  Thread(Thread&&) noexcept = default;
  Thread& operator=(Thread&&) = delete;
  /// Waits until the thread ends.
  ~Thread() { wait(); }

  /// Starts the thread; may be called once only.
  ///   returns  false if no thread can be created; then nothing was started
  [[nodiscard]] bool begin(std::function<void()> work);
  /// Like begin(), but throws if no thread can be created, for work that needs a thread of its own.
  void begin_or_throw(std::function<void()> work);
  bool is_begun() const { return thread_.joinable(); }

  /// Waits until the thread ends.
  void wait() {
    if (thread_.joinable()) thread_.join();
  }
  /// Returns, after wait(), the exception that the work threw; nullptr if the work ended normally.
  std::exception_ptr thrown() const { return thrown_ ? *thrown_ : nullptr; }

 private:
  std::thread thread_;
  std::unique_ptr<std::exception_ptr> thrown_;
};

/// Starts a thread that no other thread waits for.
[[nodiscard]] bool begin_alone(std::function<void()> work);

/// Executes work(0) … work(count - 1), each in a thread of its own. If a thread cannot be created, the remaining calls are executed one
/// after another in the calling thread.
///   throws  the first exception found, after all calls have ended
void run_parallel(int count, const std::function<void(int)>& work);

}  // namespace kadr
