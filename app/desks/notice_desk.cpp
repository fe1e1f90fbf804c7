#include "app/desks/notice_desk.h"

#include <utility>

namespace usar::app {

NoticeDesk::NoticeDesk(MissionControl& control, const widgets::WindowViews& views) : views_(views) {
    auto* const center = views.notifications;
    connect(&control, &MissionControl::noticed, this, [this](const QString& key, const mission::Notice& notice) {
        say(notice.severity, key, QString::fromStdString(notice.text));
    });
    connect(&control, &MissionControl::cured, center, &widgets::NotificationCenter::cured);
    connect(&control, &MissionControl::robotRemoved, center->model(),
            [center](RobotId, const QString& name) { center->model()->cureAll(name + u'/'); });
    connect(center->model(), &widgets::NotificationModel::offerTaken, this, [this](const QString& key) {
        if (const auto offered = offers_.find(key); offered != offers_.end())
            std::function<void()>(offered->second)(); // A copy, because the call may cure the problem and erase it.
    });
    connect(center->model(), &widgets::NotificationModel::cured, this,
            [this](const QString& key) { offers_.erase(key); });
}

void NoticeDesk::complain(const QString& key, const Error& error) {
    say(Severity::Error, key, QString::fromStdString(error.text()));
}

void NoticeDesk::offer(Severity severity, const QString& key, const QString& text, const widgets::Offer& offer,
                       std::function<void()> accept) {
    offers_[key] = std::move(accept);
    views_.notifications->push(key, severity, text, true, offer);
}

} // namespace usar::app
