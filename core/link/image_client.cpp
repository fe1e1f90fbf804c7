#include "core/link/image_client.h"

#include <algorithm>
#include <cmath>

#include <QNetworkProxy>
#include <QtEndian>

#include "core/link/retry.h"
#include "core/protocol/usual_values.h"

namespace usar::link {

ImageClient::ImageClient(QObject* parent) : QObject(parent) {
    socket_.setProxy(QNetworkProxy::NoProxy);
    socket_.setReadBufferSize(1 << 16);
    for (QTimer* const timer : {&retry_timer_, &connect_timer_, &silence_timer_, &ask_timer_})
        timer->setSingleShot(true);
    connect(&retry_timer_, &QTimer::timeout, this, &ImageClient::connectNow);
    connect(&ask_timer_, &QTimer::timeout, this, &ImageClient::askNow);
    connect(&connect_timer_, &QTimer::timeout, this,
            [this] { failed(tr("No answer from the image server at %1. Is it running there?").arg(place())); });
    connect(&silence_timer_, &QTimer::timeout, this, [this] {
        failed(tr("The image server at %1 was asked for a picture and sends none. Is the game's window open there?")
                   .arg(place()));
    });
    connect(&socket_, &QTcpSocket::connected, this, [this] {
        connect_timer_.stop();
        socket_.setSocketOption(QAbstractSocket::LowDelayOption, 1);
        socket_.setSocketOption(QAbstractSocket::KeepAliveOption, 1);
        setState(ImageState::Quiet);
        askSoon();
    });
    connect(&socket_, &QTcpSocket::readyRead, this, &ImageClient::takeBytes);
    connect(&socket_, &QTcpSocket::errorOccurred, this, [this](QAbstractSocket::SocketError error) {
        if (!open_ || status_.state == ImageState::Waiting)
            return;
        if (error == QAbstractSocket::ConnectionRefusedError)
            return failed(tr("No image server listens at %1. Start one there, or check its port (usually %2).")
                              .arg(place())
                              .arg(protocol::usual_port::image));
        if (error == QAbstractSocket::RemoteHostClosedError)
            return failed(tr("The image server at %1 closed the connection.").arg(place()));
        failed(tr("Trouble with the image server at %1: %2.").arg(place(), socket_.errorString()));
    });
    clock_.start();
}

ImageClient::~ImageClient() {
    socket_.disconnect(this);
}

QString ImageClient::place() const {
    return QStringLiteral("%1:%2").arg(host_).arg(port_);
}

void ImageClient::open(const QString& host, quint16 port) {
    close();
    host_ = host.trimmed();
    port_ = port;
    open_ = true;
    failed_tries_ = 0;
    connectNow();
}

void ImageClient::close() {
    open_ = false;
    retry_timer_.stop();
    dropConnection();
    setState(ImageState::Off);
}

void ImageClient::setWanted(bool wanted) {
    if (wanted == wanted_)
        return;
    wanted_ = wanted;
    arrivals_ms_.clear();
    if (wanted)
        return askSoon();
    ask_timer_.stop();
    if (status_.state == ImageState::Live)
        setState(ImageState::Quiet);
}

void ImageClient::connectNow() {
    dropConnection();
    setState(ImageState::Connecting);
    connect_timer_.start(toMilliseconds(limits_.connect_timeout));
    socket_.connectToHost(host_, port_);
}

void ImageClient::askSoon() {
    if (!wanted_ || asked_ || socket_.state() != QAbstractSocket::ConnectedState || ask_timer_.isActive())
        return;
    const qint64 due_ms = asked_ms_ + toMilliseconds(limits_.shortest_interval).count();
    ask_timer_.start(static_cast<int>(std::max<qint64>(0, due_ms - clock_.elapsed())));
}

void ImageClient::askNow() {
    if (!wanted_ || asked_ || socket_.state() != QAbstractSocket::ConnectedState)
        return;
    asked_ = true;
    asked_ms_ = clock_.elapsed();
    socket_.write("OK", 2);
    silence_timer_.start(toMilliseconds(limits_.silence));
}

void ImageClient::takeBytes() {
    while (socket_.bytesAvailable() > 0) {
        if (head_.size() < frame_head_bytes) {
            head_ += socket_.read(frame_head_bytes - head_.size());
            if (head_.size() == frame_head_bytes && !takeHead())
                return;
            continue;
        }
        data_ += socket_.read(data_bytes_ - data_.size());
        if (data_.size() == data_bytes_)
            takeFrame();
    }
}

/// Reads the head of a frame. If it cannot be the head of a picture, drops the connection and returns false.
bool ImageClient::takeHead() {
    const auto type = static_cast<std::uint8_t>(head_[0]);
    const auto bytes = qFromBigEndian<quint32>(head_.constData() + 1);
    if (type > last_image_type || bytes == 0) {
        failed(tr("%1 does not speak the image server's protocol. Check the port (usually %2).")
                   .arg(place())
                   .arg(protocol::usual_port::image));
        return false;
    }
    if (bytes > limits_.most_bytes) {
        failed(tr("The image server at %1 announces a picture of %2 MB, more than any camera's. Check the port "
                  "(usually 5003).")
                   .arg(place())
                   .arg(bytes / 1e6, 0, 'f', 1));
        return false;
    }
    data_bytes_ = static_cast<qsizetype>(bytes);
    return true;
}

void ImageClient::takeFrame() {
    const auto type = static_cast<ImageType>(head_[0]);
    const QByteArray data = std::exchange(data_, {});
    head_.clear();
    asked_ = false;
    silence_timer_.stop();
    failed_tries_ = 0;
    arrivals_ms_.push_back(clock_.elapsed());
    if (constexpr std::size_t rate_over_frames = 10; arrivals_ms_.size() > rate_over_frames)
        arrivals_ms_.pop_front();
    const qint64 span_ms = arrivals_ms_.back() - arrivals_ms_.front();
    status_.frames_per_s =
        span_ms > 0 ? 1000.0 * static_cast<double>(arrivals_ms_.size() - 1) / static_cast<double>(span_ms) : 0.0;
    if (wanted_) {
        status_.state = ImageState::Live;
        status_.reason.clear();
    }
    emit frameReceived(type, data);
    emit statusChanged(status_);
    askSoon();
}

void ImageClient::failed(const QString& trouble) {
    dropConnection();
    const Seconds wait = retryPause(limits_.first_retry, limits_.longest_retry, failed_tries_);
    ++failed_tries_;
    retry_timer_.start(toMilliseconds(wait));
    setState(ImageState::Waiting, trouble);
}

void ImageClient::dropConnection() {
    for (QTimer* const timer : {&connect_timer_, &silence_timer_, &ask_timer_})
        timer->stop();
    const QSignalBlocker quiet(socket_);
    if (socket_.state() != QAbstractSocket::UnconnectedState)
        socket_.abort();
    head_.clear();
    data_ = {};
    arrivals_ms_.clear();
    asked_ = false;
}

void ImageClient::setState(ImageState state, const QString& reason) {
    const bool connected = socket_.state() == QAbstractSocket::ConnectedState;
    const ImageStatus next{state, reason, 0.0, connected ? socket_.localAddress().toString() : QString()};
    if (next == status_)
        return;
    status_ = next;
    emit statusChanged(status_);
}

} // namespace usar::link
