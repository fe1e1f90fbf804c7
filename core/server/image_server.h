// The image server: serves pictures of a simulation's cameras over TCP, one per request (protocol.md
// 6.1).
#pragma once

#include <functional>
#include <map>
#include <memory>

#include <QElapsedTimer>
#include <QObject>
#include <QTcpServer>
#include <QThread>

#include "core/server/access.h"
#include "core/server/image_protocol.h"
#include "core/sim/camera/camera_scene.h"

namespace usar::server {

struct ImageServerOptions {
    link::ImageType type = link::ImageType::Good;
    bool frame_on_connect = false; ///< legacy: the first frame is sent without a request
};

/// Runs in the simulator's thread, where it takes snapshots of the scene; pictures are made in a thread of its own, one
/// at a time, so that simulation ticks do not wait for them. A client gets at most 30 frames a second, and its next
/// frame is begun only when the last one has been sent, so a client that does not read costs one frame. Up to 16
/// requests are queued per client; further ones are dropped. Connections beyond 32 are refused. A client sees the
/// game's window (sim::windowPicture); AttachCamera on the bot port chooses a camera for the viewers at an address.
class ImageServer : public QObject {
    Q_OBJECT
public:
    using Look = std::function<sim::CameraScene()>;

    /// `look` returns the current scene. It is called in this object's thread, as long as the server exists.
    explicit ImageServer(Look look, const ImageServerOptions& options = {}, QObject* parent = nullptr);
    ~ImageServer() override;

    /// Admits this machine alone unless told otherwise before `listen`.
    void setAccess(const Access& access) { server_.setAccess(access); }
    /// Port 0 chooses a free one. Returns the port. A port in use is an error that says how to choose another.
    Result<quint16> listen(quint16 port) { return server_.open(port, "--image-port"); }
    quint16 port() const { return server_.serverPort(); }
    std::size_t clientCount() const { return viewers_.size(); }
    /// Number of pictures made so far. Equal pictures of one tick are made once.
    quint64 picturesMade() const;

private:
    struct Viewer;
    class PictureMaker;

    void acceptAll();
    void readFrom(Viewer& viewer);
    void serve(Viewer& viewer);
    void send(quint64 viewer, const QByteArray& frame);

    Look look_;
    ImageServerOptions options_;
    GuardedServer server_{this};
    QElapsedTimer clock_;
    std::map<quint64, std::unique_ptr<Viewer>> viewers_;
    quint64 last_viewer_ = 0;
    QThread thread_;
    PictureMaker* maker_; ///< belongs to thread_, which deletes it
};

} // namespace usar::server
