#include "core/sim/robots/robot_body.h"

namespace usar::sim {

RobotBody::RobotBody(Physics& physics, const RobotModel& model, const Pose& base_in_map)
    : physics_(physics)
    , model_(model)
    , id_(physics.add(model.body, base_in_map * Pose{.position_m = model.center_of_mass_in_base_m}))
    , touched_(model.links.size() + 1, false)
    , last_position_m_(base_in_map.position_m) {}

RobotBody::~RobotBody() {
    physics_.remove(id_);
}

Pose RobotBody::base_in_map() const {
    return Pose::from(link_in_map(-1));
}

Eigen::Isometry3d RobotBody::link_in_map(int link) const {
    const auto index = static_cast<std::size_t>(link);
    const BodyState body = link < 0 ? physics_.state(id_) : physics_.state(id_, index);
    const Vec3& center_m = link < 0 ? model_.center_of_mass_in_base_m : model_.links[index].center_of_mass_in_link_m;
    Eigen::Isometry3d isometry = Eigen::Isometry3d::Identity();
    isometry.linear() = body.rotation.toRotationMatrix();
    isometry.translation() = body.position_m - isometry.linear() * center_m;
    return isometry;
}

void RobotBody::afterStep() {
    for (const Contact& contact : physics_.contacts(id_))
        touched_[static_cast<std::size_t>(contact.link + 1)] = true;
    const Vec3 position_m = physics_.state(id_).position_m;
    distance_m_ += (position_m - last_position_m_).norm();
    last_position_m_ = position_m;
}

void RobotBody::forgetTouches() {
    touched_.assign(touched_.size(), false);
}

} // namespace usar::sim
