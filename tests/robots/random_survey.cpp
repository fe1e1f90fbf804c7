#include "tests/robots/random_survey.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <stdexcept>

#include <QTest>

#include "core/base/random.h"
#include "core/mapping/raster_export.h"
#include "core/mission/runs/mission_score.h"
#include "core/sim/rays/ray_caster.h"
#include "core/sim/world/free_space.h"
#include "core/sim/world/world_generator.h"
#include "robots/airrobot/descriptions.h"
#include "tests/doubles/shipped_robots.h"
#include "tests/doubles/simulated_flight.h"

namespace usar::test {

namespace {

constexpr Seconds longest_flight{36000.0};
constexpr double free_m = 2.5; ///< around a start
constexpr double steepest = 0.1;
/// The base is so high over the ground that the legs nearly touch it. A robot that is spawned higher sinks by itself,
/// and a wind of more than 3.5 m/s throws it over before its behavior has a say.
constexpr double standing_m = 0.23;
/// The legs end so far from the robot's center and below it. One that is spawned in the ground is thrown out of it, and
/// the robot breaks as it falls back (surveys 152552 and 152848).
constexpr double leg_away_m = 0.36;
constexpr double leg_below_m = 0.215;
/// Where the ground is not level, there is no air for the body so low; the fill of what can be reached begins higher.
constexpr double off_the_ground_m = 0.3;
/// A tenth of the lanes may be given up in a success.
constexpr double least_scanned_pct = 85.0;
constexpr const char* crashed = "The robot has crashed";
/// How much of the lanes, or of the area.
constexpr std::array confessions{"none was found to ", "no ground is within reach", "the scans show "};

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

/// True if the legs stand on it and nothing reaches up to the belly: no curb, no board. Wind moves a robot as it is
/// spawned, so the ground around it counts, too.
bool isFlat(const sim::RayCaster& rays, const Vec3& at_m) {
    for (double x_m = -1.2; x_m <= 1.2; x_m += 0.03)
        for (double y_m = -1.2; y_m <= 1.2; y_m += 0.03) {
            const double low_m = rays.cast(at_m + Vec3(x_m, y_m, 2.0), -Vec3::UnitZ(), 10.0) - 2.0;
            if (std::abs(low_m) > 0.05 + steepest * std::hypot(x_m, y_m))
                return false;
        }
    return true;
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
    return isFlat(rays, at_m) && rays.cast(at_m + Vec3(0.0, 0.0, 0.3), Vec3::UnitZ(), 3.0) >= 3.0;
}

/// The height (map z) at which it stands there, whatever way it is turned.
double standsAt_m(const sim::RayCaster& rays, const Vec3& at_m) {
    double highest_m = at_m.z() + standing_m - leg_below_m;
    for (int i = 0; i < 24; ++i) {
        const double bearing_rad = 2.0 * pi * i / 24.0;
        const Vec3 leg_m = at_m + leg_away_m * Vec3(std::cos(bearing_rad), std::sin(bearing_rad), 0.0);
        highest_m = std::max(highest_m, at_m.z() + 2.0 - rays.cast(leg_m + Vec3(0.0, 0.0, 2.0), -Vec3::UnitZ(), 10.0));
    }
    return highest_m + leg_below_m;
}

bool isRoom(const std::string& world) {
    return world == "vmac_room" || world == "spqr_soccer" || world == "warehouse";
}

/// A free place within `roam_m` of one of the world's start poses, or that start pose where none was found.
Pose drawStart(const sim::World& world, double roam_m, Random& random) {
    const sim::RayCaster rays(world);
    std::vector<Pose> starts; // Some are for submarines.
    for (const sim::NamedPose& start : world.start_poses)
        if (!world.water || rays.cast(start.pose_in_map.position_m, -Vec3::UnitZ(), 2.0) < 2.0)
            starts.push_back(start.pose_in_map);
    const Pose given_in_map = starts.at(random() % starts.size());
    const Rectangle extent = sim::extentOf(world);
    for (int attempt = 0; attempt < 400; ++attempt) {
        const double x_m = given_in_map.position_m.x() + uniform(random, -roam_m, roam_m);
        const double y_m = given_in_map.position_m.y() + uniform(random, -roam_m, roam_m);
        if (!extent.contains({x_m, y_m}))
            continue;
        const double from_m = given_in_map.position_m.z() + (isRoom(world.name) ? 2.0 : 300.0);
        const Vec3 ground_m(x_m, y_m, from_m - rays.cast({x_m, y_m, from_m}, -Vec3::UnitZ(), 1000.0));
        if (isFree(world, rays, ground_m))
            return Pose{{x_m, y_m, standsAt_m(rays, ground_m)}, 0.0, 0.0, uniform(random, -pi, pi)};
    }
    for (const Pose& start_in_map : starts) // Nothing is free. On a field, some of them are too close to a board.
        if (isFlat(rays, start_in_map.position_m))
            return start_in_map;
    return given_in_map;
}

Vec2 windOf(const RandomSurvey& survey) {
    return survey.wind_m_s * Vec2(std::cos(survey.wind_toward_rad), std::sin(survey.wind_toward_rad));
}

sim::SimulationOptions optionsOf(const RandomSurvey& survey) {
    sim::SimulationOptions options;
    options.seed = survey.noise_seed;
    options.battery_life = sim::survey_battery_life;
    options.robots = doubles::shippedRobots();
    if (survey.wind_m_s > 0.0) {
        sim::Fault wind{.kind = sim::FaultKind::Wind};
        wind.numbers = {{"speed", survey.wind_m_s}, {"toward_deg", degrees(survey.wind_toward_rad)}};
        options.faults.push_back(wind);
    }
    if (survey.fault)
        options.faults.push_back(survey.fault->fault);
    return options;
}

std::optional<double> reachableCoverage_pct(const SimulatedFlight& flight, const sim::World& world,
                                            const RandomSurvey& survey, const agent::ParameterSet& parameters) {
    const mission::Truth truth{.surface_m = {},
                               .ground_m = {},
                               .world_in_map = sim::extentOf(world),
                               .reach = [&world](const FlightLimits& limits, const Rectangle& area_in_map) {
                                   return sim::reachFrom(world, limits, area_in_map);
                               }};
    auto limits = mission::flightLimitsOf(survey.start_in_map, parameters.values());
    limits->start_in_map_m.z() += off_the_ground_m;
    const auto reach = mission::areaReach(mapping::rasterOf(flight.map()), survey.area_in_map, truth, *limits);
    return reach ? std::optional(reach->coverage_pct) : std::nullopt;
}

/// Writes the flight to the console: the truth at each tick in which the robot says something, in the map's frame, with
/// the behavior's state, what its sonars and its INS say, and what the behavior commands.
void runTraced(SimulatedFlight& flight) {
    std::string words;
    flight.listen([&words](bool from_robot, std::string_view line) {
        const auto tells = [line](std::string_view type) { return line.find(type) != std::string_view::npos; };
        if (!from_robot || (line.starts_with("SEN") && (tells("{Type Sonar}") || tells("{Type INS}"))))
            words.append("\n  ").append(line);
    });
    std::size_t events = 0;
    flight.run(longest_flight, [&] {
        if (words.empty())
            return;
        const sim::RobotTruth truth = flight.truth();
        const Vec3& at_m = truth.base_in_map.position_m;
        std::printf("T %.1f at %.2f %.2f %.2f rpy %.2f %.2f %.2f v %.2f %.2f %.2f, %d contacts%s, %s%s\n",
                    flight.status().elapsed.count(), at_m.x(), at_m.y(), at_m.z(), truth.base_in_map.roll_rad,
                    truth.base_in_map.pitch_rad, truth.base_in_map.yaw_rad, truth.velocity_in_map_m_s.x(),
                    truth.velocity_in_map_m_s.y(), truth.velocity_in_map_m_s.z(), truth.collisions,
                    truth.broken ? ", BROKEN" : "", flight.status().state.c_str(), words.c_str());
        words.clear();
        for (; events < flight.events().size(); ++events)
            std::printf("E %s\n", flight.events()[events].c_str());
    });
}

SurveyOutcome outcomeOf(const SimulatedFlight& flight, const sim::World& world, const RandomSurvey& survey) {
    const sim::RobotTruth truth = flight.truth();
    SurveyOutcome outcome;
    outcome.ended = flight.ending().has_value();
    // A robot that lies on its back has not always broken a rotor, and is lost all the same.
    outcome.broken = truth.broken || (outcome.ended && flight.ending()->reason.starts_with(crashed));
    outcome.success = outcome.ended && flight.ending()->success && !outcome.broken; // So do missions.
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

/// Says how it went, and demands what holds for each survey.
void report(const RandomSurvey& survey, const SurveyOutcome& outcome) {
    qInfo("%s", survey.text().c_str());
    qInfo("%s", outcome.text().c_str());
    QVERIFY2(outcome.ended || outcome.broken, outcome.text().c_str());
    QVERIFY2(!outcome.isFalseSuccess(), outcome.text().c_str());
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
    return line.data() + (fault ? ", " + fault->text() : std::string());
}

bool SurveyOutcome::isFalseSuccess() const {
    return success && reachable_coverage_pct.value_or(0.0) < least_scanned_pct &&
           std::ranges::none_of(confessions,
                                [&](const char* words) { return reason.find(words) != std::string::npos; });
}

std::string SurveyOutcome::text() const {
    std::array<char, 160> line{};
    std::array<char, 48> reached{"nothing can be reached"};
    if (reachable_coverage_pct)
        std::snprintf(reached.data(), reached.size(), "of what can be reached %.1f %%", *reachable_coverage_pct);
    const char* const what = broken ? "BROKEN" : !ended ? "NEVER ENDED" : success ? "done" : "gave up";
    std::snprintf(line.data(), line.size(),
                  "%s%s, %d collisions, %.0f s, %.1f %%, %s, height %.1f m: ", isFalseSuccess() ? "FALSE " : "", what,
                  collisions, elapsed_s, coverage_pct, reached.data(), height_m);
    return line.data() + reason;
}

RandomSurvey drawSurvey(int number) {
    static constexpr std::array names{"tall_test",   "vmac_room", "point_lookout", "volcano",
                                      "spqr_soccer", "warehouse", "town",          "quarry"};
    Random random = seeded(static_cast<std::uint64_t>(number), 20);
    RandomSurvey survey;
    survey.number = number;
    survey.world = names[static_cast<std::size_t>(number) % names.size()];
    survey.world_seed = 1 + random() % 6;
    survey.noise_seed = 1 + random() % 1000;
    survey.behavior = static_cast<std::size_t>(number) / names.size() % 2 == 0 ? "airrobot/cpp" : "airrobot/posh";
    const bool room = isRoom(survey.world);
    const bool field = survey.world == "spqr_soccer";
    survey.start_in_map = drawStart(worldOf(survey.world, survey.world_seed), field ? 4.0 : room ? 15.0 : 60.0, random);
    const double off_m = field ? 3.0 : 25.0;
    const double most_m = field ? 12.0 : 50.0;
    Vec2 center_m = survey.start_in_map.position_m.head<2>();
    Vec2 half_m = Vec2::Zero();
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
        center_m[axis] += uniform(random, -off_m, off_m);
        half_m[axis] = 0.5 * uniform(random, 8.0, most_m);
    }
    survey.area_in_map = {center_m - half_m, center_m + half_m};
    survey.wind_m_s = room ? 0.0 : uniform(random, 0.0, 4.0);
    survey.wind_toward_rad = uniform(random, -pi, pi);
    return survey;
}

RandomSurvey drawFaultySurvey(int number) {
    RandomSurvey survey = drawSurvey(number);
    survey.fault = drawFault(static_cast<std::uint64_t>(number), windOf(survey));
    return survey;
}

SurveyOutcome fly(const RandomSurvey& survey) {
    const sim::World& world = worldOf(survey.world, survey.world_seed);
    auto simulation = sim::Simulation::make(world, optionsOf(survey));
    if (!simulation)
        return {.reason = simulation.error().text()};
    const agent::RobotDescription description = airrobot::AirRobot().description();
    const agent::BehaviorDescription& told = description.behaviors[0];
    const auto preset = std::ranges::find(told.presets, survey.preset, &agent::ParameterPreset::id);
    const auto parameters = agent::ParameterSet::make(
        told.parameters,
        preset == told.presets.end() ? std::map<std::string, agent::ParameterValue>() : preset->values);
    auto behavior = airrobot::AirRobot().createBehavior(
        survey.behavior, {{"R1", survey.start_in_map, survey.area_in_map, sim::dryAbove_m(world)}, *parameters});
    if (!behavior)
        return {.reason = behavior.error().text()};
    SimulatedFlight flight(std::move(*simulation), std::move(*behavior), survey.start_in_map);
    if (qEnvironmentVariableIsSet("USAR_TRACE"))
        runTraced(flight);
    else
        flight.run(longest_flight);
    SurveyOutcome outcome = outcomeOf(flight, world, survey);
    outcome.reachable_coverage_pct = reachableCoverage_pct(flight, world, survey, *parameters);
    return outcome;
}

void surveyRows(int first, int last) {
    QTest::addColumn<int>("number");
    for (int number = first; number < last; ++number)
        QTest::addRow("survey %d", number) << number;
}

void surveyRowsOrAsked(int first, int last) {
    const QList<QByteArray> asked = qgetenv("USAR_SURVEYS").split('-');
    const bool both = asked.size() == 2;
    surveyRows(both ? asked.first().toInt() : first, both ? asked.last().toInt() + 1 : last);
}

void tryRandomSurvey(int number, const std::string& preset) {
    RandomSurvey survey = drawSurvey(number);
    survey.preset = preset;
    const SurveyOutcome outcome = fly(survey);
    report(survey, outcome);
    QVERIFY2(!outcome.broken, outcome.text().c_str());
}

bool tryFaultySurvey(int number) {
    const RandomSurvey survey = drawFaultySurvey(number);
    const SurveyOutcome outcome = fly(survey);
    report(survey, outcome);
    return outcome.broken && survey.fault->can_fly;
}

} // namespace usar::test
