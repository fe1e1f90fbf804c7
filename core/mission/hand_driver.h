// Drives one robot by hand: from what hands ask to the commands that go out, and the question how it is driven.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/mission/hand_control.h"
#include "core/mission/stick_shaper.h"
#include "core/mission/walking_gait.h"
#include "core/modules/query.h"

namespace usar::mission {

/// Of one session, in its thread; owns no clock: wall time and the protocol's are arguments. Commands come out as
/// values, for the session to send.
class HandDriver {
public:
    using Commands = std::vector<protocol::Command>;

    /// Nothing is known of the robot, and no hand has it.
    void beginConnection() { *this = {}; }
    void take(const protocol::InfoLine& line);
    /// What has to be asked now, if anything; one at a time, by the protocol's clock.
    std::optional<protocol::Command> question(Seconds now);

    /// The person takes control, and the robot is asked how it is driven, or gives it back.
    void setOn(bool on);
    bool on() const { return hands_.on(); }
    bool holding() const { return hands_.holding(); }
    /// What moves the robot: "keys", "gamepad Xbox Controller".
    std::string holderText() const;

    HandControl::Verdict accept(const HandIntent& intent, Seconds wall);
    bool overdue(Seconds wall, Seconds patience) const { return hands_.overdue(wall, patience); }
    /// Time passed: what has to be said because the stick is somewhere else now.
    Commands advance(Seconds dt);
    /// The server's clock ticked: what is held is said again, and legs step.
    Commands repeat(Seconds now);
    /// What brings it to rest, whoever held; hands have to let go before they count again.
    Commands stop(const std::string& reason);

    /// Without the behavior, of which it knows nothing.
    ControlState state() const;

private:
    Commands driveNow() const;
    double speedShare() const { return hands_.holder() ? hands_.holder()->speed_share : 0.0; }

    DriveLimits limits_;
    HandControl hands_;
    StickShaper shaper_;
    WalkingGait gait_;
    modules::ConfigurationModule configuration_;
    modules::GeometryModule geometry_;
    double said_share_ = 0.0; ///< of the speed, in what was said last
    bool walked_ = false;     ///< since it was told to stand
    std::string last_stop_;
};

} // namespace usar::mission
