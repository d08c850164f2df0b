#pragma once
// Thread: whoever wants a thread asks here, and is told where none is to be had: too many of them, or too little memory. Nothing that a
// thread throws is the end of the process.

#include <exception>
#include <functional>
#include <memory>
#include <thread>

namespace kadr {

/// There is no other thread for what cannot be done without one.
struct NoThread : std::exception {
  const char* what() const noexcept override { return "no more threads are to be had"; }
};

class Thread {
 public:
  Thread() = default;
  Thread(Thread&&) noexcept = default;
  Thread& operator=(Thread&&) = delete;
  /// Waits for its end.
  ~Thread() { wait(); }

  /// Begins it; once.
  ///   returns  false: none is to be had, and nothing is begun
  [[nodiscard]] bool begin(std::function<void()> work);
  /// The same of work that cannot be done without one.
  ///   throws  NoThread
  void begin_or_throw(std::function<void()> work);
  bool is_begun() const { return thread_.joinable(); }

  /// Until it is over.
  void wait() {
    if (thread_.joinable()) thread_.join();
  }
  /// What it threw, once it has been waited for; nothing: it ended by itself.
  std::exception_ptr thrown() const { return thrown_ ? *thrown_ : nullptr; }

 private:
  std::thread thread_;
  std::unique_ptr<std::exception_ptr> thrown_;
};

/// Begins a thread that nobody waits for.
///   returns  false: none is to be had
[[nodiscard]] bool begin_alone(std::function<void()> work);

/// work(0) … work(count - 1), each in a thread as far as they are to be had, the others one after the other in this one.
///   throws  what one of them threw, once all are over
void side_by_side(int count, const std::function<void(int)>& work);

}  // namespace kadr
