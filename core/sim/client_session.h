// One connection of the simulator: what it has said and not yet seen done, and what waits to be sent to it.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/protocol/command.h"
#include "core/protocol/dialect.h"
#include "core/protocol/info_message.h"
#include "core/protocol/line_splitter.h"
#include "core/protocol/trace_pen.h"
#include "core/sim/camera/camera_scene.h"
#include "core/sim/faults/faulty_wire.h"
#include "core/sim/robots/robot.h"
#include "core/sim/scene.h"

namespace usar::sim {

/// Commands wait in order for the next tick. With lockstep those behind a STEP wait for the tick after it: when they
/// arrived cannot change what happens. GETSTARTPOSES and LOCKSTEP are obeyed at once, so that a paused server
/// answers. One question of each kind is pending and the newest wins (usarsim-protocol 5.4). Owned by a Simulation.
class ClientSession {
public:
    using Log = std::function<void(std::string)>;

    ClientSession(const World& world, protocol::Dialect profile);

    void receive(std::string_view bytes, const Log& log);
    /// What has arrived at the client by now.
    std::string takeOutput(Seconds now);

    bool lockstep() const { return lockstep_; }
    /// Tells the client that nobody waits for its STEP any more; it may ask for lockstep again.
    void leaveLockstep();
    /// A client that need not be waited for: not in lockstep, without a robot yet (it hears nothing of the ticks, so it
    /// could not answer them), or it has said STEP.
    bool ready() const { return !lockstep_ || !robot_ || !heard_tick_ || steps_waiting_ >= stepsOwed(); }
    bool idle() const { return !robot_ && !controls_ && waiting_.empty(); }
    const Robot* robot() const { return robot_.get(); }
    Robot* robot() { return robot_.get(); }
    const std::string& robotName() const { return robot_name_; }
    /// Of a connection that is a base station's.
    const std::optional<Pose>& stationInMap() const { return station_in_map_; }

    /// What acts on its robot and its connection from now on. `random` is this connection's own.
    void setFaults(const std::vector<Fault>& active, const Random& random);
    /// The robot is gone without a word; the connection stays and may not have another.
    void loseRobot() { robot_.reset(); }
    /// More waits behind a fault than a network would keep.
    bool overfull() const { return wire_ && wire_->overfull(); }
    Seconds spawnedAt() const { return spawned_at_; }
    /// The client has gone; the robot waits for another one that says INIT with its name.
    void orphan();
    bool isOrphan() const { return orphan_; }
    /// The name in an INIT that waits to be obeyed; empty where there is none.
    std::string wantedName() const;
    /// This session's robot belongs to the client of `fresh` from now on, whose INIT is obeyed by it.
    void takeOver(ClientSession& fresh);
    /// Of all bytes that it ever said.
    std::uint64_t saidDigest() const { return said_digest_; }
    /// Its robot has not been told of faults yet.
    bool isNew() const { return robot_ && new_; }

    /// What the simulation does for its clients.
    struct Host {
        std::function<std::unique_ptr<Robot>(const protocol::Init&)> spawn;
        /// Where a base station stands.
        std::function<Pose(const protocol::Init&)> startOf;
        /// A CONTROL; a sentence where it cannot be obeyed.
        std::function<std::optional<std::string>(const protocol::Command&)> control;
        std::function<protocol::WorldObjects(const protocol::GetObjectStates&)> objectStates;
        /// AttachCamera and DetachCamera; false where there is no such camera.
        std::function<bool(const protocol::Command&)> attach;
        /// SET of viewports, of which the session has said which cameras there are.
        std::function<void(const Viewports&)> show;
        /// The viewports that there are.
        std::function<Viewports()> shown;
        Log log;
        Seconds now{0.0};
    };
    void obeyWaiting(const Host& host);
    /// Answers, then the robot's lines.
    void report(Seconds now);
    /// Where its robot is now, if TRACE wants one there.
    std::optional<TraceMark> takeMark(Seconds now);

private:
    void take(std::string_view line, const Log& log);
    void obey(const protocol::Command& command, const Host& host);
    void control(const protocol::Command& command, const Host& host);
    bool obeyForRobot(const protocol::Command& command, Seconds now);
    bool attachCamera(const protocol::Command& command, const Host& host);
    bool setViewports(const protocol::Command& command, const Host& host);
    bool hasCamera(std::string_view name) const;
    void obeyUnknown(const protocol::Command& command, const Host& host);
    void init(const protocol::Init& init, const Host& host);
    void startPoses();
    void answer(Seconds now);
    protocol::Response resultOf(const protocol::Command& asked, Seconds now);
    void send(const protocol::InfoMessage& message, Seconds now = Seconds{0.0});
    /// STEPs that the client owes before the next tick: one for each tick that it has heard of.
    std::size_t stepsOwed() const { return wire_ ? ticks_heard_ : 1; }
    bool isUdk() const { return profile_ == protocol::Dialect::Udk; }

    const World& world_;
    protocol::Dialect profile_;
    protocol::LineSplitter splitter_;
    std::deque<protocol::Command> waiting_;
    std::size_t steps_waiting_ = 0;
    bool lockstep_ = false;
    std::string output_;
    std::optional<FaultyWire> wire_; ///< since the first fault of the connection
    std::size_t ticks_heard_ = 0;    ///< by the client over the wire, without its STEP yet

    std::unique_ptr<Robot> robot_;
    std::string robot_name_;
    std::optional<Pose> station_in_map_;
    protocol::TracePen pen_;
    bool initialized_ = false;
    bool controls_ = false; ///< a world controller's connection
    bool first_tick_ = true;
    bool heard_tick_ = false; ///< the client that is there now has been told of a tick
    bool orphan_ = false;
    std::uint64_t said_digest_ = 14695981039346656037ull; ///< FNV-1a
    bool new_ = true;
    Seconds spawned_at_{0.0};
    std::optional<protocol::GetGeometry> geometry_asked_;
    std::optional<protocol::GetConfiguration> configuration_asked_;
    std::optional<protocol::Command> set_asked_;
    std::optional<protocol::Response> window_set_; ///< AttachCamera or Viewports, to be answered at the tick
    std::vector<protocol::InfoMessage> lines_;
};

} // namespace usar::sim
