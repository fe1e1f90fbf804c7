// A drive that steers its wheels like a car: all of them roll about one center.
#pragma once

#include "core/sim/drives/wheeled_drive.h"

namespace usar::sim {

/// The last of the model's drive joints are steered about the vertical, the others are driven. Further settings:
/// `steered`, the number of steered ones (default 2); `max_front_steer` and `max_rear_steer` (rad, default 0);
/// `wheel_base` (m), which is required. Commanded angles are those of a bicycle in the middle, and the commanded spin
/// is that of a wheel in the middle of the rear axle; inner and outer wheels get theirs from the common center.
class AckermannDrive : public WheeledDrive {
public:
    /// Fails if no joint is driven or none steered, or if there is no wheel base.
    static Result<std::unique_ptr<Drive>> make(const RobotModel& model, Physics& physics, BodyId body,
                                               const std::vector<std::size_t>& joints);

    bool obey(const protocol::Command& command) override;
    void addState(protocol::RobotState& state) const override;

private:
    AckermannDrive(const RobotModel& model, Physics& physics, BodyId body, const std::vector<std::size_t>& wheels,
                   const std::vector<std::size_t>& steered);

    struct Steered {
        std::size_t joint = 0;
        double sign = 1.0; ///< 1 if the axis points up, -1 if down
        bool front = true;
    };

    /// Mean steering angle of the front or rear wheels, counter-clockwise positive; 0 if there are none.
    double meanSteer_rad(bool front) const;
    /// Gives all wheels their angles and spins for the commanded values.
    void steer();

    std::vector<Steered> steered_;
    double front_x_m_ = 0.0; ///< positions of the axles in the base's frame
    double rear_x_m_ = 0.0;
    double spin_rad_s_ = 0.0; ///< as commanded, like the angles
    double front_rad_ = 0.0;
    double rear_rad_ = 0.0;
};

} // namespace usar::sim
