// Notifications of the window: sentences, with a button for those that come with an offer.
#pragma once

#include <functional>
#include <map>

#include <QObject>
#include <QString>

#include "app/host/mission_control.h"
#include "app/views/window_views.h"

namespace usar::app {

/// `key` says what a sentence is about: the same key again replaces the earlier sentence, and a cure grays it out. GUI
/// thread.
class NoticeDesk : public QObject {
    Q_OBJECT
public:
    NoticeDesk(MissionControl& control, const WindowViews& views);

    void say(Severity severity, const QString& key, const QString& text);
    /// A note that the user waits for, which is shown as a toast, too.
    void note(const QString& key, const QString& text);
    void complain(const QString& key, const Error& error);
    /// With a button beside the sentence that calls `accept` as long as the trouble is not cured.
    void offer(Severity severity, const QString& key, const QString& text, const widgets::Offer& offer,
               std::function<void()> accept);
    bool offers(const QString& key) const { return offers_.contains(key); }
    void cure(const QString& key);

private:
    const WindowViews& views_;
    std::map<QString, std::function<void()>> offers_; ///< by the key of the notification
};

} // namespace usar::app
