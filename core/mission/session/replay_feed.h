// Replay in a session: turns the records of a recording into the events of a live connection, and sends nothing.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/agent/command_port.h"
#include "core/link/replay.h"
#include "core/link/tcp_link.h"
#include "core/mission/session/session_orders.h"
#include "core/mission/session/session_update.h"
#include "core/protocol/traffic_counts.h"

namespace usar::mission {

/// A session as a replay sees it.
class ReplayStage {
public:
    virtual ~ReplayStage() = default;
    /// Everything received so far is void.
    virtual void replayRewound() = 0;
    /// Reports the map as described by the recording's facts; the cell size is nullopt if they do not contain it.
    virtual void replayBegan(std::optional<double> cell_size_m, const std::string& level) = 0;
    /// The replayed link has another state now.
    virtual void replayLinkChanged(const link::LinkStatus& status) = 0;
    /// A connection was established at this point of the recording.
    virtual void replayConnected() = 0;
    /// `lost`: the connection was not closed by us.
    virtual void replayClosed(bool lost) = 0;
    /// A received line with the number that it had in the recording; the text is valid during the call only.
    virtual void replayLine(std::string_view text, LineNumber number) = 0;
    /// The dialect in which commands were sent.
    virtual protocol::Dialect replaySpelling() const = 0;
    /// A sent command with its line; `after` is the newest info line received before it.
    virtual void replayCommand(const agent::CausedCommand& command, std::string text, LineNumber after) = 0;
    virtual void replayPublished(const agent::Published& value) = 0;
    /// A status that is only passed on the way to another moment.
    virtual void replayPassed(const agent::BehaviorStatus& status) = 0;
    /// The recording's note of the mission that the next task flies (FlownMission).
    virtual void replayMission(std::string_view note) = 0;
    virtual void replayTask(const ReplayedTask& task, const std::string& robot_name) = 0;
    virtual void replayFinished(const agent::BehaviorFinished& finished) = 0;
    virtual void replayFault(const std::string& sentence) = 0;
    /// `on`: a seek begins; what follows is only passed on the way to another moment.
    virtual void replaySeeks(bool on) = 0;
    virtual void replayChanged() = 0;
    /// The recording turned out to be damaged; the sentence says where and how much.
    virtual void replayDamaged(const std::string& complaint) = 0;
    /// The recording has been played to its end.
    virtual void replayEnds() = 0;
};

/// During a seek, only cumulative values are all passed on; for the others only the newest is passed on, because an
/// hour of them would be too much. Belongs to one session and its thread.
class ReplayFeed : private link::ReplayTaker {
public:
    /// `stage` must outlive this object.
    explicit ReplayFeed(ReplayStage& stage) : stage_(stage) {}

    /// Takes over the recording and begins to replay it.
    void begin(std::unique_ptr<link::RecordingReader> recording);
    void order(const ReplayOrder& order);
    void end();
    /// Resets the traffic counts because a connection, replayed or live, begins on the stage.
    void beginConnection() { traffic_ = {}; }

    /// True from `begin` to `end`.
    bool on() const { return replayer_ != nullptr; }
    /// Status of the replayed link.
    const link::LinkStatus& linkStatus() const { return link_; }
    /// Traffic of the replayed connection so far.
    const protocol::TrafficCounts& traffic() const { return traffic_; }
    /// Returns nullopt if nothing is replayed.
    std::optional<link::ReplayFigures> figures() const;

private:
    void rewound() override;
    void opened(std::string_view place) override;
    void closed(std::string_view reason) override;
    void line(std::string_view text, LineNumber number) override;
    void sent(const link::Record& record) override;
    void note(const link::Record& record) override;
    void quiet(bool on) override;

    void setLink(link::LinkState now, std::string_view reason);
    void takePublished(const agent::Published& value);
    void takeTask(std::string_view text);
    /// Passes on the newest values that were kept during a seek.
    void passNewest();

    ReplayStage& stage_;
    std::unique_ptr<link::Replayer> replayer_;
    link::LinkStatus link_;
    protocol::TrafficCounts traffic_;
    /// During a seek: the newest value of each kind for which only the newest matters.
    std::map<std::size_t, agent::Published> newest_on_the_way_;
    /// A seek is under way.
    bool on_the_way_ = false;
};

} // namespace usar::mission
