// The window's handle to the world controller's session, which runs in a thread of its own.
#pragma once

#include <QObject>
#include <QThread>

#include "core/mission/world/world_session.h"

namespace usar::mission {

/// Belongs to the GUI thread. Calls are queued to the WorldSession and never wait; only the destructor waits for the
/// session's thread to end. See WorldSession for what the calls do.
class WorldLink : public QObject {
    Q_OBJECT
public:
    explicit WorldLink(QObject* parent = nullptr);
    ~WorldLink() override;

    /// The newest state from the session; valid until control returns to the event loop.
    const mission::WorldView& view() const { return *view_; }
    void open(const QString& host, quint16 port);
    void close();
    /// Classes that the server is asked about, without package.
    void setClasses(const std::vector<std::string>& class_names);
    /// Interval at which to ask where things are; nullopt: only after commands.
    void setPolling(std::optional<std::chrono::milliseconds> interval);
    void setPaused(bool paused);
    void send(const protocol::Command& command);

signals:
    /// `view` has changed.
    void changed();
    void noticed(const usar::mission::Notice& notice);

private:
    template <class Call>
    void later(Call call);

    QThread thread_;
    mission::WorldSession* session_; ///< belongs to thread_ and is deleted there
    std::shared_ptr<const mission::WorldView> view_ = std::make_shared<const mission::WorldView>();
};

} // namespace usar::mission
