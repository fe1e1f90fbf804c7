// Receives and decodes pictures from an image server in a thread of its own.
#pragma once

#include <atomic>

#include <QByteArray>
#include <QImage>
#include <QObject>

#include "core/base/result.h"
#include "core/link/image_client.h"
#include "core/link/image_type.h"
#include "core/mission/fleet/own_thread.h"

namespace usar::mission {

/// Decodes the data of a frame, JPEG or raw (protocol.md 6.1). Data that cannot be read, or a picture larger than
/// 4096 pixels a side, is an error.
Result<QImage> cameraPictureOf(link::ImageType type, const QByteArray& data);

/// Decodes the frames of its client. Owned by a CameraFeed; apart from `unseen`, it is used in the receiving thread
/// only.
class CameraReceiver : public QObject {
    Q_OBJECT
public:
    CameraReceiver() { connect(&client, &link::ImageClient::frameReceived, this, &CameraReceiver::take); }

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

/// Belongs to the GUI thread. Calls are queued to the receiving thread and never wait; only the destructor waits for
/// that thread to end. Pictures are requested only while they are wanted.
class CameraFeed : public QObject {
    Q_OBJECT
public:
    CameraFeed();

    /// Closes any open connection, then connects to this server; a call with the same address changes nothing. Lost
    /// connections are made again until `close`.
    void open(const QString& host, quint16 port);
    void close();
    /// Starts or stops requesting pictures; initially false. The connection stays open either way.
    void setWanted(bool wanted);

signals:
    /// `frames_per_s` is the rate over the last ten pictures. At most three pictures wait for the GUI thread; further
    /// ones are dropped.
    void pictureArrived(const QImage& picture, double frames_per_s);
    void statusChanged(const usar::link::ImageStatus& status);
    /// A picture could not be decoded; `reason` is one sentence.
    void unreadable(const QString& reason);

private:
    link::ImageClient* client() const { return &receiver_.get()->client; }

    QString host_; ///< empty: closed
    quint16 port_ = 0;
    bool wanted_ = false;
    OwnThread<CameraReceiver> receiver_{"camera"};
};

} // namespace usar::mission
