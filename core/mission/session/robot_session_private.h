// Implementation of RobotSession: its parts, and what they tell one another. Included by its own .cpp files only.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <QElapsedTimer>
#include <QTimer>

#include "core/mission/session/helm.h"
#include "core/mission/session/incoming.h"
#include "core/mission/session/notices.h"
#include "core/mission/session/record_keeping.h"
#include "core/mission/session/replay_feed.h"
#include "core/mission/session/robot_session.h"
#include "core/mission/session/scan_book.h"
#include "core/mission/session/spawn_life.h"
#include "core/mission/session/update_feed.h"
#include "core/mission/session/vigil.h"

namespace usar::mission {

struct RobotSession::Private : SpawnOwner, HelmOwner, ReplayStage {
    /// `cell_size_m` is the side of the map's cells.
    Private(RobotSession& session, double cell_size_m);

    /// A connection begins, live or replayed.
    void beginConnection();
    /// The live connection is established.
    void opened();
    /// The live connection has ended.
    void connectionLost();
    /// Takes one line without its line end, live or replayed.
    void takeLine(std::string_view text);
    void endAtLimit();
    void endWithClaims();
    void lookForAwaitedTime();
    /// Called regularly while connected, to notice silence and overdue answers.
    void watch();
    /// With what a recording, or a part of it, begins.
    RecordingScene scene() const;
    /// The figures of the next update.
    SessionFigures figures() const;
    /// Status of the replay's link in a replay, of the live one otherwise.
    const link::LinkStatus& linkStatus() const { return replay.on() ? replay.linkStatus() : link.status(); }
    /// True in a replay, in which nothing can be sent; reports that once.
    bool refusedInReplay();
    /// Notes a fault in the scan book and in the recording.
    void noteFault(const std::string& sentence);
    void endReplay();
    /// Does what is left of an adjustment in a replay, where no line may follow, in parts.
    void adjustReplay();

    /// The overrides serve the parts of the session (SpawnLife, Helm, ReplayFeed), in the session's thread.
    void sendInit(const protocol::Init& init) override;
    void reconnect() override;
    void spawnChanged() override { updates.touched(); }
    void robotCame(const std::string& robot_name) override { emit q.spawned(QString::fromStdString(robot_name)); }
    void robotFailed(const std::string& reason) override { emit q.spawnFailed(QString::fromStdString(reason)); }

    void writeLine(const agent::CausedCommand& command, std::string text) override;
    void flush() override { link.flush(); }
    /// True while a server is connected, or was at this point of the replay.
    bool connected() const override { return linkStatus().state == link::LinkState::Connected; }
    bool replaying() const override { return replay.on(); }
    /// True if more bytes wait to be sent than the limits allow.
    bool congested() const override { return link.unsentBytes() > limits.unsent_bytes; }
    void takePublished(const std::vector<agent::Published>& published) override;
    void finishBehavior(const agent::BehaviorFinished& finished, bool is_published) override;
    void touched() override { updates.touched(); }
    /// Seconds since the session was created, from a clock that never jumps.
    Seconds wall() const override { return Seconds(static_cast<double>(clock.nsecsElapsed()) * 1e-9); }

    void replayRewound() override;
    void replayBegan(std::optional<double> cell_size_m, const std::string& level) override;
    void replayLinkChanged(const link::LinkStatus& status) override { emit q.linkChanged(status); }
    void replayConnected() override { beginConnection(); }
    void replayClosed(bool lost) override;
    void replayLine(std::string_view text, LineNumber number) override;
    /// Dialect in which replayed commands are read.
    protocol::Dialect replaySpelling() const override { return helm.spelling(); }
    void replayCommand(const agent::CausedCommand& command, std::string text, LineNumber after) override;
    void replayPublished(const agent::Published& value) override { takePublished({value}); }
    void replayPassed(const agent::BehaviorStatus& status) override { book.passStatus(status); }
    void replayMission(std::string_view note) override;
    void replayTask(const ReplayedTask& task, const std::string& robot_name) override;
    void replayFinished(const agent::BehaviorFinished& finished) override { finishBehavior(finished, false); }
    void replayFault(const std::string& sentence) override { noteFault(sentence); }
    void replaySeeks(bool on) override;
    void replayChanged() override { updates.touched(); }
    void replayDamaged(const std::string& complaint) override {
        notices.say(Severity::Warning, Topic::Recording, complaint);
    }
    void replayEnds() override { emit q.replayEnded(); }

    /// The session that owns this object.
    RobotSession& q;
    SessionLimits limits;
    std::string equipment_advice; ///< see RobotSession
    link::TcpLink link;
    QTimer watch_timer;
    QElapsedTimer clock; ///< since the session was created
    Notices notices;
    UpdateFeed updates;
    Incoming incoming;
    ScanBook book;
    ClaimWatch claims;
    Vigil vigil;
    SpawnLife spawning;
    RecordKeeping records;
    Helm helm;
    ReplayFeed replay;
    /// The user's wish; whether lockstep is in effect is up to the server.
    bool lockstep_wanted = false;
    bool behavior_running = false;    ///< here or in the replay
    Seconds behavior_since{};         ///< protocol clock when the newest behavior was started here
    std::optional<Seconds> awaited{}; ///< see awaitTime
};

} // namespace usar::mission
