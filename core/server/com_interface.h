// The ComServerInterface (protocol.md 6.4): tells an external wireless server where the radios are and how many
// obstacles stand between them.
#pragma once

#include <string>
#include <string_view>

#include "core/server/radio_field.h"
#include "core/server/request_server.h"

namespace usar::server {

/// Answers GETPOS, and GETOBS between two points in the wire frame or between two robots by name (as the original
/// wireless server asks). If GETOBS names a place that cannot be read, the answer is -1 obstacles; other requests get
/// no answer. Runs in the simulator's thread; `simulation` and `field` must outlive it.
class ComInterface : public RequestServer {
    Q_OBJECT
public:
    ComInterface(const sim::Simulation& simulation, RadioField& field, QObject* parent = nullptr);

private:
    std::string answer(int client, std::string_view line) override;
    std::string obstacles(std::string_view from, std::string_view to);
    std::string positions();

    const sim::Simulation& simulation_;
    RadioField& field_;
};

} // namespace usar::server
