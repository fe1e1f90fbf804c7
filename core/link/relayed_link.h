// One radio link between two robots: two sockets, and bytes carried from each to the other.
#pragma once

#include <array>
#include <optional>
#include <string>

#include <QObject>
#include <QTcpSocket>

#include "core/link/com_frames.h"

namespace usar::link {

enum class LinkWords { None, Sends }; ///< Sends: robots wrap what they say as "SEND len data;"

/// Holds at most some 128 KiB each way: who does not read is not read from. When one end closes, what it has said still
/// reaches the other, and then that closes, too. Owns its sockets; lives in its owner's thread.
class RelayedLink : public QObject {
    Q_OBJECT
public:
    RelayedLink(std::string from, std::string to, QTcpSocket* near_end, QTcpSocket* far_end, LinkWords words,
                QObject* parent = nullptr);
    ~RelayedLink() override;

    const std::string& from() const { return from_; }
    const std::string& to() const { return to_; }
    /// Where the far robot sees the call come from.
    quint16 callerPort() const { return caller_port_; }
    /// At once and without a word to either robot but the closing of its socket.
    void drop();

signals:
    /// Once; whoever owns it deletes it.
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
    std::optional<std::array<ComFrames, 2>> frames_;
    quint16 caller_port_;
    bool ended_ = false;
};

/// Calls a port of this machine from a port that is known before the call is answered.
QTcpSocket* callLoopback(quint16 port);

} // namespace usar::link
