#include "core/mission/fleet/camera_feed.h"

#include <utility>

#include "core/link/across_threads.h"
#include "core/mission/files/camera_picture.h"
#include "core/mission/fleet/camera_receiver.h"

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

CameraFeed::CameraFeed(QObject* parent) : QObject(parent), receiver_(new CameraReceiver) {
    thread_.setObjectName("camera");
    receiver_->moveToThread(&thread_);
    connect(&thread_, &QThread::finished, receiver_, &QObject::deleteLater);
    link::connectAcross(receiver_, &CameraReceiver::pictureArrived, this,
                        [this](const QImage& picture, double frames_per_s) {
                            --receiver_->unseen;
                            emit pictureArrived(picture, frames_per_s);
                        });
    link::connectAcross(receiver_, &CameraReceiver::unreadable, this, &CameraFeed::unreadable);
    link::connectAcross(&receiver_->client, &link::ImageClient::statusChanged, this, &CameraFeed::statusChanged);
    thread_.start();
}

CameraFeed::~CameraFeed() {
    receiver_->disconnect(this);
    later([](link::ImageClient& client) { client.close(); });
    thread_.quit();
    thread_.wait();
}

template <class Call>
void CameraFeed::later(Call call) {
    link::post(receiver_, [receiver = receiver_, call = std::move(call)] { call(receiver->client); });
}

void CameraFeed::open(const QString& host, quint16 port) {
    if (host == host_ && port == port_)
        return;
    host_ = host;
    port_ = port;
    later([=](link::ImageClient& client) { client.open(host, port); });
}

void CameraFeed::close() {
    if (host_.isEmpty())
        return;
    host_.clear();
    later([](link::ImageClient& client) { client.close(); });
}

void CameraFeed::setWanted(bool wanted) {
    if (wanted == std::exchange(wanted_, wanted))
        return;
    later([=](link::ImageClient& client) { client.setWanted(wanted); });
}

} // namespace usar::mission
