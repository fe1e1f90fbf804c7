// Frames of bytes over a connected socket between two processes.
#pragma once

#include <array>
#include <optional>

#include <QByteArray>

#include "core/base/clock.h"

namespace usar::agent {

/// A frame is its length (four bytes, little end first) and so many bytes. Owns the socket and closes it. Calls wait as
/// long as their patience says; used from one thread at a time. POSIX only; the death of the peer's process is seen on
/// Linux.
class FrameChannel {
public:
    enum class Received { Frame, TimedOut, Closed };
    /// More than any message of a behavior has; a larger length is damage, and counts as the end of the connection.
    static constexpr quint32 most_bytes = 64u << 20;

    explicit FrameChannel(int socket) : socket_(socket) {}
    ~FrameChannel();
    Q_DISABLE_COPY_MOVE(FrameChannel)

    int socket() const { return socket_; }
    /// A handle that can be read from when the process on the other side is over: then the connection counts as closed,
    /// whoever else may hold its other end. What was said before is received first. Not owned; -1: none.
    void endWith(int process_handle) { process_handle_ = process_handle; }
    /// False where the other side is gone, or does not read for so long.
    bool send(const QByteArray& frame, Seconds patience);
    /// Without a patience it waits for good. What has come of a frame by the end of it is kept for the next call.
    Received receive(QByteArray& frame, std::optional<Seconds> patience);

private:
    enum class Waited { Ready, TimedOut, Over };
    Waited waitFor(short events, std::optional<Seconds> patience) const;
    /// `got` of the `bytes` are there before, and after.
    Received fill(char* to, qsizetype bytes, qsizetype& got, std::optional<Seconds> patience);

    int socket_;
    int process_handle_ = -1;
    std::array<char, sizeof(quint32)> length_{}; ///< of the frame that is coming
    QByteArray frame_;                           ///< that is coming
    qsizetype length_bytes_ = 0;                 ///< that are there of the length
    qsizetype frame_bytes_ = 0;                  ///< and of the frame
};

} // namespace usar::agent
