// Where a notification leads: the robot that it is about, and the part of the window that has more about it.
#pragma once

#include <optional>

#include <QString>

#include "core/base/robot_id.h"

namespace usar::widgets {

/// Each part may be missing.
struct NoticePlace {
    QString robot_name; ///< empty: no robot, or one that is known by its id
    RobotId robot_id{}; ///< 0: no robot, or one that is known by its name
    QString dock;       ///< object name of a dock; empty: none
    QString command;    ///< id of a command that opens the place; empty: none
    bool operator==(const NoticePlace&) const = default;
};

/// `key` is that of the notification: "R1/sensor: GPS", "mission-2", "plot".
NoticePlace placeOf(const QString& key);

} // namespace usar::widgets
