// HttpServer: the server of the page. This file accepts connections and answers HTTP requests. Used by cli/serve; tested by tests/serve.py.

#include "server/http_server.h"

#include <boost/asio/ip/tcp.hpp>
#include <chrono>
#include <new>
#include <optional>

#include "server/connection.h"
#include "server/page_files.h"
#include "texts/serve_command.h"

namespace kadr {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using tcp = asio::ip::tcp;
using Response = http::response<http::string_body>;

constexpr std::uint32_t max_header = 16 << 10, most_body = 1 << 10;  // greatest size in bytes of the header and of the body of a request
constexpr auto request_timeout = std::chrono::seconds(10), until_taken = std::chrono::seconds(60);
constexpr int max_requests = 512;  // greatest number of open connections without a session; the server closes further connections

constexpr const char* policy =
    "default-src 'none'; script-src 'self'; worker-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' blob:; connect-src 'self'; "
    "font-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

const EmbeddedFile* file_of(std::string_view target) {
  target = target.substr(0, target.find('?'));
  const std::string_view name = target == "/" ? std::string_view("index.html") : target.substr(1);
  for (const EmbeddedFile& file : page_files())
    if (file.name == name) return &file;
  return nullptr;
}

Response answer(const PageRequest& request, http::status status, std::string_view type, std::string body) {
  Response response{status, request.version()};
  response.set(http::field::content_type, beast::string_view(type.data(), type.size()));
  response.set(http::field::cache_control, "no-cache");
  response.set("Content-Security-Policy", policy);
  response.set("X-Content-Type-Options", "nosniff");
  response.set("Referrer-Policy", "no-referrer");
  response.set("Cross-Origin-Resource-Policy", "same-origin");
  response.set("Cross-Origin-Opener-Policy", "same-origin");
  response.keep_alive(request.keep_alive());
  response.body() = std::move(body);
  response.prepare_payload();
  return response;
}

std::string_view view_of(beast::string_view text) { return {text.data(), text.size()}; }

constexpr std::string_view plain = "text/plain; charset=utf-8";

/// Answers an HTTP request that does not open a WebSocket.
Response answer_to(const PageRequest& request) {
  if (request.method() != http::verb::get && request.method() != http::verb::head) {
    Response refused = answer(request, http::status::method_not_allowed, plain, "GET, HEAD\n");
    refused.set(http::field::allow, "GET, HEAD");
    return refused;
  }
  const std::string_view target = view_of(request.target());
  if (target == "/health") return answer(request, http::status::ok, plain, "ok\n");
  if (!target.starts_with('/')) return answer(request, http::status::bad_request, plain, "bad request\n");
  const EmbeddedFile* const file = file_of(target);
  if (file != nullptr) return answer(request, http::status::ok, content_type(file->name), std::string(file->text));
  if (page_files().empty() && target == "/")
    return answer(request, http::status::service_unavailable, plain, translated(texts::serve_command::no_page) + "\n");
  return answer(request, http::status::not_found, plain, "not found\n");
}

}  // namespace

struct HttpServer::Inside : std::enable_shared_from_this<Inside> {
  Inside(ServedAddress its_address, const PageServer& its_page) : address(std::move(its_address)), page(its_page), acceptor(network) {}
  void accept();

  ServedAddress address;
  const PageServer& page;
  asio::io_context network{1};
  tcp::acceptor acceptor;
  asio::steady_timer rest{network};
  std::shared_ptr<std::atomic<int>> sessions = std::make_shared<std::atomic<int>>(0);
  std::atomic<int> requests{0};
};

namespace {

/// A connection, from its acceptance until a WebSocket session begins or the connection ends.
class Request : public std::enable_shared_from_this<Request> {
 public:
  struct Shared {
    const ServedAddress& address;
    const PageServer& page;
    std::shared_ptr<std::atomic<int>> sessions;
    std::atomic<int>& requests;
  };
  Request(tcp::socket socket, const Shared& shared) : stream_(std::move(socket)), shared_(shared) { ++shared_.requests; }
  ~Request() { --shared_.requests; }

  void read() {
    parser_.emplace();
    parser_->header_limit(max_header);
    parser_->body_limit(most_body);
    stream_.expires_after(request_timeout);
    http::async_read(stream_, buffer_, *parser_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      if (!error) self->take(self->parser_->release());
    });
  }

 private:
  void take(PageRequest request) {
    const std::string host(view_of(request[http::field::host])), origin(view_of(request[http::field::origin]));
    if (!is_own_host(shared_.address, host) || !is_own_origin(origin, host))
      return write(answer(request, http::status::forbidden, plain, "forbidden\n"), false, false);
    if (!beast::websocket::is_upgrade(request))
      return write(answer_to(request), request.keep_alive(), request.method() == http::verb::head);
    if (view_of(request.target()) != "/session") return write(answer(request, http::status::not_found, plain, "not found\n"), false, false);
    if (++*shared_.sessions > HttpServer::max_sessions) {
      --*shared_.sessions;
      return write(answer(request, http::status::service_unavailable, plain, "too many sessions\n"), false, false);
    }
    std::make_shared<Connection>(std::move(stream_), shared_.page, shared_.sessions)->accept(request);
  }

  void write(Response response, bool keeps, bool head_only) {
    stream_.expires_after(until_taken);
    response.keep_alive(keeps);
    response_ = std::move(response);
    const auto written = [self = shared_from_this(), keeps](beast::error_code error, std::size_t) {
      if (error || !keeps) return self->end();
      self->read();
    };
    if (!head_only) return http::async_write(stream_, response_, written);
    serializer_.emplace(response_);
    http::async_write_header(stream_, *serializer_, written);
  }

  void end() {
    beast::error_code ignored;
    stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
  }

  beast::tcp_stream stream_;
  Shared shared_;
  beast::flat_buffer buffer_{std::size_t{64} << 10};
  std::optional<http::request_parser<http::string_body>> parser_;
  Response response_;
  std::optional<http::response_serializer<http::string_body>> serializer_;
};

}  // namespace

void HttpServer::Inside::accept() {
  acceptor.async_accept([self = shared_from_this()](beast::error_code error, tcp::socket socket) {
    if (error == asio::error::operation_aborted) return;
    if (!error && self->requests < max_requests)
      std::make_shared<Request>(std::move(socket), Request::Shared{self->address, self->page, self->sessions, self->requests})->read();
    if (!error) return self->accept();
    // No file descriptor is free: the server accepts connections again after 50 ms.
    self->rest.expires_after(std::chrono::milliseconds(50));
    self->rest.async_wait([self](beast::error_code stopped) {
      if (!stopped) self->accept();
    });
  });
}

tl::expected<std::unique_ptr<HttpServer>, std::string> HttpServer::listen(const ServedAddress& address, const PageServer& page) {
  auto inside = std::make_shared<Inside>(address, page);
  beast::error_code error;
  const auto place = asio::ip::make_address(address.host == "localhost" ? "127.0.0.1" : address.host, error);
  const auto fault = [&] { return tl::unexpected(address.host + ":" + std::to_string(address.port) + ": " + error.message()); };
  if (error) return fault();
  const tcp::endpoint end(place, address.port);
  tcp::acceptor& acceptor = inside->acceptor;
  if (acceptor.open(end.protocol(), error)) return fault();
  acceptor.set_option(asio::socket_base::reuse_address(true), error);
  if (error || acceptor.bind(end, error) || acceptor.listen(asio::socket_base::max_listen_connections, error)) return fault();
  inside->address.port = acceptor.local_endpoint().port();
  return std::unique_ptr<HttpServer>(new HttpServer(std::move(inside)));
}

HttpServer::~HttpServer() = default;

const ServedAddress& HttpServer::address() const { return inside_->address; }

void HttpServer::run() {
  inside_->accept();
  for (bool over = false; !over;) {
    try {
      inside_->network.run();
      over = true;
      // Memory is exhausted; the exception has ended only the connection that needed it, and the server continues.
    } catch (const std::bad_alloc&) {
    }
  }
}

void HttpServer::stop() { inside_->network.stop(); }

}  // namespace kadr
