#include "core/server/embedded/simulator_channels.h"

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

} // namespace

OpenChannels openChannels(SimulatorServer& server, const ChannelPorts& wanted, const ImageServerOptions& images) {
    auto* image = new ImageServer([&server] { return server.simulation().cameraScene(); }, images, &server);
    auto* relay = new RadioRelay(server.simulation(), &server);
    auto* wireless = new WirelessServer(*relay, relay);
    auto* comserver = new ComServer(*relay, relay);
    auto* cominterface = new ComInterface(server.simulation(), relay->field(), relay);
    // Figures are also reported while time stands still; robots can come and go then, too.
    QObject::connect(&server, &SimulatorServer::ticked, relay, &RadioRelay::look);
    QObject::connect(&server, &SimulatorServer::figuresChanged, relay, &RadioRelay::look);
    QObject::connect(relay, &RadioRelay::logged, &server, &SimulatorServer::logged);
    for (RequestServer* const one : {static_cast<RequestServer*>(wireless), static_cast<RequestServer*>(comserver),
                                     static_cast<RequestServer*>(cominterface)})
        one->setAccess(server.access());
    image->setAccess(server.access());
    relay->setAccess(server.access());
    OpenChannels open;
    auto& [ports, sentences] = open;
    ports.image = listen(*image, wanted.image, QObject::tr("image server"), sentences);
    ports.wireless = listen(*wireless, wanted.wireless, QObject::tr("wireless server"), sentences);
    ports.comserver = listen(*comserver, wanted.comserver, QObject::tr("ComServer"), sentences);
    ports.cominterface = listen(*cominterface, wanted.cominterface, QObject::tr("ComServerInterface"), sentences);
    return open;
}

} // namespace usar::server
