#pragma once
// AxisLinks: links between axes of different channels. Either an axis follows a master axis of another channel, or two axes are exchanged
// (nct 20.2, 20.3).
//
//   machine's logic ─▶ Control::cross_channel_axes() ─▶ relink()          a block of the master's channel ─▶ carry() ─▶ the follower has
//   moved along
//
// INFERRED: the follower travels as part of the master's motion, without an action of its own. An exchanged axis has the position, the
// end positions and the name (in alarms) of the axis that it drives; the programmed axis determines the times.

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "control/state/cross_channel_axis.h"
#include "session/channel_run.h"

namespace kadr {

struct Channel;

/// One link between two axes.
struct LinkedAxis {
  std::size_t channel = 0;  // index of the channel whose axis follows or is exchanged
  CrossChannelAxis far;
  std::size_t to_channel = 0, to_axis = 0;  // indices of the channel and the axis that are followed or exchanged
  double lead = 0;  // offset of a following axis: its machine position = lead + sign · machine position of the master
};

class AxisLinks {
 public:
  /// The arguments must outlive this object.
  AxisLinks(const std::vector<Channel>& channels, const std::vector<std::unique_ptr<ChannelRun>>& runs)
      : channels_(channels), runs_(runs) {}

  /// Called when the machine's logic has requested or ended links of axes in this channel.
  void relink(std::size_t channel);
  /// Called when the axes of a channel have moved: moves the axes of other channels that follow them.
  ///   alarms  if a follower exceeds its limits
  Status carry(std::size_t moved);

  const std::vector<LinkedAxis>& memory() const { return links_; }
  /// Restores the links. The channels must have been restored to the same time before this call.
  void resume_from(const std::vector<LinkedAxis>& then);

 private:
  using Place = std::pair<std::size_t, std::size_t>;  // index of a channel, index of an axis
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
