// The client end of one connection to an image server.
#pragma once

#include <deque>

#include <QByteArray>
#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTcpSocket>
#include <QTimer>

#include "core/base/clock.h"
#include "core/link/image_type.h"

namespace usar::link {

/// The stages of a connection. Failures lead to Waiting, never to Off.
enum class ImageState {
    Off, ///< closed by the owner, or never opened
    Connecting,
    Waiting, ///< between two attempts to connect
    Quiet,   ///< connected; no picture yet, or none wanted
    Live     ///< pictures arrive
};

/// State of the connection for the user.
struct ImageStatus {
    ImageState state = ImageState::Off;
    QString reason;            ///< while Waiting: one or two sentences with the remedy
    double frames_per_s = 0.0; ///< over the last ten frames; 0 before the second one
    QString local_address{};   ///< address of this end, by which the server knows the viewer; empty while not connected
    bool operator==(const ImageStatus&) const = default;
};

/// Wall-clock limits. Tests shorten them.
struct ImageClientLimits {
    Seconds connect_timeout{5.0};
    /// The pause after the first failure; each further failure doubles it up to `longest_retry`.
    Seconds first_retry{0.5};
    Seconds longest_retry{5.0};
    Seconds silence{8.0};                ///< longest wait between request and picture
    Seconds shortest_interval{0.07};     ///< between two requests
    std::uint32_t most_bytes = 8u << 20; ///< largest frame that is accepted
};

/// Connects, and reconnects with growing pauses until closed; while frames are wanted, requests one after the other.
/// Needs no more memory than one frame of the largest allowed size. Runs in its owner's thread, which needs an event
/// loop.
class ImageClient : public QObject {
    Q_OBJECT
public:
    explicit ImageClient(QObject* parent = nullptr);
    ~ImageClient() override;

    /// Applies to requests and attempts that begin afterward.
    void setLimits(const ImageClientLimits& limits) { limits_ = limits; }
    /// Closes any open connection, then connects to this server.
    void open(const QString& host, quint16 port);
    /// Closes the connection and does not reconnect.
    void close();
    /// Starts or stops requesting frames. Initially false. The connection stays open either way.
    void setWanted(bool wanted);
    const ImageStatus& status() const { return status_; }

signals:
    /// Emitted after every change of the state and after every frame, because the frame rate changes.
    void statusChanged(const usar::link::ImageStatus& status);
    /// `data` is a JPEG file, or for ImageType::Raw the pixels as protocol.md 6.1 packs them.
    void frameReceived(usar::link::ImageType type, const QByteArray& data);

private:
    void connectNow();
    /// Sends "OK", which requests the next frame (protocol.md 6.1).
    void askNow();
    /// Requests a frame when the shortest interval since the last request is over; does nothing while one is under way.
    void askSoon();
    void takeBytes();
    /// The head is one byte for the type and four bytes, big-endian, for the size of the data.
    bool takeHead();
    void takeFrame();
    /// Drops the connection and tries again later; `trouble` becomes the reason in the status.
    void failed(const QString& trouble);
    /// Stops all timers but the one for the next attempt, and forgets a frame that is not complete.
    void dropConnection();
    void setState(ImageState state, const QString& reason = {});
    /// Host and port as "host:port", for messages.
    QString place() const;

    QTcpSocket socket_{this};
    QTimer retry_timer_{this};
    QTimer connect_timer_{this};
    QTimer silence_timer_{this};
    QTimer ask_timer_{this};
    QElapsedTimer clock_;
    ImageClientLimits limits_;
    QString host_;
    quint16 port_ = 0;
    QByteArray head_;                ///< bytes of the next frame's head received so far
    QByteArray data_;                ///< bytes of its data received so far
    qsizetype data_bytes_ = 0;       ///< size of the frame that is arriving
    std::deque<qint64> arrivals_ms_; ///< when the last frames arrived, by clock_
    qint64 asked_ms_ = 0;
    int failed_tries_ = 0;
    bool wanted_ = false;
    bool open_ = false;
    bool asked_ = false; ///< a request has been sent and not been answered yet
    ImageStatus status_;
};

} // namespace usar::link
