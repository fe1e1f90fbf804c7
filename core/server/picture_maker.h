// Makes frames of scenes, one after the other, in the image server's second thread.
#pragma once

#include <atomic>
#include <optional>

#include <QByteArray>
#include <QList>
#include <QObject>

#include "core/server/image_protocol.h"
#include "core/sim/camera/camera_scene.h"

namespace usar::server {

/// An order for one client's next frame.
struct PictureOrder {
    quint64 viewer = 0; ///< client id, passed back with the frame
    std::shared_ptr<const sim::CameraScene> scene;
    std::optional<sim::CameraChoice> camera; ///< nullopt: what the game's window shows
    ImageRequest request;
    link::ImageType type = link::ImageType::Good;
};

/// Keeps the last four pictures, so that several clients, or a client that asks faster than the simulation ticks, share
/// one.
class PictureMaker : public QObject {
    Q_OBJECT
public:
    /// Makes one frame and emits frameMade. To be called in this object's thread.
    void make(const PictureOrder& order);
    /// Cancels all orders that are still queued. May be called from any thread.
    void giveUp() { given_up_ = true; }
    /// Number of pictures made so far. May be called from any thread.
    quint64 made() const { return made_; }

signals:
    void frameMade(quint64 viewer, const QByteArray& frame);

private:
    struct Kept {
        std::uint64_t tick;
        std::optional<sim::CameraChoice> camera;
        sim::Picture picture;
    };
    const sim::Picture& pictureFor(const PictureOrder& order);

    static constexpr qsizetype most_kept = 4;
    QList<Kept> kept_; ///< newest first
    std::atomic<bool> given_up_ = false;
    std::atomic<quint64> made_ = 0;
};

} // namespace usar::server
