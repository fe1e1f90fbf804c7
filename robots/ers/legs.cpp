#include "robots/ers/legs.h"

#include <algorithm>
#include <cmath>

namespace usar::ers {

namespace {

constexpr double thigh_m = 0.071;
constexpr double shin_m = 0.072;
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

/// Thigh, shin and the line from hip to paw form a triangle, from which the angle of the knee follows.
void putPaw(protocol::MultiDrive& drive, Leg leg, const PawPlace& paw) {
    const double square_m2 = paw.forward_m * paw.forward_m + paw.down_m * paw.down_m;
    const double cosine = (square_m2 - thigh_m * thigh_m - shin_m * shin_m) / (2.0 * thigh_m * shin_m);
    const double knee_rad = std::acos(std::clamp(cosine, -1.0, 1.0));
    const double ahead_of_paw_rad = std::atan2(shin_m * std::sin(knee_rad), thigh_m + shin_m * std::cos(knee_rad));
    const JointNames& names = namesOf(leg);
    drive.joints.push_back({names.swing, std::atan2(paw.forward_m, paw.down_m) + ahead_of_paw_rad});
    drive.joints.push_back({names.spread, spread_rad});
    drive.joints.push_back({names.knee, knee_rad});
}

/// Uses the nod first and the neck only for the rest, because leaning the neck forward shifts the weight.
void bowHead(protocol::MultiDrive& drive, double down_rad) {
    const double nod_rad = std::clamp(down_rad, 0.0, deepest_nod_rad);
    drive.joints.push_back({"HeadNod", -nod_rad});
    drive.joints.push_back({"HeadTilt", nod_rad - std::clamp(down_rad, 0.0, deepest_bow_rad)});
    drive.joints.push_back({"HeadPan", 0.0});
}

} // namespace usar::ers
