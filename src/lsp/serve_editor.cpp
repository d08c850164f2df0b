// Connects a LanguageServer with an editor over two file descriptors. One thread reads the messages, so that a check ends at once when the
// editor has something to say, and so that a request can be cancelled before it is executed. Used by cli/lsp_command; tested by
// tests/lsp.py.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>

#include "base/thread.h"
#include "lsp/language_server.h"
#include "lsp/message_stream.h"

namespace kadr {
namespace {

/// The messages that have been read and not executed yet.
class Inbox {
 public:
  void put(std::string message) {
    LspJson json = LspJson::parse(message, nullptr, false);
    const std::lock_guard hold(lock_);
    if (json.is_object() && json.value("method", LspJson()) == "$/cancelRequest") {
      const auto params = json.find("params");
      if (params != json.end() && params->is_object() && params->contains("id")) cancelled_.push_back((*params)["id"]);
    } else {
      const bool is_request = json.is_object() && json.contains("id") && json.contains("method");
      messages_.push_back({std::move(message), is_request ? json["id"] : LspJson()});
    }
    interrupts_ = true;
    changed_.notify_one();
  }
  void close() {
    const std::lock_guard hold(lock_);
    closed_ = interrupts_ = true;
    changed_.notify_one();
  }

  struct Message {
    std::string text;
    LspJson id;  // null: a notification
    bool cancelled = false;
  };
  /// Returns the next message. Waits for it if there is nothing else to do.
  ///   returns  nullopt if there is none now, or, after waiting, if the input has ended
  std::optional<Message> next(bool waits, const StopToken& stop) {
    std::unique_lock hold(lock_);
    constexpr std::chrono::milliseconds poll_period(100);  // within this time a stop is noticed
    while (waits && messages_.empty() && !closed_ && !stop.requested()) changed_.wait_for(hold, poll_period);
    interrupts_ = false;
    if (messages_.empty()) {
      cancelled_.clear();  // these requests were executed before
      return std::nullopt;
    }
    Message message = std::move(messages_.front());
    messages_.pop_front();
    const auto found = message.id.is_null() ? cancelled_.end() : std::find(cancelled_.begin(), cancelled_.end(), message.id);
    message.cancelled = found != cancelled_.end();
    if (message.cancelled) cancelled_.erase(found);
    return message;
  }
  bool is_over() {
    const std::lock_guard hold(lock_);
    return closed_ && messages_.empty();
  }
  /// True while a message waits that was put after the last call of next().
  const std::atomic<bool>& interrupts() const { return interrupts_; }

 private:
  std::mutex lock_;
  std::condition_variable changed_;
  std::deque<Message> messages_;
  std::vector<LspJson> cancelled_;
  std::atomic<bool> interrupts_ = false;
  bool closed_ = false;
};

/// Reads messages until the input ends or `ends` is set.
void read_messages(int input, Inbox& inbox, const std::atomic<bool>& ends, MessageWriter& writer) {
  MessageReader reader(input, StopToken(ends));
  while (!ends) {
    auto message = reader.next();
    if (!message && !ends) {
      constexpr int type_error = 1;
      (void)writer.put(dumped_message(
          {{"jsonrpc", "2.0"}, {"method", "window/logMessage"}, {"params", {{"type", type_error}, {"message", message.error()}}}}));
    }
    if (!message || !*message) break;
    inbox.put(std::move(**message));
  }
  inbox.close();
}

}  // namespace

int serve_editor(int input, int output, Lang lang, const std::string& version, const StopToken& stop) {
  MessageWriter writer(output);
  Inbox inbox;
  std::atomic<bool> ends = false;
  Thread reading;
  reading.begin_or_throw([&] { read_messages(input, inbox, ends, writer); });
  LanguageServer server([&](const std::string& message) { (void)writer.put(message); }, lang, version);
  // A check that is interrupted begins again. An editor that asks without a pause could therefore prevent it permanently, so it is
  // interrupted at most a few times in a row.
  constexpr int most_interruptions = 3;
  const std::atomic<bool> never = false;
  int interruptions = 0;
  while (!server.is_over() && !stop.requested()) {
    const bool busy = server.has_work();
    const auto message = inbox.next(!busy, stop);
    if (message) {
      if (message->cancelled) server.refuse_cancelled(message->id);
      else server.take(message->text);
    } else if (busy) {
      server.work(StopToken(interruptions < most_interruptions ? inbox.interrupts() : never));
      interruptions = server.has_work() ? interruptions + 1 : 0;
    } else if (inbox.is_over()) {
      break;
    }
  }
  ends = true;
  reading.wait();
  return server.exit_status();
}

}  // namespace kadr
