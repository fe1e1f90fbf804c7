// What can be made to go wrong on request, as values and as the line of text that a person writes.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/sim/robots/robot_model.h"

namespace usar::sim {

/// In the order of `faultKinds`.
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

inline constexpr Seconds without_end{std::numeric_limits<double>::infinity()};

/// From `from` on the simulation's clock, for as long as it lasts. What happens at once (a cut, an empty battery, a
/// robot that vanishes) is not undone at its end. Numbers are by name, in the units that `FaultNumber` gives.
struct Fault {
    FaultKind kind = FaultKind::SensorBias;
    std::string robot{};  ///< by name, in any case; empty: every robot
    std::string sensor{}; ///< its name or its type, in any case; empty: every sensor
    Seconds from{0.0};
    Seconds lasts = without_end;
    Numbers numbers{};

    double number(std::string_view name) const;
    bool activeAt(Seconds now) const { return now >= from && now < from + lasts; }
    bool concerns(std::string_view robot_name) const;
    bool operator==(const Fault&) const = default;
};

struct FaultNumber {
    std::string_view name;
    std::string_view unit;
    double smallest = 0.0;
    double largest = 0.0;
    double usual = 0.0; ///< where the text does not say
    std::string_view help;
};

struct FaultDescription {
    FaultKind kind;
    std::string_view word;
    std::string_view help;
    bool of_robot = true; ///< can be meant for one robot
    bool of_sensor = false;
    std::span<const FaultNumber> numbers;
};

/// Every kind, with all that a help text or a form needs.
std::span<const FaultDescription> faultKinds();
const FaultDescription& descriptionOf(FaultKind kind);

/// "sensor_bias robot=R1 sensor=INS x=0.5 from=60 for=30": the kind, then keys with values in any order. Errors name
/// the word, with the nearest known one, and the range of a number.
Result<Fault> readFault(std::string_view text);
/// The same text, with what is not usual only.
std::string write(const Fault& fault);

} // namespace usar::sim
