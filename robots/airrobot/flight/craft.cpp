#include "robots/airrobot/flight/craft.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace usar::airrobot {

namespace {

constexpr double most_drift_m = 3.0;        ///< More is no drift of the height, but another view of things.
constexpr double slowest_in_wind_m_s = 0.3; ///< It waits for a lull rather than being slower against the wind.
/// If the robot needs to climb no more than this, it continues past an overhang at the same height.
constexpr double bearable_deficit_m = 1.5;
constexpr double path_half_width_m = 0.75;
/// A robot that must not climb where it is flies on until something is so near before it that it must.
constexpr double soon_m = 5.0;
constexpr double soon_half_width_m = 1.5;
/// The robot keeps its height for this distance from the place of a climb.
constexpr double over_way_m = 12.0;
/// A look up shows the tops of trees that are far enough away; those nearby are as high, and the robot flies at them.
constexpr double canopy_seen_m = 30.0;
constexpr double canopy_way_m = 25.0;
/// A robot that is so much higher than where it ended a climb is climbing again.
constexpr double over_again_m = 0.7;
/// A robot that is to fly fast is slow among things within this distance and bearing, and slower while it climbs faster
/// than `rising_m_s`: trunks carry crowns, and no sensor looks at what is higher. So is any robot that hears something
/// there: one that climbed at 1 m/s on its way at 1.7 m/s met the underside of a crown that it had heard for two
/// seconds (random survey 172368).
constexpr double near_m = 6.0;
constexpr double ahead_rad = radians(75.0);
constexpr double crowded_m_s = 1.2;
constexpr double rising_m_s = 0.2;
constexpr double rising_speed_m_s = 1.0;
/// A robot that climbs and is slower than this on the level does not see what it climbs toward.
constexpr double straight_m_s = 0.2;
/// The robot climbs straight up so fast where its scanner has seen the sky. It may have missed a wire, and bears most
/// touches of one at this speed; one at 0.97 m/s broke it (random survey 164038).
constexpr double seen_sky_m_s = 0.7;
/// A robot that leans forward by more than half a sonar's cone, as it does against the wind, hears nothing at its own
/// height. It met a wire so as it climbed at 0.68 m/s on its way at 0.82 m/s (random survey 168982), and bears a touch
/// if it is slower than this and climbs with care.
constexpr double looks_down_rad = radians(7.5);
constexpr double blind_m_s = 0.5;
constexpr double heard_rad = radians(100.0); ///< No sonar hears what is farther from the nose than this.
/// A robot that backs away faster than this no longer nears what it flees from, and what it flees to it may touch: one
/// fled between racks and broke at the one behind it (`tst_random_surveys_campaign`, number 159781).
constexpr double backs_m_s = 0.1;
constexpr double stands_m_s = 0.05; ///< A slower robot does not get past what is before it.
constexpr double hold_still_m = 0.5;
constexpr double detour_m_s = 1.0;
constexpr double among_m = 3.0; ///< A detour is as slow as through a door where something is nearer than this.
/// A robot that is less above a ceiling than this may be below it: the estimate of its height drifts by decimeters.
constexpr double surely_above_m = 1.5;
constexpr double below_ceiling_m = 0.5; ///< Scanner hits higher than this are on the ceiling.
constexpr double open_sky_m = 8.0;      ///< A beam has reached so far above the robot where it is in no room.

/// A thing that a sonar has heard close by once is remembered this much higher than the robot.
constexpr double glimpse_above_m = 0.3;

/// A roof that a robot meets as it climbs does not break it, but does if it slides along it.
constexpr double below_roof_m_s = 0.3;
/// The robot doubts its distance from the roof by no more than this: otherwise, it would creep all the time.
constexpr double most_doubt_m = 1.2;

/// True if the height may have drifted so far that this one is that of a roof.
bool mayTouchRoof(const Senses& senses, const Overhead& overhead) {
    const double doubt_m = std::min(senses.height_doubt_m, most_doubt_m);
    return senses.position_m().z() > overhead.limit_m(senses.position2_m()) - doubt_m;
}

/// Limits speeds to what the robot can do, because the course filter and the stopping distance rely on the command.
Settings withinLimits(Settings settings, const SensorLayout& layout) {
    for (double* speed : {&settings.scan_speed_m_s, &settings.transit_speed_m_s, &settings.evasion_speed_m_s})
        *speed = std::min(*speed, layout.maximum_speed_m_s);
    for (double* rate : {&settings.climb_speed_m_s, &settings.descent_speed_m_s})
        *rate = std::min(*rate, layout.maximum_climb_m_s);
    settings.turn_rate_rad_s = std::min(settings.turn_rate_rad_s, layout.maximum_turn_rad_s);
    return settings;
}

/// True if something before the robot reaches the level above which it flies over things (Craft::passesBelow_m).
bool nearsSomething(const std::vector<Obstacle>& obstacles, const Vec2& here_m, double bearing_rad) {
    return std::ranges::any_of(obstacles, [&](const Obstacle& obstacle) {
        const Vec2 offset_m = obstacle.at_m - here_m;
        return offset_m.norm() < near_m && std::abs(normalizedAngle(bearingOf(offset_m) - bearing_rad)) < ahead_rad;
    });
}

/// True if a sonar hears something before the robot that is not the ground.
bool hearsSomething(const Senses& senses, double bearing_rad) {
    return std::ranges::any_of(senses.sonars, [&](const SonarEcho& echo) {
        const double aside_rad = normalizedAngle(senses.base_in_map.yaw_rad + echo.bearing_rad - bearing_rad);
        return isNoGround(echo, senses) && std::abs(aside_rad) < ahead_rad;
    });
}

} // namespace

void Craft::perceive(const agent::Tick& tick, const SensorLayout& layout, bool airborne, agent::CommandPort& port) {
    settings = withinLimits(settings, layout);
    fastest_m_s_ = layout.maximum_speed_m_s;
    pilot_.limitSpeed(layout.maximum_speed_m_s);
    reader_.navigateByTruth(settings.navigate_by_truth);
    reader_.correctHeading(settings.correct_heading);
    reader_.correctLean(settings.hurried() || overhead.everHadCeiling());
    reader_.tellWind(pilot_.feelsWind());
    const bool aloft = senses.heightOverGround_m(1e9) > surely_aloft_m;
    reader_.tellCommand(aloft ? pilot_.wantedInBase_m_s() : Vec2::Zero(),
                        aloft && !ascending_ ? commanded_climb_m_s_ : 0.0);
    reader_.tellDrive(aloft ? std::optional<Vec2>(pilot_.told().velocity_m_s.head<2>()) : std::nullopt);
    senses = reader_.read(tick.now, tick.line, tick.robot, layout, Seconds(settings.sensor_timeout_s));
    const Vec3 measured_m_s =
        Eigen::AngleAxisd(-senses.base_in_map.yaw_rad, Vec3::UnitZ()) * senses.velocity_in_map_m_s;
    if (airborne)
        link_.ask(tick.now, port);
    const bool was_late = link_.late() > Seconds{0.0};
    link_.note(senses.now, pilot_.told(), {measured_m_s, senses.yaw_rate_rad_s},
               senses.heightOverGround_m(1e9) > surely_aloft_m);
    senses.late = link_.late();
    if (!was_late && senses.late > Seconds{0.0})
        overhead.forgetTouches();
    crash_ = nullptr;
    if (airborne) {
        crash_ = crash_watch_.update(senses, {pilot_.wantedInBase_m_s().norm(), commanded_climb_m_s_});
        overhead.observe(senses, {commanded_climb_m_s_, std::exchange(ascending_, false)});
        if (overhead.found()) { // What was seen of this ceiling before was taken for walls.
            memory.clear();
            atlas_.clear();
            ways.map().clear();
        }
        const double below_m = overhead.ceiling_m(senses.position2_m()).value_or(1e9) - below_ceiling_m;
        const bool open_sky = !overhead.hasCeiling() && overhead.seenTo_m() > senses.position_m().z() + open_sky_m;
        memory.take(senses, {Seconds(settings.scan_memory_s), Seconds(settings.sonar_memory_s), below_m,
                             settings.hurried() || open_sky, overhead.hasCeiling()});
        for (const SonarEcho& glimpse : senses.glimpses)
            if (isNoGround(glimpse, senses))
                memory.touch({glimpse.center_in_map_m.x(), glimpse.center_in_map_m.y(),
                              senses.position_m().z() + glimpse_above_m});
        if (settings.hurried())
            atlas_.take(senses, below_m);
        ways.take(senses, below_m, senses.heightOverGround_m(1e9) > sure_of_walls_m, overhead.hasCeiling());
        refuge.note(senses, memory, dry_m());
        battery.moveTo(senses.position_m());
    }
    ways.map().passOver(passesBelow_m());
    obstacles_ = memory.near(senses.position2_m(), look_around_m, senses.position_m().z() - passesBelow_m());
    if (airborne)
        way_back_.note(senses.now, senses.position2_m(), nearest_m(obstacles_, senses.position2_m(), look_around_m));
    if (way_back_.active())
        obstacles_.clear(); // It has been there, so they are not in its way.
    else if (mayClimb() && std::exchange(plans_after_way_back_, false))
        climb_over_.start(senses, obstacles_, settings, retreat());
    threats = judgeThreats(senses, ways.forThreats(settings));
    port.publish(agent::SonarZones{threats.zones});
    scanned = log.tick(senses, airborne, settings, port);
}

double Craft::dry_m() const {
    return dryLevel_m(settings);
}

double Craft::speedToward_m_s(const Vec2& place_m) const {
    const double fastest_m_s = pilot_.fastestAlong_m_s(bearingOf(place_m - senses.position2_m()));
    return std::clamp(fastest_m_s, slowest_in_wind_m_s, settings.transit_speed_m_s) * senses.steadyShare();
}

void Craft::look(const Leg& leg) {
    noteGoal(leg);
    detour_aim_m_ = way_back_.active() ? way_back_.aim_m()
                    : detour_.active() ? detour_.aim_m(ways.map(), senses)
                                       : leg.aim_m;
    ways.squeeze(detour_.isNarrow());
    const double way_rad = bearingOf(detour_aim_m_ - senses.position2_m()) - senses.base_in_map.yaw_rad;
    if ((way_back_.active() || ways.isNarrow()) && isWayClear(threats, way_rad))
        threats = noThreats(std::move(threats));
    evasion_.observe(senses, threats, detour_aim_m_, settings);
    decision_.reset();
}

const EvasionDecision& Craft::decide(agent::CommandPort& port) {
    if (!decision_) {
        decision_ = evasion_.decide(senses, threats, obstacles_, settings, retreat());
        log.risks(senses, *decision_, port);
    }
    return *decision_;
}

Retreat Craft::retreat() const {
    return {[this](const Vec2& at_m) { return ways.map().wasFlown(at_m); }, overhead.hasCeiling()};
}

FlightState Craft::fly(const Leg& leg, agent::CommandPort& port) {
    look(leg);
    const EvasionMode mode = decide(port).mode;
    Maneuver maneuver = mode == EvasionMode::None ? Maneuver::Cruise : Maneuver::Avoid;
    if (mode != EvasionMode::Flee && climbingOver())
        maneuver = Maneuver::ClimbOver;
    const FlightState state = perform(maneuver, leg, port);
    return stuck() ? FlightState::Unreachable : state;
}

FlightState Craft::perform(Maneuver maneuver, const Leg& asked, agent::CommandPort& port) {
    FlightState state = FlightState::Flying;
    Leg leg = asked;
    if (detour_.active() || way_back_.active()) {
        leg.aim_m = detour_aim_m_;
        const bool among_things = nearest_m(obstacles_, senses.position2_m(), among_m) < among_m;
        leg.speed_m_s = std::min(leg.speed_m_s, way_back_.active() || among_things ? Ways::door_m_s : detour_m_s);
    }
    if (ways.isNarrow())
        leg.speed_m_s = std::min(leg.speed_m_s, Ways::door_m_s);
    log.goal(Vec3(leg.goal_m.x(), leg.goal_m.y(), senses.position_m().z()), port);
    climb_over_.feel(senses, log.lean().slope(senses.base_in_map.yaw_rad), commanded_climb_m_s_, settings);
    if (climb_over_.sinks()) // It would press against what its ring has met as it flees from the echo of that.
        maneuver = Maneuver::ClimbOver;
    Motion motion = maneuver == Maneuver::Avoid       ? evade(decide(port), leg, state)
                    : maneuver == Maneuver::ClimbOver ? climbOver(leg, state)
                                                      : cruise(leg, state);
    const bool hindered = state != FlightState::Flying || blocked_;
    if (!mayClimb())
        ways.noteProgress(senses.now, senses.position2_m());
    if (detour_.active())
        stuck_.wait(senses.now); // A detour has a time limit of its own.
    else
        stuck_.update(senses.now, senses.position2_m(), leg.goal_m, hindered);
    findWay(leg, hindered);
    const double wanted_m_s = motion.velocity_in_map_m_s.norm();
    makeSafe(motion);
    // Steering counts on the robot to climb on its way; where it stands instead, it must look for another way.
    blocked_ = wanted_m_s > stands_m_s && motion.velocity_in_map_m_s.norm() < stands_m_s;
    // What made it climb over something may make it climb on, such as a wall that reaches a roof. So may a wall alone.
    climbs_on_ = climbs_on_ && motion.climb_m_s > 0.0;
    const bool again = climbed_at_ && senses.position_m().z() > climbed_at_->z() + over_again_m;
    const bool maybe_roofed =
        climb_over_.active() || climbs_on_ || again || overhead.hasCeiling() || overhead.besideWall(senses.now);
    const bool straight_up = motion.velocity_in_map_m_s.norm() < straight_m_s;
    const double z_m = senses.position_m().z();
    const bool unseen = z_m > overhead.freeTo_m();
    const bool unseen_sky = z_m > overhead.seenTo_m();
    double most_m_s = motion.climb_m_s;
    if ((maybe_roofed && unseen) || column_.mayMeetAgain(senses.position_m()))
        most_m_s = Overhead::gentle_m_s;
    else if (straight_up)
        most_m_s = unseen_sky ? Overhead::careful_m_s : std::min(most_m_s, seen_sky_m_s);
    const bool hears_nothing_level = senses.base_in_map.pitch_rad > looks_down_rad;
    if (motion.climb_m_s > rising_m_s && !straight_up && hears_nothing_level) {
        most_m_s = std::min(most_m_s, Overhead::careful_m_s);
        motion.velocity_in_map_m_s *= std::min(1.0, blind_m_s / motion.velocity_in_map_m_s.norm());
    }
    motion.climb_m_s = overhead.allowed_m_s(senses, motion.climb_m_s, most_m_s);
    const double speed_m_s = motion.velocity_in_map_m_s.norm();
    if (motion.climb_m_s > 0.0 && speed_m_s > below_roof_m_s && mayTouchRoof(senses, overhead))
        motion.velocity_in_map_m_s *= below_roof_m_s / speed_m_s;
    command(calmed(motion, senses, settings), port, leg.source);
    return state;
}

void Craft::goUnder(const Vec2& place_m) {
    ways.goUnder(place_m, overhead);
    memory.clear();
    startAnew();
}

void Craft::comeUp() {
    ways.comeUp(overhead);
    memory.clear();
    column_ = {};
    ascent_ = Ascent::beyondDoor();
    startAnew();
}

Motion Craft::evade(const EvasionDecision& decision, const Leg& leg, FlightState& state) {
    state = FlightState::Evading;
    const Vec2 here_m = senses.position2_m();
    if (decision.mode == EvasionMode::Flee) {
        const Vec2 away(std::cos(decision.flee_bearing_rad), std::sin(decision.flee_bearing_rad));
        const double turned_rad = std::abs(normalizedAngle(decision.flee_bearing_rad - senses.base_in_map.yaw_rad));
        const bool backs_away = senses.velocity_in_map_m_s.head<2>().dot(away) > backs_m_s;
        const double speed_m_s = ways.isNarrow() || (turned_rad > heard_rad && backs_away)
                                     ? std::min(settings.evasion_speed_m_s, Overhead::careful_m_s)
                                     : settings.evasion_speed_m_s;
        return {.velocity_in_map_m_s = speed_m_s * away, .sudden = decision.sudden};
    }
    if (decision.mode == EvasionMode::Divert && (decision.diversion_m - here_m).norm() > hold_still_m)
        return toward(senses, bearingOf(decision.diversion_m - here_m), settings.evasion_speed_m_s, settings);
    Motion motion = holding(senses, here_m);
    motion.yaw_rate_rad_s = turnRate_rad_s(senses, bearingOf(leg.aim_m - here_m), settings);
    return motion;
}

Motion Craft::cruise(const Leg& leg, FlightState& state) {
    const Vec2 here_m = senses.position2_m();
    const double level_m = senses.position_m().z() - passesBelow_m();
    const double half_width_m = ways.isNarrow() ? std::min(Ways::door_half_width_m, settings.side_clearance_m / 2.0)
                                                : settings.side_clearance_m / 2.0;
    const double straight_m = (leg.end_m.value_or(leg.goal_m) - here_m).norm();
    const auto bearing = steering_.choose(obstacles_, here_m, leg.aim_m, level_m, {half_width_m, 3.5});
    if (!bearing) {
        state = FlightState::Evading;
        Motion motion = holding(senses, here_m);
        motion.yaw_rate_rad_s = turnRate_rad_s(senses, bearingOf(leg.aim_m - here_m), settings);
        motion.climb_m_s = climbRate({here_m, bearingOf(leg.aim_m - here_m), 0.0, straight_m});
        return motion;
    }
    const double distance_m = (leg.aim_m - here_m).norm();
    const bool fast = leg.speed_m_s > Settings::unhurried_m_s;
    const bool crowded = fast && nearsSomething(obstacles_, here_m, *bearing);
    const double most_m_s = crowded ? std::min(leg.speed_m_s, crowded_m_s) : leg.speed_m_s;
    const double stops_m_s =
        stoppingSpeed_m_s(distance_m, settings.braking_m_s2 / 2.0, (reaction + senses.late).count());
    const double speed_m_s = std::min(most_m_s, 0.2 + stops_m_s);
    const Corner corner = fast && !crowded ? Corner::Round : Corner::Sharp;
    Motion motion = toward(senses, *bearing, speed_m_s, settings, corner);
    motion.climb_m_s = climbRate({here_m, *bearing, motion.velocity_in_map_m_s.norm(), straight_m});
    if (motion.climb_m_s > rising_m_s && (crowded || hearsSomething(senses, *bearing)))
        motion.velocity_in_map_m_s *= rising_speed_m_s / std::max(speed_m_s, rising_speed_m_s);
    if (!climb_forbidden_)
        return motion;
    state = FlightState::Evading; // Waits until it backs away and climbs where there is room
    Motion waiting = holding(senses, here_m);
    waiting.yaw_rate_rad_s = motion.yaw_rate_rad_s;
    return waiting;
}

Motion Craft::climbOver(const Leg& leg, FlightState& state) {
    state = FlightState::ClimbingOver;
    const ClimbStep step =
        climb_over_.step(senses, threats, obstacles_, leg.aim_m, overhead.limit_m(senses.position2_m()), settings);
    Motion motion = holding(senses, step.place_m);
    if (step.state == ClimbState::Over) {
        climbed_at_ = senses.position_m();
        climbs_on_ = true;
        stuck_.clearHindered();
    }
    // A wall that reaches the ceiling does not end lower down. The robot stays up here, where it sees over all that it
    // can pass, and looks for ways.
    if (step.state == ClimbState::Failed && overhead.hasCeiling())
        climbed_at_ = senses.position_m();
    motion.climb_m_s = step.climb_m_s;
    if (step.state == ClimbState::Climbing)
        motion.yaw_rate_rad_s = turnRate_rad_s(senses, bearingOf(leg.aim_m - senses.position2_m()), settings);
    return motion;
}

std::optional<double> Craft::heldHeight_m() {
    if (climbed_at_ && (senses.position2_m() - climbed_at_->head<2>()).norm() > over_way_m)
        climbed_at_.reset();
    if (canopy_at_ && (senses.position2_m() - canopy_at_->head<2>()).norm() > canopy_way_m)
        canopy_at_.reset();
    std::optional<double> held_m = climbed_at_ ? std::optional(climbed_at_->z()) : std::nullopt;
    if (canopy_at_)
        held_m = std::max(held_m.value_or(canopy_at_->z()), canopy_at_->z());
    return held_m;
}

void Craft::expectCanopy() {
    canopy_at_.reset();
    const Vec3 here_m = senses.position_m();
    const auto top_m = memory.highest_m(here_m.head<2>(), canopy_seen_m);
    const bool first = !std::exchange(has_flown_, true);
    if (first && settings.hurried() && !overhead.hasCeiling() && top_m && *top_m > here_m.z())
        canopy_at_ = Vec3(here_m.x(), here_m.y(), *top_m + settings.clearance_m);
}

double Craft::climbRate(const WayAhead& way) {
    Settings higher = settings; // Things seen some time ago are higher now by the drift.
    higher.clearance_m += std::clamp(memory.risen_m(), 0.0, most_drift_m);
    double wanted_m = altitudeGoal_m(senses, memory, way.bearing_rad, way.speed_m_s, heldHeight_m(), higher);
    double needed_m = wanted_m; // at once
    bool known = false;
    if (settings.hurried() && !overhead.hasCeiling()) {
        const auto ahead_m = memory.highestAlong_m(way.from_m, way.bearing_rad, soon_half_width_m, soon_m);
        needed_m = ahead_m ? *ahead_m + higher.clearance_m : senses.position_m().z();
        wanted_m = std::max(wanted_m, drapedHeight_m(atlas_, way, higher).value_or(wanted_m));
        known = maySinkFast(atlas_, way, senses.heightOverGround_m(1e9));
    }
    if (way.speed_m_s > straight_m_s && !overhead.hasCeiling())
        wanted_m = aboveWires_m(senses, memory, wanted_m);
    const double goal_m = std::min(wanted_m, overhead.limit_m(way.from_m));
    const double rate_m_s =
        altitude_.climbRate_m_s(senses, memory, goal_m, way.bearing_rad, way.speed_m_s, settings, known);
    if (way_back_.active()) { // It has been there at this height, and does not know what is above.
        climb_forbidden_ = false;
        return std::min(rate_m_s, 0.0);
    }
    const bool overhang = rate_m_s > 0.0 && besideOverhang();
    climb_forbidden_ = overhang && std::min(needed_m, goal_m) - senses.position_m().z() > bearable_deficit_m;
    return overhang ? 0.0 : rate_m_s;
}

bool Craft::besideOverhang() const {
    const double level_m = senses.position_m().z() - trunk_margin_m;
    return std::ranges::any_of(obstacles_, [&](const Obstacle& obstacle) {
        return obstacle.top_m > level_m && (obstacle.at_m - senses.position2_m()).norm() < settings.climb_standoff_m;
    });
}

void Craft::makeSafe(Motion& motion) const {
    const double speed_m_s = motion.velocity_in_map_m_s.norm();
    if (speed_m_s < 1e-3)
        return;
    const double bearing_rad = std::atan2(motion.velocity_in_map_m_s.y(), motion.velocity_in_map_m_s.x());
    const double free_m = clearance_m(obstacles_, senses.position2_m(), bearing_rad, path_half_width_m, look_around_m) -
                          settings.safety_margin_m;
    const double safe_m_s = stoppingSpeed_m_s(free_m, settings.braking_m_s2, (reaction + senses.late).count());
    if (safe_m_s < speed_m_s)
        motion.velocity_in_map_m_s *= safe_m_s / speed_m_s;
}

void Craft::hover(const Vec2& place_m, agent::CommandPort& port, const std::string& source) {
    Motion motion = holding(senses, place_m);
    makeSafe(motion);
    stuck_.wait(senses.now);
    command(calmed(motion, senses, settings), port, source);
}

void Craft::leave(bool airborne, agent::CommandPort& port) {
    if (airborne && !crash_)
        port.send(still(), "finished");
    else
        rest(port, "finished");
}

void Craft::rest(agent::CommandPort& port, const std::string& source) {
    stuck_.wait(senses.now);
    commanded_climb_m_s_ = 0.0;
    pilot_.stop(port, source);
}

void Craft::forgetPlaces() {
    memory.clear();
    atlas_.endFlight();
    ways.startAnew(senses.position_m().z());
    refuge = {};
    way_back_ = {};
    plans_after_way_back_ = false;
    canopy_at_.reset();
    overhead.forgetPlaces();
    ascent_ = Ascent(std::exchange(column_, {}).come_down_m);
    crash_watch_ = {};
    reader_.forgetMotion();
    battery.forgetPosition();
    log.forgetPath();
    startAnew();
}

void Craft::startAnew() {
    overhead.takeForSmall(false, senses.position_m().z() - surely_above_m);
    evasion_.reset();
    steering_.reset();
    stuck_.reset();
    climb_over_.reset();
    climbed_at_.reset();
    detour_.end();
    no_way_before_ = std::exchange(no_way_, false) || no_way_before_;
    goal_m_.reset();
}

} // namespace usar::airrobot
