#include "app/desks/radio_desk.h"

#include <algorithm>

#include "core/protocol/commands/spawn.h"
#include "widgets/models/figures.h"
#include "widgets/style/empty_state.h"

namespace usar::app {

namespace {

QString keyOf(const QString& a, const QString& b) {
    return QStringLiteral("radio/%1/%2").arg(a, b);
}

} // namespace

RadioDesk::RadioDesk(const DeskContext& context) : desk_(context) {}

void RadioDesk::registerCommands() {
    desk_.commands.add(
        {"radio.station",
         tr("Spawn a base station"),
         tr("Radio"),
         tr("A base of the radio network, on the first start pose that is free"),
         "plus",
         {QKeySequence("Ctrl+B")}},
        [this](bool) { spawnStation(); }, [this] { return connected_ && !desk_.control.startPoses().empty(); });
    desk_.commands.add({"radio.show",
                        tr("Radio links"),
                        tr("Radio"),
                        tr("How well robots hear each other: dBm of each pair, and the last minutes"),
                        "",
                        {QKeySequence("F7")}},
                       [this](bool) {
                           desk_.views.radio_dock->show();
                           desk_.views.radio_dock->raise();
                       });
    desk_.commands.add({"radio.map",
                        tr("Radio links on the map"),
                        tr("Radio"),
                        tr("Lines between robots in the color of their link; the Layers dock has it, too"),
                        "",
                        {QKeySequence("Ctrl+Shift+B")},
                        true},
                       [this](bool on) { showOnMap(on); });
}

void RadioDesk::wire() {
    connect(&desk_.control.simulator(), &server::SimulatorHost::channelsOpened, this,
            [this](const server::ChannelPorts& ports) { ports_ = ports; });
    connect(&desk_.control, &MissionControl::linkChanged, this, &RadioDesk::follow);
    connect(&desk_.control, &MissionControl::robotAdded, this, &RadioDesk::followRobots);
    connect(&desk_.control, &MissionControl::robotRemoved, this, &RadioDesk::followRobots);
    link::connectAcross(client_.get(), &link::WirelessClient::reported, this, &RadioDesk::take);
    link::connectAcross(
        client_.get(), &link::WirelessClient::statusChanged, this, [this](const link::LinkStatus& status) {
            status_ = status;
            desk_.views.radio->setSource(tr("Wireless server at %1:%2").arg(status.host).arg(status.port));
            explainEmptiness();
        });
    QAction* const on_map = desk_.commands.action("radio.map");
    connect(desk_.views.layers, &widgets::LayersPanel::layerChanged, on_map,
            [on_map](widgets::MapLayer which, const widgets::LayerState& state) {
                if (which == widgets::MapLayer::Radio)
                    on_map->setChecked(state.visible);
            });
    explainEmptiness();
}

void RadioDesk::showOnMap(bool on) {
    widgets::LayerState state = desk_.views.map->layer(widgets::MapLayer::Radio);
    state.visible = on;
    desk_.views.map->setLayer(widgets::MapLayer::Radio, state);
    desk_.views.layers->setLayer(widgets::MapLayer::Radio, state);
}

/// Prefers a free start pose, because two stations on one pose would only hear each other well.
void RadioDesk::spawnStation() {
    const auto robots = desk_.control.robots();
    const auto& poses = desk_.control.startPoses();
    const auto is_free = [&](const protocol::StartPose& pose) {
        return std::ranges::none_of(robots, [&](const Robot* robot) {
            return robot->view().spawn.start_in_map.position_m.isApprox(pose.pose_in_map.position_m);
        });
    };
    auto place = std::ranges::find_if(poses, is_free);
    if (place == poses.end())
        place = poses.begin();
    const auto is_taken = [&](const std::string& name) {
        return std::ranges::any_of(robots, [&](const Robot* robot) { return robot->view().spawn.robot_name == name; });
    };
    std::string name = "Base";
    for (int number = 2; is_taken(name); ++number)
        name = "Base" + std::to_string(number);
    const auto id = desk_.control.spawn({std::string(protocol::station_class), name, place->pose_in_map});
    if (!id)
        desk_.notices.complain("spawn", id.error());
}

void RadioDesk::follow(const link::LinkStatus& status) {
    const bool connected = status.state == link::LinkState::Connected;
    if (std::exchange(connected_, connected) == connected)
        return;
    const ServerTarget& server = desk_.control.server();
    if (!connected)
        client_.call(&link::WirelessClient::close);
    else if (server.embedded)
        client_.call(&link::WirelessClient::open, QString("127.0.0.1"), ports_.wireless);
    else
        client_.call(&link::WirelessClient::open, server.host, server.simulator.channels.wireless);
    explainEmptiness();
}

void RadioDesk::followRobots() {
    QStringList robots;
    for (const Robot* robot : desk_.control.robots())
        if (!robot->isReplay())
            robots << QString::fromStdString(robot->view().spawn.robot_name);
    robots_ = robots;
    client_.call(&link::WirelessClient::setRobots, robots_);
    explainEmptiness();
}

void RadioDesk::take(const link::RadioStrengths& strengths) {
    std::vector<widgets::RadioLink> links;
    for (const link::RadioStrength& strength : strengths)
        links.push_back({strength.a, strength.b, strength.strength_dbm});
    for (const widgets::RadioLink& link : links)
        tell(link);
    std::erase_if(linked_, [&](const auto& one) {
        const bool gone = !robots_.contains(one.first.first) || !robots_.contains(one.first.second);
        if (gone && !one.second)
            desk_.notices.cure(keyOf(one.first.first, one.first.second));
        return gone;
    });
    desk_.views.radio->take(links);
    desk_.views.map->setRadioLinks(links);
}

/// Reports a lost link once, and cures the notice when the link is back.
void RadioDesk::tell(const widgets::RadioLink& link) {
    const bool linked = link.strength_dbm && *link.strength_dbm >= widgets::radio_cutoff_dbm;
    const auto known = linked_.find({link.a, link.b});
    if (known == linked_.end()) {
        if (linked) // A pair that was never linked has lost nothing.
            linked_[{link.a, link.b}] = true;
        return;
    }
    if (std::exchange(known->second, linked) == linked)
        return;
    const QString key = keyOf(link.a, link.b);
    if (linked)
        return desk_.notices.cure(key);
    const QString reason = link.strength_dbm
                               ? tr("%1 and %2 have lost their radio link: %3 dBm, and %4 dBm are needed. Bring them "
                                    "closer together, or out from behind what stands between.")
                                     .arg(link.a, link.b, widgets::figure(*link.strength_dbm, 1),
                                          widgets::figure(widgets::radio_cutoff_dbm, 0))
                               : tr("%1 and %2 do not hear each other any more: one of them has left the world, or its "
                                    "battery is empty. Look at their states in the list of robots.")
                                     .arg(link.a, link.b);
    desk_.notices.say(Severity::Warning, key, reason);
}

void RadioDesk::explainEmptiness() {
    widgets::EmptyState* const empty = desk_.views.radio->emptyState();
    if (robots_.size() < 2) {
        empty->setText(tr("No radio links yet"),
                       robots_.isEmpty() ? tr("How well robots hear each other appears here. Spawn two robots, or a "
                                              "robot and a base station.")
                                         : tr("How well robots hear each other appears here. Spawn one more robot, or "
                                              "a base station."));
        return empty->setAction(desk_.commands.action("radio.station"));
    }
    empty->setAction(nullptr);
    if (status_.state == link::LinkState::Connected || status_.reason.isEmpty())
        empty->setText(tr("Asking the wireless server…"), tr("Its first answers come within seconds."));
    else
        empty->setText(tr("No wireless server"), status_.reason);
}

} // namespace usar::app
