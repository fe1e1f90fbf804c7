// The ComServerInterface (protocol.md 6.4): tells an external wireless server where the radios are and how many
// obstacles stand between them.
#pragma once

#include <string>
#include <string_view>

#include <QObject>

#include "core/protocol/usual_values.h"
#include "core/server/radio_field.h"
#include "core/server/request_server.h"

namespace usar::server {

/// Answers GETPOS, and GETOBS between two points in the wire frame or between two robots by name (as the original
/// wireless server asks). If GETOBS names a place that cannot be read, the answer is -1 obstacles; other requests get
/// no answer. Runs in the simulator's thread; `simulation` and `field` must outlive it.
class ComInterface : public QObject {
    Q_OBJECT
public:
    static constexpr quint16 usual_port = protocol::usual_port::com_interface;

    ComInterface(const sim::Simulation& simulation, RadioField& field, QObject* parent = nullptr);

    /// Loopback only; port 0 chooses a free one. Returns the port. A port in use is an error that names
    /// --cominterface-port.
    Result<quint16> listen(quint16 port) { return server_.listen(port, "--cominterface-port"); }
    quint16 port() const { return server_.port(); }

private:
    std::string answer(std::string_view line);
    std::string obstacles(std::string_view from, std::string_view to);
    std::string positions();

    const sim::Simulation& simulation_;
    RadioField& field_;
    RequestServer server_;
};

} // namespace usar::server
