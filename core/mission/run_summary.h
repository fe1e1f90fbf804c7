// The figures of a finished run, and their JSON.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <QJsonObject>
#include <QStringList>

#include "core/base/clock.h"
#include "core/mission/mission_score.h"

namespace usar::mission {

/// Of what dives, since it went under; keys least_height_m, mean_height_m and height_spread_m (standard deviation).
struct HeightOverGround {
    double least_m = 0.0;
    double mean_m = 0.0;
    double spread_m = 0.0;
};

/// What only a simulator can count; of our robot.
struct TrueFigures {
    int collisions = 0;
    double distance_m = 0.0;   ///< path length; key true_distance_m
    Seconds longest_stay{0.0}; ///< within a meter; key longest_stay_s
    int falls = 0;
    int touches = 0;                      ///< of things that can be pushed
    std::optional<Seconds> first_touch{}; ///< since the spawn; key first_touch_s
    std::optional<HeightOverGround> height{};
};

/// Keys of the JSON are the field names, every one of them there however the run ended; what is unknown is null.
/// `speed_x` is protocol seconds a wall second. As it is made it is a run that was refused before it began.
struct RunSummary {
    bool success = false;
    std::string reason;
    std::string mission;  ///< empty: unknown
    std::string behavior; ///< empty: unknown
    std::string plan;     ///< path of a person's own; empty: none
    std::optional<std::uint64_t> seed;
    Seconds duration{0.0}; ///< of the behavior, protocol clock; key duration_s
    Seconds wall{0.0};     ///< the same by the clock on the wall; key wall_s
    double distance_m = 0.0;
    int charges = 0;
    std::optional<TrueFigures> truth;
    Score score; ///< keys coverage_pct, rmse_m, rmse_surface_m
    std::size_t cells = 0;
    std::uint64_t lines_received = 0;
    std::uint64_t lines_malformed = 0;
    bool lockstep = false;
    QStringList faults; ///< what was made to go wrong, and when
    QStringList files;
};

/// All keys are there; those of figures that nobody knows are null.
QJsonObject toJson(const std::optional<TrueFigures>& truth);
QJsonObject toJson(const RunSummary& summary);

} // namespace usar::mission
