#include "tests/widgets/gallery/pages.h"
#include "widgets/robot_list.h"

namespace usar::gallery {

using namespace usar::widgets;

std::unique_ptr<QWidget> robotsPage() {
    auto list = std::make_unique<RobotList>();
    list->resize(260, 300);
    list->setRobots({
        {1, 1, QStringLiteral("R1"), QStringLiteral("AirRobot"), QStringLiteral("scanning lane 4 of 9"), 71.0, false},
        {2, 2, QStringLiteral("R2"), QStringLiteral("P2DX"), QStringLiteral("idle"), 22.0, false},
        {3, 3, QStringLiteral("Hilltop-watcher"), QStringLiteral("AirRobot"),
         QStringLiteral("returning to recharge, 120 m to go over the wood"), 9.0, false},
        {4, 4, QStringLiteral("R4"), QStringLiteral("AirRobot"), QStringLiteral("scanning lane 2 of 3"), 55.0, true},
        {5, 5, QStringLiteral("R5"), QStringLiteral("Submarine"), QStringLiteral("spawning"), std::nullopt, false},
    });
    list->selectRobot(1);
    return list;
}

std::unique_ptr<QWidget> emptyRobotsPage() {
    auto list = std::make_unique<RobotList>();
    list->resize(260, 220);
    return list;
}

} // namespace usar::gallery
