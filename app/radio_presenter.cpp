#include "app/radio_presenter.h"

#include "widgets/empty_state.h"
#include "widgets/models/figures.h"

namespace usar::app {

namespace {

QString keyOf(const QString& a, const QString& b) {
    return QStringLiteral("radio/%1/%2").arg(a, b);
}

} // namespace

RadioPresenter::RadioPresenter(MissionControl& control, WindowViews& views, QObject* parent)
    : QObject(parent)
    , control_(control)
    , views_(views) {
    connect(&control_.simulator(), &SimulatorHost::channelsOpened, this,
            [this](const ChannelPorts& ports) { ports_ = ports; });
    connect(&control_, &MissionControl::linkChanged, this, &RadioPresenter::follow);
    connect(&control_, &MissionControl::robotAdded, this, &RadioPresenter::followRobots);
    connect(&control_, &MissionControl::robotRemoved, this, &RadioPresenter::followRobots);
    connect(&watch_, &RadioWatch::reported, this, &RadioPresenter::take);
    connect(&watch_, &RadioWatch::statusChanged, this, [this](const link::LinkStatus& status) {
        status_ = status;
        views_.radio->setSource(tr("Wireless server at %1:%2").arg(status.host).arg(status.port));
        explainEmptiness();
    });
    explainEmptiness();
}

void RadioPresenter::setStationAction(QAction* action) {
    station_action_ = action;
    explainEmptiness();
}

void RadioPresenter::follow(const link::LinkStatus& status) {
    const bool connected = status.state == link::LinkState::Connected;
    if (std::exchange(connected_, connected) == connected)
        return;
    const ServerTarget& server = control_.server();
    if (!connected)
        watch_.close();
    else if (server.embedded)
        watch_.open("127.0.0.1", ports_.wireless);
    else
        watch_.open(server.host, server.simulator.channels.wireless);
    explainEmptiness();
}

void RadioPresenter::followRobots() {
    QStringList robots;
    for (const Robot* robot : control_.robots())
        if (!robot->isReplay())
            robots << QString::fromStdString(robot->view().spawn.robot_name);
    robots_ = robots;
    watch_.setRobots(robots_);
    explainEmptiness();
}

void RadioPresenter::take(const link::RadioStrengths& strengths) {
    std::vector<widgets::RadioLink> links;
    for (const link::RadioStrength& strength : strengths)
        links.push_back({strength.a, strength.b, strength.strength_dbm});
    for (const widgets::RadioLink& link : links)
        tell(link);
    std::erase_if(linked_, [&](const auto& one) {
        const bool gone = !robots_.contains(one.first.first) || !robots_.contains(one.first.second);
        if (gone && !one.second)
            control_.cure(keyOf(one.first.first, one.first.second));
        return gone;
    });
    views_.radio->take(links);
    views_.map->setRadioLinks(links);
}

/// A link that is lost, once; it is cured when the link is back.
void RadioPresenter::tell(const widgets::RadioLink& link) {
    const bool linked = link.strength_dbm && *link.strength_dbm >= widgets::radio_cutoff_dbm;
    const auto known = linked_.find({link.a, link.b});
    if (known == linked_.end()) {
        if (linked) // who has never been heard has lost nothing
            linked_[{link.a, link.b}] = true;
        return;
    }
    if (std::exchange(known->second, linked) == linked)
        return;
    const QString key = keyOf(link.a, link.b);
    if (linked)
        return control_.cure(key);
    const QString reason = link.strength_dbm
                               ? tr("%1 and %2 have lost their radio link: %3 dBm, and %4 dBm are needed. Bring them "
                                    "closer together, or out from behind what stands between.")
                                     .arg(link.a, link.b, widgets::figure(*link.strength_dbm, 1),
                                          widgets::figure(widgets::radio_cutoff_dbm, 0))
                               : tr("%1 and %2 do not hear each other any more: one of them has left the world, or its "
                                    "battery is empty. Look at their states in the list of robots.")
                                     .arg(link.a, link.b);
    views_.notifications->push(key, Severity::Warning, reason);
}

void RadioPresenter::explainEmptiness() {
    widgets::EmptyState* const empty = views_.radio->emptyState();
    if (robots_.size() < 2) {
        empty->setText(tr("No radio links yet"),
                       robots_.isEmpty() ? tr("How well robots hear each other appears here. Spawn two robots, or a "
                                              "robot and a base station.")
                                         : tr("How well robots hear each other appears here. Spawn one more robot, or "
                                              "a base station."));
        return empty->setAction(station_action_);
    }
    empty->setAction(nullptr);
    if (status_.state == link::LinkState::Connected || status_.reason.isEmpty())
        empty->setText(tr("Asking the wireless server…"), tr("Its first answers come within seconds."));
    else
        empty->setText(tr("No wireless server"), status_.reason);
}

} // namespace usar::app
