// The robots of a fleet by id, and the rules for the names, ids and places of new robots.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include <QString>

#include "core/mission/fleet/robot.h"
#include "core/mission/session/session_orders.h"
#include "core/protocol/info/game_info.h"

namespace usar::mission {

/// Owns robots and is used in the GUI thread, as they are. Ids are 1 to `most_robots`; the first nine are the keys that
/// select them. Returned pointers are valid until the robot is taken out.
class Roster {
public:
    static constexpr int most_robots = 50; ///< what the window was measured with (measured.md, section "The window")
    static constexpr int robots_with_a_key = 9;

    bool full() const { return nextId().value > most_robots; }
    /// The lowest free id; more than `most_robots` if it is full.
    RobotId nextId() const;
    /// "R1": the name that the next robot gets if the user gives none.
    QString nextName() const { return QString("R%1").arg(nextId().value); }
    /// Returns `name`, followed by a number if a robot already has that name.
    QString unusedName(const QString& name) const;
    /// Returns the request, with a name if it had none. An error for a request without a class, for one robot too
    /// many, and for a name that a robot already has.
    Result<SpawnRequest> accept(SpawnRequest request) const;

    /// Adds a robot under its `view().id`, which must be free.
    void add(std::unique_ptr<Robot> robot);
    /// Removes the robot and returns it; null if there is none.
    std::unique_ptr<Robot> take(RobotId id);
    void clear() { robots_.clear(); }

    /// Null if there is none.
    Robot* robot(RobotId id) const;
    /// The robot with that RobotView::connection; null if there is none.
    Robot* on(ConnectionId connection) const;
    /// The lowest id of a robot; 0 if there is none.
    RobotId first() const { return robots_.empty() ? RobotId{} : robots_.begin()->first; }
    /// Returns all robots, ordered by id.
    std::vector<Robot*> robots() const;

private:
    bool has(const std::string& name) const;

    std::map<RobotId, std::unique_ptr<Robot>> robots_;
};

/// Returns a request for a base station at the first start pose at which none of the present robots was spawned, or at
/// the first one if all are taken. Its name is new: "Base", "Base2" and so on. `poses` must not be empty; `present`:
/// how the present robots were spawned.
SpawnRequest stationRequest(const std::vector<protocol::StartPose>& poses, const std::vector<SpawnRequest>& present);

/// Name of the start pose that a robot was spawned on, or of the first one; `otherwise` if there are none. `robot` may
/// be null.
std::string startName(const std::vector<protocol::StartPose>& poses, const Robot* robot, const std::string& otherwise);

} // namespace usar::mission
