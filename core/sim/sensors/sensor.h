// A sensor of a robot as the server sees it: it measures at the message tick and answers GETGEO, GETCONF and SET.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/base/random.h"
#include "core/base/result.h"
#include "core/protocol/command.h"
#include "core/protocol/info_message.h"
#include "core/sim/robots/robot_body.h"
#include "core/sim/scene.h"
#include "core/sim/sensors/rays.h"
#include "core/sim/world.h"

namespace usar::sim {

/// What there is to be measured at a tick.
struct SensorView {
    Seconds now;
    Seconds tick; ///< since the last one
    const RobotBody& body;
    const Rays& rays;
    const World& world;
    Scene& scene;
};

/// What a sensor is born with.
struct SensorBirth {
    const RobotModel& robot;
    Pose base_in_map;
    Seconds scan_interval{0.2};
    bool noise = true;
    Random random; ///< a stream of its own: sensors that come later change nobody's noise
};

class Sensor {
public:
    explicit Sensor(SensorModel model) : model_(std::move(model)) {}
    virtual ~Sensor() = default;

    const SensorModel& model() const { return model_; }
    /// Adds its line to `out`, or its part to the line of its type that is the last one there (UT2004 puts all sensors
    /// of a simple type into one line). Nothing where there is nothing to tell.
    virtual void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) = 0;
    /// False for those that the first tick after INIT brings already (usarsim-protocol 2.4).
    virtual bool needsHistory() const { return true; }
    /// Its part of CONF.
    virtual std::vector<protocol::Setting> settings() const = 0;
    /// A SET that names its type and name, or its type only; nothing where it knows no such opcode.
    virtual std::optional<protocol::Response> set(const protocol::Command& /*command*/, bool /*at_rest*/) {
        return std::nullopt;
    }

protected:
    protocol::Response answer(bool ok) const { return {{}, model_.type, model_.name, ok}; }
    static protocol::Setting setting(std::string key, double number) { return {std::move(key), "", number}; }
    double number(std::string_view key, double otherwise) const { return numberOr(model_.numbers, key, otherwise); }
    Eigen::Isometry3d sensor_in_map(const SensorView& view) const {
        return view.body.link_in_map(model_.link) * model_.sensor_in_link.isometry();
    }

private:
    SensorModel model_;
};

/// The line of type `Readings` that ends `out`, or a new one.
template <class Readings>
Readings& lineIn(std::vector<protocol::InfoMessage>& out) {
    if (out.empty() || !std::holds_alternative<Readings>(out.back()))
        out.emplace_back(Readings{});
    return std::get<Readings>(out.back());
}

/// Fails for a type that no sensor of the simulator has, and for settings that make no sense.
Result<std::unique_ptr<Sensor>> makeSensor(const SensorModel& model, const SensorBirth& birth);

/// The place of a type in a tick's order (usarsim-protocol 9.1); types that it does not name come between GPS and the
/// packages.
int orderOf(std::string_view type);

} // namespace usar::sim
