// Serial lines (termios) and TCP connections. Tested by tests/drive/byte_port_test.cpp and tests/drive.py over pseudo-terminals and the
// loopback interface.

#include "drive/port/byte_port.h"

#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "config/texts.h"
#include "texts/drive.h"

namespace kadr::drive {
namespace {

constexpr double write_wait = 1;    // s
constexpr double connect_wait = 5;  // s
constexpr std::string_view tcp = "tcp:";
constexpr std::pair<int, speed_t> rates[] = {{300, B300},       {600, B600},       {1200, B1200},    {2400, B2400},   {4800, B4800},
                                             {9600, B9600},     {19200, B19200},   {38400, B38400},  {57600, B57600}, {115200, B115200},
                                             {230400, B230400}, {460800, B460800}, {921600, B921600}};

const std::pair<int, speed_t>* rate_of(int baud) {
  const auto* const found = std::find_if(std::begin(rates), std::end(rates), [&](const auto& rate) { return rate.first == baud; });
  return found == std::end(rates) ? nullptr : found;
}

std::string text_of_error(int error) { return std::strerror(error); }  // NOLINT(concurrency-mt-unsafe): glibc's is safe

/// A file descriptor that is closed at the end of its life.
class OwnedFile {
 public:
  explicit OwnedFile(int fd) : fd_(fd) {}
  ~OwnedFile() {
    if (fd_ >= 0) ::close(fd_);
  }
  OwnedFile(OwnedFile&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  OwnedFile& operator=(OwnedFile&&) = delete;
  OwnedFile(const OwnedFile&) = delete;
  OwnedFile& operator=(const OwnedFile&) = delete;
  int fd() const { return fd_; }
  bool is_open() const { return fd_ >= 0; }

 private:
  int fd_;
};

class FilePort : public BytePort {
 public:
  enum class Kind : std::uint8_t { serial, network };
  FilePort(OwnedFile file, Kind kind) : file_(std::move(file)), kind_(kind) {}

  std::optional<std::string> read(double seconds) override {
    pollfd wanted = {file_.fd(), POLLIN, 0};
    const int ready = ::poll(&wanted, 1, static_cast<int>(seconds * 1000));
    if (ready < 0) return errno == EINTR ? std::optional<std::string>("") : std::nullopt;
    if (ready == 0) return "";
    std::array<char, 4096> bytes{};
    const ssize_t got = ::read(file_.fd(), bytes.data(), bytes.size());
    const std::string_view came(bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    if (got > 0) return kind_ == Kind::network ? telnet_.data_in(came) : std::string(came);
    if (got < 0 && (errno == EAGAIN || errno == EINTR)) return "";
    return std::nullopt;
  }

  bool write(std::string_view bytes) override {
    while (!bytes.empty()) {
      const ssize_t put = ::write(file_.fd(), bytes.data(), bytes.size());
      if (put > 0) {
        bytes.remove_prefix(static_cast<std::size_t>(put));
        continue;
      }
      if (put < 0 && errno != EAGAIN && errno != EINTR) return false;
      pollfd wanted = {file_.fd(), POLLOUT, 0};
      if (::poll(&wanted, 1, static_cast<int>(write_wait * 1000)) <= 0) return false;
    }
    return true;
  }

 private:
  OwnedFile file_;
  Kind kind_;
  TelnetFilter telnet_;
};

/// Sets the line: raw bytes, and the control lines stay as they are when the port is closed, since many boards restart when DTR changes.
bool set_line(int fd, const LineSettings& line) {
  termios settings{};
  if (::tcgetattr(fd, &settings) != 0) return false;
  ::cfmakeraw(&settings);
  settings.c_cflag &= ~static_cast<tcflag_t>(CSIZE | PARENB | PARODD | CSTOPB | CRTSCTS | HUPCL);
  settings.c_cflag |= static_cast<tcflag_t>(CLOCAL | CREAD | (line.data_bits == 7 ? CS7 : CS8));
  if (line.parity != Parity::none) settings.c_cflag |= static_cast<tcflag_t>(line.parity == Parity::odd ? PARENB | PARODD : PARENB);
  if (line.stop_bits == 2) settings.c_cflag |= static_cast<tcflag_t>(CSTOPB);
  if (line.rts_cts) settings.c_cflag |= static_cast<tcflag_t>(CRTSCTS);
  const auto* const rate = rate_of(line.baud);
  if (rate == nullptr || ::cfsetispeed(&settings, rate->second) != 0 || ::cfsetospeed(&settings, rate->second) != 0) return false;
  settings.c_cc[VMIN] = 0;
  settings.c_cc[VTIME] = 0;
  return ::tcsetattr(fd, TCSANOW, &settings) == 0;
}

tl::expected<std::unique_ptr<BytePort>, std::string> open_serial(const std::string& name, const LineSettings& line) {
  OwnedFile file(::open(name.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (!file.is_open()) return tl::unexpected(translated(texts::drive::port_not_opened, name, text_of_error(errno)));
  if (::isatty(file.fd()) == 0) return tl::unexpected(translated(texts::drive::no_serial_line, name));
  if (::flock(file.fd(), LOCK_EX | LOCK_NB) != 0 || ::ioctl(file.fd(), TIOCEXCL) != 0)
    return tl::unexpected(translated(texts::drive::port_in_use, name));
  if (!set_line(file.fd(), line)) return tl::unexpected(translated(texts::drive::line_not_set, name, line.baud, text_of_error(errno)));
  return std::make_unique<FilePort>(std::move(file), FilePort::Kind::serial);
}

/// Connects within `connect_wait`. Returns 0, or the number of the error.
int connected(int fd, const addrinfo& to) {
  if (::connect(fd, to.ai_addr, to.ai_addrlen) == 0) return 0;
  if (errno != EINPROGRESS) return errno;
  pollfd wanted = {fd, POLLOUT, 0};
  if (::poll(&wanted, 1, static_cast<int>(connect_wait * 1000)) <= 0) return ETIMEDOUT;
  int error = 0;
  socklen_t size = sizeof error;
  return ::getsockopt(fd, SOL_SOCKET, SO_ERROR, &error, &size) == 0 ? error : errno;
}

tl::expected<std::unique_ptr<BytePort>, std::string> open_tcp(const std::string& name) {
  const std::size_t colon = name.rfind(':');
  const std::string host = name.substr(0, colon);
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (colon == std::string::npos || ::getaddrinfo(host.c_str(), name.c_str() + colon + 1, &wanted, &found) != 0)
    return tl::unexpected(translated(texts::drive::no_such_host, name));
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> owner(found, ::freeaddrinfo);
  int error = 0;
  for (const addrinfo* one = found; one != nullptr; one = one->ai_next) {
    OwnedFile file(::socket(one->ai_family, one->ai_socktype | SOCK_CLOEXEC | SOCK_NONBLOCK, one->ai_protocol));
    error = file.is_open() ? connected(file.fd(), *one) : errno;
    if (error != 0) continue;
    const int on = 1;  // a feed hold does not wait for the bytes after it
    (void)::setsockopt(file.fd(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    return std::make_unique<FilePort>(std::move(file), FilePort::Kind::network);
  }
  return tl::unexpected(translated(texts::drive::port_not_opened, name, text_of_error(error)));
}

}  // namespace

bool is_baud_rate(int baud) { return rate_of(baud) != nullptr; }

double characters_per_second(const LineSettings& line) {
  const int bits = 1 + line.data_bits + (line.parity == Parity::none ? 0 : 1) + line.stop_bits;
  return static_cast<double>(line.baud) / bits;
}

double characters_per_second(const std::string& name, const LineSettings& line) {
  return name.starts_with(tcp) ? 0 : characters_per_second(line);
}

std::string TelnetFilter::data_in(std::string_view bytes) {
  constexpr unsigned char begin_parameters = 250, end_parameters = 240, will = 251, command = 255;
  std::string data;
  for (const char byte : bytes) {
    const auto code = static_cast<unsigned char>(byte);
    switch (expects_) {
      case Expects::data:
        if (code == command) expects_ = Expects::command;
        else data += byte;
        break;
      case Expects::command:
        if (code == command) data += byte;  // a doubled 255 is data
        expects_ = code == begin_parameters ? Expects::parameters : code >= will && code < command ? Expects::option : Expects::data;
        break;
      case Expects::option: expects_ = Expects::data; break;
      case Expects::parameters:
        if (code == command) expects_ = Expects::end_of_parameters;
        break;
      case Expects::end_of_parameters: expects_ = code == end_parameters ? Expects::data : Expects::parameters; break;
    }
  }
  return data;
}

tl::expected<std::unique_ptr<BytePort>, std::string> open_port(const std::string& name, const LineSettings& line) {
  return name.starts_with(tcp) ? open_tcp(name.substr(tcp.size())) : open_serial(name, line);
}

}  // namespace kadr::drive
