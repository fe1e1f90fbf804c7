// The equipment of a robot, so that the window shows no instrument that stays empty forever.
#pragma once

#include <optional>

#include "core/agent/published.h"
#include "core/base/clock.h"
#include "core/protocol/info/robot_state.h"
#include "core/protocol/info_message.h"

namespace usar::mission {

/// Told from what the robot says: the kind of vehicle in its STA, its SEN readings, the answers GEO and CONF, and the
/// status of its behavior. What has not been heard of `patience` after the robot's first words is not there; until
/// then, and before a robot is known, anything may come.
class Equipment {
public:
    /// Every sensor sends within this time on the protocol clock.
    static constexpr Seconds patience{1.0};

    /// `now` is the protocol clock at this line.
    void take(const protocol::InfoLine& line, Seconds now);
    void take(const agent::BehaviorStatus& status);

    bool mayHaveScanner() const { return scanner_ || !settled_; }
    bool mayHaveSonars() const { return sonars_ || !settled_; }
    /// Also true for the vehicles of a UDK server, which does not tell the kind of those that fly.
    bool mayFly() const;
    /// The behavior knows how far the battery lasts, and can recharge it; unknown until there is a status.
    bool mayRecharge() const { return recharges_ || (!told_status_ && mayFly()); }

private:
    void takePart(const std::string& type);

    protocol::VehicleKind kind_ = protocol::VehicleKind::Unknown;
    std::optional<Seconds> first_heard_;
    bool settled_ = false;
    bool scanner_ = false;
    bool sonars_ = false;
    bool recharges_ = false;
    bool told_status_ = false;
};

} // namespace usar::mission
