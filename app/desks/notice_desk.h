// Desk for notifications: shows sentences to the user, some with a button.
#pragma once

#include <functional>
#include <map>
#include <optional>

#include <QObject>
#include <QString>

#include "app/host/mission_control.h"
#include "widgets/window/window_views.h"

namespace usar::app {

/// Every desk reports through this one; it also shows the notices of MissionControl. `key` identifies what a sentence
/// is about: a sentence with the same key replaces the earlier one, and `cure` grays it out. GUI thread.
class NoticeDesk : public QObject {
    Q_OBJECT
public:
    NoticeDesk(MissionControl& control, const widgets::WindowViews& views);

    /// Shows a complete sentence; warnings and errors also as a toast, unless `toast` says otherwise.
    void say(Severity severity, const QString& key, const QString& text, std::optional<bool> toast = std::nullopt) {
        views_.notifications->push(key, severity, text, toast);
    }
    /// Shows a note that the user waits for, also as a toast.
    void note(const QString& key, const QString& text) { views_.notifications->push(key, Severity::Note, text, true); }
    /// Shows an error.
    void complain(const QString& key, const Error& error);
    /// Shows a sentence with a button beside it, which calls `accept` as long as the problem is not cured.
    void offer(Severity severity, const QString& key, const QString& text, const widgets::Offer& offer,
               std::function<void()> accept);
    /// True while the notification with this key has such a button.
    bool offers(const QString& key) const { return offers_.contains(key); }
    /// The problem is over. An unknown key has no effect.
    void cure(const QString& key) { views_.notifications->cured(key); }

private:
    const widgets::WindowViews& views_;
    std::map<QString, std::function<void()>> offers_; ///< the callbacks of the buttons, by key
};

} // namespace usar::app
