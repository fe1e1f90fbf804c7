// What kind of robot it is, so that the window offers no command and no figure that makes no sense for it.
#pragma once

#include "core/agent/published.h"
#include "core/protocol/info/robot_state.h"
#include "core/protocol/info_message.h"

namespace usar::mission {

/// Told from what the robot says: the kind of vehicle in its STA and in the answers GEO and CONF, and the status of its
/// behavior. Before a robot is known, anything may come. Which sensors it has is up to its instruments
/// (widgets/models/robot_instruments.h).
class Equipment {
public:
    void take(const protocol::InfoLine& line);
    void take(const agent::BehaviorStatus& status);

    /// By STA, CONF or GEO; Unknown until one of them tells.
    protocol::VehicleKind kind() const { return kind_; }
    /// Also true for an unknown kind: the STA of a UDK server does not tell the kind of those that fly.
    bool mayFly() const;
    /// The behavior knows how far the battery lasts, and can recharge it; unknown until there is a status.
    bool mayRecharge() const { return recharges_ || (!told_status_ && mayFly()); }

private:
    protocol::VehicleKind kind_ = protocol::VehicleKind::Unknown;
    bool recharges_ = false;
    bool told_status_ = false;
};

} // namespace usar::mission
