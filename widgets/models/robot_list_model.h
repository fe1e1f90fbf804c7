// List model of the robots: one row per robot, in the order of their numbers, with the words for who drives it.
#pragma once

#include <optional>
#include <vector>

#include <QString>

#include "core/base/robot_id.h"
#include "widgets/models/row_model.h"

namespace usar::widgets {

/// The one in control of a robot; Person is the user, at keys, pad or gamepad.
enum class Driver { Nobody, Behavior, Person };

/// Content of the chip, for example {"R1", Person, "keys"}.
struct ControlWords {
    QString robot{}; ///< empty: no robot is selected
    Driver driver = Driver::Nobody;
    QString by{}; ///< the behavior's name, or the device that the user holds; may be empty
    bool operator==(const ControlWords&) const = default;
};

/// "idle", "Terrain survey drives", "you drive · keys".
QString controlText(const ControlWords& words);

/// A battery with less than this left, in percent, is shown in the color of a caution, or of a danger.
inline constexpr double battery_caution_pct = 30.0;
inline constexpr double battery_danger_pct = 15.0;

/// A robot as the list needs it. `id` is assigned by the window; `number` 1..9 selects color and key.
struct RobotRow {
    RobotId id{};
    int number = 1;
    QString name;
    QString class_name;                ///< "AirRobot"
    QString state;                     ///< in words: "scanning lane 4 of 9"
    std::optional<double> battery_pct; ///< what is left, 0..100; nullopt: unknown
    bool stale = false;                ///< state and battery may be out of date
    ControlWords driver{};             ///< the one in control
    bool operator==(const RobotRow&) const = default;
};

/// Sorted by number, then id. DisplayRole is a complete sentence for assistive tools and type-ahead; views paint from
/// `row`. GUI thread.
class RobotListModel : public RowModel<RobotRow> {
    Q_OBJECT
public:
    using RowModel::RowModel;

    /// Updates the robot with this id, or adds it. Emits nothing if nothing changed.
    void updateRobot(const RobotRow& robot);
    /// An unknown id changes nothing.
    void removeRobot(RobotId id);

    /// Row of that robot; nullopt if it is not listed.
    std::optional<int> indexOf(RobotId id) const { return find(&RobotRow::id, id); }
    QVariant data(const QModelIndex& index, int role) const override;
};

} // namespace usar::widgets
