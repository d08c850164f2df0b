#pragma once
// Connection: the WebSocket of one page. The network's thread reads and writes, a thread of its own answers.

#include <atomic>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <string>

#include "view/page_session.h"

namespace kadr {

using PageRequest = boost::beast::http::request<boost::beast::http::string_body>;

class Connection : public PageLine, public std::enable_shared_from_this<Connection> {
 public:
  /// `sessions`: that are open; counted down when this one is over. What it is given must outlive it.
  Connection(boost::beast::tcp_stream stream, const PageServer& page, std::shared_ptr<std::atomic<int>> sessions);
  ~Connection() override;

  void accept(const PageRequest& request);

  // ---- of the thread that answers
  bool text(std::string message) override { return send({std::move(message), false}); }
  bool frame(std::string bytes) override { return send({std::move(bytes), true}); }

 private:
  struct Question {
    std::string text;
    bool stopped = false;
  };
  struct Outgoing {
    std::string bytes;
    bool binary;
  };
  void read();
  void take_message();
  void answer_all();
  bool answer_next();
  bool send(Outgoing out);
  void write_next();
  void close(boost::beast::websocket::close_code code);
  void close_when_sent();
  void lost();

  boost::beast::websocket::stream<boost::beast::tcp_stream> socket_;
  boost::beast::flat_buffer buffer_;
  std::shared_ptr<std::atomic<int>> sessions_;
  std::mutex lock_;                       // of all below
  std::unique_ptr<PageSession> session_;  // nullptr: it is over
  std::condition_variable news_;
  std::deque<Question> questions_;
  std::size_t question_bytes_ = 0;
  std::deque<Outgoing> out_;  // the first one is being written
  std::size_t unsent_ = 0;    // bytes
  bool hurries_ = false;      // what is being answered is to end at once: it does not wait for the page to take off what was sent
  bool ends_ = false;         // it is closed when all is sent
  bool over_ = false;
};

}  // namespace kadr
