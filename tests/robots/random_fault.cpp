#include "tests/robots/random_fault.h"

#include <array>
#include <cmath>

#include "core/base/random.h"

namespace usar::test {

namespace {

/// A robot of 1 kg with a drag of 0.2 kg/m that leans by 25 degrees, the most it may, holds its place in 4.8 m/s.
constexpr double most_wind_m_s = 4.5;
/// Three rotors and this share of the fourth hold the robot level: 0.6 * 6 N are half as much again as a quarter of its
/// weight.
constexpr double enough_thrust = 0.6;
/// The robot begins its way home a minute before it must; it is at most some 100 m away.
constexpr double enough_power_s = 180.0;

void drawSensor(sim::Fault& fault, Random& random) {
    static constexpr std::array names{"INS", "Sonar", "RangeScanner", "GroundTruth"};
    fault.sensor = names[random() % names.size()];
}

void drawBias(sim::Fault& fault, Random& random) {
    drawSensor(fault, random);
    const bool has_pose = fault.sensor == "INS" || fault.sensor == "GroundTruth";
    if (!has_pose)
        fault.numbers = {{"by", uniform(random, -1.5, 1.5)}};
    else if (random() % 2 == 0)
        fault.numbers = {{"yaw_deg", uniform(random, -30.0, 30.0)}};
    else
        fault.numbers = {
            {"x", uniform(random, -4.0, 4.0)}, {"y", uniform(random, -4.0, 4.0)}, {"z", uniform(random, -2.0, 2.0)}};
}

bool drawWind(sim::Fault& fault, Random& random, const Vec2& wind_in_map_m_s) {
    const double speed_m_s = uniform(random, 1.0, 6.0);
    const double toward_rad = uniform(random, -pi, pi);
    const double gust_m_s = uniform(random, 0.0, 0.7);
    fault.numbers = {{"speed", speed_m_s}, {"toward_deg", degrees(toward_rad)}, {"gust", gust_m_s}};
    const Vec2 all_m_s = wind_in_map_m_s + speed_m_s * Vec2(std::cos(toward_rad), std::sin(toward_rad));
    return all_m_s.norm() + 2.0 * gust_m_s < most_wind_m_s;
}

bool drawStrength(sim::Fault& fault, Random& random, const Vec2& wind_in_map_m_s) {
    switch (fault.kind) {
    case sim::FaultKind::SensorBias:
        drawBias(fault, random);
        return true;
    case sim::FaultKind::SensorDropout:
        drawSensor(fault, random);
        fault.numbers = {{"share", uniform(random, 0.2, 1.0)}};
        return true;
    case sim::FaultKind::SensorFreeze:
        drawSensor(fault, random);
        return true;
    case sim::FaultKind::LinkDelay:
        fault.numbers = {{"by", uniform(random, 0.1, 1.5)}};
        return true;
    case sim::FaultKind::LinkLoss:
        fault.numbers = {{"share", uniform(random, 0.0001, 0.003)}};
        return true;
    case sim::FaultKind::LinkHalfOpen:
        fault.lasts = Seconds(uniform(random, 2.0, 20.0)); // It would wait for ever if this had no end.
        return true;
    case sim::FaultKind::Battery:
        fault.numbers = {{"left", uniform(random, 30.0, 600.0)}};
        return fault.number("left") > enough_power_s;
    case sim::FaultKind::Rotor:
        fault.numbers = {{"rotor", static_cast<double>(1 + random() % 4)}, {"thrust", uniform(random, 0.0, 1.0)}};
        return fault.number("thrust") > enough_thrust;
    case sim::FaultKind::Wind:
        return drawWind(fault, random, wind_in_map_m_s);
    case sim::FaultKind::LinkCut:
    case sim::FaultKind::Vanish:
        break;
    }
    return false;
}

} // namespace

std::string RandomFault::text() const {
    return sim::write(fault) + (can_fly ? "" : " (it cannot fly on)");
}

RandomFault drawFault(std::uint64_t number, const Vec2& wind_in_map_m_s) {
    static constexpr std::array kinds{
        sim::FaultKind::SensorBias, sim::FaultKind::SensorDropout, sim::FaultKind::SensorFreeze,
        sim::FaultKind::LinkDelay,  sim::FaultKind::LinkLoss,      sim::FaultKind::LinkHalfOpen,
        sim::FaultKind::Battery,    sim::FaultKind::Rotor,         sim::FaultKind::Wind};
    Random random = seeded(number, 21);
    RandomFault drawn;
    drawn.fault.kind = kinds[random() % kinds.size()];
    drawn.fault.from = Seconds(uniform(random, 5.0, 150.0));
    if (random() % 2 == 0)
        drawn.fault.lasts = Seconds(uniform(random, 5.0, 60.0));
    drawn.can_fly = drawStrength(drawn.fault, random, wind_in_map_m_s);
    return drawn;
}

} // namespace usar::test
