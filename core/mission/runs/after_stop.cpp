#include "core/mission/runs/after_stop.h"

#include <utility>

namespace usar::mission {

AfterStop::AfterStop(RobotSession& session, AskTruth ask, QObject* parent)
    : QObject(parent)
    , session_(session)
    , ask_(std::move(ask)) {
    connect(&session_, &RobotSession::timeReached, this, [this] { end(true); });
    connect(&session_, &RobotSession::linkChanged, this, [this](const link::LinkStatus& status) {
        if (status.state != link::LinkState::Connected)
            giveUp();
    });
}

bool AfterStop::begin(const std::optional<TrueFigures>& at_end) {
    const SessionFigures figures = session_.figures();
    const bool stopped = !figures.behavior_running && session_.linkStatus().state == link::LinkState::Connected;
    if (!stopped || !at_end || at_end->broken)
        return false;
    watching_ = true;
    session_.awaitTime(figures.now + span);
    return true;
}

void AfterStop::giveUp() {
    end(false);
}

void AfterStop::addTo(TrueFigures& at_end) const {
    if (!after_)
        return;
    at_end.broken = after_->broken;
    if (after_->powered_for >= span)
        at_end.contacts_after_stop = after_->collisions - at_end.collisions;
}

void AfterStop::end(bool whole) {
    if (!std::exchange(watching_, false))
        return;
    if (whole)
        after_ = ask_();
    emit over();
}

} // namespace usar::mission
