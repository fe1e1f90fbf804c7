// The embedded simulator for a program without a window.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include <QObject>
#include <QString>
#include <QThread>

#include "core/base/result.h"
#include "core/mission/mission_score.h"
#include "core/sim/ray_caster.h"
#include "core/sim/simulation.h"

namespace usar::app {

/// Serves one world on a free loopback port from a thread of its own, from `start` until it is destroyed. What it tells
/// beside the wire is for scores only. Lives in the main thread.
class HeadlessSimulator {
public:
    /// `speed_x` simulated seconds per second, absent for as fast as it can. An unknown world is an error that lists
    /// the known ones.
    static Result<std::unique_ptr<HeadlessSimulator>> start(const QString& world, std::uint64_t seed,
                                                            std::optional<double> speed_x);
    static Result<std::unique_ptr<HeadlessSimulator>> serve(sim::World world, std::uint64_t seed,
                                                            std::optional<double> speed_x);
    ~HeadlessSimulator();

    quint16 port() const { return port_; }
    Rectangle extent() const;
    /// Valid as long as this object.
    mission::Truth truth() const;
    /// Hits of all robots that are there now.
    std::optional<int> collisions() const;

private:
    HeadlessSimulator() = default;

    QThread thread_;
    QObject* worker_ = new QObject; ///< lives in thread_, owns the server, is deleted there
    const sim::Simulation* simulation_ =
        nullptr; ///< the server's; touched from its thread only, but for the still world
    std::unique_ptr<sim::RayCaster> rays_;
    quint16 port_ = 0;
};

} // namespace usar::app
