#include "core/sim/sensors/sensor.h"

#include <algorithm>
#include <array>

#include "core/base/text.h"
#include "core/sim/sensors/camera_sensor.h"
#include "core/sim/sensors/finding_sensors.h"
#include "core/sim/sensors/motion_sensors.h"
#include "core/sim/sensors/range_sensors.h"

namespace usar::sim {

namespace {

template <class One, auto... arguments>
std::unique_ptr<Sensor> make(const SensorModel& model, const SensorBirth& birth) {
    return std::make_unique<One>(model, birth, arguments...);
}

struct SensorRow {
    std::string_view type;
    std::unique_ptr<Sensor> (*make)(const SensorModel&, const SensorBirth&);
    std::array<std::string_view, 2> joints{}; ///< the words of the model that must name joints; empty: none
};

/// The types in the order in which they report at a tick.
constexpr std::array rows{
    SensorRow{"Sonar", make<SonarSensor>},
    SensorRow{"IR", make<RaySensor>},
    SensorRow{"Range", make<RaySensor>},
    SensorRow{"RangeScanner", make<ScannerSensor>},
    SensorRow{"IRScanner", make<ScannerSensor>},
    SensorRow{"INS", make<InsSensor>},
    SensorRow{"Odometry", make<OdometrySensor>, {"left", "right"}},
    SensorRow{"Encoder", make<EncoderSensor>, {"joint"}},
    SensorRow{"Touch", make<TouchSensor>},
    SensorRow{"RFID", make<RfidSensor>},
    SensorRow{"VictSensor", make<VictimSensor>},
    SensorRow{"GroundTruth", make<GroundTruthSensor>},
    SensorRow{"GPS", make<GpsSensor>},
    SensorRow{"Tachometer", make<TachometerSensor>},
    SensorRow{"Accel", make<AccelerationSensor, false>},
    SensorRow{"AcceleroMeter", make<AccelerationSensor, true>},
    SensorRow{"HumanMotion", make<HumanMotionSensor>},
    SensorRow{"Sound", make<SoundSensor>},
    SensorRow{"CO2Sensor", make<GasSensor>},
    SensorRow{"Helper", make<BallSensor>},
    SensorRow{"Camera", make<CameraSensor>},
};

auto rowOf(std::string_view type) {
    return std::ranges::find_if(rows, [type](const SensorRow& row) { return sameWord(row.type, type); });
}

} // namespace

std::optional<int> linkNamedBy(std::string_view word, const SensorModel& model, const RobotModel& robot) {
    const auto name = model.words.find(word);
    return name == model.words.end() ? std::nullopt : robot.linkOnJoint(name->second);
}

Result<std::unique_ptr<Sensor>> makeSensor(const SensorModel& model, const SensorBirth& birth) {
    const std::string where = "robot " + birth.robot.class_name;
    const auto row = rowOf(model.type);
    if (row == rows.end())
        return failure("there is no sensor of the type " + model.type, where,
                       "Check usar:type of \"" + model.name + "\"");
    for (const std::string_view word : row->joints)
        if (!word.empty() && !linkNamedBy(word, model, birth.robot))
            return failure("the sensor \"" + model.name + "\" needs the name of a joint as usar:" + std::string(word),
                           where, "Fix its file");
    return row->make(model, birth);
}

int orderOf(std::string_view type, protocol::Dialect profile) {
    // In the order of the captured ticks; those that no capture has follow the sensor that they are most like.
    constexpr std::array<std::string_view, 13> udk{"GroundTruth", "Odometry",  "INS",          "Sonar",  "IR",
                                                   "Range",       "IRScanner", "RangeScanner", "Camera", "Tachometer",
                                                   "Encoder",     "Touch",     "GPS"};
    const auto at = std::ranges::find_if(udk, [type](std::string_view one) { return sameWord(one, type); });
    if (profile == protocol::Dialect::Udk && at != udk.end())
        return static_cast<int>(at - udk.begin());
    const int otherwise = static_cast<int>(rowOf(type) - rows.begin());
    return profile == protocol::Dialect::Udk ? static_cast<int>(udk.size()) + otherwise : otherwise;
}

} // namespace usar::sim
