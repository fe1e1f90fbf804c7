// The world controller's session in a thread of its own, as the window holds it.
#pragma once

#include <QObject>
#include <QThread>

#include "core/mission/session/world_session.h"

namespace usar::mission {

/// Lives in the GUI thread; calls are queued to the session and never wait.
class WorldLink : public QObject {
    Q_OBJECT
public:
    explicit WorldLink(QObject* parent = nullptr);
    ~WorldLink() override;

    /// The newest that the session said.
    const mission::WorldView& view() const { return *view_; }
    void open(const QString& host, quint16 port);
    void close();
    void setClasses(const std::vector<std::string>& class_names);
    void setPolling(std::optional<std::chrono::milliseconds> interval);
    void setPaused(bool paused);
    void send(const protocol::Command& command);

signals:
    void changed();
    void noticed(const usar::mission::Notice& notice);

private:
    template <class Call>
    void later(Call call);

    QThread thread_;
    mission::WorldSession* session_; ///< lives in thread_ and is deleted there
    std::shared_ptr<const mission::WorldView> view_ = std::make_shared<const mission::WorldView>();
};

} // namespace usar::mission
