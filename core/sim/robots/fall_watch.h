// Counts how often a robot fell over.
#pragma once

namespace usar::sim {

/// A fall is a lean of more than 60 degrees; the next one counts only after the robot has stood upright again.
class FallWatch {
public:
    /// `up_z` is the z component of the base's z axis in the map frame.
    void step(double up_z) {
        if (!lies_ && up_z < lying_z) {
            lies_ = true;
            ++count_;
        } else if (lies_ && up_z > upright_z) {
            lies_ = false;
        }
    }
    int count() const { return count_; }

private:
    static constexpr double lying_z = 0.5;    ///< cosine of 60 degrees
    static constexpr double upright_z = 0.85; ///< cosine of 32 degrees

    bool lies_ = false;
    int count_ = 0;
};

} // namespace usar::sim
