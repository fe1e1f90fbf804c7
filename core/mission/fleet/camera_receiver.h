// The part of the camera feed that runs in the receiving thread.
#pragma once

#include <atomic>

#include <QImage>
#include <QObject>

#include "core/link/image_client.h"

namespace usar::mission {

/// Decodes the frames of its client. Owned by a CameraFeed; apart from `unseen`, it is used in the receiving thread
/// only.
class CameraReceiver : public QObject {
    Q_OBJECT
public:
    CameraReceiver();

    link::ImageClient client{this};
    std::atomic<int> unseen = 0; ///< number of pictures that the GUI thread has not taken yet

signals:
    /// Counts as unseen until the receiver decrements `unseen`.
    void pictureArrived(const QImage& picture, double frames_per_s);
    /// The frame could not be decoded; `reason` is one sentence.
    void unreadable(const QString& reason);

private:
    /// Decodes a frame, or drops it if too many pictures are unseen.
    void take(link::ImageType type, const QByteArray& data);
};

} // namespace usar::mission
