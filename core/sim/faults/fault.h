// Faults that can be injected on request, as values and as the line of text that a user writes.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/base/text.h"
#include "core/sim/robots/robot_model.h"

namespace usar::sim {

/// Kinds of faults, in the order of `faultKinds`, which describes each.
enum class FaultKind {
    SensorBias,
    SensorDropout,
    SensorFreeze,
    LinkDelay,
    LinkLoss,
    LinkCut,
    LinkHalfOpen,
    Battery,
    Rotor,
    Wind,
    Vanish,
};

/// Duration of a fault that lasts to the end of the run.
inline constexpr Seconds without_end{std::numeric_limits<double>::infinity()};

/// Acts from `from` on the simulation's clock for as long as `lasts`. Effects that happen at once (a cut, an empty
/// battery, a robot that vanishes) are not undone at its end. Numbers are by name, in the units that `FaultNumber`
/// gives.
struct Fault {
    FaultKind kind = FaultKind::SensorBias;
    std::string robot{};  ///< its name, in any case; empty: every robot
    std::string sensor{}; ///< its name or its type, in any case; empty: every sensor
    Seconds from{0.0};
    Seconds lasts = without_end;
    Numbers numbers{};

    /// The number by this name, or its usual value if it is not given; 0 if the kind has no such number.
    double number(std::string_view name) const;
    /// True if the fault is meant for every robot or for this one.
    bool concerns(std::string_view robot_name) const { return robot.empty() || sameWord(robot, robot_name); }
    bool operator==(const Fault&) const = default;
};

/// Describes one number of a kind of fault.
struct FaultNumber {
    std::string_view name;
    std::string_view unit;
    double smallest = 0.0;
    double largest = 0.0;
    double usual = 0.0; ///< used if the text does not give the number
    std::string_view help;
    bool whole = false; ///< only whole numbers make sense
};

/// Describes one kind of fault, for the reader, help texts and forms.
struct FaultDescription {
    FaultKind kind;
    std::string_view word; ///< the first word of the fault's text
    std::string_view help;
    bool of_robot = true;   ///< can be limited to one robot
    bool of_sensor = false; ///< can be limited to one sensor
    std::span<const FaultNumber> numbers;
};

/// All kinds of faults.
std::span<const FaultDescription> faultKinds();
const FaultDescription& descriptionOf(FaultKind kind);

/// Reads "sensor_bias robot=R1 sensor=INS x=0.5 from=60 for=30": the kind, then keys with values in any order. An error
/// names the wrong word and the nearest known one, or the range of a number.
Result<Fault> readFault(std::string_view text);
/// The fault as such a text, without the values that are the usual ones.
std::string write(const Fault& fault);
/// The same without its times.
std::string writeWithoutTimes(Fault fault);

} // namespace usar::sim
