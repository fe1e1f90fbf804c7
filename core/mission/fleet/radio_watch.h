// Asks the wireless server for radio signal strengths, in a thread of its own.
#pragma once

#include <QObject>
#include <QThread>

#include "core/link/wireless_client.h"

namespace usar::mission {

/// Belongs to the GUI thread and hands a WirelessClient's results to it. Calls are queued to the client's thread and
/// never wait; only the destructor waits for that thread to end.
class RadioWatch : public QObject {
    Q_OBJECT
public:
    explicit RadioWatch(QObject* parent = nullptr);
    ~RadioWatch() override;

    /// Sets the server. The connection is made once at least two robots are set, and again after it was lost.
    void open(const QString& host, quint16 port);
    void close();
    /// Names of the robots between which strengths are asked for.
    void setRobots(const QStringList& names);

signals:
    void statusChanged(const usar::link::LinkStatus& status);
    /// One entry for each pair that the server has answered for; empty while nothing is known.
    void reported(const usar::link::RadioStrengths& strengths);

private:
    QThread thread_;
    link::WirelessClient* client_; ///< belongs to thread_ and is deleted there
};

} // namespace usar::mission
