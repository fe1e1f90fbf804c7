#include "core/mission/session/map_adjuster.h"

#include <utility>

namespace usar::mission {

using mapping::AdjustmentVerdict;

void MapAdjuster::begin() {
    note();
    beginNoted();
}

void MapAdjuster::note() {
    noted_ = {mapper_.store().scans().size(), mapper_.store().sorties()};
}

void MapAdjuster::beginNoted() {
    if (!noted_)
        return;
    rebuild_.reset();
    scans_begun_ = noted_->scans;
    adjustment_.emplace(mapper_.store(), noted_->scans, std::move(noted_->sorties));
    noted_.reset();
}

bool MapAdjuster::step() {
    if (mapper_.store().overfull() && rebuild_) // The scans are gone.
        rebuild_.reset();
    if (adjustment_) {
        if (!adjustment_->step())
            conclude();
        return true;
    }
    if (!rebuild_)
        return false;
    if (!rebuild_->step()) {
        mapper_.replaceMap(rebuild_->takeMap());
        rebuild_.reset();
        result_ = std::move(adjusted_);
        flight_.take(result_->correction);
        mapper_.setError(flight_.newest());
    }
    return true;
}

void MapAdjuster::followFlight() {
    if (!busy() && flight_.step())
        mapper_.setError(flight_.newest());
}

/// Also a map whose path is not corrected is made again, because its cells become better.
void MapAdjuster::conclude() {
    adjusted_ = adjustment_->result();
    adjustment_.reset();
    if (!mapper_.store().scans().empty()) {
        rebuild_.emplace(mapper_.store(), adjusted_->correction, emptyMap_());
        return;
    }
    const bool is_corrected = result_ && result_->verdict != AdjustmentVerdict::Declined;
    if (!is_corrected)
        result_ = std::move(adjusted_);
    else if (!result_->reason.ends_with(adjusted_->reason)) // The map stays corrected without the scans.
        result_->reason += " The rest is as it was flown. " + adjusted_->reason;
}

void MapAdjuster::forget() {
    noted_.reset();
    adjustment_.reset();
    rebuild_.reset();
    adjusted_.reset();
    result_.reset();
    flight_ = mapping::LagAdjustment(mapper_.store());
    mapper_.setError({});
    scans_begun_ = 0;
}

} // namespace usar::mission
