#include "core/mission/session/map_adjuster.h"

#include <utility>

namespace usar::mission {

using mapping::AdjustmentVerdict;

void MapAdjuster::begin() {
    rebuild_.reset();
    scans_begun_ = mapper_.store().scans().size();
    adjustment_.emplace(mapper_.store());
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
    }
    return true;
}

/// A map that is as it was flown need not be made again.
void MapAdjuster::conclude() {
    adjusted_ = adjustment_->result();
    adjustment_.reset();
    const bool is_corrected = result_ && result_->verdict != AdjustmentVerdict::Declined;
    if (!mapper_.store().overfull() && (adjusted_->verdict != AdjustmentVerdict::Declined || is_corrected))
        rebuild_.emplace(mapper_.store(), adjusted_->correction, emptyMap_());
    else
        result_ = std::move(adjusted_);
}

void MapAdjuster::forget() {
    adjustment_.reset();
    rebuild_.reset();
    adjusted_.reset();
    result_.reset();
    scans_begun_ = 0;
}

} // namespace usar::mission
