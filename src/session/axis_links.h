#pragma once
// AxisLinks: links between axes of different channels. A link either makes an axis follow a master axis of another channel, or exchanges
// two axes between their channels (nct 20.2, 20.3).
//
//   machine's logic ─▶ Control::cross_channel_axes() ─▶ relink()
//   a block of the master's channel ─▶ carry() ─▶ the following axis has moved with its master
//
// INFERRED: the following axis moves as part of the master's motion, without an action of its own. An exchanged axis has the position, the
// end positions and the name (in alarms) of the axis that it drives. The programmed axis determines the times.

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "control/state/cross_channel_axis.h"
#include "session/channel_run.h"

namespace kadr {

struct Channel;

/// A link between two axes of different channels.
struct LinkedAxis {
  std::size_t channel = 0;  // index of the channel whose axis follows or is exchanged
  CrossChannelAxis far;
  // two indices: of the other axis of the link (the master, or the exchanged axis) in its channel, and of that channel
  std::size_t to_channel = 0, to_axis = 0;
  // Offset of a following axis, mm or degrees: its machine position is offset + sign · machine position of the master.
  double offset = 0;
};

class AxisLinks {
 public:
  /// The constructor stores references to both arguments, so they must outlive the AxisLinks object.
  AxisLinks(const std::vector<Channel>& channels, const std::vector<std::unique_ptr<ChannelRun>>& runs)
      : channels_(channels), runs_(runs) {}

  /// Updates the links of this channel. The caller calls this function when the machine's logic has requested or ended links of the
  /// channel's axes.
  void relink(std::size_t channel);
  /// Moves the axes of other channels that follow axes of the channel `moved`. The caller calls this function when the axes of that channel
  /// have moved.
  ///   alarms  if a following axis would exceed its limits
  Status carry(std::size_t moved);

  const std::vector<LinkedAxis>& memory() const { return links_; }
  /// Replaces the links by stored ones. The caller must restore the channels to the same instant before this call.
  void resume_from(const std::vector<LinkedAxis>& then);

 private:
  using Place = std::pair<std::size_t, std::size_t>;  // index of a channel and index of an axis in that channel
  std::optional<Place> place_of(int number) const;
  bool follows(Place axis, Place master) const;
  bool may_link(const LinkedAxis& link) const;
  void begin(LinkedAxis link);
  void end(const LinkedAxis& link);
  double master_at(const LinkedAxis& link) const;
  double offset_of(const LinkedAxis& link) const;

  const std::vector<Channel>& channels_;
  const std::vector<std::unique_ptr<ChannelRun>>& runs_;
  std::vector<LinkedAxis> links_;
};

}  // namespace kadr
