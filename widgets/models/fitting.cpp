#include "widgets/models/fitting.h"

#include <algorithm>
#include <cmath>

#include "core/base/alternatives.h"
#include "core/base/text.h"

namespace usar::widgets {

void Fitting::take(const protocol::InfoMessage& message) {
    std::visit(Overloaded{[this](const protocol::RobotState& state) {
                              if (state.kind != protocol::VehicleKind::Unknown)
                                  kind_ = state.kind;
                          },
                          [this](const protocol::GeometryInfo& geometry) {
                              if (geometry.dimensions_m) {
                                  dimensions_m_ = geometry.dimensions_m;
                                  robot_class_ = lowerCase(geometry.robot_class);
                              }
                              for (const protocol::MountedItem& item : geometry.items)
                                  mounts_[{lowerCase(geometry.type), lowerCase(item.name)}] = item;
                          },
                          [this](const protocol::ConfigurationInfo& told) {
                              if (const auto robot = protocol::robotConfigurationOf(told)) {
                                  kind_ = robot->kind == protocol::VehicleKind::Unknown ? kind_ : robot->kind;
                                  steering_ = robot->steering;
                                  robot_class_ = lowerCase(robot->robot_class);
                              }
                              for (protocol::PackageConfiguration& package : protocol::packageConfigurationsOf(told))
                                  packages_[lowerCase(package.name)] = std::move(package);
                              for (protocol::SensorConfiguration& sensor : protocol::sensorConfigurationsOf(told))
                                  settings_[{lowerCase(sensor.type), lowerCase(sensor.name)}] = std::move(sensor);
                          },
                          [](const auto&) {}},
               message);
}

std::optional<Pose> Fitting::mount(const std::string& type, const std::string& name) const {
    const auto found = mounts_.find({lowerCase(type), lowerCase(name)});
    if (found == mounts_.end())
        return std::nullopt;
    const std::string on = lowerCase(found->second.mount);
    const bool on_base = on.empty() || on == "hard" || on == robot_class_;
    return on_base ? std::optional(found->second.item_in_mount) : std::nullopt;
}

const protocol::SensorConfiguration* Fitting::settings(const std::string& type, const std::string& name) const {
    const auto found = settings_.find({lowerCase(type), lowerCase(name)});
    return found == settings_.end() ? nullptr : &found->second;
}

const protocol::LinkConfiguration* Fitting::joint(const std::string& package, long long link) const {
    const auto found = packages_.find(lowerCase(package));
    if (found == packages_.end())
        return nullptr;
    const auto& links = found->second.links;
    const auto one = std::ranges::find_if(links, [link](const auto& each) { return each.link == link; });
    return one == links.end() ? nullptr : &*one;
}

bool Fitting::looksDown(const std::string& type, const std::string& name, double sign) const {
    const std::optional<Pose> pose = mount(type, name);
    return pose && sign * std::sin(pose->pitch_rad) > std::sin(radians(45.0));
}

} // namespace usar::widgets
