#pragma once
// MessageInbox: the messages of an editor that have been read and not executed yet. One thread reads them, so that long work ends at once
// when the editor has something to say.

#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <string>

#include "base/stop_token.h"
#include "base/thread.h"
#include "lsp/lsp_json.h"
#include "lsp/message_stream.h"

namespace kadr {

class MessageInbox {
 public:
  struct Message {
    std::string text;
    LspJson id;              // null: a notification, or a message of the Debug Adapter Protocol
    bool cancelled = false;  // true: the editor has cancelled this request
  };

  /// Starts to read messages from a file descriptor.
  ///   on_fault  a function of the client that receives the reason why the rest of the input cannot be read; called in another thread
  MessageInbox(int input, std::function<void(const std::string& reason)> on_fault);
  ~MessageInbox();

  /// Returns the next message. Waits for it if `waits`.
  ///   returns  nullopt if there is none now, or, after waiting, if the input has ended or `stop` was requested
  std::optional<Message> next(bool waits, const StopToken& stop);
  /// True if the input has ended and all messages have been taken.
  bool is_over();
  /// True while a message waits that came after the last call of next().
  const std::atomic<bool>& interrupts() const { return interrupts_; }
  /// True while a cancellation waits, of a request that has been taken already.
  const std::atomic<bool>& cancels() const { return cancels_; }

 private:
  void read(int input);
  void put(std::string message);

  const std::function<void(const std::string&)> on_fault_;
  std::mutex lock_;
  std::condition_variable changed_;
  std::deque<Message> messages_;
  std::atomic<bool> interrupts_ = false, cancels_ = false, ends_ = false;
  bool closed_ = false;
  Thread reading_;
};

}  // namespace kadr
