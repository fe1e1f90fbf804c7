#include "core/sim/faults/fault_schedule.h"

#include <algorithm>
#include <cmath>

namespace usar::sim {

namespace {

constexpr double scale_m = 68.0;
constexpr double slowest_m_s = 3.0; // Gusts pass at least this fast, even in still air.

// Apart from the random streams of sensors and connections.
constexpr std::uint64_t wind_streams = std::uint64_t(1) << 41;

Wind windOf(const Fault& fault, Random random) {
    const double toward_rad = radians(fault.number("toward_deg"));
    const Vec3 mean_m_s = fault.number("speed") * Vec3(std::cos(toward_rad), std::sin(toward_rad), 0.0);
    return Wind({mean_m_s, fault.number("gust")}, random);
}

} // namespace

Wind::Wind(const WindParameters& parameters, Random random)
    : parameters_(parameters)
    , random_(random)
    , correlation_(scale_m / std::max(slowest_m_s, parameters.mean_in_map_m_s.norm())) {
    for (double& component : gust_m_s_)
        component = gaussian(random_, 1.0); // As if the wind had always blown.
    gust_m_s_ = gust_m_s_.cwiseProduct(Vec3(1.0, 1.0, 0.5)) * parameters_.gust_m_s;
}

Vec3 Wind::step(Seconds dt) {
    const double kept = std::exp(-dt / correlation_);
    const double fresh_m_s = std::sqrt(1.0 - kept * kept) * parameters_.gust_m_s;
    for (int axis = 0; axis < 3; ++axis)
        gust_m_s_[axis] = kept * gust_m_s_[axis] + gaussian(random_, 1.0) * fresh_m_s * (axis == 2 ? 0.5 : 1.0);
    return parameters_.mean_in_map_m_s + gust_m_s_;
}

std::string sentenceOf(const FaultStatus& turned) {
    return (turned.phase == FaultPhase::Active ? "fault begins: " : "fault ends: ") + write(turned.fault);
}

int FaultSchedule::add(const Fault& fault) {
    faults_.push_back({static_cast<int>(faults_.size()) + 1, fault, FaultPhase::ToCome});
    return faults_.back().id;
}

bool FaultSchedule::end(int id) {
    const auto found = std::ranges::find(faults_, id, &FaultStatus::id);
    if (found == faults_.end() || found->phase == FaultPhase::Over)
        return false;
    ending_.push_back(id);
    return true;
}

std::vector<FaultStatus> FaultSchedule::advance(Seconds now) {
    std::vector<FaultStatus> changed;
    for (FaultStatus& status : faults_) {
        const FaultPhase before = status.phase;
        const bool past = now >= status.fault.from + status.fault.lasts || std::ranges::count(ending_, status.id) > 0;
        if (past)
            status.phase = FaultPhase::Over;
        else if (before == FaultPhase::ToCome && now >= status.fault.from)
            status.phase = FaultPhase::Active;
        if (status.phase == before)
            continue;
        changed.push_back(status);
        if (status.fault.kind == FaultKind::Wind && status.phase == FaultPhase::Active)
            winds_.emplace_back(status.id,
                                windOf(status.fault, seeded(seed_, wind_streams + std::uint64_t(status.id))));
        else
            std::erase_if(winds_, [&](const auto& one) { return one.first == status.id; });
    }
    ending_.clear();
    return changed;
}

std::vector<Fault> FaultSchedule::activeOn(std::string_view robot_name) const {
    std::vector<Fault> active;
    for (const FaultStatus& status : faults_)
        if (status.phase == FaultPhase::Active && status.fault.concerns(robot_name))
            active.push_back(status.fault);
    return active;
}

bool FaultSchedule::takeCut(std::string_view robot_name) {
    bool cut = false;
    for (FaultStatus& status : faults_) {
        if (status.fault.kind != FaultKind::LinkCut || status.phase != FaultPhase::Active ||
            !status.fault.concerns(robot_name))
            continue;
        cut = true;
        ending_.push_back(status.id); // It ends at the next tick, so that every robot it is meant for is cut off.
    }
    return cut;
}

Vec3 FaultSchedule::wind(Seconds dt) {
    Vec3 sum_m_s = Vec3::Zero();
    for (auto& [id, wind] : winds_)
        sum_m_s += wind.step(dt);
    return sum_m_s;
}

} // namespace usar::sim
