#include "core/mission/fleet/world_link.h"

#include <utility>

#include "core/link/across_threads.h"

namespace usar::mission {

WorldLink::WorldLink(QObject* parent) : QObject(parent), session_(new mission::WorldSession) {
    thread_.setObjectName("world");
    session_->moveToThread(&thread_);
    connect(&thread_, &QThread::finished, session_, &QObject::deleteLater);
    link::connectAcross(session_, &mission::WorldSession::changed, this, [this](const auto& view) {
        view_ = view;
        emit changed();
    });
    link::connectAcross(session_, &mission::WorldSession::noticed, this, &WorldLink::noticed);
    thread_.start();
}

WorldLink::~WorldLink() {
    thread_.quit();
    thread_.wait();
}

template <class Call>
void WorldLink::later(Call call) {
    link::post(session_, [session = session_, call = std::move(call)] { call(*session); });
}

void WorldLink::open(const QString& host, quint16 port) {
    later([=](mission::WorldSession& session) { session.open(host, port); });
}

void WorldLink::close() {
    later([](mission::WorldSession& session) { session.close(); });
}

void WorldLink::setClasses(const std::vector<std::string>& class_names) {
    later([=](mission::WorldSession& session) { session.setClasses(class_names); });
}

void WorldLink::setPolling(std::optional<std::chrono::milliseconds> interval) {
    later([=](mission::WorldSession& session) { session.setPolling(interval); });
}

void WorldLink::setPaused(bool paused) {
    later([=](mission::WorldSession& session) { session.setPaused(paused); });
}

void WorldLink::send(const protocol::Command& command) {
    later([=](mission::WorldSession& session) { session.send(command); });
}

} // namespace usar::mission
