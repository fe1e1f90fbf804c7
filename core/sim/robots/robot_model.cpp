#include "core/sim/robots/robot_model.h"

#include <algorithm>
#include <numeric>

#include "core/base/text.h"

namespace usar::sim {

double RobotModel::mass_kg() const {
    return std::accumulate(body.links.begin(), body.links.end(), body.base.mass_kg,
                           [](double sum_kg, const LinkDescription& link) { return sum_kg + link.body.mass_kg; });
}

BodyDescription RobotModel::whole() const {
    BodyDescription whole{mass_kg(), body.base.inertia_kg_m2, body.base.friction};
    const auto add = [&whole](const BodyDescription& link, const Pose& link_in_base) {
        for (const BodyPart& part : link.parts)
            whole.parts.push_back({part.shape, link_in_base * part.part_in_body});
    };
    const Pose center_in_base{.position_m = center_of_mass_in_base_m};
    add(body.base, center_in_base);
    std::vector<Pose> links_in_base;
    for (const LinkDescription& link : body.links) {
        const Pose& parent_in_base =
            link.parent < 0 ? center_in_base : links_in_base[static_cast<std::size_t>(link.parent)];
        links_in_base.push_back(parent_in_base * link.link_in_parent);
        add(link.body, links_in_base.back());
    }
    return whole;
}

std::optional<int> RobotModel::linkOnJoint(std::string_view joint) const {
    const auto found = std::ranges::find_if(links, [joint](const ModelLink& link) { return link.joint == joint; });
    return found == links.end() ? std::nullopt : std::optional(static_cast<int>(found - links.begin()));
}

std::string_view withoutPackage(std::string_view class_name) {
    return class_name.substr(class_name.rfind('.') + 1);
}

const RobotModel* findRobot(const RobotCatalog& robots, std::string_view class_name) {
    const std::string_view bare_name = withoutPackage(class_name);
    const auto is_named = [&](const std::string& name) { return sameWord(name, bare_name); };
    auto found = std::ranges::find_if(robots, is_named, &RobotModel::class_name);
    if (found == robots.end())
        found = std::ranges::find_if(
            robots, [&](const RobotModel& robot) { return std::ranges::any_of(robot.aliases, is_named); });
    return found == robots.end() ? nullptr : &*found;
}

} // namespace usar::sim
