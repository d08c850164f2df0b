#pragma once
// ZIP, as far as 3MF needs it: written with less than 4 GB; stored or deflated, without a password (PKWARE, APPNOTE.TXT 6.3).

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "stock/mesh/byte_sink.h"

namespace kadr {

struct ZipEntry {
  std::string_view name;
  std::uint16_t method;
  std::uint32_t crc;
  std::uint64_t packed, unpacked;  // bytes, as the directory says
  std::uint64_t local;             // where its own header stands
};

/// The archive's directory, within its bytes.
///   returns  an error sentence: no archive, cut off, too many files
tl::expected<std::vector<ZipEntry>, std::string> zip_entries(std::string_view archive);

/// Unpacks an entry.
///   most     bytes: what is longer is refused when it has come to that length, whatever the directory says
///   returns  an error sentence: longer, damaged, a method that is not known
tl::expected<std::string, std::string> zip_file(std::string_view archive, const ZipEntry& entry, std::size_t most);

/// Writes an archive file by file.
class ZipWriter {
 public:
  explicit ZipWriter(const ByteSink& sink) : sink_(sink) {}
  /// `content` fills the file through the sink that it is given. Packed as it comes, kept packed until it is whole.
  ///   returns  an error sentence; empty: written
  std::string add(const std::string& name, const std::function<bool(const ByteSink&)>& content);
  /// The directory; nothing may follow.
  std::string finish();

 private:
  bool put(const std::string& bytes);

  const ByteSink& sink_;
  std::string directory_;
  std::uint16_t count_ = 0;
  std::size_t written_ = 0;
};

}  // namespace kadr
