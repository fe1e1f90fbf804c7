#include "core/mission/files/plan_file.h"

#include <algorithm>

#include <QFile>

#include "core/base/text.h"
#include "core/posh/language/token.h"

namespace usar::mission {

std::string readPlanText(QIODevice& input) {
    constexpr qsizetype most = static_cast<qsizetype>(posh::longest_plan_bytes) + 1;
    QByteArray text;
    while (text.size() < most) {
        const QByteArray piece = input.read(std::min<qsizetype>(most - text.size(), 1 << 20));
        if (piece.isEmpty())
            break;
        text += piece;
    }
    return text.toStdString();
}

Result<agent::PlanText> readPlanFile(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failure("cannot read the plan: " + file.errorString().toStdString(), path.toStdString(),
                       "Check the path, or leave the plan out for the one that comes with the robot");
    return agent::PlanText{path.toStdString(), readPlanText(file)};
}

Result<const agent::RobotDescription*> robotForPlans(const std::vector<agent::RobotDescription>& robots,
                                                     const QString& name) {
    const std::string wanted = name.toStdString();
    std::string known;
    for (const agent::RobotDescription& robot : robots) {
        if (robot.primitives.empty())
            continue;
        const bool by_behavior = std::ranges::any_of(
            robot.behaviors, [&](const agent::BehaviorDescription& behavior) { return sameWord(behavior.id, wanted); });
        if (by_behavior || sameWord(robot.name, wanted) || sameWord(robot.class_name, wanted))
            return &robot;
        known += (known.empty() ? "" : ", ") + robot.name;
    }
    return failure("no plan can run such a robot", wanted,
                   known.empty() ? "No robot plugin was found; are they beside the program?"
                                 : "Choose one of " + known);
}

} // namespace usar::mission
