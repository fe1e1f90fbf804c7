#include "core/sim/faults/fault.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/numbers.h"
#include "core/base/spelling.h"

namespace usar::sim {

namespace {

constexpr double longest_s = 1e6;

constexpr std::array bias_numbers{
    FaultNumber{"by", "", -1e3, 1e3, 0.0, "added to every number that the sensor tells, in the sensor's unit"},
    FaultNumber{"x", "m", -1e3, 1e3, 0.0, "added to a position, map frame"},
    FaultNumber{"y", "m", -1e3, 1e3, 0.0, "added to a position, map frame"},
    FaultNumber{"z", "m", -1e3, 1e3, 0.0, "added to a position, map frame"},
    FaultNumber{"yaw_deg", "deg", -180.0, 180.0, 0.0, "added to an orientation, counter-clockwise"}};
constexpr std::array dropout_numbers{FaultNumber{"share", "", 0.0, 1.0, 1.0, "of the readings that are missing"}};
constexpr std::array delay_numbers{
    FaultNumber{"by", "s", 0.0, 60.0, 1.0, "each way, rounded up to whole message ticks"}};
constexpr std::array loss_numbers{FaultNumber{"share", "", 0.0, 1.0, 0.001, "of the bytes that are lost, each way"}};
constexpr std::array battery_numbers{FaultNumber{"left", "s", 0.0, longest_s, 0.0, "of battery life that is left"}};
constexpr std::array rotor_numbers{
    FaultNumber{"rotor", "", 1.0, 4.0, 1.0, "1 front left, 2 front right, 3 rear right, 4 rear left", true},
    FaultNumber{"thrust", "", 0.0, 1.0, 0.0, "share of the thrust that is left"}};
constexpr std::array wind_numbers{
    FaultNumber{"speed", "m/s", 0.0, 60.0, 3.0, "mean at 10 m above the ground, less below"},
    FaultNumber{"toward_deg", "deg", -360.0, 360.0, 0.0, "where it blows to, counter-clockwise from the map's x"},
    FaultNumber{"gust", "m/s", 0.0, 30.0, 0.0, "standard deviation of the gusts"}};
constexpr std::array vanish_numbers{FaultNumber{"after", "s", 0.0, longest_s, 1.0, "since the robot was spawned"}};

constexpr std::array kinds{
    FaultDescription{FaultKind::SensorBias, "sensor_bias", "a sensor reads too much or too little", true, true,
                     bias_numbers},
    FaultDescription{FaultKind::SensorDropout, "sensor_dropout", "readings of a sensor are missing", true, true,
                     dropout_numbers},
    FaultDescription{FaultKind::SensorFreeze, "sensor_freeze", "a sensor repeats its last reading", true, true, {}},
    FaultDescription{FaultKind::LinkDelay, "link_delay", "lines and commands arrive late", true, false, delay_numbers},
    FaultDescription{FaultKind::LinkLoss, "link_loss", "bytes are lost both ways", true, false, loss_numbers},
    FaultDescription{FaultKind::LinkCut, "link_cut", "the server hangs up", true, false, {}},
    FaultDescription{FaultKind::LinkHalfOpen,
                     "link_half_open",
                     "the connection stays open but nothing gets through; what was held back arrives at the end",
                     true,
                     false,
                     {}},
    FaultDescription{FaultKind::Battery, "battery", "the battery loses its charge", true, false, battery_numbers},
    FaultDescription{FaultKind::Rotor, "rotor", "a rotor of a flying robot loses thrust", true, false, rotor_numbers},
    FaultDescription{FaultKind::Wind, "wind", "moving air, with gusts, for everything that flies", false, false,
                     wind_numbers},
    FaultDescription{FaultKind::Vanish, "vanish", "the robot is gone, the connection stays", true, false,
                     vanish_numbers}};

const FaultNumber* findNumber(const FaultDescription& kind, std::string_view name) {
    for (const FaultNumber& number : kind.numbers)
        if (sameWord(number.name, name))
            return &number;
    return nullptr;
}

std::vector<std::string> keysOf(const FaultDescription& kind) {
    std::vector<std::string> keys;
    if (kind.of_robot)
        keys.emplace_back("robot");
    if (kind.of_sensor)
        keys.emplace_back("sensor");
    for (const FaultNumber& number : kind.numbers)
        keys.emplace_back(number.name);
    keys.insert(keys.end(), {"from", "for"});
    return keys;
}

std::vector<std::string> kindWords() {
    std::vector<std::string> words;
    for (const FaultDescription& kind : kinds)
        words.emplace_back(kind.word);
    return words;
}

std::string short_(double value) {
    std::string text = fixed(value, 6);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.')
        text.pop_back();
    if (readNumber(text) == value)
        return text; // This is how users write it.
    text.clear();
    appendShortest(text, value);
    return text;
}

tl::unexpected<Error> unknown(const std::string& what, const std::string& word, const std::vector<std::string>& known) {
    return failure("unknown " + what + " '" + word + "'", "fault",
                   "Did you mean '" + nearestWord(word, known) + "'? Known here: " + listOf(known));
}

Result<double> numberOf(std::string_view key, std::string_view value, double smallest, double largest,
                        bool whole = false) {
    const std::optional<double> number = readNumber(value);
    if (!number || !(*number >= smallest && *number <= largest) || (whole && *number != std::trunc(*number)))
        return failure("'" + std::string(value) + "' is not a valid " + std::string(key), "fault",
                       (whole ? "Give a whole number from " : "Give a number from ") + short_(smallest) + " to " +
                           short_(largest));
    return *number;
}

/// Stores one key's value in the fault.
Result<void> take(Fault& fault, const FaultDescription& kind, std::string_view key, std::string_view value) {
    if (kind.of_robot && sameWord(key, "robot")) {
        fault.robot = value;
        return {};
    }
    if (kind.of_sensor && sameWord(key, "sensor")) {
        fault.sensor = value;
        return {};
    }
    if (const FaultNumber* const known = findNumber(kind, key))
        return numberOf(known->name, value, known->smallest, known->largest, known->whole).map([&](double number) {
            fault.numbers[std::string(known->name)] = number;
        });
    for (const auto& [word, moment] : {std::pair("from", &fault.from), std::pair("for", &fault.lasts)})
        if (sameWord(key, word))
            return numberOf(word, value, 0.0, longest_s).map([moment](double time_s) { *moment = Seconds{time_s}; });
    return unknown("word", std::string(key), keysOf(kind));
}

} // namespace

double Fault::number(std::string_view name) const {
    const FaultNumber* const described = findNumber(descriptionOf(kind), name);
    return numberOr(numbers, name, described ? described->usual : 0.0);
}

std::span<const FaultDescription> faultKinds() {
    return kinds;
}

const FaultDescription& descriptionOf(FaultKind kind) {
    return kinds[static_cast<std::size_t>(kind)];
}

Result<Fault> readFault(std::string_view text) {
    const std::string word(takeWord(text));
    const FaultDescription* kind = nullptr;
    for (const FaultDescription& one : kinds)
        if (sameWord(one.word, word))
            kind = &one;
    if (!kind)
        return unknown("kind", word, kindWords());
    Fault fault{.kind = kind->kind};
    for (std::string_view pair = takeWord(text); !pair.empty(); pair = takeWord(text)) {
        const std::size_t equals = pair.find('=');
        if (equals == std::string_view::npos || equals + 1 == pair.size())
            return failure("'" + std::string(pair) + "' has no value", "fault",
                           "Write it as " + std::string(pair.substr(0, equals)) + "=VALUE");
        if (const auto taken = take(fault, *kind, pair.substr(0, equals), pair.substr(equals + 1)); !taken)
            return tl::unexpected(taken.error());
    }
    if (fault.kind == FaultKind::SensorBias &&
        std::ranges::all_of(fault.numbers, [](const auto& one) { return one.second == 0.0; }))
        return failure("this bias changes nothing", "fault", "Give at least one of by, x, y, z and yaw_deg");
    return fault;
}

std::string write(const Fault& fault) {
    const FaultDescription& kind = descriptionOf(fault.kind);
    std::string text(kind.word);
    if (!fault.robot.empty())
        text += " robot=" + fault.robot;
    if (!fault.sensor.empty())
        text += " sensor=" + fault.sensor;
    for (const FaultNumber& number : kind.numbers)
        if (const double value = fault.number(number.name); value != number.usual)
            text += " " + std::string(number.name) + "=" + short_(value);
    if (fault.from > Seconds{0.0})
        text += " from=" + short_(fault.from.count());
    if (std::isfinite(fault.lasts.count()))
        text += " for=" + short_(fault.lasts.count());
    return text;
}

std::string writeWithoutTimes(Fault fault) {
    fault.from = Seconds{0.0};
    fault.lasts = without_end;
    return write(fault);
}

} // namespace usar::sim
