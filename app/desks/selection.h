// Which robot the window shows.
#pragma once

#include <QObject>

#include "app/host/mission_control.h"

namespace usar::app {

/// The id of the robot that is shown, 0 while there is none. Every desk shows that robot, and its commands are meant
/// for it. GUI thread.
class Selection : public QObject {
    Q_OBJECT
public:
    explicit Selection(const MissionControl& control) : control_(control) {}

    int id() const { return id_; }
    /// Null while no robot is shown.
    Robot* robot() const { return control_.robot(id_); }
    /// Shows no robot if there is none with this id. The id that is selected already shows its robot afresh.
    void select(int id) {
        id_ = control_.robot(id) ? id : 0;
        emit changed(id_);
    }

signals:
    void changed(int id);

private:
    const MissionControl& control_;
    int id_ = 0;
};

} // namespace usar::app
