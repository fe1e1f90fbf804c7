// A P2DX that explores: what it knows and what it can do. Both deciders, the coded one and the plan, work on it.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/agent/robot_plugin.h"
#include "core/agent/timed_run.h"
#include "robots/p2dx/surroundings.h"
#include "robots/p2dx/track.h"

namespace usar::p2dx {

/// Senses say what is, acts give the DRIVE of a tick; `perceive` comes once before them. The robot roams until it is in
/// danger; then it backs away as far as it knows the ground behind it, turns from the nearer side until the way is
/// free, and goes straight on for a moment. Owned by one behavior.
///
/// A scanner that repeats itself while the robot moves is frozen, and the robot stands. One that froze where nothing
/// was in its reach cannot be told from one that looks over an empty plain: beams that return nothing have no noise,
/// and a long way without an echo is what a plain is like. Low things make the sonars hear what no scan shows, so they
/// are no proof either. There the sonars alone turn it back from what is ahead, and it may touch what is beside it.
class Explorer {
public:
    explicit Explorer(agent::BehaviorContext context);

    /// The thesis's listener: it keeps scan, echoes and INS itself, without the modules.
    void hear(const protocol::InfoLine& line);
    void perceive(const agent::Tick& tick);

    // Senses.
    Seconds scanAge() const; ///< huge before the first scan, and while the scanner is frozen
    /// A person asked it to, or it has not rested long enough to start.
    bool waiting() const;
    /// Something is too close ahead, or the ground too steep, or the robot is still backing away from that.
    bool inDanger() const;
    bool trapped() const;
    bool mustTurn() const { return maneuver_ == Maneuver::Turning; }
    /// The third to head for; another takes its place only by a clear lead.
    Third open() const;

    // Acts.
    protocol::SkidDrive halt();
    protocol::SkidDrive reverse();
    protocol::SkidDrive turnAway();
    protocol::SkidDrive goAhead();
    protocol::SkidDrive steerLeft();
    protocol::SkidDrive steerRight();
    /// Begins to turn around, the second time in the same place after backing away; gives no DRIVE.
    void escape();

    /// True: it sees to the order.
    bool order(agent::Order order) { return run_.order(order); }
    void setParameters(const agent::ParameterSet& parameters) { settings_ = settingsFrom(parameters); }
    const std::string& state() const { return run_.state; }
    agent::BehaviorStatus status() const;
    agent::PoseEstimate pose() const { return {run_.now, track_.base_in_map()}; }
    const std::optional<agent::BehaviorFinished>& ending() const { return run_.ending; }
    std::vector<agent::BehaviorEvent> takeEvents() { return std::exchange(events_, {}); }

private:
    enum class Maneuver { None, Backing, Turning };

    void takeReadings();
    void watchForIce();
    void chooseThird();
    void watchScanner();
    void watchClock();
    void stepManeuver(Seconds dt);
    void stepTurn();
    bool blind() const;
    bool frozen() const;
    bool tooClose() const;
    bool wayIsFree() const;
    void backAway();
    void beginBacking(double distance_m);
    void beginTurn(double angle_rad);
    double roamingSpeed_m_s() const;
    double innerShare(double side_m) const;
    protocol::SkidDrive drive(double left_m_s, double right_m_s, Motion motion, const char* state);

    agent::TimedRun run_;
    Settings settings_;
    Rectangle area_in_map_;

    std::optional<protocol::RangeScan> scan_;
    std::vector<protocol::NamedRange> sonars_;
    std::optional<Pose> ins_in_map_;
    bool scan_is_new_ = false;
    std::vector<double> former_ranges_m_; ///< of the scan before
    double moved_with_same_scan_m_ = 0.0; ///< way, and the turns of a hull's rim

    std::optional<Seconds> scan_at_;
    Surroundings around_;
    Track track_;
    Third chosen_ = Third::Ahead;

    Maneuver maneuver_ = Maneuver::None;
    Seconds maneuver_time_{0.0};
    double to_back_m_ = 0.0;
    double backed_m_ = 0.0;
    double to_turn_rad_ = 0.0;
    double turned_rad_ = 0.0;
    bool turns_left_ = false;
    double side_kept_until_m_ = 0.0; ///< of the way; until then all turns go to the same side
    Seconds straight_until_{0.0};
    Vec2 escaped_from_m_ = Vec2::Constant(1e9);

    Motion motion_ = Motion::Standing;
    bool blind_told_ = false;
    std::vector<agent::BehaviorEvent> events_;
};

/// Older scans are no guide: the robot stops.
inline constexpr Seconds blind_after{2.0};

} // namespace usar::p2dx
