#include "robots/submarine/diver.h"

#include <algorithm>
#include <cmath>

#include "core/base/numbers.h"
#include "core/base/text.h"

namespace usar::submarine {

namespace {

constexpr double no_echo_share = 0.99;    ///< a range above this share of the reach is not an echo
constexpr double steepest_rise_m_s = 1.0; ///< greatest rate of rise of the bottom; faster changes are cliffs
constexpr Seconds smoothed_over{1.5};
/// If the robot is below its height for this long, it is in shallows.
constexpr Seconds in_the_shallows{15.0};
/// If the robot is above its height for this long without coming down by `comes_down_m`, its hull does not follow the
/// planes. This happens at the surface, where the stern would have to leave the water.
constexpr Seconds in_vain{20.0};
constexpr double comes_down_m = 0.5;
constexpr double stands_m_s = 0.03;
constexpr double astern_m_s = -0.1;
constexpr double usual_speed_m_s = 1.28;
constexpr double braking_pitch_rad = radians(8.0);   ///< at a steeper pitch the planes would push the hull down
constexpr double backing_pitch_rad = radians(-5.0);  ///< a hull that moves backward with its nose down rises
constexpr double returning_pitch_rad = radians(8.0); ///< nose up, because the bottom may be higher on the way back
constexpr double steers_at_rad = 0.3;                ///< course error at which the rudder is hard over
constexpr double arrived_m = 8.0;
constexpr double longest_way_back = 3.0; ///< multiple of the distance after which the way back is given up

} // namespace

void Diver::perceive(const agent::Tick& tick, const std::optional<Limits>& limits) {
    if (!run_.began)
        heard_at_ = tick.now;
    const Seconds dt = run_.step(tick.now);
    limits_ = limits;
    reckon(dt, tick.robot.state);
    takeReadings();
    if (!limits_)
        return;
    watchRay();
    watchSearch(dt);
    if (const Seconds whole(settings_.dive_time_s); run_.isOver(whole))
        run_.ending = {true, "Dived for " + fixed(whole.count(), 0) + " s, about " + fixed(way_m_, 0) + " m."};
    watchLevel();
    stepManeuver();
}

void Diver::reckon(Seconds dt, const modules::StateModule& state) {
    double rudder_rad = 0.0;
    if (state.latest()) {
        for (const protocol::JointAngle& fin : state.latest()->joints) {
            if (sameWord(fin.name, "SternPlaneAngle"))
                plane_now_rad_ = fin.angle_rad;
            else if (sameWord(fin.name, "RudderAngle"))
                rudder_rad = fin.angle_rad;
        }
    }
    hull_.step(dt, propeller_share_, plane_now_rad_);
    const double step_m = hull_.speed_m_s() * dt.count();
    way_m_ += std::abs(step_m);
    trail_.step(step_m, rudder_rad / limits_.value_or(Limits{}).rudder_rad);
}

void Diver::takeReadings() {
    for (const auto& reading : readings_.takeAll<protocol::RangeReadings>()) {
        const double range_m = reading.value.range_m;
        if (!(range_m > 0.0)) // Also skips NaN
            continue;
        const double pitch_rad = hull_.pitch_rad();
        const double reach_m = limits_ ? limits_->ray_reach_m : Limits{}.ray_reach_m;
        echoes_.last_m = echoes_.present_m;
        echoes_.present_m = range_m < no_echo_share * reach_m ? std::optional(range_m) : std::nullopt;
        echoes_.apart = reading.time - reading_at_;
        heights_ = settings_.knows_slant ? plumb(echoes_, pitch_at_echo_rad_, pitch_rad) : echoes_;
        pitch_at_echo_rad_ = pitch_rad;
        reckonBottom();
        reading_at_ = reading.time;
        heard_at_ = run_.now;
    }
}

/// Estimates the rise of the bottom: the robot's own climb minus the change of its height over the bottom.
void Diver::reckonBottom() {
    if (!heights_.last_m || !heights_.present_m)
        return;
    rise_now_m_s_ = std::clamp(hull_.climb_m_s() - heights_.climb_m_s(), -steepest_rise_m_s, steepest_rise_m_s);
    const double share = std::min(1.0, heights_.apart / smoothed_over);
    bottom_rise_m_s_ = std::lerp(bottom_rise_m_s_, rise_now_m_s_, share);
}

void Diver::watchRay() {
    if (blind() && !blind_told_)
        events_.push_back({Severity::Warning, "The ray on the belly is silent; the robot waits until it speaks."});
    blind_told_ = blind();
}

/// Ends the behavior if there has been no echo for too long a descent; the sea may extend beyond the modeled world.
void Diver::watchSearch(Seconds dt) {
    const double sink_m = -hull_.climb_m_s() * dt.count();
    searched_m_ = echoes_.present_m ? 0.0 : searched_m_ + sink_m;
    if (searched_m_ > settings_.deepest_search_m && !run_.ending)
        run_.ending = {false, "There is no bottom within " + fixed(settings_.deepest_search_m, 0) + " m."};
}

/// Measures how long the robot has been too low, and how long too high without coming down. Remembers the places where
/// it could follow the bottom.
void Diver::watchLevel() {
    const Level level = levelOf(heights_, settings_);
    if (level != Level::Ascend)
        below_since_ = run_.now;
    if (level != Level::Ascend && heights_.present_m && maneuver_ == Maneuver::None)
        trail_.keepPlace();
    const bool falls_off = heights_.climb_m_s() > steepest_rise_m_s;
    const bool comes_down = heights_.present_m && *heights_.present_m < came_down_to_m_ - comes_down_m;
    if (run_.paused || blind())
        below_since_ = run_.now;
    else if (level == Level::Descend && heights_.present_m && !falls_off && !comes_down)
        return;
    above_since_ = run_.now;
    came_down_to_m_ = heights_.present_m.value_or(unknown_m);
}

bool Diver::divesInVain() const {
    return settings_.knows_slant && run_.now - above_since_ > in_vain;
}

/// Returns whether the bottom is too near. Looks less far ahead when the robot is slow, forward or backward, because it
/// then stops sooner.
bool Diver::inDanger() const {
    if (!settings_.knows_slant)
        return tooNear(heights_, 0.0, Seconds{0.0}, settings_);
    const double share = std::clamp(std::abs(hull_.speed_m_s()) / usual_speed_m_s, 0.0, 1.0);
    return tooNear(heights_, rise_now_m_s_, share * Seconds(settings_.foresight_s), settings_);
}

void Diver::begin(Maneuver maneuver) {
    maneuver_ = maneuver;
    below_since_ = above_since_ = run_.now;
    maneuver_began_m_ = way_m_;
}

/// Begins to return to a place where the robot could follow the bottom. If there is none, it just continues, as the
/// thesis's robot always does.
void Diver::beginGoingBack() {
    back_to_m_ = settings_.knows_slant ? trail_.placeBehind(settings_.way_back_m) : std::nullopt;
    begin(back_to_m_ ? Maneuver::GoingBack : Maneuver::None);
}

/// Begins and ends maneuvers. If the bottom is too near, the robot first backs off and then goes back. It also goes
/// back from shallows and where the bottom falls out of reach.
void Diver::stepManeuver() {
    const double way_m = way_m_ - maneuver_began_m_;
    const bool astern = hull_.speed_m_s() < astern_m_s;
    const bool lost = echoes_.last_m && !echoes_.present_m;
    const bool shallow = run_.now - below_since_ > in_the_shallows;
    if (maneuver_ == Maneuver::BackingOff) {
        if (way_m > settings_.back_off_m || (astern && inDanger()))
            beginGoingBack();
    } else if (!astern && inDanger()) {
        begin(Maneuver::BackingOff);
    } else if (maneuver_ == Maneuver::GoingBack) {
        if (trail_.distanceTo_m(*back_to_m_) < arrived_m || way_m > longest_way_back * settings_.way_back_m)
            begin(Maneuver::None);
    } else if (settings_.knows_slant && (lost || shallow)) {
        beginGoingBack();
    }
}

/// Returns the side to turn to: 1 for right, -1 for left. It alternates, so that the robot does not move in a circle.
double Diver::side() const {
    const double turns = run_.elapsed().count() / settings_.change_side_s;
    return static_cast<long long>(turns) % 2 == 0 ? 1.0 : -1.0;
}

double Diver::plane_rad() const {
    if (!settings_.knows_slant)
        return plumbPlane_rad(heights_, settings_, plane_now_rad_, limits_->stern_plane_rad);
    if (divesInVain())
        return -limits_->stern_plane_rad;
    return hull_.planeFor_rad(wantedPitch_rad(heights_, bottom_rise_m_s_, hull_.speed_m_s(), settings_));
}

protocol::NauticDrive Diver::decide() {
    if (!limits_)
        return halt("asking for its configuration");
    if (run_.paused)
        return halt("paused");
    if (blind())
        return halt("waiting for the ray");
    if (maneuver_ == Maneuver::BackingOff)
        return backOff();
    if (maneuver_ == Maneuver::GoingBack)
        return goBack();
    return keepLevel();
}

protocol::NauticDrive Diver::keepLevel() {
    const Level level = levelOf(heights_, settings_);
    if (level == Level::Keep)
        return drive(1.0, side(), plane_rad(), side() > 0.0 ? "level, turning right" : "level, turning left");
    if (level == Level::Ascend)
        return drive(1.0, 0.0, plane_rad(), "ascending");
    return drive(divesInVain() ? 100.0 / settings_.propeller_pct : 1.0, 0.0, plane_rad(),
                 heights_.present_m ? "descending" : "looking for the bottom");
}

/// Brakes with the nose up until the robot stands, then moves backward over the ground that it has crossed.
protocol::NauticDrive Diver::backOff() {
    if (!settings_.knows_slant)
        return drive(-1.0, 0.0, 0.0, "backing off");
    const double full_astern = -100.0 / settings_.propeller_pct;
    const double pitch_rad = hull_.speed_m_s() > 0.0 ? braking_pitch_rad : backing_pitch_rad;
    return drive(full_astern, 0.0, hull_.planeFor_rad(pitch_rad), "backing off");
}

/// Steers to the destination of the way back; rises if the bottom is out of reach.
protocol::NauticDrive Diver::goBack() {
    const double plane_rad = hull_.planeFor_rad(returning_pitch_rad);
    const double right = std::clamp(-trail_.bearingOf_rad(*back_to_m_) / steers_at_rad, -1.0, 1.0);
    const double rudder = hull_.speed_m_s() < 0.0 ? -right : right; // The rudder works the other way backward
    return drive(1.0, rudder, echoes_.present_m ? this->plane_rad() : plane_rad, "going back");
}

/// Brakes with the propeller, because the hull would otherwise glide on for twenty meters.
protocol::NauticDrive Diver::halt(const char* state) {
    const double brake =
        std::abs(hull_.speed_m_s()) < stands_m_s ? 0.0 : std::clamp(-4.0 * hull_.speed_m_s(), -1.0, 1.0);
    return drive(brake, 0.0, 0.0, state);
}

protocol::NauticDrive Diver::drive(double share, double rudder_share, double plane_rad, const char* state) {
    const Limits limits = limits_.value_or(Limits{});
    run_.state = state;
    propeller_share_ = share * settings_.propeller_pct / 100.0;
    return {.propeller_rad_s = propeller_share_ * limits.propeller_rad_s,
            .rudder_rad = rudder_share * limits.rudder_rad,
            .stern_plane_rad = std::clamp(plane_rad, -limits.stern_plane_rad, limits.stern_plane_rad)};
}

agent::BehaviorStatus Diver::status() const {
    agent::BehaviorStatus status = run_.status(Seconds(settings_.dive_time_s), way_m_);
    if (heights_.present_m && limits_)
        status.state += ", " + fixed(*heights_.present_m, 1) + " m over the bottom";
    return status;
}

} // namespace usar::submarine
