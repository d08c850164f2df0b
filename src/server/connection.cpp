// Connection: the WebSocket of a page. Used by server/http_server; tested by tests/serve.py.

#include "server/connection.h"

#include <malloc.h>

#include "base/thread.h"

namespace kadr {
namespace {

namespace beast = boost::beast;
namespace websocket = beast::websocket;

// Limit in bytes of the messages that wait to be sent to the page; at this limit an answer pauses.
constexpr std::size_t max_unsent = std::size_t{8} << 20;
// Greatest number of requests that may wait for an answer; one more closes the connection.
constexpr std::size_t max_questions = 256;
// Greatest total length of the waiting requests in bytes; more bytes close the connection.
constexpr std::size_t max_question_bytes = std::size_t{48} << 20;

}  // namespace

Connection::Connection(beast::tcp_stream stream, const PageServer& page, std::shared_ptr<std::atomic<int>> sessions)
    : socket_(std::move(stream)), sessions_(std::move(sessions)), session_(std::make_unique<PageSession>(page, *this)) {}

Connection::~Connection() { --*sessions_; }

void Connection::accept(const PageRequest& request) {
  beast::get_lowest_layer(socket_).expires_never();
  beast::error_code ignored;
  // Without the option no_delay, a second answer would wait 40 ms for the acknowledgement of the first answer.
  beast::get_lowest_layer(socket_).socket().set_option(boost::asio::ip::tcp::no_delay(true), ignored);
  socket_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
  socket_.read_message_max(PageSession::max_message);
  socket_.auto_fragment(false);  // fragmentation is off, because it would divide a long message into pieces of 4 KiB
  socket_.async_accept(request, [self = shared_from_this()](beast::error_code error) {
    if (error) return self->lost();
    if (!begin_alone([self] { self->answer_all(); })) return self->close(websocket::close_code::try_again_later);
    self->read();
  });
}

void Connection::read() {
  socket_.async_read(buffer_, [self = shared_from_this()](beast::error_code error, std::size_t) {
    if (error) return self->lost();
    self->take_message();
  });
}

/// Reads a message from the page. A request to stop takes effect at once; it also stops the earlier requests that still wait for an answer.
void Connection::take_message() {
  std::string text = beast::buffers_to_string(buffer_.data());
  buffer_.consume(buffer_.size());
  bool flood = false;
  {
    const std::lock_guard hold(lock_);
    if (PageSession::asks_to_stop(text)) {
      for (Question& q : questions_) q.stopped = true;
      hurries_ = true;
      if (session_) session_->stop();
    }
    if (session_ && PageSession::asks_for_emergency(text)) session_->emergency();
    question_bytes_ += text.size();
    questions_.push_back({std::move(text)});
    flood = questions_.size() > max_questions || question_bytes_ > max_question_bytes;
  }
  news_.notify_all();
  if (flood) return close(websocket::close_code::policy_error);
  read();
}

/// The main function of the thread that answers requests. This thread also destroys the session: freeing the session's memory takes time,
/// and the network's thread must not wait.
void Connection::answer_all() {
  while (answer_next()) {
  }
  std::unique_ptr<PageSession> its;
  {
    const std::lock_guard hold(lock_);
    its = std::move(session_);
  }
  its.reset();
  ::malloc_trim(0);
}

/// Answers the next request. Returns false if the connection has ended or must be closed, so no more requests are answered.
bool Connection::answer_next() {
  Question question;
  {
    std::unique_lock hold(lock_);
    news_.wait(hold, [this] { return over_ || !questions_.empty(); });
    if (over_) return false;
    question = std::move(questions_.front());
    questions_.pop_front();
    question_bytes_ -= question.text.size();
    hurries_ = false;
    session_->begin(question.stopped);
  }
  bool goes_on = false;
  try {
    goes_on = session_->take(question.text);
  } catch (const std::exception&) {  // memory is exhausted: only the session of this page ends, not the server
  }
  if (!goes_on) boost::asio::post(socket_.get_executor(), [self = shared_from_this()] { self->close_when_sent(); });
  return goes_on;
}

bool Connection::send(Outgoing out) {
  {
    std::unique_lock hold(lock_);
    news_.wait(hold, [this] { return over_ || hurries_ || unsent_ < max_unsent; });
    if (over_) return false;
    unsent_ += out.bytes.size();
    out_.push_back(std::move(out));
    if (out_.size() > 1) return true;
  }
  boost::asio::post(socket_.get_executor(), [self = shared_from_this()] { self->write_next(); });
  return true;
}

void Connection::write_next() {
  Outgoing* out = nullptr;
  {
    const std::lock_guard hold(lock_);
    if (over_ || out_.empty()) return;
    // The address of the message stays valid after the lock is released, because the message is removed only when it has been sent.
    out = &out_.front();
  }
  socket_.binary(out->binary);
  socket_.async_write(boost::asio::buffer(out->bytes), [self = shared_from_this()](beast::error_code error, std::size_t) {
    if (error) return self->lost();
    bool more = false, closes = false;
    {
      const std::lock_guard hold(self->lock_);
      self->unsent_ -= self->out_.front().bytes.size();
      self->out_.pop_front();
      more = !self->out_.empty();
      closes = !more && self->ends_;
    }
    self->news_.notify_all();
    if (more) self->write_next();
    if (closes) self->close(websocket::close_code::policy_error);
  });
}

/// Closes the connection after all pending messages have been sent to the page.
void Connection::close_when_sent() {
  {
    const std::lock_guard hold(lock_);
    ends_ = true;
    if (!out_.empty()) return;
  }
  close(websocket::close_code::policy_error);
}

void Connection::close(websocket::close_code code) {
  {
    const std::lock_guard hold(lock_);
    if (over_) return;
  }
  socket_.async_close(code, [self = shared_from_this()](beast::error_code) { self->lost(); });
}

void Connection::lost() {
  {
    const std::lock_guard hold(lock_);
    over_ = true;
    if (session_) session_->stop();
  }
  news_.notify_all();
}

}  // namespace kadr
