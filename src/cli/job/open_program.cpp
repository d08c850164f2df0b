// Opens the text of a program, and finds one of several programs on a tape. This file is used by cli/job/job and tested by
// tests/run_tapes.py and tests/utf16.py.

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "cli/job/job.h"
#include "config/read_file.h"
#include "lang/text/several_programs.h"
#include "lang/text/utf16.h"
#include "texts/job.h"

namespace kadr::cli {
namespace {

/// The text of a program, with its encoding.
struct Text {
  std::shared_ptr<ByteSource> source;
  std::optional<Encoding> encoding;
};

Text text_of(const Job& job) {
  OpenedText text = open_text(job.file, job.encoding);
  return {std::move(text.source), text.encoding};
}

/// Returns the stated encoding. If none is stated, it is detected from the first bytes of the file.
std::optional<Encoding> encoding_of(const Text& text) {
  return text.encoding ? text.encoding : detect_encoding(LineReader(text.source).sample());
}

/// Returns the programs of a tape with several programs, or an empty list for any other file. If the beginning of a file contains no second
/// % sign, the file has only one program, and the rest is not read.
TapeContents programs_of(const Job& job, const Text& text) {
  if (!job.def->grammar.percent_number) return {};
  const auto encoding = encoding_of(text);
  if (count_program_signs(*text.source, encoding) < 2 && job.program == 0) return {};
  return contents_of(text.source, job.def->grammar, encoding);
}

/// Returns the numbers of the programs as text for a message.
std::string numbers_of(const TapeContents& contents) {
  if (contents.programs.size() < 2)
    return contents.programs.empty() || contents.programs[0].number == 0 ? "%" : std::to_string(contents.programs[0].number);
  std::string text;
  for (std::size_t i = 0; i < contents.programs.size(); ++i) {
    const std::uint32_t number = contents.programs[i].number;
    text += fmt::format("{}{}", i == 0 ? "" : ", ", number != 0 ? std::to_string(number) : "%");
  }
  return text;
}

}  // namespace

std::size_t count_programs(const Job& job) {
  if (job.file == "-") return 1;
  const Text text = text_of(job);
  return text.source ? std::max<std::size_t>(programs_of(job, text).programs.size(), 1) : 1;
}

std::optional<Program> open_program(const Job& job) {
  OpenedText opened = open_text(job.file, job.encoding);
  Program program{job.file, std::move(opened.source), opened.encoding};
  if (!program.source) {
    complain(fmt::format("{}: {}", job.file, errno_message(errno)));
    return std::nullopt;
  }
  if (!job.def->grammar.percent_number && job.program == 0) return program;
  const Text text{std::move(program.source), program.encoding};
  const TapeContents contents = programs_of(job, text);
  std::optional<std::size_t> index = job.program_index;
  if (job.program != 0) {
    index = program_numbered(contents, job.program);
    if (!index) {
      complain(translated_in(job.lang, texts::job::no_program_on_tape, job.file, job.program, numbers_of(contents)));
      return std::nullopt;
    }
  } else if (contents.programs.size() > 1 && !index) {
    complain(translated_in(job.lang, texts::job::several_programs_on_tape, job.file, numbers_of(contents)));
    index = 0;
  }
  if (index && *index < contents.programs.size()) program.source = only_program(text.source, contents, *index, encoding_of(text));
  else program.source = whole_file(text.source);
  return program;
}

}  // namespace kadr::cli
