// The wireless server's answers for the window, asked for in a thread of their own.
#pragma once

#include <QObject>
#include <QThread>

#include "core/link/wireless_client.h"

namespace usar::mission {

/// Lives in the GUI thread; its client and socket live in theirs.
class RadioWatch : public QObject {
    Q_OBJECT
public:
    explicit RadioWatch(QObject* parent = nullptr);
    ~RadioWatch() override;

    void open(const QString& host, quint16 port);
    void close();
    void setRobots(const QStringList& names);

signals:
    void statusChanged(const usar::link::LinkStatus& status);
    void reported(const usar::link::RadioStrengths& strengths);

private:
    QThread thread_;
    link::WirelessClient* client_; ///< lives in thread_ and is deleted there
};

} // namespace usar::mission
