#include "core/server/image_server.h"

#include <algorithm>
#include <atomic>
#include <optional>

#include <QList>
#include <QTimer>

#include "core/link/across_threads.h"
#include "core/sim/camera/renderer.h"

namespace usar::server {

namespace {

constexpr std::size_t most_viewers = 32;
constexpr std::size_t most_waiting = 16;
constexpr qint64 frame_interval_ms = 33;
constexpr qint64 unread_bytes = 4096;
constexpr qsizetype most_kept = 4;

/// An order for one client's next frame.
struct PictureOrder {
    std::shared_ptr<const sim::CameraScene> scene;
    std::optional<sim::CameraChoice> camera; ///< nullopt: what the game's window shows
    ImageRequest request;
    link::ImageType type = link::ImageType::Good;
};

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

/// Makes frames of scenes, one after the other, in the server's second thread. Keeps the last four pictures, so that
/// several clients, or a client that asks faster than the simulation ticks, share one.
class ImageServer::PictureMaker : public QObject {
public:
    /// The frame; nullopt after `giveUp`. To be called in this object's thread.
    std::optional<QByteArray> make(const PictureOrder& order) {
        if (given_up_)
            return std::nullopt;
        const sim::Picture& whole = pictureFor(order);
        const auto& part = order.request.part;
        return part ? frameOf(sim::cut(whole, part->x, part->y, part->width, part->height), order.type)
                    : frameOf(whole, order.type);
    }
    /// Cancels all orders that are still queued. May be called from any thread.
    void giveUp() { given_up_ = true; }
    /// Number of pictures made so far. May be called from any thread.
    quint64 made() const { return made_; }

private:
    struct Kept {
        std::uint64_t tick;
        std::optional<sim::CameraChoice> camera;
        sim::Picture picture;
    };
    const sim::Picture& pictureFor(const PictureOrder& order) {
        const auto known = std::ranges::find_if(
            kept_, [&](const Kept& one) { return one.tick == order.scene->tick && one.camera == order.camera; });
        if (known != kept_.end())
            return known->picture;
        kept_.prepend({order.scene->tick, order.camera,
                       sim::windowPicture(*order.scene, order.camera ? &*order.camera : nullptr)});
        if (kept_.size() > most_kept)
            kept_.removeLast();
        ++made_;
        return kept_.first().picture;
    }

    QList<Kept> kept_; ///< newest first
    std::atomic<bool> given_up_ = false;
    std::atomic<quint64> made_ = 0;
};

ImageServer::ImageServer(Look look, const ImageServerOptions& options, QObject* parent)
    : QObject(parent)
    , look_(std::move(look))
    , options_(options)
    , maker_(new PictureMaker) {
    clock_.start();
    connect(&server_, &QTcpServer::newConnection, this, &ImageServer::acceptAll);
    thread_.setObjectName("pictures");
    maker_->moveToThread(&thread_);
    connect(&thread_, &QThread::finished, maker_, &QObject::deleteLater);
    thread_.start(QThread::LowPriority); // Simulation ticks take precedence.
}

ImageServer::~ImageServer() {
    for (const auto& [id, viewer] : viewers_)
        viewer->socket->disconnect(this);
    maker_->giveUp();
    link::post(maker_, [this] { thread_.quit(); }); // Runs in the maker's thread, which then deletes the maker.
    thread_.wait();                                 // Waits for at most one picture.
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
    const PictureOrder order{std::move(scene), camera, viewer.waiting.front(), options_.type};
    viewer.waiting.pop_front();
    link::post(maker_, [this, maker = maker_, id = viewer.id, order] {
        if (const auto frame = maker->make(order))
            link::post(this, [this, id, frame] { send(id, *frame); });
    });
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
