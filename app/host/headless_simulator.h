// The embedded simulator for a program without a window.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QString>
#include <QThread>

#include "core/base/result.h"
#include "core/mission/session/mission_score.h"
#include "core/mission/session/run_summary.h"
#include "core/server/simulator_server.h"
#include "core/sim/rays/ray_caster.h"
#include "core/sim/simulation.h"

namespace usar::app {

struct HeadlessSpec {
    std::uint64_t seed = 1;
    std::optional<double> speed_x{}; ///< simulated seconds per second, absent for as fast as it can
    std::vector<sim::Fault> faults{};
};

/// Serves one world on a free loopback port from a thread of its own, from `start` until it is destroyed. What it tells
/// beside the wire is for scores only. Lives in the main thread.
class HeadlessSimulator {
public:
    /// An unknown world is an error that lists the known ones.
    static Result<std::unique_ptr<HeadlessSimulator>> start(const QString& world, const HeadlessSpec& spec);
    static Result<std::unique_ptr<HeadlessSimulator>> serve(sim::World world, const HeadlessSpec& spec);
    ~HeadlessSimulator();

    quint16 port() const { return port_; }
    Rectangle extent() const;
    /// Valid as long as this object.
    mission::Truth truth() const;
    /// `tell` is called in the thread of `context` with a sentence when a fault begins or ends.
    void onFault(QObject* context, const std::function<void(const QString&)>& tell);
    /// Of the first robot that is there now.
    std::optional<mission::TrueFigures> figures() const;

private:
    HeadlessSimulator() = default;

    QThread thread_;
    QObject* worker_ = new QObject; ///< lives in thread_, owns the server, is deleted there
    server::SimulatorServer* server_ = nullptr;
    const sim::Simulation* simulation_ =
        nullptr; ///< the server's; touched from its thread only, but for the still world
    std::unique_ptr<sim::RayCaster> rays_;
    quint16 port_ = 0;
};

} // namespace usar::app
