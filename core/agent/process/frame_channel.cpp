#include "core/agent/process/frame_channel.h"

#include <cerrno>
#include <chrono>
#include <cmath>
#include <utility>

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <QtEndian>

namespace usar::agent {

FrameChannel::~FrameChannel() {
    ::close(socket_);
}

FrameChannel::Waited FrameChannel::waitFor(short events, std::optional<Seconds> patience) const {
    using Clock = std::chrono::steady_clock;
    const auto until = Clock::now() + std::chrono::duration_cast<Clock::duration>(patience.value_or(Seconds{0.0}));
    for (;;) {
        int left_ms = -1;
        if (patience)
            left_ms = static_cast<int>(std::ceil(std::max(0.0, Seconds(until - Clock::now()).count()) * 1e3));
        std::array watched{pollfd{socket_, events, 0}, pollfd{process_handle_, POLLIN, 0}}; // ignored if below 0
        const int ready = ::poll(watched.data(), watched.size(), left_ms);
        if (ready == 0 || (ready < 0 && errno != EINTR))
            return Waited::TimedOut;
        if (ready > 0)
            return watched[0].revents != 0 ? Waited::Ready : Waited::Over;
    }
}

bool FrameChannel::send(const QByteArray& frame, Seconds patience) {
    QByteArray bytes(sizeof(quint32), Qt::Uninitialized);
    qToLittleEndian(static_cast<quint32>(frame.size()), bytes.data());
    bytes += frame; // in one piece, so that the other side wakes up only once
    for (qsizetype sent = 0; sent < bytes.size();) {
        const ssize_t now = ::send(socket_, bytes.constData() + sent, static_cast<std::size_t>(bytes.size() - sent),
                                   MSG_NOSIGNAL | MSG_DONTWAIT);
        if (now > 0)
            sent += now;
        else if (errno == EAGAIN && waitFor(POLLOUT, patience) != Waited::Ready)
            return false;
        else if (errno != EAGAIN && errno != EINTR)
            return false;
    }
    return true;
}

FrameChannel::Received FrameChannel::fill(char* to, qsizetype bytes, qsizetype& got, std::optional<Seconds> patience) {
    while (got < bytes) {
        const ssize_t now = ::recv(socket_, to + got, static_cast<std::size_t>(bytes - got), MSG_DONTWAIT);
        if (now > 0) {
            got += now;
        } else if (now == 0 || (errno != EAGAIN && errno != EINTR)) {
            return Received::Closed;
        } else if (errno == EAGAIN) {
            const Waited waited = waitFor(POLLIN, patience);
            if (waited != Waited::Ready)
                return waited == Waited::Over ? Received::Closed : Received::TimedOut;
        }
    }
    return Received::Frame;
}

FrameChannel::Received FrameChannel::receive(QByteArray& frame, std::optional<Seconds> patience) {
    if (const Received begun = fill(length_.data(), sizeof length_, length_bytes_, patience); begun != Received::Frame)
        return begun;
    const quint32 bytes = qFromLittleEndian<quint32>(length_.data());
    if (bytes > most_bytes)
        return Received::Closed;
    frame_.resize(bytes);
    const Received whole = fill(frame_.data(), bytes, frame_bytes_, patience);
    if (whole == Received::Frame) {
        frame = std::exchange(frame_, {});
        length_bytes_ = frame_bytes_ = 0;
    }
    return whole;
}

} // namespace usar::agent
