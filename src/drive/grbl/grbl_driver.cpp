// Connects a GrblLink to a port. Used by kadr drive, tested by tests/drive.py over a pseudo-terminal.

#include "drive/grbl/grbl_driver.h"

#include <fmt/core.h>

namespace kadr::drive {

GrblDriver::GrblDriver(std::unique_ptr<BytePort> port, BlackBox* log, const LinkOptions& options)
    : port_(std::move(port)), log_(log), link_(options) {
  link_.open(0);
}

void GrblDriver::flush() {
  for (std::string bytes = link_.take_output(); !bytes.empty() && port_; bytes = link_.take_output()) {
    const bool is_only_question = bytes == "?";  // asked five times a second: the answers are in the log
    if (log_ != nullptr && !is_only_question) log_->sent(bytes);
    if (port_->write(bytes)) continue;
    port_.reset();
    link_.port_lost();
  }
}

std::vector<LinkEvent> GrblDriver::step(double seconds) {
  flush();
  if (port_) {
    const auto bytes = port_->read(seconds);
    if (!bytes) {
      port_.reset();
      link_.port_lost();
    } else if (!bytes->empty()) {
      received_ += *bytes;
      for (std::size_t end = received_.find('\n'); end != std::string::npos; end = received_.find('\n')) {
        if (log_ != nullptr && end > 1) log_->received(std::string_view(received_).substr(0, end));
        received_.erase(0, end + 1);
      }
      constexpr std::size_t most_kept = 4096;  // of a line that never ends, bytes
      if (received_.size() > most_kept) received_.clear();
      link_.receive(*bytes, now());
    }
  }
  link_.tick(now());
  flush();
  std::vector<LinkEvent> events = link_.take_events();
  if (log_ != nullptr)
    for (const LinkEvent& event : events)
      if (event.kind == LinkEventKind::fault)
        log_->note(fmt::format("fault {} {} line {} executed {} {}", name_of(event.fault), event.number, event.line, link_.view().executed,
                               event.text));
  return events;
}

void feed(GrblLink& link, GrblJob& job) {
  while (link.wants_line()) {
    auto line = job.next();
    if (!line) return link.end_of_job();
    link.offer(std::move(*line));
  }
}

}  // namespace kadr::drive
