#include "core/server/embedded/simulator_channels.h"

#include "core/server/com_interface.h"
#include "core/server/com_server.h"
#include "core/server/radio_relay.h"
#include "core/server/wireless_server.h"

namespace usar::server {

namespace {

/// Returns the port that the server listens on: the wanted one, or else a free one, about which a sentence is added; 0
/// if it cannot listen at all.
template <class Server>
quint16 listen(Server& server, quint16 wanted, const QString& name, QStringList& sentences) {
    Result<quint16> port = server.listen(wanted);
    if (!port) {
        const QString reason = QString::fromStdString(port.error().text());
        port = server.listen(0);
        sentences << (port ? QObject::tr("Port %1 is in use by another program; the %2 listens on port %3 instead.")
                                 .arg(wanted)
                                 .arg(name)
                                 .arg(*port)
                           : QObject::tr("The %1 does not run. %2").arg(name, reason));
    }
    return port.value_or(0);
}

void openRadio(server::SimulatorServer& server, const ChannelPorts& wanted, OpenChannels& open) {
    auto* relay = new server::RadioRelay(server.simulation(), &server);
    auto* wireless = new server::WirelessServer(*relay, relay);
    auto* comserver = new server::ComServer(*relay, relay);
    auto* cominterface = new server::ComInterface(server.simulation(), relay->field(), relay);
    // Figures are also reported while time stands still; robots can come and go then, too.
    QObject::connect(&server, &server::SimulatorServer::ticked, relay, &server::RadioRelay::look);
    QObject::connect(&server, &server::SimulatorServer::figuresChanged, relay, &server::RadioRelay::look);
    QObject::connect(relay, &server::RadioRelay::logged, &server, &server::SimulatorServer::logged);
    open.ports.wireless = listen(*wireless, wanted.wireless, QObject::tr("wireless server"), open.sentences);
    open.ports.comserver = listen(*comserver, wanted.comserver, QObject::tr("ComServer"), open.sentences);
    open.ports.cominterface =
        listen(*cominterface, wanted.cominterface, QObject::tr("ComServerInterface"), open.sentences);
}

} // namespace

OpenChannels openChannels(server::SimulatorServer& server, const ChannelPorts& wanted,
                          const server::ImageServerOptions& images) {
    OpenChannels open;
    auto* image = new server::ImageServer([&server] { return server.simulation().cameraScene(); }, images, &server);
    open.ports.image = listen(*image, wanted.image, QObject::tr("image server"), open.sentences);
    openRadio(server, wanted, open);
    return open;
}

} // namespace usar::server
