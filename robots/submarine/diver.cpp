#include "robots/submarine/diver.h"

#include <algorithm>
#include <cmath>

#include "core/base/numbers.h"
#include "core/base/text.h"

namespace usar::submarine {

namespace {

constexpr double no_echo_share = 0.99; ///< of the reach
/// So long below its height without rising to it, the robot is in the shallows and turns all the same.
constexpr Seconds in_the_shallows{15.0};
constexpr double steepest_rise_m_s = 1.0; ///< of the bottom; what changes faster is a cliff, and no rate to go by
constexpr Seconds smoothed_over{1.5};
constexpr Seconds another_coast{60.0};
constexpr Seconds soonest{3.0}; ///< a maneuver may end: the hull has to stop first
constexpr double stands_m_s = 0.03;
constexpr double usual_speed_m_s = 1.28;
constexpr double backing_pitch_rad = radians(-12.0); ///< with its nose down a hull that backs off rises
constexpr double turn_per_m = 0.15;                  ///< with the rudder hard over, ahead and astern
constexpr double half_circle_m = pi / turn_per_m;
constexpr double turn_back_m = 60.0;

} // namespace

Diver::Diver(agent::BehaviorContext context) : settings_(settingsFrom(context.parameters)) {}

void Diver::perceive(const agent::Tick& tick, const std::optional<Limits>& limits) {
    const Seconds dt = began_ ? tick.now - now_ : Seconds{0.0};
    now_ = tick.now;
    if (!began_) {
        began_ = heard_at_ = now_;
    }
    limits_ = limits;
    reckon(dt, tick.robot.state);
    takeReadings();
    if (!limits_)
        return;
    watchRay();
    watchSearch(dt);
    watchClock();
    stepManeuver();
}

void Diver::reckon(Seconds dt, const modules::StateModule& state) {
    if (state.latest())
        for (const protocol::JointAngle& fin : state.latest()->joints)
            if (sameWord(fin.name, "SternPlaneAngle"))
                plane_now_rad_ = fin.angle_rad;
    hull_.step(dt, propeller_share_, plane_now_rad_);
    const double step_m = std::abs(hull_.speed_m_s()) * dt.count();
    way_m_ += step_m;
    turned_rad_ += turn_per_m * step_m;
}

void Diver::takeReadings() {
    for (const auto& reading : readings_.takeAll<protocol::RangeReadings>()) {
        const double range_m = reading.value.range_m;
        if (!(range_m > 0.0)) // not a number
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
        heard_at_ = now_;
    }
}

/// What of the change of height is not the robot's own climb is the bottom's.
void Diver::reckonBottom() {
    if (!heights_.last_m || !heights_.present_m)
        return;
    const double climb_m_s = hull_.speed_m_s() * std::sin(hull_.pitch_rad());
    const double rise_m_s = std::clamp(climb_m_s - heights_.climb_m_s(), -steepest_rise_m_s, steepest_rise_m_s);
    const double share = std::min(1.0, heights_.apart / smoothed_over);
    bottom_rise_m_s_ = std::lerp(bottom_rise_m_s_, rise_m_s, share);
}

void Diver::watchRay() {
    if (blind() && !blind_told_)
        events_.push_back({Severity::Warning, "The ray on the belly is silent; the robot waits until it speaks."});
    blind_told_ = blind();
}

/// The world may end, and the sea go on.
void Diver::watchSearch(Seconds dt) {
    const double sink_m = -hull_.speed_m_s() * std::sin(hull_.pitch_rad()) * dt.count();
    searched_m_ = echoes_.present_m ? 0.0 : searched_m_ + sink_m;
    if (searched_m_ > settings_.deepest_search_m && !ending_)
        ending_ = {false, "There is no bottom within " + fixed(settings_.deepest_search_m, 0) + " m."};
}

void Diver::watchClock() {
    const Seconds whole(settings_.dive_time_s);
    if (whole > Seconds{0.0} && now_ - *began_ >= whole && !ending_)
        ending_ = {true, "Dived for " + fixed(whole.count(), 0) + " s, about " + fixed(way_m_, 0) + " m."};
}

bool Diver::inDanger() const {
    if (!settings_.knows_slant)
        return tooNear(heights_, settings_, Seconds{0.0});
    const double share = std::clamp(hull_.speed_m_s() / usual_speed_m_s, 0.0, 1.0); // what is slow stops sooner
    return tooNear(heights_, settings_, share * Seconds(settings_.foresight_s));
}

/// Behind it, too.
bool Diver::rising() const {
    return heights_.present_m && *heights_.present_m < 2.0 * settings_.least_height_m && heights_.climb_m_s() < 0.0;
}

void Diver::begin(Maneuver maneuver) {
    maneuver_ = maneuver;
    maneuver_began_ = now_;
    maneuver_began_m_ = way_m_;
}

/// What follows soon is still the same coast: turning to and fro there leads nowhere.
void Diver::beginBackingOff() {
    if (now_ - maneuver_began_ > another_coast)
        away_ = side();
    turned_rad_ = 0.0;
    begin(Maneuver::BackingOff);
}

void Diver::stepManeuver() {
    const Seconds lasts = now_ - maneuver_began_;
    const bool runs_aground = settings_.knows_slant && lasts > soonest && hull_.speed_m_s() < 0.0 && rising();
    if (maneuver_ == Maneuver::BackingOff && (lasts > Seconds(settings_.back_off_s) || runs_aground))
        begin(Maneuver::TurningAway);
    else if (maneuver_ == Maneuver::TurningAway && turned_rad_ > settings_.turn_away_rad)
        begin(Maneuver::None);
    const bool lost = echoes_.last_m && !echoes_.present_m;
    if (maneuver_ == Maneuver::None && lost && settings_.knows_slant)
        begin(Maneuver::TurningBack);
    if (maneuver_ == Maneuver::TurningBack && (echoes_.present_m || way_m_ - maneuver_began_m_ > turn_back_m))
        begin(Maneuver::None);
    const bool may_back = maneuver_ == Maneuver::TurningAway ? lasts > soonest : maneuver_ != Maneuver::BackingOff;
    if (may_back && inDanger())
        beginBackingOff();
    if (levelOf(heights_, settings_) != Level::Ascend)
        below_since_ = now_;
}

/// 1 is the right. It changes after a time, so that the robot does not go in a circle.
double Diver::side() const {
    const double turns = (now_ - *began_).count() / settings_.change_side_s;
    return static_cast<long long>(turns) % 2 == 0 ? 1.0 : -1.0;
}

double Diver::plane_rad() const {
    if (!settings_.knows_slant)
        return plumbPlane_rad(heights_, settings_, plane_now_rad_, limits_->stern_plane_rad);
    return hull_.planeFor_rad(wantedPitch_rad(heights_, bottom_rise_m_s_, hull_.speed_m_s(), settings_));
}

protocol::NauticDrive Diver::decide() {
    if (!limits_)
        return halt("asking for its configuration");
    if (paused_)
        return halt("paused");
    if (blind())
        return halt("waiting for the ray");
    if (maneuver_ == Maneuver::BackingOff)
        return backOff();
    if (maneuver_ == Maneuver::TurningAway)
        return drive(1.0, awayRudder(), plane_rad(), "turning away");
    if (maneuver_ == Maneuver::TurningBack)
        return turnBack();
    return keepLevel();
}

protocol::NauticDrive Diver::keepLevel() {
    const char* const turning = side() > 0.0 ? "turning right" : "turning left";
    if (now_ - below_since_ > in_the_shallows)
        return drive(1.0, side(), plane_rad(), std::string("in the shallows, ") + turning);
    switch (levelOf(heights_, settings_)) {
    case Level::Descend:
        return drive(1.0, 0.0, plane_rad(), heights_.present_m ? "descending" : "looking for the bottom");
    case Level::Ascend:
        return drive(1.0, 0.0, plane_rad(), "ascending");
    case Level::Keep:
        break;
    }
    return drive(1.0, side(), plane_rad(), std::string("level, ") + turning);
}

/// While the hull goes astern, the rudder turns it the other way.
double Diver::awayRudder() const {
    return hull_.speed_m_s() < 0.0 ? -away_ : away_;
}

protocol::NauticDrive Diver::backOff() {
    if (!settings_.knows_slant)
        return drive(-1.0, 0.0, 0.0, "backing off");
    const double full_astern = -100.0 / settings_.propeller_pct;
    return drive(full_astern, 0.0, hull_.planeFor_rad(backing_pitch_rad), "backing off");
}

/// Where the bottom falls out of reach, it stays as high as it is and goes back to where it was.
protocol::NauticDrive Diver::turnBack() {
    const bool around = way_m_ - maneuver_began_m_ > half_circle_m;
    return drive(1.0, around ? 0.0 : side(), hull_.planeFor_rad(0.0), "turning back to the bottom");
}

/// Left to itself the hull would glide on for twenty meters.
protocol::NauticDrive Diver::halt(const char* state) {
    const double brake =
        std::abs(hull_.speed_m_s()) < stands_m_s ? 0.0 : std::clamp(-4.0 * hull_.speed_m_s(), -1.0, 1.0);
    return drive(brake, 0.0, 0.0, state);
}

protocol::NauticDrive Diver::drive(double share, double rudder_share, double plane_rad, const std::string& state) {
    const Limits limits = limits_.value_or(Limits{});
    state_ = state;
    propeller_share_ = share * settings_.propeller_pct / 100.0;
    protocol::NauticDrive drive;
    drive.propeller_rad_s = propeller_share_ * limits.propeller_rad_s;
    drive.rudder_rad = rudder_share * limits.rudder_rad;
    drive.stern_plane_rad = std::clamp(plane_rad, -limits.stern_plane_rad, limits.stern_plane_rad);
    return drive;
}

void Diver::order(agent::Order order) {
    if (order == agent::Order::LandNow)
        ending_ = {false, "A person asked the robot to stop."};
    else
        paused_ = order == agent::Order::Pause;
}

agent::BehaviorStatus Diver::status() const {
    const Seconds whole(settings_.dive_time_s);
    agent::BehaviorStatus status;
    status.time = now_;
    status.elapsed = began_ ? now_ - *began_ : Seconds{0.0};
    status.state = state_;
    if (heights_.present_m && limits_)
        status.state += ", " + fixed(*heights_.present_m, 1) + " m over the bottom";
    status.distance_flown_m = way_m_;
    status.paused = paused_;
    if (whole > Seconds{0.0}) {
        status.progress_pct = std::min(100.0, 100.0 * (status.elapsed / whole));
        status.time_left = std::max(Seconds{0.0}, whole - status.elapsed);
    }
    return status;
}

} // namespace usar::submarine
