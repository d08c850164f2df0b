#pragma once
// RunHistory: snapshots of a run at regular numbers of blocks, so that the run can go back to any block that it has executed.
//
//   ●────────●────────●───▸ present block      ●: a snapshot
//            ↑ restored, and run again up to the wanted block

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "base/stop_token.h"
#include "session/stepping.h"

namespace kadr {

class RunHistory {
 public:
  /// Stores the first snapshot.
  ///   pre  the session is held before its first block; both outlive this object
  RunHistory(Session& session, Stepping& stepping);

  /// Stores a snapshot if enough blocks were executed since the last one. To be called between two calls of Session::go_on().
  void note();
  /// Goes back to the block with this number (Origin::number), and is held before it. Number 0 is the beginning.
  ///   returns  the state of the session: held, or another one if there is no such block
  ///   alarms   as Session::restore()
  Result<Session::State> go_back(std::uint32_t number);
  /// A search for the last block before the present one at which a stop point holds the program.
  struct Search {
    std::uint32_t until = 0;              // the blocks from this number on have been searched
    bool inside = false;                  // true: a part of the run before `until` is being searched
    std::optional<std::uint32_t> last{};  // the last block found in that part so far
  };
  Search begin_search() const;
  /// Searches the part of the run from one snapshot to the next. If nothing is found there, the session is held at the end of that part.
  ///   holds    returns false for a stop point, by its number, that is passed over
  ///   stop     ends the search where the session is held next (Stepping::hold_next()); the next call continues there
  ///   returns  the state of the session at the block that was found, or at the beginning; nullopt: the search goes on
  ///   alarms   as Session::restore()
  Result<std::optional<Session::State>> search(Search& of, const std::function<bool(std::size_t)>& holds, const StopToken& stop);

 private:
  bool search_part(Search& of, const std::function<bool(std::size_t)>& holds, const StopToken& stop);

  struct Kept {
    Stepping::Memory memory;
    std::uint32_t number = 0;  // number of the last block that was executed before the snapshot
  };
  Session& session_;
  Stepping& stepping_;
  std::optional<Stepping::Memory> first_;  // the state before the first block
  std::vector<Kept> all_;
  std::uint32_t each_;  // number of blocks between two snapshots
};

}  // namespace kadr
