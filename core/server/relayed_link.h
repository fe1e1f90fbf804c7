// One radio link between two robots: two sockets, with the bytes of each carried to the other.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include <QObject>
#include <QTcpSocket>

namespace usar::server {

/// Extracts payloads from what a robot sends on a data link of the ComServer (protocol.md 6.3: "SEND 5 hello;" and
/// "CLOSE;"), in bytes that are fed in chunks of any size. Payload bytes are passed on as they arrive, so a
/// message of any length needs no buffer. A payload may hold any bytes; the one byte after it is swallowed whatever it
/// is. An unknown word is skipped up to its semicolon.
class ComFrames {
public:
    using Take = std::function<void(std::string_view payload)>;

    /// Passes payload bytes to `take`, possibly in several pieces; the views are valid during the call only. Returns
    /// false once CLOSE has arrived; bytes after it are ignored.
    bool feed(std::string_view bytes, const Take& take);

private:
    enum class State { Between, Word, Length, Payload, End, Skip, Closed };
    void takeOne(char c);

    State state_ = State::Between;
    std::string word_;     ///< word read so far, or the digits of a length
    std::size_t left_ = 0; ///< bytes of the payload still to come
};

enum class LinkWords { None, Sends }; ///< Sends: robots wrap their data as "SEND len data;"

/// Buffers at most about 128 KiB each way; while one end does not read, the other is not read from. When one end
/// closes, the data that it had sent still reaches the other, which is then closed, too. Owns its sockets; runs in its
/// owner's thread.
class RelayedLink : public QObject {
    Q_OBJECT
public:
    /// `near_end` is the socket to robot `from`, `far_end` the one to robot `to`; both may still be connecting.
    RelayedLink(std::string from, std::string to, QTcpSocket* near_end, QTcpSocket* far_end, LinkWords words,
                QObject* parent = nullptr);
    ~RelayedLink() override;

    const std::string& from() const { return from_; }
    const std::string& to() const { return to_; }
    /// Port from which the far robot sees the call come.
    quint16 callerPort() const { return caller_port_; }
    /// Ends the link at once; the robots only see their sockets close.
    void drop();

signals:
    /// Emitted once. The link's owner then deletes it.
    void ended();

private:
    void join(QTcpSocket& in, QTcpSocket& out, std::size_t way);
    void carry(QTcpSocket& in, QTcpSocket& out, std::size_t way);
    void finish(QTcpSocket& gone, QTcpSocket& other, std::size_t way);
    void end();

    std::string from_;
    std::string to_;
    QTcpSocket* near_;
    QTcpSocket* far_;
    std::optional<std::array<ComFrames, 2>> frames_; ///< by direction; only with LinkWords::Sends
    quint16 caller_port_;
    bool ended_ = false;
};

} // namespace usar::server
