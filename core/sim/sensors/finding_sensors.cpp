#include "core/sim/sensors/finding_sensors.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/numbers.h"
#include "core/base/text.h"

namespace usar::sim {

namespace {

constexpr double body_half_m = 0.2; ///< half the thickness of a person's part, whose center may be behind its skin

bool inView(const Vec3& point_in_sensor_m, double range_m, double horizontal_rad, double vertical_rad) {
    const double yaw_rad = std::atan2(point_in_sensor_m.y(), point_in_sensor_m.x());
    const double lift_rad = std::atan2(point_in_sensor_m.z(), point_in_sensor_m.head<2>().norm());
    return point_in_sensor_m.norm() <= range_m && std::abs(yaw_rad) <= horizontal_rad / 2.0 &&
           std::abs(lift_rad) <= vertical_rad / 2.0;
}

/// True if nothing is between the eye and a thing of this half-width.
bool isOpen(const SensorView& view, const Vec3& eye_m, const Vec3& thing_m, double half_m) {
    const double distance_m = (thing_m - eye_m).norm();
    if (distance_m <= half_m)
        return true;
    return view.rays.cast(eye_m, (thing_m - eye_m) / distance_m, distance_m) >= distance_m - half_m;
}

Vec3 shaken(Random& random, const Vec3& point_m, double sigma_m) {
    if (sigma_m <= 0.0)
        return point_m;
    return point_m + Vec3(gaussian(random, sigma_m), gaussian(random, sigma_m), gaussian(random, sigma_m));
}

} // namespace

void RfidSensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    scene_ = &view.scene;
    const Eigen::Isometry3d map_in_sensor = sensor_in_map(view).inverse();
    protocol::RfidReading reading{.time = view.now, .name = model().name};
    std::vector<int> ids;
    for (const RfidTag& tag : view.scene.tags) {
        const Vec3 tag_in_sensor_m = map_in_sensor * tag.position_in_map_m;
        if (tag_in_sensor_m.norm() > range_m_)
            continue;
        ids.push_back(tag.id);
        reading.tags.push_back({tag.id, tag_in_sensor_m, {}});
    }
    const bool news = ids != std::exchange(ids_, ids) || (!spoken_ && !ids.empty());
    spoken_ = true;
    if (news && !reading.tags.empty())
        out.emplace_back(std::move(reading));
}

RfidTag* RfidSensor::heard(const std::string& id) const {
    const auto number = readInteger(id);
    if (!scene_ || !number || std::ranges::find(ids_, *number) == ids_.end())
        return nullptr;
    const auto tag = std::ranges::find(scene_->tags, static_cast<int>(*number), &RfidTag::id);
    return tag == scene_->tags.end() ? nullptr : &*tag;
}

std::optional<protocol::Response> RfidSensor::set(const protocol::Command& command, bool) {
    if (const auto* const read = std::get_if<protocol::ReadTag>(&command)) {
        const RfidTag* const tag = heard(read->tag_id);
        protocol::Response answer = this->answer(tag != nullptr);
        if (tag) {
            answer.tag_id = tag->id;
            answer.memory = tag->memory;
        }
        return answer;
    }
    const auto* const write = std::get_if<protocol::WriteTag>(&command);
    if (!write)
        return std::nullopt;
    RfidTag* const tag = heard(write->tag_id);
    if (tag)
        tag->memory = write->memory;
    return answer(tag != nullptr);
}

void VictimSensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    const Eigen::Isometry3d sensor_in_map = this->sensor_in_map(view);
    const Eigen::Isometry3d map_in_sensor = sensor_in_map.inverse();
    protocol::VictimReading reading{.time = view.now, .name = model().name};
    for (const Victim& victim : view.world.victims)
        for (const VictimPart& part : victim.parts) {
            const Vec3 part_in_sensor_m = map_in_sensor * part.position_in_map_m;
            if (inView(part_in_sensor_m, range_m_, horizontal_rad_, vertical_rad_) &&
                isOpen(view, sensor_in_map.translation(), part.position_in_map_m, body_half_m))
                reading.parts.push_back({std::string(nameOf(part.kind)), shaken(random_, part_in_sensor_m, sigma_m_)});
        }
    if (false_alarm_ > 0.0 && uniform(random_, 0.0, 1.0) < false_alarm_)
        reading.parts.push_back({"Hand", Vec3(uniform(random_, 1.0, range_m_), 0.0, 0.0)});
    if (reading.parts.empty())
        reading.status = "NoVictims";
    out.emplace_back(std::move(reading));
}

void HumanMotionSensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    const Eigen::Isometry3d sensor_in_map = this->sensor_in_map(view);
    double sure = 0.0;
    for (const Victim& victim : view.world.victims) {
        if (sameWord(victim.status, "Unconscious") || sameWord(victim.status, "Dead"))
            continue;
        for (const VictimPart& part : victim.parts) {
            const Vec3 part_in_sensor_m = sensor_in_map.inverse() * part.position_in_map_m;
            if (inView(part_in_sensor_m, range_m_, fov_rad_, fov_rad_) &&
                isOpen(view, sensor_in_map.translation(), part.position_in_map_m, body_half_m))
                sure = std::max(sure, 1.0 - part_in_sensor_m.norm() / range_m_);
        }
    }
    if (sigma_ > 0.0)
        sure += gaussian(random_, sigma_);
    out.emplace_back(protocol::HumanMotionReading{view.now, model().name, std::clamp(sure, 0.0, 1.0)});
}

void SoundSensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    const Vec3 ear_m = sensor_in_map(view).translation();
    double loudest_db = -1e9;
    for (const SoundSource& source : view.world.sounds) {
        const double distance_m = std::max(1.0, (source.position_in_map_m - ear_m).norm());
        loudest_db = std::max(loudest_db, source.loudness_db - 20.0 * std::log10(distance_m));
    }
    if (sigma_db_ > 0.0)
        loudest_db += gaussian(random_, sigma_db_);
    if (loudest_db >= threshold_db_)
        out.emplace_back(protocol::SoundReading{view.now, model().name, loudest_db, view.tick});
}

void GasSensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    const auto word = model().words.find("gas");
    const std::string gas = word == model().words.end() ? "CO2" : word->second;
    const Vec3 nose_m = sensor_in_map(view).translation();
    double density = 0.0;
    for (const GasSource& source : view.world.gases)
        if (sameWord(source.gas, gas))
            density += source.density / std::max(1.0, (source.position_in_map_m - nose_m).squaredNorm());
    out.emplace_back(protocol::GasReading{view.now, model().name, gas, density});
}

void BallSensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    const Eigen::Isometry3d sensor_in_map = this->sensor_in_map(view);
    const auto is_ball = [](const std::string& word) {
        return word.size() >= 4 && sameWord(word.substr(word.size() - 4), "ball");
    };
    std::optional<Vec3> nearest_m;
    double radius_m = 0.0;
    for (const SceneObject& object : view.scene.objects) {
        const Vec3 ball_m = sensor_in_map.inverse() * object.body_in_map.position_m;
        if ((is_ball(object.class_name) || is_ball(object.name)) && inView(ball_m, range_m_, fov_rad_, fov_rad_) &&
            (!nearest_m || ball_m.norm() < nearest_m->norm()) &&
            isOpen(view, sensor_in_map.translation(), object.body_in_map.position_m, object.radius_m + 0.01)) {
            nearest_m = ball_m;
            radius_m = object.radius_m;
        }
    }
    protocol::BallReading seen{view.now, model().name, Vec3(Vec3::Zero()), nearest_m.has_value()};
    if (nearest_m) {
        seen.position = protocol::acrossWire(shaken(random_, *nearest_m, sigma_ * nearest_m->norm()));
        const double edge_m = seen.position->x() * std::tan(fov_rad_ / 2.0); // of the picture, at the ball's distance
        if (edge_m > 0.0) {
            seen.place_in_picture = {seen.position->y() / edge_m, seen.position->z() / edge_m};
            seen.radius_in_picture = radius_m / edge_m;
        }
    }
    out.emplace_back(std::move(seen));
}

} // namespace usar::sim
