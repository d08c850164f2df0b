#pragma once
// HttpServer: the HTTP and WebSocket server of the page. Each connection has its own PageSession with its own thread; one more thread
// serves the network.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <tl/expected.hpp>

#include "server/guard.h"
#include "view/page/page_session.h"

namespace kadr {

class HttpServer {
 public:
  static constexpr int max_sessions = 32;

  /// Starts listening, on any free port if the port is 0. `page` must outlive the server.
  ///   returns  the server, or a sentence that describes the error
  static tl::expected<std::unique_ptr<HttpServer>, std::string> listen(const ServedAddress& address, const PageServer& page);
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  /// Returns the address that the server listens on, with the actual port.
  const ServedAddress& address() const;
  /// Serves requests until stop() is called.
  void run();
  /// Ends run(). May be called from any thread.
  void stop();

 private:
  struct Inside;
  explicit HttpServer(std::shared_ptr<Inside> inside) : inside_(std::move(inside)) {}
  std::shared_ptr<Inside> inside_;
};

}  // namespace kadr
