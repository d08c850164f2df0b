#pragma once
// AxisLinks: axes of one channel that follow axes of another channel, or are exchanged with them (nct 20.2, 20.3).
//
//   machine's logic ─▶ Control::far_axes() ─▶ relink()          a block of the master's channel ─▶ carry() ─▶ the follower has moved along
//
// INFERRED: the travel of the follower is part of the master's motion and no action of its own. An exchanged axis has the position, the end
// positions and the name (in alarms) of the axis that it drives; times remain those of the programmed axis.

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "control/state/far_axis.h"
#include "session/channel_run.h"

namespace kadr {

struct Channel;

/// One link: which axis follows, or is exchanged with, which other axis, and their offset.
struct LinkedAxis {
  std::size_t channel = 0;  // index
  FarAxis far;
  std::size_t to_channel = 0, to_axis = 0;  // the master axis, or the axis exchanged with
  double lead = 0;                          // machine = lead + sign · machine of the master
};

class AxisLinks {
 public:
  /// Both must outlive it.
  AxisLinks(const std::vector<Channel>& channels, const std::vector<std::unique_ptr<ChannelRun>>& runs)
      : channels_(channels), runs_(runs) {}

  /// The machine's logic has requested or ended links in this channel.
  void relink(std::size_t channel);
  /// The axes of a channel have moved: moves the axes that follow them.
  ///   alarms  if a follower exceeds its limits
  Status carry(std::size_t moved);

  const std::vector<LinkedAxis>& memory() const { return links_; }
  /// Restores the links. The channels must be restored to the same time.
  void remember(const std::vector<LinkedAxis>& then);

 private:
  using Place = std::pair<std::size_t, std::size_t>;  // channel, axis
  std::optional<Place> place_of(int number) const;
  bool follows(Place axis, Place master) const;
  bool may_link(const LinkedAxis& link) const;
  void begin(LinkedAxis link);
  void end(const LinkedAxis& link);
  double master_at(const LinkedAxis& link) const;
  double lead_of(const LinkedAxis& link) const;

  const std::vector<Channel>& channels_;
  const std::vector<std::unique_ptr<ChannelRun>>& runs_;
  std::vector<LinkedAxis> links_;
};

}  // namespace kadr
