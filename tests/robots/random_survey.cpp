#include "tests/robots/random_survey.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <random>
#include <stdexcept>

#include <QTest>

#include "core/sim/rays/ray_caster.h"
#include "core/sim/world/world_generator.h"
#include "robots/airrobot/descriptions.h"
#include "tests/doubles/shipped_robots.h"
#include "tests/doubles/simulated_flight.h"

namespace usar::test {

namespace {

constexpr Seconds longest_flight{36000.0};
constexpr double free_m = 2.5; ///< around a start
constexpr double steepest = 0.1;

/// A world and its number, which is kept for the next mission there.
const sim::World& worldOf(const std::string& name, std::uint64_t seed) {
    static std::map<std::pair<std::string, std::uint64_t>, sim::World> worlds;
    const auto known = worlds.find({name, seed});
    if (known != worlds.end())
        return known->second;
    worlds.clear(); // Big ones take 100 MB.
    auto world = sim::makeWorld(name, seed, USAR_SOURCE_DIR "/resources/worlds");
    if (!world)
        throw std::runtime_error(world.error().text());
    return worlds.emplace(std::pair(name, seed), std::move(*world)).first->second;
}

/// True if an AirRobot can stand there: level, dry, and nothing near it.
bool isFree(const sim::World& world, const sim::RayCaster& rays, const Vec3& at_m) {
    if (world.water && at_m.z() < world.water->surface_z_m + 1.0)
        return false;
    for (const sim::WorldObject& object : world.objects)
        if ((object.body_in_map.position_m - at_m).head<2>().norm() < free_m)
            return false;
    for (int i = 0; i < 24; ++i) {
        const double bearing_rad = 2.0 * pi * i / 24.0;
        const Vec3 along(std::cos(bearing_rad), std::sin(bearing_rad), 0.0);
        for (const double height_m : {0.3, 1.5, 3.0})
            if (rays.cast(at_m + Vec3(0.0, 0.0, height_m), along, free_m) < free_m)
                return false;
        const double low_m = rays.cast(at_m + free_m * along + Vec3(0.0, 0.0, 2.0), -Vec3::UnitZ(), 10.0);
        if (std::abs(low_m - 2.0) > steepest * free_m)
            return false;
    }
    return rays.cast(at_m + Vec3(0.0, 0.0, 0.3), Vec3::UnitZ(), 3.0) >= 3.0;
}

} // namespace

std::string RandomSurvey::text() const {
    std::array<char, 256> line{};
    const Vec2 size_m = area_in_map.max_m - area_in_map.min_m;
    std::snprintf(line.data(), line.size(),
                  "%d: %s %llu, %s, start %.1f %.1f %.1f, area %.0f x %.0f at %.0f %.0f, wind %.1f", number,
                  world.c_str(), static_cast<unsigned long long>(world_seed), behavior.c_str(),
                  start_in_map.position_m.x(), start_in_map.position_m.y(), start_in_map.position_m.z(), size_m.x(),
                  size_m.y(), area_in_map.center_m().x(), area_in_map.center_m().y(), wind_m_s);
    return line.data();
}

std::string SurveyOutcome::text() const {
    std::array<char, 128> line{};
    std::snprintf(line.data(), line.size(), "%s, %d collisions, %.0f s, %.1f %%, height %.1f m: ",
                  broken    ? "BROKEN"
                  : !ended  ? "NEVER ENDED"
                  : success ? "done"
                            : "gave up",
                  collisions, elapsed_s, coverage_pct, height_m);
    return line.data() + reason;
}

RandomSurvey drawSurvey(int number) {
    static constexpr std::array names{"tall_test", "vmac_room", "point_lookout", "volcano", "spqr_soccer"};
    std::mt19937_64 random(static_cast<std::uint64_t>(number) * 7919U + 13U);
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() >> 11U) / 9007199254740992.0;
    };
    RandomSurvey survey;
    survey.number = number;
    survey.world = names[static_cast<std::size_t>(number) % names.size()];
    survey.world_seed = 1 + random() % 6;
    survey.noise_seed = 1 + random() % 1000;
    survey.behavior = number / 5 % 2 == 0 ? "airrobot/cpp" : "airrobot/posh";
    const sim::World& world = worldOf(survey.world, survey.world_seed);
    const sim::RayCaster rays(world);
    const bool room = survey.world == "vmac_room" || survey.world == "spqr_soccer";
    std::vector<Pose> starts; // Some are for submarines.
    for (const sim::NamedPose& start : world.start_poses)
        if (!world.water || rays.cast(start.pose_in_map.position_m, -Vec3::UnitZ(), 2.0) < 2.0)
            starts.push_back(start.pose_in_map);
    survey.start_in_map = starts.at(random() % starts.size());
    const Rectangle extent = sim::extentOf(world);
    const double roam_m = survey.world == "spqr_soccer" ? 4.0 : room ? 15.0 : 60.0;
    for (int attempt = 0; attempt < 400; ++attempt) {
        const Vec2 at_m =
            survey.start_in_map.position_m.head<2>() + Vec2(between(-roam_m, roam_m), between(-roam_m, roam_m));
        if (!extent.contains(at_m))
            continue;
        const double z_m = survey.start_in_map.position_m.z();
        const double from_m = room ? z_m + 2.0 : z_m + 300.0;
        const Vec3 ground_m(at_m.x(), at_m.y(),
                            from_m - rays.cast({at_m.x(), at_m.y(), from_m}, -Vec3::UnitZ(), 1000.0));
        if (!isFree(world, rays, ground_m))
            continue;
        survey.start_in_map = Pose{ground_m + Vec3(0.0, 0.0, 0.35), 0.0, 0.0, between(-pi, pi)};
        break;
    }
    const double off_m = survey.world == "spqr_soccer" ? 3.0 : 25.0;
    const Vec2 center_m =
        survey.start_in_map.position_m.head<2>() + Vec2(between(-off_m, off_m), between(-off_m, off_m));
    const double most_m = survey.world == "spqr_soccer" ? 12.0 : 50.0;
    const Vec2 half_m = 0.5 * Vec2(between(8.0, most_m), between(8.0, most_m));
    survey.area_in_map = {center_m - half_m, center_m + half_m};
    survey.wind_m_s = room ? 0.0 : between(0.0, 4.0);
    survey.wind_toward_rad = between(-pi, pi);
    return survey;
}

SurveyOutcome fly(const RandomSurvey& survey) {
    const sim::World& world = worldOf(survey.world, survey.world_seed);
    sim::SimulationOptions options;
    options.seed = survey.noise_seed;
    options.battery_life = sim::survey_battery_life;
    options.robots = doubles::shippedRobots();
    if (survey.wind_m_s > 0.0) {
        sim::Fault wind{.kind = sim::FaultKind::Wind};
        wind.numbers = {{"speed", survey.wind_m_s}, {"toward_deg", degrees(survey.wind_toward_rad)}};
        options.faults.push_back(wind);
    }
    auto simulation = sim::Simulation::make(world, options);
    if (!simulation)
        return {.reason = simulation.error().text()};
    const agent::RobotDescription description = airrobot::AirRobot().description();
    const auto parameters = agent::ParameterSet::make(description.behaviors[0].parameters);
    auto behavior = airrobot::AirRobot().createBehavior(
        survey.behavior, {{"R1", survey.start_in_map, survey.area_in_map, sim::dryAbove_m(world)}, *parameters});
    if (!behavior)
        return {.reason = behavior.error().text()};
    SimulatedFlight flight(std::move(*simulation), std::move(*behavior), survey.start_in_map);
    flight.run(longest_flight);
    SurveyOutcome outcome;
    const sim::RobotTruth truth = flight.truth();
    outcome.ended = flight.ending().has_value();
    outcome.success = outcome.ended && flight.ending()->success;
    outcome.broken = truth.broken;
    outcome.collisions = truth.collisions;
    outcome.elapsed_s = flight.status().elapsed.count();
    outcome.coverage_pct = flight.coverage_pct(survey.area_in_map);
    outcome.height_m =
        sim::RayCaster(world).cast(truth.base_in_map.position_m - Vec3(0.0, 0.0, 0.25), -Vec3::UnitZ(), 100.0);
    outcome.reason = outcome.ended ? flight.ending()->reason : flight.status().state;
    if (!flight.events().empty())
        outcome.reason += " | " + flight.events().back();
    return outcome;
}

void surveyRows(int first, int last) {
    QTest::addColumn<int>("number");
    for (int number = first; number < last; ++number)
        QTest::addRow("survey %d", number) << number;
}

void tryRandomSurvey(int number) {
    const RandomSurvey survey = drawSurvey(number);
    const SurveyOutcome outcome = fly(survey);
    qInfo("%s", survey.text().c_str());
    qInfo("%s", outcome.text().c_str());
    QVERIFY2(!outcome.broken, outcome.text().c_str());
    QVERIFY2(outcome.ended, outcome.text().c_str());
}

} // namespace usar::test
