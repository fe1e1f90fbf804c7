// The robots of a fleet by their ids, and what a further one may be called.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include <QString>

#include "core/mission/fleet/robot.h"

namespace usar::mission {

/// Owns robots; lives in the GUI thread, as they do. Ids are 1 to 9, the keys that select them. Pointers that it gives
/// are valid until the robot is taken out.
class Roster {
public:
    static constexpr int most_robots = 9; ///< one key each

    bool full() const { return nextId() > most_robots; }
    /// The lowest free id; more than `most_robots` if it is full.
    int nextId() const;
    /// "R1": the name that the next robot gets when the person gives none.
    QString nextName() const { return QString("R%1").arg(nextId()); }
    /// `name`, or with a number behind it where a robot has that name.
    QString unusedName(const QString& name) const;
    /// The request as it can be carried out, with a name where it had none. An error for a request without a class, for
    /// a tenth robot, and for a name that a robot has already.
    Result<SpawnRequest> accept(SpawnRequest request) const;

    /// Under its `view().id`, which must be free.
    void add(std::unique_ptr<Robot> robot);
    /// Null if there is none.
    std::unique_ptr<Robot> take(int id);
    void clear() { robots_.clear(); }

    /// Null if there is none.
    Robot* robot(int id) const;
    /// The robot with that RobotView::connection; null if there is none.
    Robot* on(int connection) const;
    /// In the order of their ids.
    std::vector<Robot*> robots() const;

private:
    bool has(const std::string& name) const;

    std::map<int, std::unique_ptr<Robot>> robots_;
};

} // namespace usar::mission
