#include "core/mission/fleet/camera_feed.h"

#include <utility>

#include "core/mission/files/camera_picture.h"

namespace usar::mission {

namespace {

constexpr int most_unseen = 3;

} // namespace

CameraReceiver::CameraReceiver() {
    connect(&client, &link::ImageClient::frameReceived, this, &CameraReceiver::take);
}

void CameraReceiver::take(link::ImageType type, const QByteArray& data) {
    if (unseen >= most_unseen)
        return;
    const Result<QImage> picture = mission::cameraPictureOf(type, data);
    if (!picture)
        return emit unreadable(QString::fromStdString(picture.error().text()));
    ++unseen;
    emit pictureArrived(*picture, client.status().frames_per_s);
}

CameraFeed::CameraFeed(QObject* parent) : QObject(parent) {
    CameraReceiver* const receiver = receiver_.get();
    link::connectAcross(receiver, &CameraReceiver::pictureArrived, this,
                        [this, receiver](const QImage& picture, double frames_per_s) {
                            --receiver->unseen;
                            emit pictureArrived(picture, frames_per_s);
                        });
    link::connectAcross(receiver, &CameraReceiver::unreadable, this, &CameraFeed::unreadable);
    link::connectAcross(client(), &link::ImageClient::statusChanged, this, &CameraFeed::statusChanged);
}

void CameraFeed::open(const QString& host, quint16 port) {
    if (host == host_ && port == port_)
        return;
    host_ = host;
    port_ = port;
    callLater(client(), &link::ImageClient::open, host, port);
}

void CameraFeed::close() {
    if (host_.isEmpty())
        return;
    host_.clear();
    callLater(client(), &link::ImageClient::close);
}

void CameraFeed::setWanted(bool wanted) {
    if (wanted != std::exchange(wanted_, wanted))
        callLater(client(), &link::ImageClient::setWanted, wanted);
}

} // namespace usar::mission
