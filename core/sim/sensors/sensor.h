// A sensor of a robot as the server sees it: it measures at the message tick and answers GETGEO, GETCONF and SET.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/base/random.h"
#include "core/base/result.h"
#include "core/protocol/command.h"
#include "core/protocol/dialect.h"
#include "core/protocol/info_message.h"
#include "core/sim/physics/scene.h"
#include "core/sim/robots/robot_body.h"
#include "core/sim/sensors/rays.h"
#include "core/sim/world/world.h"

namespace usar::sim {

/// Everything that a sensor can measure at a tick.
struct SensorView {
    Seconds now;
    Seconds tick; ///< length of a message tick
    const RobotBody& body;
    const Rays& rays;
    const World& world;
    Scene& scene;
};

/// Initial conditions of a sensor.
struct SensorBirth {
    const RobotModel& robot;
    Pose base_in_map;           ///< at the spawn
    Seconds scan_interval{0.2}; ///< from one of its measurements to the next
    bool noise = true;
    Random random; ///< a stream of its own: sensors added later change nobody's noise
    protocol::Dialect profile = protocol::Dialect::Ut2004;
};

/// Base of all sensors. Owned by its robot's SensorSuite.
class Sensor {
public:
    /// Keeps no reference to its arguments.
    Sensor(const SensorModel& model, const SensorBirth& birth)
        : random_(birth.random)
        , model_(model)
        , noise_(birth.noise)
        , scan_interval_(birth.scan_interval) {}
    virtual ~Sensor() = default;

    const SensorModel& model() const { return model_; }
    /// Appends its line to `out`, or adds its part to the last line there if that is of its type (UT2004 puts all
    /// sensors of a simple type into one line). Adds nothing if there is nothing to report.
    virtual void measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) = 0;
    /// Called instead of `measure` at a tick at which the sensor is not due.
    virtual void passOver(const SensorView& /*view*/) {}
    /// False for sensors that already report at the first tick after INIT (protocol.md 2.4).
    virtual bool needsHistory() const { return true; }
    /// Its settings as CONF reports them: unless a sensor has others, its scan interval in s.
    virtual std::vector<protocol::Setting> settings() const {
        return {setting("ScanInterval", scan_interval_.count())};
    }
    /// Answers a SET that names its type and name, or its type only; nullopt if it does not know the opcode.
    virtual std::optional<protocol::Response> set(const protocol::Command& command, bool /*at_rest*/) {
        return std::holds_alternative<protocol::ResetSensor>(command) && reset() ? std::optional(answer(true))
                                                                                 : std::nullopt;
    }

protected:
    protocol::Response answer(bool ok) const { return {{}, model_.type, model_.name, ok}; }
    static protocol::Setting setting(std::string key, double number) { return {std::move(key), "", number}; }
    /// A setting of the model, or `otherwise` if it is not given.
    double number(std::string_view key, double otherwise) const { return numberOr(model_.numbers, key, otherwise); }
    /// Like `number`, for the strength of an error; 0 if the sensor makes none.
    double error(std::string_view key, double otherwise) const { return noise_ ? number(key, otherwise) : 0.0; }
    /// False if sensors are told to measure exactly.
    bool makesErrors() const { return noise_; }
    /// Obeys a RESET. Returns false for sensors that know none.
    virtual bool reset() { return false; }
    /// Current pose of the sensor.
    Eigen::Isometry3d sensor_in_map(const SensorView& view) const {
        return view.body.link_in_map(model_.link) * model_.sensor_in_link.isometry();
    }

    Random random_; ///< for all its errors

private:
    SensorModel model_;
    bool noise_;
    Seconds scan_interval_;
};

/// The last line of `out` if it is of type `Readings`; otherwise a new one.
template <class Readings>
Readings& lineIn(std::vector<protocol::InfoMessage>& out) {
    if (out.empty() || !std::holds_alternative<Readings>(out.back()))
        out.emplace_back(Readings{});
    return std::get<Readings>(out.back());
}

/// The link on the joint that this word of a sensor's model names; nullopt if there is no such word or joint.
std::optional<int> linkNamedBy(std::string_view word, const SensorModel& model, const RobotModel& robot);

/// Makes the sensor of the model's type. Fails if the simulator has no such type, or if the sensor needs a joint that
/// the robot does not have.
Result<std::unique_ptr<Sensor>> makeSensor(const SensorModel& model, const SensorBirth& birth);

/// The position of a type in the order of a tick, which is another one in each profile (protocol.md 1.8). Types that
/// are not named there come between GPS and the packages.
int orderOf(std::string_view type, protocol::Dialect profile);

} // namespace usar::sim
