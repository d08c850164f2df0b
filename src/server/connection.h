#pragma once
// Connection: the WebSocket of one page. The network's thread reads and writes the socket; each connection has its own thread that
// answers requests.

#include <atomic>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <string>

#include "view/page/page_session.h"

namespace kadr {

using PageRequest = boost::beast::http::request<boost::beast::http::string_body>;

class Connection : public PageLine, public std::enable_shared_from_this<Connection> {
 public:
  /// `sessions`: counter of the open sessions, which is decremented when this object is destroyed. `page` must outlive this object.
  Connection(boost::beast::tcp_stream stream, const PageServer& page, std::shared_ptr<std::atomic<int>> sessions);
  ~Connection() override;

  void accept(const PageRequest& request);

  // The thread that answers requests calls the following functions to send a message to the page.
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
  std::mutex lock_;                       // mutex that protects all members below
  std::unique_ptr<PageSession> session_;  // the session of the page; nullptr after the session has ended
  std::condition_variable news_;
  std::deque<Question> questions_;
  std::size_t question_bytes_ = 0;
  std::deque<Outgoing> out_;  // messages for the page in the order of sending; the first one is being sent
  std::size_t unsent_ = 0;    // total length in bytes of the messages in out_
  // True after a request to stop: the present answer ends at once, and does not wait until the page has received the earlier messages.
  bool hurries_ = false;
  bool ends_ = false;  // true if the connection closes as soon as out_ is empty
  bool over_ = false;
};

}  // namespace kadr
