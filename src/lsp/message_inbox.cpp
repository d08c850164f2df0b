// MessageInbox: reads the messages of an editor in a thread of its own. Used by lsp/serve_editor; tested by tests/lsp.py.

#include "lsp/message_inbox.h"

#include <algorithm>
#include <chrono>

#include "config/json_text.h"

namespace kadr {

MessageInbox::MessageInbox(int input, std::function<void(const std::string&)> on_fault) : on_fault_(std::move(on_fault)) {
  reading_.begin_or_throw([this, input] { read(input); });
}

MessageInbox::~MessageInbox() {
  ends_ = true;
  reading_.wait();
}

void MessageInbox::read(int input) {
  MessageReader reader(input, StopToken(ends_));
  while (!ends_) {
    auto message = reader.next();
    if (!message && !ends_) on_fault_(message.error());
    if (!message || !*message) break;
    put(std::move(**message));
  }
  const std::lock_guard hold(lock_);
  closed_ = interrupts_ = cancels_ = true;
  changed_.notify_one();
}

void MessageInbox::put(std::string message) {
  LspJson json = json_of(message);
  const std::lock_guard hold(lock_);
  const auto is_cancelled = [&](const LspJson& id) {
    const auto found = std::find_if(messages_.begin(), messages_.end(), [&](const Message& one) { return one.id == id; });
    if (id.is_null() || found == messages_.end()) return false;
    return found->cancelled = true;
  };
  const LspJson::json_pointer cancelled("/params/id");
  const bool cancels = json.is_object() && json.value("method", LspJson()) == "$/cancelRequest";
  // A request that has been taken already may still be worked on: then its cancellation is taken like other messages.
  if (!cancels || !json.contains(cancelled) || !is_cancelled(json[cancelled])) {
    const bool is_request = json.is_object() && json.contains("id") && json.contains("method");
    messages_.push_back({std::move(message), is_request ? json["id"] : LspJson()});
    if (cancels) cancels_ = true;
  }
  interrupts_ = true;
  changed_.notify_one();
}

std::optional<MessageInbox::Message> MessageInbox::next(bool waits, const StopToken& stop) {
  std::unique_lock hold(lock_);
  constexpr std::chrono::milliseconds poll_period(100);  // within this time a stop is noticed
  while (waits && messages_.empty() && !closed_ && !stop.requested()) changed_.wait_for(hold, poll_period);
  interrupts_ = cancels_ = false;
  if (messages_.empty()) return std::nullopt;
  Message message = std::move(messages_.front());
  messages_.pop_front();
  return message;
}

bool MessageInbox::is_over() {
  const std::lock_guard hold(lock_);
  return closed_ && messages_.empty();
}

}  // namespace kadr
