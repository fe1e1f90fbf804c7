// The client's end of one connection to an image server.
#pragma once

#include <deque>

#include <QByteArray>
#include <QElapsedTimer>
#include <QMetaType>
#include <QObject>
#include <QString>
#include <QTcpSocket>
#include <QTimer>

#include "core/base/clock.h"
#include "core/link/image_type.h"

namespace usar::link {

enum class ImageState {
    Off,
    Connecting,
    Waiting, ///< for the next try
    Quiet,   ///< connected; no picture yet, or none wanted
    Live
};

struct ImageStatus {
    ImageState state = ImageState::Off;
    QString reason; ///< one or two sentences with the mend, while Waiting
    double frames_per_s = 0.0;
    QString local_address{}; ///< of this end: whom the server calls the viewer; empty without a connection
    bool operator==(const ImageStatus&) const = default;
};

/// Wall-clock limits. Tests shorten them.
struct ImageClientLimits {
    Seconds connect_timeout{5.0};
    Seconds first_retry{0.5};
    Seconds longest_retry{5.0};
    Seconds silence{8.0};            ///< between request and picture
    Seconds shortest_interval{0.07}; ///< between requests
    std::uint32_t most_bytes = 8u << 20;
};

/// Connects, and reconnects until told to close; asks for one frame after the other while frames are wanted. Takes no
/// more memory than one frame of the largest allowed size. Lives in its owner's thread, which has an event loop.
class ImageClient : public QObject {
    Q_OBJECT
public:
    explicit ImageClient(QObject* parent = nullptr);
    ~ImageClient() override;

    void setLimits(const ImageClientLimits& limits) { limits_ = limits; }
    /// Closes what is open, then connects there.
    void open(const QString& host, quint16 port);
    void close();
    /// False at first.
    void setWanted(bool wanted);
    const ImageStatus& status() const { return status_; }
    /// Since `open`.
    quint64 framesReceived() const { return frames_; }

signals:
    void statusChanged(const usar::link::ImageStatus& status);
    /// `data` is a JPEG file, or raw as the protocol has it.
    void frameReceived(usar::link::ImageType type, const QByteArray& data);

private:
    void connectNow();
    void askNow();
    void askSoon();
    void takeBytes();
    bool takeHead();
    void takeFrame();
    void failed(const QString& trouble);
    void dropConnection();
    void setState(ImageState state, const QString& reason = {});
    QString place() const;

    QTcpSocket socket_;
    QTimer retry_timer_;
    QTimer connect_timer_;
    QTimer silence_timer_;
    QTimer ask_timer_;
    QElapsedTimer clock_;
    ImageClientLimits limits_;
    QString host_;
    quint16 port_ = 0;
    QByteArray head_;
    QByteArray data_;
    qsizetype data_bytes_ = 0; ///< of the frame that is coming
    std::deque<qint64> arrivals_ms_;
    qint64 asked_ms_ = 0;
    quint64 frames_ = 0;
    int failed_tries_ = 0;
    bool wanted_ = false;
    bool open_ = false;
    bool asked_ = false; ///< and not answered yet
    ImageStatus status_;
};

} // namespace usar::link

Q_DECLARE_METATYPE(usar::link::ImageStatus)
Q_DECLARE_METATYPE(usar::link::ImageType)
