// Who drives a robot, and how that is said in a few words.
#pragma once

#include <QString>

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

/// "nobody drives", "Terrain survey drives", "you drive · keys".
QString controlText(const ControlWords& words);

} // namespace usar::widgets
