// The selected robot: the one that the window shows.
#pragma once

#include <QObject>

#include "app/host/mission_control.h"

namespace usar::app {

/// Id of the selected robot, 0 while there is none. Every desk shows this robot, and its commands apply to it. GUI
/// thread.
class Selection : public QObject {
    Q_OBJECT
public:
    explicit Selection(const MissionControl& control) : control_(control) {}

    RobotId id() const { return id_; }
    /// Returns nullptr while no robot is selected.
    Robot* robot() const { return control_.robot(id_); }
    /// Selects this robot, or none if there is no such robot. Selecting the current one again makes all desks show it
    /// again.
    void select(RobotId id) {
        id_ = control_.robot(id) ? id : RobotId{};
        emit changed(id_);
    }

signals:
    /// Emitted by every `select`, even with the same id. 0: no robot.
    void changed(usar::RobotId id);

private:
    const MissionControl& control_;
    RobotId id_;
};

} // namespace usar::app
