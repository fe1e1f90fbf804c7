// The camera feed's half in its own thread.
#pragma once

#include <atomic>

#include <QImage>
#include <QObject>

#include "core/link/image_client.h"

namespace usar::mission {

class CameraReceiver : public QObject {
    Q_OBJECT
public:
    CameraReceiver();

    link::ImageClient client{this};
    std::atomic<int> unseen = 0; ///< pictures that the GUI thread has not taken yet

signals:
    void pictureArrived(const QImage& picture, double frames_per_s);
    void unreadable(const QString& reason);

private:
    void take(link::ImageType type, const QByteArray& data);
};

} // namespace usar::mission
