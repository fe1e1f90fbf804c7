#include "core/mission/fleet/radio_watch.h"

#include "core/link/across_threads.h"

namespace usar::mission {

RadioWatch::RadioWatch(QObject* parent) : QObject(parent), client_(new link::WirelessClient) {
    thread_.setObjectName("radio");
    client_->moveToThread(&thread_);
    connect(&thread_, &QThread::finished, client_, &QObject::deleteLater);
    link::connectAcross(client_, &link::WirelessClient::statusChanged, this, &RadioWatch::statusChanged);
    link::connectAcross(client_, &link::WirelessClient::reported, this, &RadioWatch::reported);
    thread_.start();
}

RadioWatch::~RadioWatch() {
    thread_.quit();
    thread_.wait();
}

void RadioWatch::open(const QString& host, quint16 port) {
    link::post(client_, [client = client_, host, port] { client->open(host, port); });
}

void RadioWatch::close() {
    link::post(client_, [client = client_] { client->close(); });
}

void RadioWatch::setRobots(const QStringList& names) {
    link::post(client_, [client = client_, names] { client->setRobots(names); });
}

} // namespace usar::mission
