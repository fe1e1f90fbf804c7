// The spawning of one connection's robot, from the request to its first data.
#pragma once

#include <optional>
#include <string>

#include "core/mission/session/notices.h"
#include "core/mission/session/session_orders.h"
#include "core/protocol/command.h"
#include "core/protocol/info/answers.h"

namespace usar::mission {

/// Interface of the session that a spawn uses.
class SpawnOwner {
public:
    virtual ~SpawnOwner() = default;
    virtual void sendInit(const protocol::Init& init) = 0;
    /// A server accepts one INIT per connection, so another attempt needs a new one.
    virtual void reconnect() = 0;
    virtual void spawnChanged() = 0;
    virtual void robotCame(const std::string& robot_name) = 0;
    virtual void robotFailed(const std::string& reason) = 0;
};

/// Sends one INIT per connection, and assumes that the robot has spawned as soon as data arrives: no server confirms
/// an INIT, and only ours refuses one in words. Wall times are arguments and count from any moment. Belongs to one
/// session and its thread.
class SpawnLife {
public:
    /// Both must outlive this object.
    SpawnLife(SpawnOwner& owner, Notices& notices) : owner_(owner), notices_(notices) {}

    SpawnState state() const { return state_; }
    bool done() const { return state_ == SpawnState::Done; }
    /// The robot of the newest request, also after it was lost.
    const std::string& robotName() const { return request_.robot_name; }
    /// Protocol clock at the spawn; 0 until it is known.
    Seconds spawnedAt() const { return spawned_at_; }
    /// True for a base station, which sends no data and does not drive; it counts as spawned as soon as INIT is sent.
    bool isStation() const { return protocol::isStation(request_.class_name); }
    /// The INIT that was sent on this connection and has not failed.
    std::optional<protocol::Init> standingInit() const;

    /// Refused with a notice while there is no connection or a robot on it.
    void ask(const SpawnRequest& request, bool connected, Seconds wall);
    void beginConnection();
    /// Sends a request that was waiting for a new connection.
    void connected(Seconds wall);
    /// Takes note that data from a robot has arrived.
    void heard();
    /// Takes the protocol clock after each line; its first value after the spawn counts as the spawn time.
    void passed(Seconds now);
    /// Fails the spawn if this is the server's refusal of the INIT, which the embedded simulator sends.
    void answered(const protocol::Response& answer);
    /// Fails the spawn if the robot has been silent for longer than `limit` after INIT.
    void look(Seconds wall, Seconds limit);
    /// Returns the state of the spawn that was lost with the connection.
    SpawnState loseConnection();
    /// Reports that a spawned robot was lost; `lost` is the result of `loseConnection`.
    void reportLoss(SpawnState lost);
    /// Reports that the server closed the connection instead of answering INIT; `lost` as above.
    void reportRefusal(SpawnState lost);
    /// Forgets the robot because it no longer exists.
    void end() { set(SpawnState::None); }
    /// Forgets a request that waits for a new connection.
    void dropWaiting() { waiting_.reset(); }
    /// Takes an INIT from a replay.
    void sawInit(const protocol::Init& init);

    void describe(SessionFigures& figures) const;

private:
    void init(const SpawnRequest& request, Seconds wall);
    void set(SpawnState now);
    void fail(SpawnState now, const std::string& reason);

    SpawnOwner& owner_;
    Notices& notices_;
    SpawnState state_ = SpawnState::None;
    SpawnRequest request_;
    std::optional<SpawnRequest> waiting_; ///< waits for a new connection
    std::optional<Seconds> asked_at_;     ///< wall time of the newest INIT
    Seconds spawned_at_{0.0};             ///< protocol clock; 0 until it is known
};

} // namespace usar::mission
