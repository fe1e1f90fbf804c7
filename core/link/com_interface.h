// The ComServerInterface (usarsim-protocol 6.4): where radios are and what stands between, for a wireless server of
// somebody else's.
#pragma once

#include <string>
#include <string_view>

#include <QObject>

#include "core/link/radio_field.h"
#include "core/link/request_server.h"

namespace usar::link {

/// GETOBS between two points of the wire's frame, or two robots by name as the original wireless server asks, and
/// GETPOS. What it does not understand has -1 obstacles or no answer. In the simulator's thread.
class ComInterface : public QObject {
    Q_OBJECT
public:
    static constexpr quint16 usual_port = 7435;

    ComInterface(const sim::Simulation& simulation, RadioField& field, QObject* parent = nullptr);

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

} // namespace usar::link
