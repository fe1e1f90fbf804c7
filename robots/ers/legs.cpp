#include "robots/ers/legs.h"

#include <algorithm>

#include "core/agent/leg_kinematics.h"

namespace usar::ers {

namespace {

constexpr double spread_rad = 0.1; ///< outward angle of the legs, so that the robot does not tip over
constexpr double deepest_nod_rad = 0.25;

struct JointNames {
    protocol::Token swing;
    protocol::Token spread;
    protocol::Token knee;
};

/// The joint names of the embedded simulator (robots-and-worlds.md 3.4); the names in UT2004 are unknown.
const JointNames& namesOf(Leg leg) {
    static const std::array<JointNames, 4> names{{{"LFLeg1", "LFLeg2", "LFLeg3"},
                                                  {"RFLeg1", "RFLeg2", "RFLeg3"},
                                                  {"LHLeg1", "LHLeg2", "LHLeg3"},
                                                  {"RHLeg1", "RHLeg2", "RHLeg3"}}};
    return names[static_cast<std::size_t>(leg)];
}

} // namespace

void putPaw(protocol::MultiDrive& drive, Leg leg, const PawPlace& paw) {
    const agent::LegAngles angles = agent::legAngles(agent::ers_leg, paw.forward_m, paw.down_m);
    const JointNames& names = namesOf(leg);
    drive.joints.push_back({names.swing, angles.hip_rad});
    drive.joints.push_back({names.spread, spread_rad});
    drive.joints.push_back({names.knee, angles.knee_rad});
}

/// Uses the nod first and the neck only for the rest, because leaning the neck forward shifts the weight.
void bowHead(protocol::MultiDrive& drive, double down_rad) {
    const double nod_rad = std::clamp(down_rad, 0.0, deepest_nod_rad);
    drive.joints.push_back({"HeadNod", -nod_rad});
    drive.joints.push_back({"HeadTilt", nod_rad - std::clamp(down_rad, 0.0, deepest_bow_rad)});
    drive.joints.push_back({"HeadPan", 0.0});
}

} // namespace usar::ers
