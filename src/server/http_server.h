#pragma once
// HttpServer: HTTP and WebSocket for the page, one PageSession a connection, each with a thread of its own; one thread for the network.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <tl/expected.hpp>

#include "server/guard.h"
#include "view/page_session.h"

namespace kadr {

class HttpServer {
 public:
  static constexpr int most_sessions = 32;

  /// Listens, on a free port where 0 is asked for. `page` must outlive it.
  ///   returns  an error sentence
  static tl::expected<std::unique_ptr<HttpServer>, std::string> listen(const ServedAddress& address, const PageServer& page);
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  /// With the port that it got.
  const ServedAddress& address() const;
  /// Serves until stop().
  void run();
  /// From any thread.
  void stop();

 private:
  struct Inside;
  explicit HttpServer(std::shared_ptr<Inside> inside) : inside_(std::move(inside)) {}
  std::shared_ptr<Inside> inside_;
};

}  // namespace kadr
