// kadr tape decode|encode: converts images of punched tape to text, and text to images.

#include "texts/tape_command.h"

#include <fmt/core.h>

#include "cli/job/files.h"
#include "cli/job/job.h"
#include "cli/job/outputs.h"
#include "cli/job/terminal.h"
#include "cli/options/options.h"
#include "lang/text/encoding.h"
#include "lang/text/tape_reading.h"
#include "lang/text/utf16.h"
#include "out/text/tape_text.h"

namespace kadr::cli {
namespace {

constexpr std::size_t longest_tape = 256u << 20;  // greatest size of a tape image, bytes: 680 km of tape

int decode(const TapeOptions& options, const std::string& rows, std::string& output, Lang lang) {
  const TapeReading read = read_tape(rows, tape_code_named(options.code));
  const bool is_turned = read.orientation != TapeOrientation::right;
  if (is_turned) complain(translated_in(lang, texts::tape_command::tape_was, options.input, orientation_in_words(read.orientation, lang)));
  for (const TapeFault& fault : read.faults) complain(fmt::format("{}: {}", options.input, fault_in_words(fault, read.code, lang)));
  output = read.text;
  return read.faults.empty() && !is_turned ? ok : alarms;
}

int encode(const TapeOptions& options, const std::string& bytes, std::string& output, Lang lang) {
  GivenEncoding given;
  if (!read_encoding(options.encoding, given)) {
    complain(no_encoding(options.encoding, lang));
    return wrong_usage;
  }
  const Encoding encoding = given.encoding ? *given.encoding : detect_encoding(bytes).value_or(Encoding::utf8);
  std::string text;
  if (!append_if_utf16(bytes, given, text))
    if (const Status decoded = append_utf8(bytes, encoding, text); !decoded) {
      complain(translated_in(lang, texts::tape_command::byte_not_in_encoding, options.input, decoded.error().where.begin + 1,
                             name_of(encoding)));
      return alarms;
    }
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);  // removes a byte order mark, which is not a character of the tape
  const TapeCode code = tape_code_named(options.code).value_or(TapeCode::iso);
  const std::string_view name = name_for_people(code);
  const auto rows = encode_tape(text, options.leader, code);
  if (!rows) {
    const Span at = rows.error().where;
    const std::string character = text.substr(at.begin, at.end - at.begin);
    complain(translated_in(lang, texts::tape_command::character_not_in_code, options.input, character, at.begin + 1, name));
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
  const int status = options.decode ? decode(options, *bytes, output, lang) : encode(options, *bytes, output, lang);
  if (output.empty() && status != ok) return status;
  if (!outputs.open()) return wrong_usage;
  write_data(outputs.stream("OUTPUT"), output);  // a write error is not checked here, since Outputs::keep() reports it
  return outputs.keep() ? status : wrong_usage;
}

}  // namespace kadr::cli
