// Exchanges frames of bytes between two processes over a connected socket.
#pragma once

#include <array>
#include <optional>

#include <QByteArray>

#include "core/base/clock.h"

namespace usar::agent {

/// A frame is sent as its length (four bytes, little-endian) and its bytes. Owns the socket and closes it. Calls block
/// for at most their `patience`. Use it from one thread at a time. POSIX only; the death of the peer's process is
/// noticed on Linux only.
class FrameChannel {
public:
    enum class Received { Frame, TimedOut, Closed };
    /// More than any message of a behavior needs. A larger length means that the data is damaged, and counts as the end
    /// of the connection.
    static constexpr quint32 most_bytes = 64u << 20;

    explicit FrameChannel(int socket) : socket_(socket) {}
    ~FrameChannel();
    Q_DISABLE_COPY_MOVE(FrameChannel)

    int socket() const { return socket_; }
    /// Sets a file descriptor that becomes readable when the process on the other side ends. From then on the
    /// connection counts as closed, even if another process holds its other end; data sent before is still received.
    /// The descriptor is not owned; -1 means none.
    void endWith(int process_handle) { process_handle_ = process_handle; }
    /// False if the other side is gone or has not read for `patience`.
    bool send(const QByteArray& frame, Seconds patience);
    /// Waits forever if `patience` is nullopt. After TimedOut, the part of a frame that has arrived is kept for the
    /// next call.
    Received receive(QByteArray& frame, std::optional<Seconds> patience);

private:
    enum class Waited { Ready, TimedOut, Over };
    Waited waitFor(short events, std::optional<Seconds> patience) const;
    /// Reads until `to` holds `bytes` bytes; `got` counts those that it holds, before and after the call.
    Received fill(char* to, qsizetype bytes, qsizetype& got, std::optional<Seconds> patience);

    int socket_;
    int process_handle_ = -1;
    std::array<char, sizeof(quint32)> length_{}; ///< length of the frame being received
    QByteArray frame_;                           ///< the frame being received
    qsizetype length_bytes_ = 0;                 ///< number of bytes received of the length
    qsizetype frame_bytes_ = 0;                  ///< number of bytes received of the frame
};

} // namespace usar::agent
