// A robot that the user wants to spawn.
#pragma once

#include <QString>

namespace usar::widgets {

/// The robot that the user wants at a start pose, or at the pose that was drawn on the map.
struct SpawnChoice {
    static constexpr int at_draft = -1; ///< as `start_pose`: MapContent::spawn_draft_in_map

    int start_pose = 0; ///< index of the pose
    QString class_name; ///< as in the protocol: "USARBot.AirRobot"
    QString robot_name;
    QString behavior_id; ///< empty: no behavior
    bool operator==(const SpawnChoice&) const = default;
};

} // namespace usar::widgets
