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

using Made = Result<std::unique_ptr<Sensor>>;
using Make = Made (*)(const SensorModel&, const SensorBirth&);

template <class One, auto... Arguments>
Made make(const SensorModel& model, const SensorBirth& birth) {
    return std::make_unique<One>(model, birth, Arguments...);
}

/// The link on the joint that this word of the sensor names.
Result<int> jointOf(const SensorModel& model, const SensorBirth& birth, const char* word) {
    const auto name = model.words.find(word);
    const auto link = name == model.words.end() ? std::nullopt : birth.robot.linkOnJoint(name->second);
    if (!link)
        return failure("the sensor \"" + model.name + "\" needs the name of a joint as usar:" + word,
                       "robot " + birth.robot.class_name, "Mend its file");
    return *link;
}

Made makeEncoder(const SensorModel& model, const SensorBirth& birth) {
    const auto joint = jointOf(model, birth, "joint");
    if (!joint)
        return tl::unexpected(joint.error());
    return std::make_unique<EncoderSensor>(model, birth, *joint);
}

Made makeOdometry(const SensorModel& model, const SensorBirth& birth) {
    const auto left = jointOf(model, birth, "left");
    const auto right = jointOf(model, birth, "right");
    if (!left || !right)
        return tl::unexpected(left ? right.error() : left.error());
    return std::make_unique<OdometrySensor>(model, birth, *left, *right);
}

template <class One>
Made makePlain(const SensorModel& model, const SensorBirth&) {
    return std::make_unique<One>(model);
}

struct Row {
    std::string_view type;
    Make make;
};

/// The types in the order in which they report at a tick.
constexpr std::array rows{
    Row{"Sonar", make<SonarSensor>},
    Row{"IR", make<RaySensor>},
    Row{"Range", make<RaySensor>},
    Row{"RangeScanner", make<ScannerSensor>},
    Row{"IRScanner", make<ScannerSensor>},
    Row{"INS", make<InsSensor>},
    Row{"Odometry", makeOdometry},
    Row{"Encoder", makeEncoder},
    Row{"Touch", makePlain<TouchSensor>},
    Row{"RFID", makePlain<RfidSensor>},
    Row{"VictSensor", make<VictimSensor>},
    Row{"GroundTruth", make<GroundTruthSensor>},
    Row{"GPS", make<GpsSensor>},
    Row{"Tachometer", make<TachometerSensor>},
    Row{"Accel", make<AccelerationSensor, false>},
    Row{"AcceleroMeter", make<AccelerationSensor, true>},
    Row{"HumanMotion", make<HumanMotionSensor>},
    Row{"Sound", make<SoundSensor>},
    Row{"CO2Sensor", makePlain<GasSensor>},
    Row{"Helper", make<BallSensor>},
    Row{"Camera", make<CameraSensor>},
};

const Row* rowOf(std::string_view type) {
    const auto row = std::ranges::find_if(rows, [type](const Row& one) { return sameWord(one.type, type); });
    return row == rows.end() ? nullptr : &*row;
}

} // namespace

Result<std::unique_ptr<Sensor>> makeSensor(const SensorModel& model, const SensorBirth& birth) {
    const Row* const row = rowOf(model.type);
    if (!row)
        return failure("no sensor here is of the type " + model.type, "robot " + birth.robot.class_name,
                       "Check usar:type of \"" + model.name + "\"");
    return row->make(model, birth);
}

int orderOf(std::string_view type) {
    const Row* const row = rowOf(type);
    return row ? static_cast<int>(row - rows.data()) : static_cast<int>(rows.size());
}

} // namespace usar::sim
