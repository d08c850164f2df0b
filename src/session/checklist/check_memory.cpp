// CheckMemory: lets the check of a changed text continue at a place before the change. Used by lsp/open_document; tested by
// tests/session/check_memory_test.cpp.

#include "session/checklist/check_memory.h"

#include <cstring>
#include <string>

namespace kadr {
namespace {

/// Returns the number of bytes, in whole pieces, in which the two texts begin equally; NotedSource::all if they are the same text.
std::uint64_t equal_bytes(ByteSource& a, ByteSource& b) {
  constexpr std::size_t piece = 4096;
  constexpr std::size_t pieces = 16;
  std::string of_a(piece * pieces, '\0'), of_b(piece * pieces, '\0');
  for (std::uint64_t at = 0;;) {
    const std::size_t got_a = a.read(at, of_a.data(), of_a.size()), got_b = b.read(at, of_b.data(), of_b.size());
    if (got_a == 0 && got_b == 0) return NotedSource::all;
    const std::size_t both = std::min(got_a, got_b);
    for (std::size_t i = 0; i < both; i += piece)
      if (std::memcmp(of_a.data() + i, of_b.data() + i, std::min(piece, both - i)) != 0) return at + i;
    if (got_a != got_b) return at + both;
    at += both;
  }
}

}  // namespace

std::unique_ptr<ByteSource> CheckMemory::follow(std::shared_ptr<ByteSource> text) {
  const std::uint64_t unchanged = text_ ? equal_bytes(*text_, *text) : 0;
  run_places_.keep_until(unchanged);
  text_places_.keep_until(unchanged);
  text_ = text;
  auto noted = std::make_unique<NotedSource>(std::move(text));
  noted_ = noted.get();
  return noted;
}

CheckMemory::Before CheckMemory::continue_run(Session& session, Checklist& checklist) {
  const RunPlace* const place = run_places_.last();
  if (place == nullptr) {
    reports_.clear();
    return {};
  }
  ++continued_;
  // The result is not needed: it is an alarm only if a called file is missing, and no place is stored once a file has been called.
  (void)session.restore(place->session);
  checklist.resume_from(place->checklist);
  reports_.resize(place->reported);
  return {std::exchange(reports_, {}), place->again};
}

void CheckMemory::store_run(Session& session, const Checklist& checklist, std::size_t again) {
  if (noted_ == nullptr || !run_places_.wants(noted_->known(), noted_->size())) return;
  if (!session.control().called_files().empty()) return;  // such a file may have changed too by the time of the next check
  auto now = session.snapshot();  // it waits for a control that runs ahead; only then is the number of known bytes that of the snapshot
  if (now) run_places_.store(noted_->known(), {std::move(*now), checklist.memory(), reports_.size(), again});
}

}  // namespace kadr
