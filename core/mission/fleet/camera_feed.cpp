#include "core/mission/fleet/camera_feed.h"

#include <utility>

#include <QBuffer>
#include <QImageReader>
#include <QtEndian>

namespace usar::mission {

namespace {

constexpr int longest_side_px = 4096;

Error unreadable(const std::string& what) {
    return {what, "the image server's picture", "Is it an image server of USARSim?"};
}

Result<QImage> rawPicture(const QByteArray& data) {
    if (data.size() < 4)
        return tl::unexpected(unreadable("a raw picture without a size"));
    const int width = qFromBigEndian<quint16>(data.constData());
    const int height = qFromBigEndian<quint16>(data.constData() + 2);
    const qsizetype row_bytes = (3 * width + 3) / 4 * 4;
    if (width == 0 || height == 0 || width > longest_side_px || height > longest_side_px ||
        data.size() < 4 + row_bytes * height)
        return tl::unexpected(unreadable("a raw picture that is not as large as it says"));
    const auto* const pixels = reinterpret_cast<const uchar*>(data.constData()) + 4;
    return QImage(pixels, width, height, row_bytes, QImage::Format_BGR888).copy();
}

constexpr int most_unseen = 3;

} // namespace

Result<QImage> cameraPictureOf(link::ImageType type, const QByteArray& data) {
    if (type == link::ImageType::Raw)
        return rawPicture(data);
    QBuffer buffer;
    buffer.setData(data);
    buffer.open(QIODevice::ReadOnly);
    QImageReader reader(&buffer, "jpeg");
    const QSize size = reader.size();
    if (size.isEmpty() || size.width() > longest_side_px || size.height() > longest_side_px)
        return tl::unexpected(unreadable("no JPEG picture, or one that is too large"));
    const QImage picture = reader.read();
    if (picture.isNull())
        return tl::unexpected(unreadable("a broken JPEG picture"));
    return picture;
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

CameraFeed::CameraFeed() {
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
