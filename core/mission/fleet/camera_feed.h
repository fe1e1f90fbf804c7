// Pictures from an image server, received and unpacked in a thread of their own.
#pragma once

#include <QImage>
#include <QObject>
#include <QThread>

#include "core/link/image_client.h"

namespace usar::mission {

class CameraReceiver;

/// Lives in the GUI thread; calls are queued and never wait.
class CameraFeed : public QObject {
    Q_OBJECT
public:
    explicit CameraFeed(QObject* parent = nullptr);
    ~CameraFeed() override;

    /// Closes what is open, then connects there; the same place again changes nothing.
    void open(const QString& host, quint16 port);
    void close();
    void setWanted(bool wanted);

signals:
    /// At most three wait for the GUI thread; what comes while it is busy is left out.
    void pictureArrived(const QImage& picture, double frames_per_s);
    void statusChanged(const usar::link::ImageStatus& status);
    /// A picture that cannot be read; one sentence.
    void unreadable(const QString& reason);

private:
    template <class Call>
    void later(Call call);

    QThread thread_;
    CameraReceiver* receiver_; ///< lives in thread_ and is deleted there
    QString host_;
    quint16 port_ = 0;
    bool wanted_ = false;
};

} // namespace usar::mission
