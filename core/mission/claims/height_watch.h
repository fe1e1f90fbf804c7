// The height of a robot above the place where it was first seen, from what it reports.
#pragma once

#include <optional>

#include "core/protocol/info_message.h"

namespace usar::mission {

/// Believes ground truth if the robot reports it, else INS. The two have data of their own, so each counts from its own
/// first pose. A plain value.
class HeightWatch {
public:
    /// Returns the height in meters, z up, if the line tells it.
    std::optional<double> take(const protocol::InfoLine& line) {
        if (const auto* const truth = std::get_if<protocol::GroundTruthReading>(&line.message)) {
            truth_known_ = true;
            return above(truth->base_in_map.position_m.z(), first_truth_m_);
        }
        if (const auto* const ins = std::get_if<protocol::InsReading>(&line.message); ins && !truth_known_)
            return above(ins->base_in_map.position_m.z(), first_ins_m_);
        return std::nullopt;
    }

private:
    static double above(double z_m, std::optional<double>& first_m) {
        if (!first_m)
            first_m = z_m;
        return z_m - *first_m;
    }

    bool truth_known_ = false;
    std::optional<double> first_truth_m_;
    std::optional<double> first_ins_m_;
};

} // namespace usar::mission
