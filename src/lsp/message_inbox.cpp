// MessageInbox: reads the messages of an editor in a thread of its own. Used by lsp/serve_editor; tested by tests/lsp.py.

#include "lsp/message_inbox.h"

#include <algorithm>
#include <chrono>

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
  closed_ = interrupts_ = true;
  changed_.notify_one();
}

void MessageInbox::put(std::string message) {
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

std::optional<MessageInbox::Message> MessageInbox::next(bool waits, const StopToken& stop) {
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

bool MessageInbox::is_over() {
  const std::lock_guard hold(lock_);
  return closed_ && messages_.empty();
}

}  // namespace kadr
