#include "core/server/image_server.h"

#include "core/link/across_threads.h"
#include "core/server/loopback.h"
#include "core/server/picture_maker.h"

namespace usar::server {

namespace {

constexpr std::size_t most_viewers = 32;
constexpr std::size_t most_waiting = 16;
constexpr qint64 frame_interval_ms = 33;
constexpr qint64 unread_bytes = 4096;

/// Returns the camera that was chosen on the bot port for the viewers at an address; nullopt if none was.
std::optional<sim::CameraChoice> choiceFor(const sim::CameraScene& scene, const QHostAddress& viewer) {
    for (const auto& [address, camera] : scene.attached)
        if (QHostAddress(QString::fromStdString(address)) == viewer)
            return camera;
    return std::nullopt;
}

} // namespace

struct ImageServer::Viewer {
    quint64 id = 0;
    QTcpSocket* socket = nullptr; ///< owned by the server
    ImageRequestReader reader;
    std::deque<ImageRequest> waiting;
    bool in_work = false;                ///< a frame for this client is being made
    qint64 last_ms = -frame_interval_ms; ///< when its last frame was begun, by clock_
    QTimer pause;                        ///< runs until its next frame may be begun
};

ImageServer::ImageServer(Look look, const ImageServerOptions& options, QObject* parent)
    : QObject(parent)
    , look_(std::move(look))
    , options_(options)
    , server_(this)
    , maker_(new PictureMaker) {
    clock_.start();
    connect(&server_, &QTcpServer::newConnection, this, &ImageServer::acceptAll);
    thread_.setObjectName("pictures");
    maker_->moveToThread(&thread_);
    connect(&thread_, &QThread::finished, maker_, &QObject::deleteLater);
    link::connectAcross(maker_, &PictureMaker::frameMade, this, &ImageServer::send);
    thread_.start(QThread::LowPriority); // Simulation ticks take precedence.
}

ImageServer::~ImageServer() {
    for (const auto& [id, viewer] : viewers_)
        viewer->socket->disconnect(this);
    maker_->giveUp();
    link::post(maker_, [this] { thread_.quit(); }); // Runs in the maker's thread, which then deletes the maker.
    thread_.wait();                                 // Waits for at most one picture.
}

Result<quint16> ImageServer::listen(quint16 port) {
    return listenOnLoopback(server_, port, "--image-port");
}

quint64 ImageServer::picturesMade() const {
    return maker_->made();
}

void ImageServer::acceptAll() {
    while (QTcpSocket* const socket = server_.nextPendingConnection()) {
        if (viewers_.size() >= most_viewers) {
            refuse(socket);
            continue;
        }
        socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
        socket->setReadBufferSize(unread_bytes);
        const quint64 id = ++last_viewer_;
        Viewer& viewer = *(viewers_[id] = std::make_unique<Viewer>());
        viewer.id = id;
        viewer.socket = socket;
        viewer.pause.setSingleShot(true);
        if (options_.frame_on_connect)
            viewer.waiting.emplace_back();
        connect(&viewer.pause, &QTimer::timeout, this, [this, &viewer] { serve(viewer); });
        connect(socket, &QTcpSocket::readyRead, this, [this, &viewer] { readFrom(viewer); });
        connect(socket, &QTcpSocket::bytesWritten, this, [this, &viewer] { serve(viewer); });
        connect(
            socket, &QTcpSocket::disconnected, this,
            [this, id, socket] {
                socket->disconnect(this);
                viewers_.erase(id);
                socket->deleteLater();
            },
            Qt::QueuedConnection);
        serve(viewer);
    }
}

void ImageServer::readFrom(Viewer& viewer) {
    const QByteArray bytes = viewer.socket->readAll();
    viewer.reader.feed({bytes.constData(), static_cast<std::size_t>(bytes.size())}, viewer.waiting);
    if (viewer.waiting.size() > most_waiting)
        viewer.waiting.resize(most_waiting);
    serve(viewer);
}

void ImageServer::serve(Viewer& viewer) {
    if (viewer.in_work || viewer.waiting.empty() || viewer.socket->bytesToWrite() > 0)
        return;
    const qint64 wait_ms = viewer.last_ms + frame_interval_ms - clock_.elapsed();
    if (wait_ms > 0) {
        if (!viewer.pause.isActive())
            viewer.pause.start(static_cast<int>(wait_ms));
        return;
    }
    viewer.in_work = true;
    viewer.last_ms = clock_.elapsed();
    auto scene = std::make_shared<const sim::CameraScene>(look_());
    const auto camera = choiceFor(*scene, viewer.socket->peerAddress());
    const PictureOrder order{viewer.id, std::move(scene), camera, viewer.waiting.front(), options_.type};
    viewer.waiting.pop_front();
    link::post(maker_, [maker = maker_, order] { maker->make(order); });
}

void ImageServer::send(quint64 id, const QByteArray& frame) {
    const auto found = viewers_.find(id);
    if (found == viewers_.end())
        return; // The viewer has disconnected meanwhile.
    Viewer& viewer = *found->second;
    viewer.in_work = false;
    if (viewer.socket->state() != QAbstractSocket::ConnectedState)
        return;
    viewer.socket->write(frame);
    serve(viewer);
}

} // namespace usar::server
