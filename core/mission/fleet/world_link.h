// The window's handle to the world controller's session, which runs in a thread of its own.
#pragma once

#include <QObject>

#include "core/mission/fleet/own_thread.h"
#include "core/mission/world/world_session.h"

namespace usar::mission {

/// Belongs to the GUI thread. Calls are queued to the WorldSession and never wait; only the destructor waits for the
/// session's thread to end. See WorldSession for what the calls do.
class WorldLink : public QObject {
    Q_OBJECT
public:
    WorldLink() {
        link::connectAcross(session_.get(), &WorldSession::changed, this, [this](const auto& view) {
            view_ = view;
            emit changed();
        });
        link::connectAcross(session_.get(), &WorldSession::noticed, this, &WorldLink::noticed);
    }

    /// The newest state from the session; valid until control returns to the event loop.
    const WorldView& view() const { return *view_; }
    void open(const QString& host, quint16 port) { session_.call(&WorldSession::open, host, port); }
    void close() { session_.call(&WorldSession::close); }
    /// Classes that the server is asked about, without package.
    void setClasses(const std::vector<std::string>& names) { session_.call(&WorldSession::setClasses, names); }
    /// Interval at which to ask where things are; nullopt: only after commands.
    void setPolling(std::optional<std::chrono::milliseconds> interval) {
        session_.call(&WorldSession::setPolling, interval);
    }
    void setPaused(bool paused) { session_.call(&WorldSession::setPaused, paused); }
    void send(const protocol::Command& command) { session_.call(&WorldSession::send, command); }
    void refuse(const QString& name, const QString& reason) { session_.call(&WorldSession::refuse, name, reason); }

signals:
    /// `view` has changed.
    void changed();
    void noticed(const usar::mission::Notice& notice);

private:
    std::shared_ptr<const WorldView> view_ = std::make_shared<const WorldView>();
    OwnThread<WorldSession> session_{"world"};
};

} // namespace usar::mission
