// The robot of one connection, from the wish to spawn it to its first word.
#pragma once

#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/mission/session/notices.h"
#include "core/mission/session/session_orders.h"
#include "core/protocol/command.h"

namespace usar::mission {

/// What a spawn needs of its session.
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

/// Sends one INIT per connection, and believes that the robot is there as soon as data comes: no server confirms an
/// INIT. Wall times are arguments and count from any moment. Belongs to one session and its thread.
class SpawnLife {
public:
    /// Both must outlive this object.
    SpawnLife(SpawnOwner& owner, Notices& notices) : owner_(owner), notices_(notices) {}

    SpawnState state() const { return state_; }
    bool done() const { return state_ == SpawnState::Done; }
    /// The newest request, also after its robot was lost.
    const SpawnRequest& request() const { return request_; }
    const std::string& robotName() const { return request_.robot_name; }
    /// True for a station, which never says that it has come, and neither drives nor sends.
    bool isStation() const;
    /// The INIT that was sent on this connection and has not failed.
    std::optional<protocol::Init> standingInit() const;

    /// Refused with a notice while there is no connection or a robot on it.
    void ask(const SpawnRequest& request, bool connected, Seconds wall);
    void beginConnection();
    /// Sends what waited for a new connection.
    void connected(Seconds wall);
    /// Data of a robot have come.
    void heard();
    /// The protocol's clock when a line had been taken; the first one with a robot counts as its time of spawning.
    void passed(Seconds now);
    /// Silence after INIT means a failed spawn.
    void look(Seconds wall, Seconds limit);
    /// Returns the state of the spawn that was lost with the connection.
    SpawnState loseConnection();
    /// To be called with what `loseConnection` returned: the robot had been there.
    void reportLoss(SpawnState lost);
    /// Likewise: the server hung up instead of an answer.
    void reportRefusal(SpawnState lost);
    /// There is no robot any more.
    void end() { set(SpawnState::None); }
    /// Forgets a request that waits for a new connection.
    void dropWaiting() { waiting_.reset(); }
    /// A replayed INIT.
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
    std::optional<SpawnRequest> waiting_; ///< for a new connection
    std::optional<Seconds> asked_at_;     ///< wall time of the newest INIT
    Seconds spawned_at_{0.0};             ///< protocol clock; 0 until it is known
};

/// Fails for names that no line can contain.
Result<protocol::Init> initOf(const SpawnRequest& request);

} // namespace usar::mission
