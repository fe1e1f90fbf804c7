// One client connection of the simulator: its commands that wait to be obeyed and its output that waits to be sent.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/protocol/command.h"
#include "core/protocol/dialect.h"
#include "core/protocol/info_message.h"
#include "core/protocol/line_splitter.h"
#include "core/protocol/trace_pen.h"
#include "core/sim/faults/faulty_wire.h"
#include "core/sim/physics/scene.h"
#include "core/sim/robots/robot.h"
#include "core/sim/session_host.h"

namespace usar::sim {

/// Commands wait in order for the next tick. In lockstep, those after a STEP wait for the tick after it, so that the
/// time of their arrival cannot change what happens. GETSTARTPOSES and LOCKSTEP are obeyed at once, so that a paused
/// server answers. At most one query of each kind is pending, and the newest wins (protocol.md 5.4). Owned by a
/// Simulation; `world` must outlive it.
class ClientSession {
public:
    using Log = SessionHost::Log;

    /// `digests`: somebody may ask for the digest of what it said.
    ClientSession(const World& world, protocol::Dialect profile, bool digests);

    /// Takes bytes in chunks of any size; `log` gets a sentence about each line that is wrong or dropped.
    void receive(std::string_view bytes, const Log& log);
    /// Takes the bytes that have reached the client by now.
    std::string takeOutput(Seconds now);

    bool lockstep() const { return lockstep_; }
    /// Tells the client that nobody waits for its STEP any longer; it may ask for lockstep again, once.
    void leaveLockstep();
    /// True if it has been taken out of lockstep so often that it gets no second chance.
    bool mayNotStep() const { return taken_out_ >= 2; }
    /// True if the simulation need not wait for this client: it is not in lockstep, has no robot yet, has not heard of
    /// a tick yet (so it could not answer one), or has sent its STEP.
    bool ready() const {
        return !lockstep_ || (!silenced_ && (!robot_ || !heard_tick_ || steps_waiting_ >= stepsOwed()));
    }
    /// Time stands still from now on, because a fault without an end keeps this client in lockstep from hearing
    /// anything; another set of faults, or leaving lockstep, ends that.
    void silence(bool on) { silenced_ = on; }
    bool silenced() const { return silenced_; }
    /// True if it has nothing that needs a tick: no robot, no world controller and no waiting command.
    bool idle() const { return !robot_ && !controls_ && waiting_.empty(); }
    const Robot* robot() const { return robot_.get(); }
    Robot* robot() { return robot_.get(); }
    const std::string& robotName() const { return robot_name_; }
    /// Pose of a base station; nullopt if this is not a base station's connection.
    const std::optional<Pose>& stationInMap() const { return station_in_map_; }

    /// Sets the faults that act on its robot and connection from now on. `random` belongs to this connection alone.
    void setFaults(const std::vector<Fault>& active, const Random& random);
    /// Removes the robot without a message; the connection stays and cannot spawn another.
    void loseRobot() { robot_.reset(); }
    /// True if more waits because of a fault than a network would buffer.
    bool overfull() const { return wire_ && wire_->overfull(); }
    Seconds spawnedAt() const { return spawned_at_; } ///< simulated time at which its INIT was obeyed
    /// To be called when the client has gone; the robot then waits for another one that sends INIT with its name.
    void orphan();
    bool isOrphan() const { return orphan_; }
    /// The robot name in an INIT that waits to be obeyed; empty if there is none.
    std::string wantedName() const;
    /// Gives this session's robot to the client of `fresh`, whose INIT thereby counts as obeyed.
    void takeOver(ClientSession& fresh);
    std::uint64_t saidDigest() const { return said_digest_; } ///< covers all output bytes ever written, if it digests
    /// True until the new robot has been told of the active faults.
    bool isNew() const { return robot_ && new_; }

    using Host = SessionHost;
    /// Obeys the commands that are due at this tick.
    void obeyWaiting(const Host& host);
    /// Writes the answers to pending queries, then the robot's lines.
    void report(Seconds now);
    /// A mark at its robot's position if TRACE calls for one now.
    std::optional<TraceMark> takeMark(Seconds now);

private:
    void take(std::string_view line, const Log& log);
    void obey(const protocol::Command& command, const Host& host);
    void control(const protocol::Command& command, const Host& host);
    bool obeyForRobot(const protocol::Command& command, Seconds now);
    bool attachCamera(const protocol::Command& command, const Host& host);
    bool setViewports(const protocol::Command& command, const Host& host);
    bool hasCamera(std::string_view name) const;
    bool tellCameras(const protocol::Command& command, const Host& host);
    void obeyUnknown(const protocol::Command& command, const Host& host);
    void init(const protocol::Init& init, const Host& host);
    void refuse(const std::string& type, const std::string& name, const std::string& sentence, const Host& host);
    void startPoses();
    void answer(Seconds now);
    protocol::Response resultOf(const protocol::Command& asked, Seconds now);
    void send(const protocol::InfoMessage& message, Seconds now = Seconds{0.0});
    /// STEPs that the client must send before the next tick: one for each tick that it has heard of.
    std::size_t stepsOwed() const { return wire_ ? ticks_heard_ : 1; }
    bool isUdk() const { return profile_ == protocol::Dialect::Udk; }

    const World& world_;
    protocol::Dialect profile_;
    protocol::LineSplitter splitter_;
    std::deque<protocol::Command> waiting_;
    std::size_t steps_waiting_ = 0;
    bool lockstep_ = false;
    bool silenced_ = false;
    int taken_out_ = 0; ///< times that others waited for its STEP in vain
    std::string output_;
    std::optional<FaultyWire> wire_; ///< exists since the first link fault
    std::size_t ticks_heard_ = 0;    ///< ticks that reached the client and are not answered by a STEP yet

    std::unique_ptr<Robot> robot_;
    std::string robot_name_;
    std::optional<Pose> station_in_map_;
    protocol::TracePen pen_;
    bool initialized_ = false;
    bool controls_ = false; ///< belongs to a world controller
    bool first_tick_ = true;
    bool heard_tick_ = false; ///< the current client has been told of a tick
    bool orphan_ = false;
    bool digests_;
    std::uint64_t said_digest_ = 14695981039346656037ull; ///< FNV-1a
    bool new_ = true;
    Seconds spawned_at_{0.0};
    std::optional<protocol::GetGeometry> geometry_asked_;
    std::optional<protocol::GetConfiguration> configuration_asked_;
    std::optional<protocol::Command> set_asked_;
    std::optional<protocol::Response> window_set_; ///< result of AttachCamera or SET Viewports, to be sent at the tick
    std::vector<protocol::InfoMessage> lines_;
};

} // namespace usar::sim
