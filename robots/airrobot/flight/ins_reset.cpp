#include "robots/airrobot/flight/ins_reset.h"

#include "core/base/text.h"

namespace usar::airrobot {

namespace {

constexpr Seconds answer_time{2.0};
constexpr double same_place_m = 0.05;
constexpr Seconds longest_unrest{60.0}; ///< A rest that has begun by then is waited for.

} // namespace

void InsReset::start(Seconds now) {
    state_ = ResetState::Resting;
    begun_ = since_ = now;
    rest_pose_.reset();
    attempts_ = 0;
}

ResetState InsReset::step(Seconds now, modules::RobotModules& robot, agent::CommandPort& port,
                          const Settings& settings) {
    const auto* truth = robot.sensors.groundTruth();
    if (state_ == ResetState::Resting) {
        const bool moved =
            truth && rest_pose_ && (truth->value.base_in_map.position_m - rest_pose_->position_m).norm() > same_place_m;
        if (truth && (!rest_pose_ || moved)) {
            rest_pose_ = truth->value.base_in_map;
            since_ = now;
        }
        const bool restless = moved && now - begun_ > longest_unrest;
        if (!restless && now - since_ < Seconds(settings.rest_time_s))
            return state_;
        if (restless || !truth)
            return state_ = ResetState::Failed;
        robot.responses.takeAll();
        state_ = ResetState::Waiting;
        sent_ = now - answer_time;
    }
    if (state_ != ResetState::Waiting)
        return state_;
    if (attempts_ > 0 && confirmed(robot))
        return state_ = ResetState::Done;
    if (now - sent_ < answer_time)
        return state_;
    if (attempts_ >= settings.reset_attempts)
        return state_ = ResetState::Failed;
    const auto* ins = robot.sensors.ins();
    port.send(protocol::SetInsPose{ins ? protocol::Name::mended(ins->value.name) : "INS", truth->value.base_in_map},
              "resetting the INS");
    ++attempts_;
    sent_ = now;
    return state_;
}

bool InsReset::confirmed(modules::RobotModules& robot) const {
    for (const protocol::Response& response : robot.responses.takeAll())
        if (response.ok && sameWord(response.type, "INS"))
            return true;
    const auto* ins = robot.sensors.ins();
    const auto* truth = robot.sensors.groundTruth();
    return ins && truth && ins->time > sent_ &&
           (ins->value.base_in_map.position_m - truth->value.base_in_map.position_m).norm() < same_place_m / 2.0;
}

} // namespace usar::airrobot
