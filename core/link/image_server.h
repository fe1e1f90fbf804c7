// The image server: pictures of a simulation's cameras on loopback TCP, one for each request (usarsim-protocol 6.1).
#pragma once

#include <atomic>
#include <deque>
#include <functional>
#include <map>
#include <memory>

#include <QElapsedTimer>
#include <QObject>
#include <QTcpServer>
#include <QTcpSocket>
#include <QThread>
#include <QTimer>

#include "core/base/result.h"
#include "core/link/image_protocol.h"
#include "core/sim/camera/camera_scene.h"

namespace usar::link {

class PictureMaker;

struct ImageServerOptions {
    ImageType type = ImageType::Good;
    bool frame_on_connect = false; ///< legacy: the first frame comes without a request
};

/// Lives in the simulator's thread, where it takes snapshots; pictures are made in a thread of its own, one at a time,
/// so that ticks do not wait for them. Each client has one frame in work at most, gets 30 a second at most, and the
/// next one is begun when it has taken the last: one that does not read costs one frame. Sixteen requests may wait,
/// further ones are dropped. Clients in excess of 32 are refused. What a client sees is the game's window
/// (sim::windowPicture); AttachCamera on the bot port chooses a camera for the viewers of an address.
class ImageServer : public QObject {
    Q_OBJECT
public:
    using Look = std::function<sim::CameraScene()>;

    /// `look` is called in this object's thread, as long as the server lives.
    explicit ImageServer(Look look, const ImageServerOptions& options = {}, QObject* parent = nullptr);
    ~ImageServer() override;

    /// Loopback only. Port 0 chooses a free one. A port in use is an error that says how to choose another.
    Result<quint16> listen(quint16 port);
    quint16 port() const { return server_.serverPort(); }
    std::size_t clientCount() const { return viewers_.size(); }
    /// Pictures made since the beginning; equal ones of one tick are made once.
    quint64 picturesMade() const;

private:
    struct Viewer;

    void acceptAll();
    void readFrom(Viewer& viewer);
    void serve(Viewer& viewer);
    void send(quint64 viewer, const QByteArray& frame);

    Look look_;
    ImageServerOptions options_;
    QTcpServer server_;
    QElapsedTimer clock_;
    std::map<quint64, std::unique_ptr<Viewer>> viewers_;
    quint64 last_viewer_ = 0;
    QThread thread_;
    PictureMaker* maker_; ///< lives in thread_
};

} // namespace usar::link
