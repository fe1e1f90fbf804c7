// Divides lanes among sorties, each flown with one battery, and orders them by what these cost: capacitated arc routing
// with one robot and one base.
#pragma once

#include <limits>
#include <vector>

#include "robots/airrobot/lane_order.h"
#include "robots/airrobot/settings.h"

namespace usar::airrobot {

/// How far a robot flies with its battery, and what a charge costs.
struct Endurance {
    double left_m = std::numeric_limits<double>::infinity(); ///< from where it is, until it is home again
    double full_m = std::numeric_limits<double>::infinity(); ///< the same after a charge
    double charge_m = 0.0; ///< what the robot could fly while it lands, charges and takes off
    /// Whether a lane may be broken off for a charge. Otherwise, a sortie of more than one lane ends before it is too
    /// long.
    bool breaks_off = true;
};

/// The way flown is longer than straight ways by this usual factor, because of evasion.
inline constexpr double usual_detour = 1.05;

/// The endurance of a robot that has flown `since_charge_m` with its battery. `detour`: the way that it flies for each
/// straight meter.
Endurance enduranceOf(const Settings& settings, double since_charge_m = 0.0, double detour = usual_detour);

/// The length of a flight along these lanes, in their order and directions, that begins at `from_m` and ends at
/// `home_m`, divided into sorties so that it is as short as possible (the splitting of Prins 2004, "A simple and
/// effective evolutionary algorithm for the vehicle routing problem"). Between two sorties the robot flies home and
/// charges. Where the battery lasts only for the way home, it breaks off a lane, and resumes it there after the charge.
/// Charges and turns are counted as the way that they cost, and what a full battery does not reach as a thousand
/// kilometers.
double flight_m(const Vec2& from_m, const std::vector<mapping::Lane>& lanes, const Vec2& home_m,
                const Endurance& endurance);

/// The same, and numbers the lanes by their sorties in this division, from 0 on. There is no lane of sortie 0 if
/// it is better to charge first.
double divideIntoSorties(const Vec2& from_m, std::vector<mapping::Lane>& lanes, const Vec2& home_m,
                         const Endurance& endurance);

/// For more lanes, an order that takes charges into account would take too long to find in flight.
inline constexpr std::size_t few_lanes = 40;

/// The same as `orderTour`, with flights home for charges if there are few lanes.
void orderFlights(const Vec2& from_m, std::vector<mapping::Lane>& lanes, const Vec2& home_m,
                  const Endurance& endurance);

/// Changes the order for as long as that makes the flight shorter, and for a fifth of a second at most on a machine of
/// today, if there are few lanes.
void improveFlights(const Vec2& from_m, std::vector<mapping::Lane>& lanes, const Vec2& home_m,
                    const Endurance& endurance);

} // namespace usar::airrobot
