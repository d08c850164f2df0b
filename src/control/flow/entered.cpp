// The operator's changes to the program flow: a line is entered (MDI), or a block that was read is returned, so that it is read
// again. Used by control/interpreter; tested by tests/session/stepping_test.cpp.

#include <utility>

#include "control/flow/flow.h"

namespace kadr {

Flow::Mark Flow::mark() const {
  const BlockReader& reader = now_.reader == 1 ? *bodies_ : files_[now_.reader]->reader();
  return {position(), reader.memory(), now_.blocks, now_.repeated, now_.ended};
}

void Flow::unread(const Mark& before) {
  BlockReader& reader = now_.reader == 1 ? *bodies_ : files_[now_.reader]->reader();
  reader.resume_from(before.memory);
  go_to(now_.reader, before.position);
  now_.blocks = before.blocks;
  now_.repeated = before.repeated;
  now_.ended = before.ended;
}

void Flow::enter(std::string line) {
  if (now_.entered.on) leave_entered();
  auto file = std::make_unique<ProgramFile>("MDI", text_source(std::string(line)), body_grammar_, Encoding::utf8);
  Entered& entered = now_.entered;
  if (entered.reader == 0) {
    entered.reader = static_cast<std::uint16_t>(files_.size());
    files_.push_back(nullptr);
  }
  files_[entered.reader] = std::move(file);
  entered = {true, now_.ended, now_.started, entered.reader, now_.reader, position(), now_.frames.size(), std::move(line)};
  now_.ended = false;
  now_.started = true;  // an entered line does not need a sign % before it
  go_to(entered.reader, {});
}

bool Flow::leave_entered() {
  Entered& entered = now_.entered;
  if (!entered.on) return false;
  entered.on = false;
  now_.frames.resize(std::min(now_.frames.size(), entered.depth));
  now_.ended = entered.ended;
  now_.started = entered.started;
  go_to(entered.back_reader, entered.back);
  return true;
}

}  // namespace kadr
