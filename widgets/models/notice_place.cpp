#include "widgets/models/notice_place.h"

#include <array>

namespace usar::widgets {

namespace {

struct Row {
    const char* beginning;
    const char* dock;
    const char* command = "";
};

/// Keys that belong to no robot. The first row with which a key begins counts.
constexpr std::array global_rows{Row{"radio", "radio"},
                                 Row{"world", "world"},
                                 Row{"fault", "faults"},
                                 Row{"mission-faults", "faults"},
                                 Row{"plan", "plan"},
                                 Row{"plot", "plots"},
                                 Row{"messages", "messages"},
                                 Row{"resend", "messages"},
                                 Row{"area", "behavior"},
                                 Row{"parameters", "behavior"},
                                 Row{"mission", "behavior"},
                                 Row{"start", "behavior"},
                                 Row{"picture", "camera"},
                                 Row{"relief", "relief"},
                                 Row{"spawn", "robots"},
                                 Row{"gamepad", "drive"},
                                 Row{"keys", "", "help.shortcuts"},
                                 Row{"layout", "", "view.layouts"},
                                 Row{"plugin", "", "plugins.show"}};

/// What sessions report of their robot, behind its name and a slash.
constexpr std::array robot_rows{
    Row{"sensor", "sensors"},         Row{"lines", "messages"},       Row{"clock", "messages"},
    Row{"overlong", "messages"},      Row{"queue", "messages"},       Row{"link", "messages"},
    Row{"no connection", "messages"}, Row{"start poses", "messages"}, Row{"behavior", "behavior"},
    Row{"control", "drive"},          Row{"placement", "behavior"}};

template <std::size_t size>
NoticePlace lookedUp(const std::array<Row, size>& rows, const QString& key) {
    for (const Row& row : rows)
        if (key.startsWith(QLatin1String(row.beginning)))
            return {{}, {}, QLatin1String(row.dock), QLatin1String(row.command)};
    return {};
}

/// The number at the end of "mission-2", if the key begins so.
RobotId idBehind(const QString& beginning, const QString& key) {
    return key.startsWith(beginning) ? RobotId{key.mid(beginning.size()).toInt()} : RobotId{};
}

} // namespace

NoticePlace placeOf(const QString& key) {
    if (key.endsWith(QStringLiteral(".so")))
        return lookedUp(global_rows, QStringLiteral("plugin"));
    NoticePlace place = lookedUp(global_rows, key);
    for (const char* const beginning : {"mission-", "start-"})
        if (const RobotId id = idBehind(QLatin1String(beginning), key); id.valid())
            place.robot_id = id;
    const qsizetype slash = key.indexOf(u'/');
    if (slash < 0 || !place.dock.isEmpty() || !place.command.isEmpty())
        return place;
    if (key.startsWith(QStringLiteral("saved/")))
        return {key.mid(slash + 1), {}, QStringLiteral("robots"), {}};
    place = lookedUp(robot_rows, key.mid(slash + 1));
    if (place.dock.isEmpty())
        place.dock = QStringLiteral("robots");
    place.robot_name = key.left(slash);
    return place;
}

} // namespace usar::widgets
