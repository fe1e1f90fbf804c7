#include "app/desks/radio_desk.h"

#include "core/mission/fleet/roster.h"

namespace usar::app {

void RadioDesk::registerCommands() {
    const auto has_place = [this] { return connected_ && !control_.startPoses().empty(); };
    add("radio.station", has_place, [this] { spawnStation(); });
    add("radio.show", [this] { raise(views_.radio_dock); });
    add("radio.map", [this](bool on) { showOnMap(on); });
}

void RadioDesk::wire() {
    connect(&control_.simulator(), &server::SimulatorHost::channelsOpened, this,
            [this](const server::ChannelPorts& ports) { ports_ = ports; });
    connect(&control_, &MissionControl::linkChanged, this, &RadioDesk::follow);
    connect(&control_, &MissionControl::robotAdded, this, &RadioDesk::followRobots);
    connect(&control_, &MissionControl::robotRemoved, this, &RadioDesk::followRobots);
    link::connectAcross(client_.get(), &link::WirelessClient::reported, this, &RadioDesk::take);
    link::connectAcross(client_.get(), &link::WirelessClient::statusChanged, this,
                        [this](const link::LinkStatus& status) {
                            status_ = status;
                            views_.radio->setSource(tr("Wireless server at %1:%2").arg(status.host).arg(status.port));
                            explainEmptiness();
                        });
    QAction* const on_map = action("radio.map");
    connect(views_.layers, &widgets::LayersPanel::layerChanged, on_map,
            [on_map](widgets::MapLayer which, const widgets::LayerState& state) {
                if (which == widgets::MapLayer::Radio)
                    on_map->setChecked(state.visible);
            });
    explainEmptiness();
}

void RadioDesk::showOnMap(bool on) {
    widgets::LayerState state = views_.map->layer(widgets::MapLayer::Radio);
    state.visible = on;
    views_.map->setLayer(widgets::MapLayer::Radio, state);
    views_.layers->setLayer(widgets::MapLayer::Radio, state);
}

void RadioDesk::spawnStation() {
    std::vector<mission::SpawnRequest> present;
    for (const Robot* robot : control_.robots())
        present.push_back(robot->view().spawn);
    if (const auto id = control_.spawn(mission::stationRequest(control_.startPoses(), present)); !id)
        notices_.complain("spawn", id.error());
}

void RadioDesk::follow(const link::LinkStatus& status) {
    const bool connected = status.state == link::LinkState::Connected;
    if (std::exchange(connected_, connected) == connected)
        return;
    const ServerTarget& server = control_.server();
    if (!connected)
        client_.call(&link::WirelessClient::close);
    else if (server.embedded)
        client_.call(&link::WirelessClient::open, QString("127.0.0.1"), ports_.wireless);
    else
        client_.call(&link::WirelessClient::open, server.host, server.simulator.channels.wireless);
    explainEmptiness();
}

void RadioDesk::followRobots() {
    robots_ = control_.liveNames();
    client_.call(&link::WirelessClient::setRobots, robots_);
    explainEmptiness();
}

void RadioDesk::take(const link::RadioStrengths& strengths) {
    std::vector<widgets::RadioLink> links;
    for (const link::RadioStrength& strength : strengths)
        links.push_back({strength.a, strength.b, strength.strength_dbm});
    if (const auto news = losses_.take(links, robots_)) {
        if (news->text.isEmpty())
            notices_.cure("radio");
        else
            notices_.say(Severity::Warning, "radio", news->text, news->first);
    }
    views_.radio->take(links);
    views_.map->setRadioLinks(links);
}

void RadioDesk::explainEmptiness() {
    const bool well = status_.state == link::LinkState::Connected;
    views_.radio->explainEmptiness(robots_.size(), well ? QString() : status_.reason, action("radio.station"));
}

} // namespace usar::app
