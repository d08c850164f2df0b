// The wire to a machine: a serial line over a pseudo-terminal, a TCP connection on the loopback interface, and what ends them.

#include "drive/port/byte_port.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>

namespace kadr::drive::byte_port_test {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// The machine's end of a serial line.
class Terminal {
 public:
  Terminal() : master_(::posix_openpt(O_RDWR | O_NOCTTY)) {
    EXPECT_EQ(::grantpt(master_), 0);
    EXPECT_EQ(::unlockpt(master_), 0);
    name_ = ::ptsname(master_);
  }
  ~Terminal() { pull(); }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  const std::string& name() const { return name_; }
  int fd() const { return master_; }
  void put(std::string_view bytes) const { EXPECT_EQ(::write(master_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size())); }
  std::string get() const {
    char bytes[256];
    const ssize_t got = ::read(master_, bytes, sizeof bytes);
    return {bytes, static_cast<std::size_t>(std::max<ssize_t>(got, 0))};
  }
  /// The cable is pulled.
  void pull() {
    if (master_ >= 0) ::close(master_);
    master_ = -1;
  }

 private:
  int master_;
  std::string name_;
};

/// A controller in the network, on the loopback interface.
class Listener {
 public:
  Listener() : fd_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in here{};
    here.sin_family = AF_INET;
    here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof here;
    EXPECT_EQ(::bind(fd_, reinterpret_cast<sockaddr*>(&here), size), 0);
    EXPECT_EQ(::listen(fd_, 1), 0);
    EXPECT_EQ(::getsockname(fd_, reinterpret_cast<sockaddr*>(&here), &size), 0);
    name_ = fmt::format("tcp:127.0.0.1:{}", ntohs(here.sin_port));
  }
  ~Listener() {
    if (peer_ >= 0) ::close(peer_);
    ::close(fd_);
  }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  const std::string& name() const { return name_; }
  void accept() { peer_ = ::accept(fd_, nullptr, nullptr); }
  void put(std::string_view bytes) const { EXPECT_EQ(::send(peer_, bytes.data(), bytes.size(), 0), static_cast<ssize_t>(bytes.size())); }
  std::string get() const {
    char bytes[256];
    const ssize_t got = ::recv(peer_, bytes, sizeof bytes, 0);
    return {bytes, static_cast<std::size_t>(std::max<ssize_t>(got, 0))};
  }
  void close() { ::close(std::exchange(peer_, -1)); }

 private:
  int fd_, peer_ = -1;
  std::string name_;
};

TEST(BytePort, ASerialLineCarriesAllBytesUnchanged) {
  const Terminal terminal;
  const auto port = open_port(terminal.name(), {});
  ASSERT_TRUE(port) << port.error();
  const std::string bytes("\x18?!~\x84\r\n\t \x7f\xff", 11);  // what a terminal would interpret
  EXPECT_TRUE((*port)->write(bytes));
  EXPECT_EQ(terminal.get(), bytes);
  terminal.put("ok\r\n\x11\x13");
  EXPECT_EQ((*port)->read(1), "ok\r\n\x11\x13");
}

TEST(BytePort, TheLineHasTheSettingsThatAreWanted) {
  const Terminal terminal;
  LineSettings line;
  line.baud = 9600;
  line.data_bits = 7;
  line.parity = Parity::even;
  line.stop_bits = 2;
  const auto port = open_port(terminal.name(), line);
  ASSERT_TRUE(port) << port.error();
  termios is{};
  ASSERT_EQ(::tcgetattr(terminal.fd(), &is), 0);
  EXPECT_EQ(::cfgetospeed(&is), speed_t{B9600});
  EXPECT_NE(is.c_cflag & tcflag_t{CSTOPB}, 0U);
  EXPECT_EQ(is.c_cflag & tcflag_t{HUPCL}, 0U) << "closing the port would reset many boards";
  EXPECT_EQ(is.c_iflag & tcflag_t{IXON | IXOFF | ICRNL}, 0U);
  EXPECT_EQ(is.c_lflag & tcflag_t{ECHO | ICANON | ISIG}, 0U);
}

TEST(BytePort, ReadWaitsNotLongerThanItMay) {
  const Terminal terminal;
  const auto port = open_port(terminal.name(), {});
  ASSERT_TRUE(port);
  const auto begin = Clock::now();
  EXPECT_EQ((*port)->read(0.05), "");
  EXPECT_GE(seconds_since(begin), 0.045);
  EXPECT_LT(seconds_since(begin), 1);
}

TEST(BytePort, APulledCableIsNoticed) {
  Terminal terminal;
  const auto port = open_port(terminal.name(), {});
  ASSERT_TRUE(port);
  terminal.put("ok\r\n");
  EXPECT_EQ((*port)->read(1), "ok\r\n");
  terminal.pull();
  EXPECT_EQ((*port)->read(1), std::nullopt);
  EXPECT_FALSE((*port)->write("!"));
}

TEST(BytePort, AMachineThatAcceptsNothingEndsTheWrite) {
  const Terminal terminal;
  const auto port = open_port(terminal.name(), {});
  ASSERT_TRUE(port);
  const auto begin = Clock::now();
  EXPECT_FALSE((*port)->write(std::string(1U << 20, 'G')));
  EXPECT_LT(seconds_since(begin), 10);
}

TEST(BytePort, APortHasOneOwner) {
  const Terminal terminal;
  auto port = open_port(terminal.name(), {});
  ASSERT_TRUE(port);
  const auto second = open_port(terminal.name(), {});
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().find("another program"), std::string::npos) << second.error();
  port->reset();
  EXPECT_TRUE(open_port(terminal.name(), {}));
}

TEST(BytePort, WhatIsNoPortIsRefused) {
  EXPECT_FALSE(open_port("/nonexistent", {}));
  EXPECT_FALSE(open_port("/dev/null", {}));
  EXPECT_FALSE(open_port("tcp:127.0.0.1", {}));
  EXPECT_FALSE(open_port("tcp:", {}));
  LineSettings line;
  line.baud = 1000;
  const Terminal terminal;
  EXPECT_FALSE(open_port(terminal.name(), line));
  EXPECT_FALSE(is_baud_rate(1000));
  EXPECT_TRUE(is_baud_rate(115200));
}

TEST(BytePort, ANetworkConnectionCarriesBytesBothWays) {
  Listener listener;
  const auto port = open_port(listener.name(), {});
  ASSERT_TRUE(port) << port.error();
  listener.accept();
  EXPECT_TRUE((*port)->write("?\n\x18\x85"));
  EXPECT_EQ(listener.get(), "?\n\x18\x85");
  listener.put("ok\r\n");
  EXPECT_EQ((*port)->read(1), "ok\r\n");
  listener.close();
  EXPECT_EQ((*port)->read(1), std::nullopt);
}

TEST(BytePort, ARefusedConnectionSaysWhy) {
  std::string name;
  {
    const Listener listener;
    name = listener.name();
  }
  const auto port = open_port(name, {});
  ASSERT_FALSE(port);
  EXPECT_NE(port.error().find("efused"), std::string::npos) << port.error();
}

TEST(BytePort, TelnetCommandsAreRemoved) {
  Listener listener;
  const auto port = open_port(listener.name(), {});
  ASSERT_TRUE(port);
  listener.accept();
  listener.put("\xff\xfb\x01o\xff\xfd\x03k\r\n");
  EXPECT_EQ((*port)->read(1), "ok\r\n");
  TelnetFilter filter;
  std::string data;
  for (const char byte : std::string("<Idle\xff\xfa\x18\x01\xff\xff\xf0\xff\xf0|\xff\xf1MPos\xff\xff>")) data += filter.data_in({&byte, 1});
  EXPECT_EQ(data, "<Idle|MPos\xff>");
}

TEST(BytePort, TheRateOfALineCountsAllBits) {
  LineSettings line;
  EXPECT_EQ(characters_per_second(line), 11520);
  line = {4800, 7, Parity::even, 2, false};
  EXPECT_NEAR(characters_per_second(line), 4800.0 / 11, 1e-9);
  EXPECT_EQ(characters_per_second("tcp:host:23", line), 0);
  EXPECT_EQ(characters_per_second("/dev/ttyUSB0", line), characters_per_second(line));
}

}  // namespace kadr::drive::byte_port_test
