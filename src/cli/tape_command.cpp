// kadr tape decode|encode: punched tape images and text.

#include <fmt/core.h>

#include "cli/files.h"
#include "cli/options.h"
#include "cli/outputs.h"
#include "lang/encoding.h"
#include "lang/tape.h"

namespace kadr::cli {
namespace {

constexpr std::size_t longest_tape = 256u << 20;  // bytes: 680 km of tape

int decode(const TapeOptions& options, const std::string& rows, std::string& output, bool ru) {
  const TapeText text = decode_tape(rows);
  for (const TapeFault& fault : text.faults)
    complain(ru ? fmt::format("{}: строка {}: нечётное число отверстий (байт {:03o})", options.input, fault.row, fault.byte)
                : fmt::format("{}: row {}: parity error (byte {:03o})", options.input, fault.row, fault.byte));
  output = text.text;
  return text.faults.empty() ? ok : alarms;
}

int encode(const TapeOptions& options, const std::string& bytes, std::string& output, bool ru) {
  auto encoding = options.encoding.empty() ? detect_encoding(bytes) : encoding_named(options.encoding);
  if (!options.encoding.empty() && !encoding) return complain(fmt::format("no encoding '{}'", options.encoding)), wrong_usage;
  std::string text;
  if (const Status decoded = append_utf8(bytes, encoding.value_or(Encoding::utf8), text); !decoded)
    return complain(fmt::format("{}: byte {}: not text in {}", options.input, decoded.error().where.begin + 1,
                                name_of(encoding.value_or(Encoding::utf8)))),
           alarms;
  const auto rows = encode_tape(text, options.leader);
  if (!rows) {
    const Span at = rows.error().where;
    complain(
        ru ? fmt::format("{}: символ '{}' (байт {}) не пробить в коде ISO-7", options.input, text.substr(at.begin, at.end - at.begin),
                         at.begin + 1)
           : fmt::format("{}: '{}' (byte {}) has no ISO-7 code", options.input, text.substr(at.begin, at.end - at.begin), at.begin + 1));
    return alarms;
  }
  output = *rows;
  return ok;
}

}  // namespace

int tape(const TapeOptions& options) {
  Options shared;
  shared.lang = options.lang;
  const Lang lang = language(shared);
  Outputs outputs(lang);
  outputs.reads(options.input);
  outputs.writes("OUTPUT", options.output.empty() ? "-" : options.output);
  if (!outputs.check()) return wrong_usage;
  const auto bytes = read_all(options.input, longest_tape);
  if (!bytes) return wrong_usage;
  std::string output;
  const int status = options.decode ? decode(options, *bytes, output, lang == Lang::ru) : encode(options, *bytes, output, lang == Lang::ru);
  if (output.empty() && status != ok) return status;
  if (!outputs.open()) return wrong_usage;
  std::fwrite(output.data(), 1, output.size(), outputs.stream("OUTPUT"));  // keep() tells whether all was written
  return outputs.keep() ? status : wrong_usage;
}

}  // namespace kadr::cli
