// Makes frames of scenes, one after the other, in the image server's second thread.
#pragma once

#include <atomic>
#include <optional>

#include <QByteArray>
#include <QList>
#include <QObject>

#include "core/link/image_protocol.h"
#include "core/sim/camera/camera_scene.h"

namespace usar::link {

/// What one client is to be shown.
struct PictureOrder {
    quint64 viewer = 0;
    std::shared_ptr<const sim::CameraScene> scene;
    std::optional<sim::CameraChoice> camera;
    ImageRequest request;
    ImageType type = ImageType::Good;
};

/// Keeps the last pictures: several clients, or one that asks faster than the simulation ticks, cost one picture.
class PictureMaker : public QObject {
    Q_OBJECT
public:
    /// In its own thread.
    void make(const PictureOrder& order);
    /// From any thread: what still waits is not made any more.
    void giveUp() { given_up_ = true; }
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

} // namespace usar::link
